//! The two self-weights compared at the landmarks.

use super::curve::STATES_OF_ONE_THICKNESS;
use super::landmarks::{certain_if, enclosed};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Exact, Undecided};
use crate::judge::{Comparison, Relation, compare_weights};
use crate::number::Ball;
use crate::problem::{Fixed, Landmark, Quantity};
use std::sync::OnceLock;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "weights-thickness",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the thickness is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Thickness),
    },
    Claim {
        id: "weights-friction",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the friction is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Friction),
    },
    Claim {
        id: "weights-opening",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the half opening is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::HalfOpening),
    },
    Claim {
        id: "weights-thrust",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the thrust is higher for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Thrust),
    },
    Claim {
        id: "weights-beta-r",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the rotational joint is wider for Milankovitch's weight",
        decide: |d| compared(d, Quantity::RotationJoint),
    },
    Claim {
        id: "weights-beta-s",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the sliding joint is wider for Milankovitch's weight",
        decide: |d| compared(d, Quantity::SlidingJoint),
    },
    Claim {
        id: "weights-limits",
        place: "Sec. 2.1, Tables 3-4",
        statement: "eta_l, alpha_l and alpha_L are higher for Heyman's weight, A_l and A_L lower",
        decide: limits_compared,
    },
    Claim {
        id: "weights-eta-l",
        place: "Sec. 3",
        statement: "the thickness is lower for Milankovitch's weight at l and at L",
        decide: limit_thickness_compared,
    },
    Claim {
        id: "weights-widest-joint",
        place: "Sec. 2.1, Fig. 2",
        statement: "the rotational joint of Heyman's solution overshoots that of Milankovitch's at the \
                    peak of beta_r(alpha)",
        decide: widest_joints_compared,
    },
    Claim {
        id: "weights-at-B",
        place: "Sec. 3",
        statement: "among T, S, J and B the two weights differ most at B, in the friction and in the half \
                    opening",
        decide: most_at_the_border,
    },
];

/// The claims of the paper on the two weights, decided once.
fn comparisons() -> Result<&'static [Comparison], Undecided> {
    static DECIDED: OnceLock<Result<Vec<Comparison>, Undecided>> = OnceLock::new();
    DECIDED.get_or_init(compare_weights).as_deref().map_err(Clone::clone)
}

/// A quantity at T, S, J and B: as claimed, or equal by exact values.
fn compared(d: &mut Derivation, quantity: Quantity) -> Result<Finding, Undecided> {
    let mut equalities = Vec::new();
    for comparison in comparisons()?.iter().filter(|c| c.quantity == quantity) {
        let landmark = comparison.landmark;
        let words = format!("{} at {}", quantity.name(), landmark.symbol());
        if comparison.certified == Relation::Equal {
            let exact = |weight| match CertifiedLandmark::new(landmark, weight)?.exact(quantity) {
                Some(Exact::Surd(value)) => Ok(value),
                _ => Err(Undecided::new(format!("{words} is not exact"))),
            };
            let [heyman, milankovitch] = SelfWeight::ALL.map(exact);
            let value = heyman?;
            d.equal(format!("{words} is the same for both weights"), &milankovitch?, &value)?;
            equalities.push(format!("{words} is {value} for both weights"));
        } else {
            let words = format!("{words} is {}", comparison.certified.name());
            let weights = match comparison.claimed {
                Relation::Higher => [SelfWeight::Heyman, SelfWeight::Milankovitch],
                _ => [SelfWeight::Milankovitch, SelfWeight::Heyman],
            };
            let value = |weight| {
                let (point, _) = enclosed(landmark, weight)?;
                let value = point.enclosure(128)?.quantity(quantity);
                value.ok_or_else(|| Undecided::new(words.clone()))
            };
            let [less, more] = weights.map(value);
            d.less(&words, [&less?, &more?])?;
        }
    }
    match equalities.is_empty() {
        true => Ok(Finding::AsPrinted),
        false => Ok(Finding::Equality { at: equalities.join("; ") }),
    }
}

fn limit_thickness_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    let [heyman, milankovitch] =
        SelfWeight::ALL.map(|weight| enclosed(Landmark::RotationEnd, weight));
    d.less("thickness at l is lower", [&milankovitch?.1.thickness, &heyman?.1.thickness])?;
    let ends = [Landmark::OverturningEnd, Landmark::RotationEnd];
    d.certain(Support::Algebra, "at L it is the physical limit", ends, |end| {
        let fixed = |weight| end.system(weight).fixed_value(Unknown::Thickness);
        let is_limit = |weight| fixed(weight) == Some(Fixed::Integer(2));
        Ok(certain_if(SelfWeight::ALL.into_iter().all(is_limit)))
    })?;
    Ok(Finding::Equality { at: "thickness at L is 2 for both weights".to_owned() })
}

fn limits_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    let exact = |landmark: Landmark, weight, quantity: Quantity| match CertifiedLandmark::new(
        landmark, weight,
    )?
    .exact(quantity)
    {
        Some(Exact::Surd(value)) => Ok(value.enclosure(128)),
        _ => Err(Undecided::new(format!("{} at {}", quantity.name(), landmark.symbol()))),
    };
    use {Landmark::*, Quantity::*};
    for (landmark, quantity, higher) in [
        (RotationEnd, Thickness, false),
        (RotationEnd, OpeningVariable, true),
        (OverturningEnd, OpeningVariable, true),
    ] {
        let [heyman, milankovitch] = SelfWeight::ALL.map(|w| exact(landmark, w, quantity));
        let (low, high) = match higher {
            true => (heyman?, milankovitch?),
            false => (milankovitch?, heyman?),
        };
        let relation = if higher { "higher" } else { "lower" };
        let words = format!("{} at {} is {relation}", quantity.name(), landmark.symbol());
        d.less(words, [&low, &high])?;
    }
    for landmark in [RotationEnd, OverturningEnd] {
        let [heyman, milankovitch] = SelfWeight::ALL.map(|w| enclosed(landmark, w));
        let (low, high) = (milankovitch?.1.half_opening.rad, heyman?.1.half_opening.rad);
        let words = format!("alpha at {} is lower", landmark.symbol());
        d.less(words, [&low, &high])?;
    }
    Ok(Finding::AsPrinted)
}

fn widest_joints_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_OF_ONE_THICKNESS)?;
    let joint =
        |weight| enclosed(Landmark::WidestJoint, weight).map(|(_, at)| at.rotation_joint.rad);
    let [heyman, milankovitch] = SelfWeight::ALL.map(joint);
    let words = "beta_sb is larger for Heyman's weight";
    d.less(words, [&milankovitch?, &heyman?])?;
    d.conclude("At the same thickness it is larger everywhere, not only at the peak.");
    Ok(Finding::AsPrinted)
}

/// The differences at T, S, J, B grow in this order.
fn most_at_the_border(d: &mut Derivation) -> Result<Finding, Undecided> {
    use Landmark::{Border, Junction, Shift, Triple};
    type Variable = fn(&Configuration<Ball>) -> &Ball;
    let variables: [(&str, Variable); 2] =
        [("mu", |at| &at.friction), ("alpha", |at| &at.half_opening.rad)];
    for (name, variable) in variables {
        let difference = |landmark| -> Result<Ball, Undecided> {
            let [heyman, milankovitch] = SelfWeight::ALL.map(|weight| enclosed(landmark, weight));
            Ok(variable(&heyman?.1).clone() - variable(&milankovitch?.1))
        };
        for (less, more) in [(Triple, Shift), (Shift, Junction), (Junction, Border)] {
            let words =
                format!("{name} differs less at {} than at {}", less.symbol(), more.symbol());
            d.less(words, [&difference(less)?, &difference(more)?])?;
        }
    }
    Ok(Finding::AsPrinted)
}
