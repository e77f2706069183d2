//! The two self-weights compared: at the landmarks, at the same half opening, on the map.

use super::curve::{STATES_IN_ORDER, STATES_OF_ONE_THICKNESS};
use super::frictions::{FRICTION_FOR_ROTATION_GROWS, SLOPES_OF_FRICTION};
use super::landmarks::{certain_if, enclosed, semicircular_state};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{Landmark, Quantity, SelfWeight, sliding};
use crate::certify::{CertifiedLandmark, Comparison, Exact, Relation, Undecided, compare_weights};
use crate::number::{Angle, Ball, Enclosure, Field, Real, Rounded, Surd};
use std::sync::OnceLock;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "weights-thickness",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the thickness is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Thickness, "lower at T, S and J; at B it is 2 for both"),
    },
    Claim {
        id: "weights-friction",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the friction is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Friction, ""),
    },
    Claim {
        id: "weights-opening",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the half opening is lower for Milankovitch's weight",
        decide: |d| compared(d, Quantity::HalfOpening, ""),
    },
    Claim {
        id: "weights-thrust",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the thrust is higher for Milankovitch's weight",
        decide: |d| compared(d, Quantity::Thrust, ""),
    },
    Claim {
        id: "weights-rotational-joint",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the rotational joint is wider for Milankovitch's weight",
        decide: |d| {
            compared(d, Quantity::RotationJoint, "wider at T and S; at J and B it is 0 for both")
        },
    },
    Claim {
        id: "weights-sliding-joint",
        place: "Sec. 3, Tables 1-2",
        statement: "at T, S, J and B the sliding joint is wider for Milankovitch's weight",
        decide: |d| compared(d, Quantity::SlidingJoint, ""),
    },
    Claim {
        id: "weights-limits",
        place: "Sec. 2.1, Tables 3-4",
        statement: "eta_l, alpha_l and alpha_L are higher for Heyman's weight, A_l and A_L lower",
        decide: limits_compared,
    },
    Claim {
        id: "weights-same-opening",
        place: "Sec. 3",
        statement: "at the same half opening Milankovitch's weight leads to a lower thickness: its \
                    iso-alpha curves lie below Heyman's",
        decide: same_opening_compared,
    },
    Claim {
        id: "weights-widest-joint",
        place: "Sec. 2.1, Fig. 2",
        statement: "the rotational joint of Heyman's solution overshoots that of Milankovitch's at the \
                    peak of beta_r(alpha)",
        decide: widest_joints_compared,
    },
    Claim {
        id: "weights-dividing-lines",
        place: "Sec. 3, Fig. 5",
        statement: "in the eta-mu map the dividing lines of Milankovitch's weight lie always below and \
                    left of Heyman's",
        decide: dividing_lines_compared,
    },
];

/// The claims of the paper on the two weights, decided once.
fn comparisons() -> Result<&'static [Comparison], Undecided> {
    static DECIDED: OnceLock<Result<Vec<Comparison>, Undecided>> = OnceLock::new();
    DECIDED.get_or_init(compare_weights).as_deref().map_err(Clone::clone)
}

/// A quantity at T, S, J and B: as claimed, or equal by exact values, which refutes the claim.
fn compared(
    d: &mut Derivation,
    quantity: Quantity,
    corrected: &'static str,
) -> Result<Finding, Undecided> {
    let mut counterexamples = Vec::new();
    for comparison in comparisons()?.iter().filter(|c| c.quantity == quantity) {
        let landmark = comparison.landmark;
        let words = format!("{} at {}", quantity.name(), landmark.symbol());
        if comparison.certified == Relation::Equal {
            let exact = |weight| match CertifiedLandmark::new(landmark, weight)?.exact(quantity) {
                Some(Exact::Surd(value)) => Ok(value),
                _ => Err(Undecided(format!("{words} is not exact"))),
            };
            let [heyman, milankovitch] = SelfWeight::ALL.map(exact);
            let value = heyman?;
            d.equal(format!("{words} is the same for both weights"), &milankovitch?, &value)?;
            counterexamples.push(format!("{words} is {value} for both weights"));
        } else {
            let strict = comparison.certified == comparison.claimed;
            let words = format!("{words} is {}", comparison.certified.name());
            d.certain(Support::Balls, words, certain_if(strict))?;
        }
    }
    match counterexamples.is_empty() {
        true => Ok(Finding::AsPrinted),
        false => Ok(Finding::Misprint { counterexample: counterexamples.join("; "), corrected }),
    }
}

fn enclosure_of(value: &Surd) -> Ball {
    let (rational, factor, radicand) = value.parts();
    let root = Ball::integer(radicand as i32, 128).sqrt();
    Ball::enclosing(rational, 128) + Ball::enclosing(factor, 128) * root
}

fn limits_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    let exact = |landmark: Landmark, weight, quantity: Quantity| match CertifiedLandmark::new(
        landmark, weight,
    )?
    .exact(quantity)
    {
        Some(Exact::Surd(value)) => Ok(enclosure_of(&value)),
        _ => Err(Undecided(format!("{} at {}", quantity.name(), landmark.symbol()))),
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
        d.certain(Support::Balls, words, low.is_less_than(&high))?;
    }
    for landmark in [RotationEnd, OverturningEnd] {
        let [heyman, milankovitch] = SelfWeight::ALL.map(|w| enclosed(landmark, w));
        let (low, high) = (milankovitch?.1.half_opening.rad, heyman?.1.half_opening.rad);
        let words = format!("alpha at {} is lower", landmark.symbol());
        d.certain(Support::Balls, words, low.is_less_than(&high))?;
    }
    Ok(Finding::AsPrinted)
}

fn same_opening_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_IN_ORDER)?;
    d.lemma(&STATES_OF_ONE_THICKNESS)?;
    d.conclude("As alpha grows with eta, at one half opening the thickness grows with delta_M.");
    let thickness = |weight| semicircular_state(weight).map(|state| state.thickness);
    let [heyman, milankovitch] = SelfWeight::ALL.map(thickness);
    let (heyman, milankovitch) = (heyman?, milankovitch?);
    let words = "the semicircle without limit of friction is thicker for Milankovitch's weight";
    d.certain(Support::Balls, words, heyman.is_less_than(&milankovitch))?;
    Ok(Finding::Misprint {
        counterexample: format!(
            "alpha = pi/2 with unlimited friction: eta = {} for Milankovitch's weight is above {} for \
             Heyman's",
            shown(&milankovitch)?,
            shown(&heyman)?
        ),
        corrected: "at the same half opening the thickness of the purely rotational and of the purely \
                    overturning state is larger for Milankovitch's weight, so that Heyman's is not on \
                    the safe side; at the same thickness the half opening is smaller",
    })
}

fn widest_joints_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_OF_ONE_THICKNESS)?;
    let joint =
        |weight| enclosed(Landmark::WidestJoint, weight).map(|(_, at)| at.rotation_joint.rad);
    let [heyman, milankovitch] = SelfWeight::ALL.map(joint);
    let words = "beta_sb is larger for Heyman's weight";
    d.certain(Support::Balls, words, milankovitch?.is_less_than(&heyman?))?;
    d.conclude("At the same thickness it is larger everywhere, not only at the peak.");
    Ok(Finding::AsPrinted)
}

fn shown(value: &Ball) -> Result<String, Undecided> {
    let rounded = Rounded::from_ball(value, 6).map(|rounded| rounded.value.to_string());
    rounded.ok_or_else(|| Undecided("the semicircle".into()))
}

/// The lines about pure rotation rise: what lies left of such a line lies above it.
fn dividing_lines_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_OF_ONE_THICKNESS)?;
    d.lemma(&SLOPES_OF_FRICTION)?;
    d.lemma(&FRICTION_FOR_ROTATION_GROWS)?;
    d.conclude(
        "On [r,r,r]|[s,r,r] the friction is M, on [r,r,r]|[r,r,s] it is m; both grow with eta. At one \
         thickness alpha and h are smaller for Milankovitch's weight, so that M is smaller, as mu_ss \
         grows with both, and m = mu_is(h) is larger. So the first line lies left of Heyman's and, as it \
         rises, above it; the second lies right of it and below.",
    );
    let states = SelfWeight::ALL.map(|weight| {
        let state = semicircular_state(weight)?;
        let half = state.thrust.pi() / state.thrust.int(2);
        let right = Angle { rad: half, sin: state.thrust.int(1), cos: state.thrust.int(0) };
        Ok((state.thickness, sliding::shoulder(&right, &state.thrust).value()))
    });
    let [heyman, milankovitch]: [Result<(Ball, Ball), Undecided>; 2] = states;
    let (heyman, milankovitch) = (heyman?, milankovitch?);
    let words = "the semicircle's point on the first line is higher for Milankovitch's weight";
    d.certain(Support::Balls, words, heyman.0.is_less_than(&milankovitch.0))?;
    let words = "and further left";
    d.certain(Support::Balls, words, milankovitch.1.is_less_than(&heyman.1))?;
    Ok(Finding::Misprint {
        counterexample: format!(
            "[r,r,r]|[s,r,r] at alpha = pi/2: mu = {}, eta = {} for Milankovitch's weight is left of and \
             above mu = {}, eta = {} for Heyman's, on a line that rises",
            shown(&milankovitch.1)?,
            shown(&milankovitch.0)?,
            shown(&heyman.1)?,
            shown(&heyman.0)?
        ),
        corrected: "Milankovitch's line [r,r,r]|[s,r,r] lies left of Heyman's and above it, \
                    [r,r,r]|[r,r,s] below it and right of it",
    })
}
