//! The two self-weights compared at the landmarks.

use super::along::{self, landmark};
use super::landmarks::{both, certain_if};
use super::{Checked, Derivation, Finding, Support, claims, lemmas};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Exact, Undecided};
use crate::judge::{Comparison, Relation, compare_weights};
use crate::number::{Ball, Field, Surd};
use crate::problem::{Fixed, Landmark, Quantity};
use std::sync::OnceLock;

claims! {
    Finds("weights-thickness", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::Thickness)):
        "at T, S, J and B the thickness is lower for Milankovitch's weight";
    Finds("weights-friction", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::Friction)):
        "at T, S, J and B the friction is lower for Milankovitch's weight";
    Finds("weights-opening", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::HalfOpening)):
        "at T, S, J and B the half opening is lower for Milankovitch's weight";
    Finds("weights-thrust", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::Thrust)):
        "at T, S, J and B the thrust is higher for Milankovitch's weight";
    Finds("weights-beta-r", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::RotationJoint)):
        "at T, S, J and B the rotational joint is wider for Milankovitch's weight";
    Finds("weights-beta-s", "Sec. 3, Tables 1-2", |d| compared(d, Quantity::SlidingJoint)):
        "at T, S, J and B the sliding joint is wider for Milankovitch's weight";
    AsPrinted("weights-limits", "Sec. 2.1, Tables 3-4", limits_compared):
        "eta_l, alpha_l and alpha_L are higher for Heyman's weight, A_l and A_L lower";
    Finds("weights-eta-l", "Sec. 3", limit_thickness_compared):
        "the thickness is lower for Milankovitch's weight at l and at L";
    AsPrinted("weights-widest-joint", "Sec. 2.1, Fig. 2", widest_joints_compared):
        "the rotational joint of Heyman's solution overshoots that of Milankovitch's at the peak of beta_r(alpha)";
    AsPrinted("weights-at-B", "Sec. 3", most_at_the_border):
        "among T, S, J and B the two weights differ most at B, in the friction, in the half opening, in the thrust \
         and in the sliding joint";
}

/// The claims of the paper on the two weights, decided once.
fn comparisons() -> Checked<&'static [Comparison]> {
    static DECIDED: OnceLock<Checked<Vec<Comparison>>> = OnceLock::new();
    DECIDED.get_or_init(compare_weights).as_deref().map_err(Clone::clone)
}

fn exact(landmark: Landmark, weight: SelfWeight, quantity: Quantity) -> Checked<Surd> {
    match CertifiedLandmark::new(landmark, weight)?.exact(quantity) {
        Some(Exact::Surd(value)) => Ok(value),
        _ => Err(Undecided::new(format!("{quantity} at {landmark}"))),
    }
}

/// A quantity at T, S, J and B: as claimed, or equal by exact values.
fn compared(d: &mut Derivation, quantity: Quantity) -> Checked<Finding> {
    let mut equalities = Vec::new();
    for comparison in comparisons()?.iter().filter(|c| c.quantity == quantity) {
        let landmark = comparison.landmark;
        let words = format!("{quantity} at {landmark}");
        if comparison.certified == Relation::Equal {
            let [value, other] = both(|weight| exact(landmark, weight, quantity))?;
            d.equal(format!("{words} is the same for both weights"), &other, &value)?;
            equalities.push(format!("{words} is {value} for both weights"));
        } else {
            let words = format!("{words} is {}", comparison.certified.name());
            let weights = match comparison.claimed {
                Relation::Higher => [SelfWeight::Heyman, SelfWeight::Milankovitch],
                _ => [SelfWeight::Milankovitch, SelfWeight::Heyman],
            };
            let [less, more] = weights.map(|weight| along::quantity(landmark, weight, quantity));
            d.less(words, [&less?, &more?])?;
        }
    }
    match equalities.is_empty() {
        true => Ok(Finding::AsPrinted),
        false => Ok(Finding::Equality { at: equalities.join("; ") }),
    }
}

fn limit_thickness_compared(d: &mut Derivation) -> Checked<Finding> {
    let [heyman, milankovitch] = both(|weight| landmark(Landmark::RotationEnd, weight))?;
    d.less("thickness at l is lower", [&milankovitch.thickness, &heyman.thickness])?;
    let ends = [Landmark::OverturningEnd, Landmark::RotationEnd];
    d.certain(Support::Algebra, "at L it is the physical limit", ends, |end| {
        let fixed = |weight| end.system(weight).fixed_value(Unknown::Thickness);
        let is_limit = |weight| fixed(weight) == Some(Fixed::Integer(2));
        Ok(certain_if(SelfWeight::ALL.into_iter().all(is_limit)))
    })?;
    Ok(Finding::Equality { at: "thickness at L is 2 for both weights".to_owned() })
}

fn limits_compared(d: &mut Derivation) -> Checked {
    use {Landmark::*, Quantity::*};
    for (point, quantity, higher) in [
        (RotationEnd, Thickness, false),
        (RotationEnd, OpeningVariable, true),
        (OverturningEnd, OpeningVariable, true),
    ] {
        let [heyman, milankovitch] =
            &both(|weight| Ok(exact(point, weight, quantity)?.enclosure(128)))?;
        let (relation, sides) = match higher {
            true => ("higher", [heyman, milankovitch]),
            false => ("lower", [milankovitch, heyman]),
        };
        d.less(format!("{quantity} at {} is {relation}", point.symbol()), sides)?;
    }
    for point in [RotationEnd, OverturningEnd] {
        let [high, low] = both(|w| landmark(point, w).map(|at| at.half_opening.rad))?;
        d.less(format!("alpha at {} is lower", point.symbol()), [&low, &high])?;
    }
    Ok(())
}

fn widest_joints_compared(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-weights"])?;
    let joint = |weight| landmark(Landmark::WidestJoint, weight).map(|at| at.rotation_joint.rad);
    let [heyman, milankovitch] = both(joint)?;
    d.less("beta_sb is larger for Heyman's weight", [&milankovitch, &heyman])?;
    d.conclude("At the same thickness it is larger everywhere, not only at the peak.")
}

/// At none of the others the difference is as large as at B.
fn most_at_the_border(d: &mut Derivation) -> Checked {
    use Landmark::{Border, Junction, Shift, Triple};
    type LandmarkReading = fn(&Configuration<Ball>) -> &Ball;
    use SelfWeight::{Heyman, Milankovitch};
    let variables: [(&str, SelfWeight, LandmarkReading); 4] = [
        ("mu", Heyman, |at| &at.friction),
        ("alpha", Heyman, |at| &at.half_opening.rad),
        ("h", Milankovitch, |at| &at.thrust),
        ("beta_s", Milankovitch, |at| &at.sliding_joint.rad),
    ];
    for (name, larger, variable) in variables {
        let difference = |point| {
            let [heyman, milankovitch] = both(|weight| landmark(point, weight))?;
            let difference = variable(&heyman).clone() - variable(&milankovitch);
            Ok::<_, Undecided>(if larger == Heyman { difference } else { -difference })
        };
        let most = difference(Border)?;
        for point in [Triple, Shift, Junction] {
            let (symbol, difference) = (point.symbol(), difference(point)?);
            d.less(
                format!("{name} is larger for {larger} weight at {symbol}"),
                [&most.int(0), &difference],
            )?;
            d.less("and differs less there than at B", [&difference, &most])?;
        }
    }
    Ok(())
}
