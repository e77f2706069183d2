//! The two self-weights compared: at the landmarks, at the same half opening, on the map.

use super::curve::{STATES_IN_ORDER, STATES_OF_ONE_THICKNESS};
use super::frictions::{FRICTION_FOR_ROTATION_GROWS, SLOPES_OF_FRICTION};
use super::landmarks::{certain_if, enclosed, state_of};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{Ring, SelfWeight, sliding, statics, thrust};
use crate::certify::{CertifiedLandmark, Exact, Undecided};
use crate::judge::{Comparison, Relation, compare_weights};
use crate::number::{Angle, Ball, Enclosure, Field, Real, Rounded};
use crate::problem::{Landmark, Mode, Quantity};
use crate::symbolic::{Letters, Polynomial, Relations, Symbol};
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
    WHERE_THE_SHOULDER_TURNS,
    WHERE_THE_JOINT_IS_GIVEN,
    Claim {
        id: "weights-same-opening",
        place: "Sec. 3",
        statement: "in the eta-mu map the curves of one half opening lie lower for Milankovitch's weight: \
                    Heyman's is on the safe side",
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

const WHERE_THE_SHOULDER_TURNS: Claim = Claim {
    id: "weights-shoulder-turns",
    place: "Sec. 3",
    statement: "where the shoulder turns about the extrados, (3), the same thrust and half opening mean a \
                larger thickness for Milankovitch's weight",
    decide: thickness_where_the_shoulder_turns,
};

const WHERE_THE_JOINT_IS_GIVEN: Claim = Claim {
    id: "weights-joint-given",
    place: "Sec. 3",
    statement: "where the line of thrust touches the intrados, (5), the same thrust and joint mean a \
                smaller thickness for Milankovitch's weight",
    decide: thickness_where_the_joint_is_given,
};

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
            let strict = comparison.certified == comparison.claimed;
            let words = format!("{words} is {}", comparison.certified.name());
            d.certain(Support::Balls, words, certain_if(strict))?;
        }
    }
    match equalities.is_empty() {
        true => Ok(Finding::AsPrinted),
        false => Ok(Finding::Equality { at: equalities.join("; ") }),
    }
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

/// Where the shoulder turns, (3) gives the thickness of a given thrust and half opening.
fn thickness_where_the_shoulder_turns(d: &mut Derivation) -> Result<Finding, Undecided> {
    let (alpha, joint, h) = (Symbol::half_opening(), Symbol::joint(), Symbol::Thrust.number());
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    d.assume("0 < eta < 2, 0 <= delta_M <= 1, N(beta) > 0, beta < alpha");
    let free = Relations::none();
    let margin = -(thrust::upper(&alpha, &joint, &ring).residual(&h) / h.int(2));
    let drop = joint.cos.clone() - &alpha.cos;
    let (extrados, intrados) = (ring.extrados() / h.int(2), ring.intrados() / h.int(2));
    let sum = extrados * statics::normal_force(&alpha, &h)
        - intrados * statics::normal_force(&joint, &h)
        - drop.clone() * &ring.centroid_factor;
    d.identity(
        "W, which vanishes where (3) holds, is the sum of the distances of the shoulder from the extrados \
         and of a joint from the intrados",
        &margin,
        &sum,
        &free,
    )?;
    let by = |symbol| [(symbol, Polynomial::from(1))];
    d.identity(
        "dW/d delta_M, negative",
        &margin.derivative(&by(Symbol::Flag)),
        &-(eta.square() * &drop / eta.int(12)),
        &free,
    )?;
    let rest = eta.int(12) * (eta.int(1) - &delta) + delta * ring.intrados() * (eta.int(6) + &eta);
    let normal = statics::normal_force(&joint, &h);
    d.identity(
        "(2 + eta) dW/d eta less W, positive",
        &(margin.derivative(&by(Symbol::Thickness)) * ring.extrados() - &margin),
        &(h.int(2) * normal + drop * rest / h.int(12)),
        &free,
    )?;
    d.conclude(
        "So W/(2 + eta) grows with eta, and W falls as delta_M grows. Let a state of thickness eta_0 have \
         delta_M = 0, W = 0 at its joint, and an admissible one of thickness eta_1 have delta_M = 1 and \
         the shoulder on the extrados, so that W >= 0 at each joint. With delta_M = 1, W < 0 at eta_0 and \
         the joint of the first, and W >= 0 there at eta_1: eta_0 < eta_1.",
    );
    Ok(Finding::Implicit)
}

/// (5) gives the thickness of a given thrust and joint.
fn thickness_where_the_joint_is_given(d: &mut Derivation) -> Result<Finding, Undecided> {
    let (eta, delta) = (Symbol::Thickness.number(), Symbol::Flag.number());
    let ring = Ring::with_flag(&delta, &eta);
    d.assume("0 < eta < 2, 0 <= delta_M <= 1");
    let thrust = thrust::tangency(&Symbol::joint().times_cotangent(), &ring).value();
    let by = |symbol| [(symbol, Polynomial::from(1))];
    let slope = -(eta.square() / (eta.int(6) * ring.intrados()));
    let words = "the derivative of h_e to delta_M, negative";
    d.identity(words, &thrust.derivative(&by(Symbol::Flag)), &slope, &Relations::none())?;
    let gain = delta * &eta * ring.intrados() / eta.int(3) + eta.int(2) * &ring.centroid_factor;
    let slope = -(gain / ring.intrados().square());
    let words = "the derivative of h_e to eta, negative";
    d.identity(words, &thrust.derivative(&by(Symbol::Thickness)), &slope, &Relations::none())?;
    d.conclude("So with the thrust and the joint kept, the thickness falls as delta_M grows.");
    Ok(Finding::Implicit)
}

fn same_opening_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&STATES_IN_ORDER)?;
    d.lemma(&STATES_OF_ONE_THICKNESS)?;
    d.lemma(&WHERE_THE_SHOULDER_TURNS)?;
    d.conclude(
        "Pure rotation and overturning: alpha grows with eta and, at one eta, falls with delta_M; so at \
         one half opening the thickness grows with delta_M. [r,r,s], [r,s,r] and [r,s]: friction gives \
         the thrust by (18), and with (3) the thickness grows with delta_M. [s,r,r]: friction gives the \
         thrust by (17), and with (2) and (5), where h falls with eta and with delta_M, the thickness \
         falls with delta_M.",
    );
    let mut counterexamples = Vec::new();
    for (alpha, friction) in [("pi/2", None), ("2.6", Some("1.9"))] {
        let [heyman, milankovitch] = SelfWeight::ALL.map(|w| state_of(alpha, friction, w));
        let (heyman, milankovitch) = (heyman?.thickness, milankovitch?.thickness);
        let place = format!("at alpha = {alpha}, mu = {}", friction.unwrap_or("inf"));
        let words = format!("{place} the thickness is larger for Milankovitch's weight");
        d.certain(Support::Balls, words, heyman.is_less_than(&milankovitch))?;
        let (eta, other) = (shown(&milankovitch)?, shown(&heyman)?);
        counterexamples.push(format!("{place}: eta = {eta}, but {other} for Heyman's weight"));
    }
    let [heyman, milankovitch] = SelfWeight::ALL.map(|w| state_of("pi/2", Some("0.38"), w));
    let (heyman, milankovitch) = (heyman?, milankovitch?);
    let words = "the semicircle with mu = 0.38 slides at its shoulder, for both weights";
    let slides = [&heyman, &milankovitch].iter().all(|s| s.mode == Mode::SlidingRotational);
    d.certain(Support::Balls, words, certain_if(slides))?;
    let words = "it is thinner for Milankovitch's weight";
    d.certain(Support::Balls, words, milankovitch.thickness.is_less_than(&heyman.thickness))?;
    Ok(Finding::Misprint {
        counterexample: counterexamples.join("; "),
        corrected: "at the same half opening and friction the thickness is smaller for Milankovitch's \
                    weight if the shoulder slides with both weights, [s,r,r]; it is larger, so that \
                    Heyman's weight is not on the safe side, if the collapse is purely rotational with \
                    both, or has an inner sliding joint with both",
    })
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
    d.lemma(&WHERE_THE_SHOULDER_TURNS)?;
    d.lemma(&WHERE_THE_JOINT_IS_GIVEN)?;
    d.conclude(
        "On the other lines friction gives the thrust by (18) and, on those about pure sliding, the half \
         opening too, the same for both weights. On [s,r,r]|[s,s] the thickness follows from (2) and (5), \
         on [r,r,s]|[r,s,r] and [r,s,r]|[r,s] from (5) at beta_s or at the crown: it is smaller for \
         Milankovitch's weight. On the lines from T to B about pure sliding it follows from (3): it is \
         larger.",
    );
    let states = SelfWeight::ALL.map(|weight| {
        let state = state_of("pi/2", None, weight)?;
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
        corrected: "at the same friction Milankovitch's lines lie above Heyman's where they are \
                    [r,r,r]|[s,r,r] or, from T to B, bound pure sliding; the others, [r,r,r]|[r,r,s], \
                    [s,r,r]|[s,s], [r,r,s]|[r,s,r] and [r,s,r]|[r,s], lie below",
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
    rounded.ok_or_else(|| Undecided::new("the semicircle"))
}
