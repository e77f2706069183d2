//! How much the two weights differ at the same half opening, in numbers.

use super::landmarks::state_of;
use super::measured::Bounds;
use super::same_opening::DIFFERENCES_GROW;
use super::{Claim, Derivation, Finding};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::state::State;
use crate::number::{Ball, Field};

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "weights-minimal",
        place: "Sec. 2.1, Fig. 2",
        statement: "at the same half opening eta and h differ really little between the two weights, even \
                    as the thickness grows",
        decide: |d| largest(d, &["pi/2", "2", "2.4", "2.55"], &[ETA, H]),
    },
    Claim {
        id: "weights-marginal",
        place: "Sec. 5",
        statement: "for openings up to the semicircle the differences between the two weights are quite \
                    marginal",
        decide: |d| largest(d, &["pi/2"], &[ETA, H, BETA]),
    },
];

/// A variable of a state, and in which direction Milankovitch's weight moves it.
type Variable = (&'static str, bool, fn(&State) -> &Ball);

const ETA: Variable = ("eta larger", true, |state| &state.thickness);
const H: Variable = ("h smaller", false, |state| &state.thrust);
const BETA: Variable = ("beta_r smaller", false, |state| &state.rotation_joint);

/// The largest relative differences up to some half openings, which are those at these.
fn largest(
    d: &mut Derivation,
    openings: &[&str],
    variables: &[Variable],
) -> Result<Finding, Undecided> {
    d.lemma(&DIFFERENCES_GROW)?;
    let mut bounds = Bounds::default();
    for alpha in openings {
        let [heyman, milankovitch] = SelfWeight::ALL.map(|weight| state_of(alpha, None, weight));
        let (heyman, milankovitch) = (heyman?, milankovitch?);
        for (name, is_larger, value) in variables {
            let part = value(&milankovitch).clone() / value(&heyman);
            let difference = part.clone() - part.int(1);
            let percent = if *is_larger { difference } else { -difference } * part.int(100);
            let words = format!("{name}, up to alpha = {alpha}");
            bounds.at_most(d, (&words, &percent, " %"), 3)?;
        }
    }
    d.conclude("They grow with the half opening, so that the last of a range is the largest.");
    Ok(bounds.finding())
}
