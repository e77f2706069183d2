//! Difference of the two weights at the same half opening, in numbers.

use super::along;
use super::landmarks::{both, state_of};
use super::measured::at_most;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::{SelfWeight, Unknown};
use crate::certify::state::State;
use crate::number::{Ball, Field};
use crate::problem::Landmark;

claims! {
    Measured("weights-minimal", "Sec. 2.1, Fig. 2", minimal):
        "at the same half opening eta and h differ really little between the two weights, even as the thickness \
         grows";
    Measured("weights-marginal", "Sec. 5", marginal):
        "for openings up to the semicircle the thickness is small and the differences between the two weights are quite \
         marginal";
    Measured("weights-slightly", "Sec. 2.1, 3", at_landmarks):
        "alpha_l, eta_l, the joints at the landmarks and alpha at B differ slightly between the two weights, mu at B \
         much";
}

/// A variable of a state, and in which direction Milankovitch's weight moves it.
type MovedVariable = (&'static str, bool, fn(&State) -> &Ball);

const ETA: MovedVariable = ("eta larger", true, |state| &state.thickness);
const H: MovedVariable = ("h smaller", false, |state| &state.thrust);
const ETA_SMALLER: MovedVariable = ("eta smaller", false, |state| &state.thickness);
const BETA: MovedVariable = ("beta_r smaller", false, |state| &state.rotation_joint);

/// The relative difference between two values, in percent.
fn percent([heyman, milankovitch]: [&Ball; 2], is_larger: bool) -> Ball {
    let part = milankovitch.clone() / heyman;
    let difference = part.clone() - part.int(1);
    if is_larger { difference * part.int(100) } else { -difference * part.int(100) }
}

/// Notes the relative differences of an arch.
fn note(
    d: &mut Derivation,
    place: &str,
    (alpha, friction): (&str, &str),
    variables: &[MovedVariable],
) -> Checked {
    let [heyman, milankovitch] = both(|weight| state_of(alpha, friction, weight))?;
    for (name, is_larger, value) in variables {
        let percent = percent([value(&heyman), value(&milankovitch)], *is_larger);
        at_most(d, (&format!("{name}, {place}"), &percent, " %"), 3)?;
    }
    Ok(())
}

/// The largest relative differences of rotational states up to some half openings, which are those at these.
fn largest(d: &mut Derivation, openings: &[&str], variables: &[MovedVariable]) -> Checked {
    lemmas(d, ["weights-differences"])?;
    for alpha in openings {
        let place = format!("mu = inf, up to alpha = {alpha}");
        note(d, &place, (alpha, "inf"), variables)?;
    }
    let words = "They grow with the half opening, so that the last of a range is the largest.";
    d.conclude(words)
}

/// Differences of one arch.
fn at(
    d: &mut Derivation,
    arch @ (alpha, friction): (&str, &str),
    variables: &[MovedVariable],
) -> Checked {
    note(d, &format!("mu = {friction}, at alpha = {alpha}"), arch, variables)
}

/// Differences that are said to be slight or much at the landmarks, and whether it is larger for
/// Milankovitch's weight.
const AT_LANDMARKS: &[(Landmark, Unknown, bool)] = &[
    (Landmark::RotationEnd, Unknown::HalfOpening, false),
    (Landmark::RotationEnd, Unknown::Thickness, false),
    (Landmark::Triple, Unknown::RotationJoint, true),
    (Landmark::Shift, Unknown::RotationJoint, true),
    (Landmark::Triple, Unknown::SlidingJoint, true),
    (Landmark::Border, Unknown::SlidingJoint, true),
    (Landmark::Border, Unknown::HalfOpening, false),
    (Landmark::Border, Unknown::Friction, false),
];

fn minimal(d: &mut Derivation) -> Checked {
    largest(d, &["pi/2", "2", "2.4", "2.55"], &[ETA, H])?;
    at(d, ("2.59", "inf"), &[ETA, H])
}

fn marginal(d: &mut Derivation) -> Checked {
    largest(d, &["pi/2"], &[ETA, H, BETA])?;
    let thickness = state_of("pi/2", "inf", SelfWeight::Milankovitch)?.thickness;
    let words = "eta, mu = inf, up to alpha = pi/2, milankovitch weight, the larger one";
    at_most(d, (words, &thickness, ""), 3)?;
    at(d, ("pi/2", "0.31"), &[ETA_SMALLER])
}

fn at_landmarks(d: &mut Derivation) -> Checked {
    for (landmark, unknown, is_larger) in AT_LANDMARKS {
        let [heyman, milankovitch] = both(|weight| along::landmark(*landmark, weight))?;
        let percent = percent([heyman.value(*unknown), milankovitch.value(*unknown)], *is_larger);
        let relation = if *is_larger { "larger" } else { "smaller" };
        let words = format!("{} {relation}, at {landmark}", unknown.name());
        at_most(d, (&words, &percent, " %"), 3)?;
    }
    Ok(())
}
