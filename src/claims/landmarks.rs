//! The landmark points: what holds besides the equations that define them, the two self-weights
//! compared, and the values that the text gives to few digits.

use super::curve::{one_joint_for_each_thickness, states_in_order};
use super::{Claim, Derivation, Finding, Support};
use crate::arch::{
    Configuration, Fixed, Landmark, Mode, Quantity, Ring, SelfWeight, Unknown, contact, cubic,
    overturning, sliding, statics, thrust,
};
use crate::certify::state::{Arch, Friction, Outcome, State};
use crate::certify::{
    CertifiedLandmark, Comparison, Exact, Relation, Undecided, compare_weights,
};
use crate::number::{
    Angle, Ball, Decimal, Enclosure, ExactNumber, Field, Real, Rounded, Surd, Ternary,
    arctangent,
};
use crate::symbolic::{Fraction, Polynomial, Relations, Symbol, along_the_joint};
use rug::Rational;
use std::sync::OnceLock;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        id: "triple-point",
        place: "Sec. 2.2, Fig. 8",
        statement: "at T the mode [r,r,s] meets the other three: (3) holds there besides",
        decide: triple_point,
    },
    Claim {
        id: "shift-point",
        place: "Sec. 3, Fig. 9",
        statement: "at S, and where beta_r = beta_s, the modes [r,r,s] and [r,s,r] coincide",
        decide: shift_point,
    },
    Claim {
        id: "junction-point",
        place: "Sec. 3, Fig. 10",
        statement: "at J the modes [r,s,r] and [r,s] meet: the line of thrust touches the intrados at \
                    the crown and has, to first order, the direction of the intrados there",
        decide: junction_point,
    },
    Claim {
        id: "border-point",
        place: "Fig. 11",
        statement: "at B, where beta_r = 0, the tangency condition (5) does not hold",
        decide: border_point,
    },
    Claim {
        id: "no-thrust-needs-unlimited-friction",
        place: "Sec. 3, Tables 3-4",
        statement: "states without thrust, l, L and all purely overturning ones, strictly require \
                    infinite friction, against inner sliding; and (2) holds at l besides",
        decide: no_thrust_needs_unlimited_friction,
    },
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
        id: "rounded-values",
        place: "Sec. 2.1-5, Fig. 7-12",
        statement: "the values given to few digits, such as beta_r = 59.7° at T, are roundings of the \
                    true ones",
        decide: rounded_values,
    },
    Claim {
        id: "semicircle",
        place: "Sec. 5",
        statement: "for the semicircle a friction of about 0.395, 22°, suffices to prevent sliding of \
                    the shoulder and warrants purely rotational collapse",
        decide: semicircle,
    },
];

/// All variables as letters; the sliding joint is the joint.
fn letters() -> Configuration<Fraction> {
    Configuration {
        half_opening: Symbol::half_opening(),
        rotation_joint: Symbol::joint(),
        sliding_joint: Symbol::joint(),
        thickness: Symbol::Thickness.number(),
        thrust: Symbol::Thrust.number(),
        friction: Symbol::Friction.number(),
    }
}

fn ring() -> Ring<Fraction> {
    Ring::with_flag(&Symbol::Flag.number(), &Symbol::Thickness.number())
}

fn certain_if(holds: bool) -> Ternary {
    if holds { Ternary::True } else { Ternary::Undecided }
}

fn triple_point(d: &mut Derivation) -> Result<Finding, Undecided> {
    let (at, ring) = (letters(), ring());
    let upper = thrust::upper(&at.half_opening, &at.rotation_joint, &ring).residual(&at.thrust);
    let whole = thrust::whole(&at.half_opening, &ring).residual(&at.thrust);
    let lower = thrust::lower(&at.rotation_joint, &ring).residual(&at.thrust);
    let words = "(3), cleared, is (4) less (2), cleared";
    d.identity(words, &upper, &(whole - lower), &Relations::none())?;
    for weight in SelfWeight::ALL {
        let arm = {
            let at = enclosed(Landmark::Triple, weight)?.1;
            let ring = Ring::new(weight, &at.thickness);
            thrust::upper(&at.half_opening, &at.rotation_joint, &ring).denominator
        };
        let words = format!("the lever arm in (3) at T, {} weight", weight.name());
        d.certain(Support::Balls, words, arm.is_positive())?;
    }
    d.conclude(
        "T is defined by (2), (4), (5), (17), (18), so (3), (5), (18) hold: those of [r,r,s].",
    );
    Ok(Finding::AsPrinted)
}

fn shift_point(d: &mut Derivation) -> Result<Finding, Undecided> {
    let [below, above] = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
    d.certain(
        Support::Algebra,
        "both modes have the equations (3), (5), (18); only the order of the joints tells them apart",
        certain_if(below.system() == above.system()),
    )?;
    for weight in SelfWeight::ALL {
        let system = Landmark::Shift.system(weight);
        let same = system.fixed_value(Unknown::RotationJoint)
            == Some(Fixed::SameAs(Unknown::SlidingJoint));
        let all = below.system().1.iter().all(|equation| system.equations.contains(equation));
        d.certain(
            Support::Algebra,
            "S has them all, and beta_r = beta_s",
            certain_if(same && all),
        )?;
    }
    Ok(Finding::AsPrinted)
}

fn junction_point(d: &mut Derivation) -> Result<Finding, Undecided> {
    let at = letters();
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &at.thickness);
        let tangency = thrust::tangency(&at.thrust.int(1), &ring).residual(&at.thrust);
        let words = format!(
            "(5) in the limit beta -> 0, cleared, is twice the slope of the distance from the \
             intrados over sin(beta) at the crown, {} weight",
            weight.name()
        );
        let slope = contact::crown_slope(weight, &at) * at.thrust.int(2);
        d.identity(words, &tangency, &slope, &Relations::none())?;
        let system = Landmark::Junction.system(weight);
        let (_, equations) = Mode::OverturningSliding.system();
        let all = equations.iter().all(|equation| system.equations.contains(equation));
        let crown = system.fixed_value(Unknown::RotationJoint) == Some(Fixed::Integer(0));
        let words = "J has (3) at beta = 0 and (18), the equations of [r,s]";
        d.certain(Support::Algebra, words, certain_if(all && crown))?;
    }
    d.conclude(
        "[r,s] needs this slope not to be negative, and [r,s,r] has the line of thrust touch at \
         beta_r > 0: they meet where it is zero.",
    );
    Ok(Finding::AsPrinted)
}

fn border_point(d: &mut Derivation) -> Result<Finding, Undecided> {
    let two = Rational::from(2);
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &two);
        let symbolic = Ring::new(weight, &Fraction::from(two.clone()));
        let cotangent = Symbol::joint().times_cotangent();
        let residual = thrust::tangency(&cotangent, &symbolic).residual(&Symbol::Thrust.number());
        let value = two.clone() * &ring.centroid_factor;
        let words = format!("(5), cleared, at eta = 2, {} weight", weight.name());
        d.identity(words, &residual, &value.clone().into(), &Relations::none())?;
        d.differ("its residual", &value, &Rational::new())?;
    }
    d.conclude("(5) holds at no joint and for no thrust at eta = 2, at B in particular.");
    Ok(Finding::Implicit)
}

fn no_thrust_needs_unlimited_friction(d: &mut Derivation) -> Result<Finding, Undecided> {
    let joint = Symbol::joint();
    let none = joint.rad.int(0);
    let (shear, normal) =
        (statics::shear_force(&joint, &none), statics::normal_force(&joint, &none));
    let ratio = joint.cos.clone() / &joint.sin;
    d.identity("T/N at any joint where h = 0", &(shear / normal), &ratio, &Relations::none())?;
    d.conclude(
        "It is cot(beta), which is unbounded next to the crown: no finite friction is enough there.",
    );
    let crown = Angle::zero(&none);
    let lower = thrust::lower(&crown, &ring());
    d.identity("(2) at beta = 0 and h = 0", &lower.residual(&none), &none, &Relations::none())?;
    let double = ring().thickness.int(2) * ring().thickness;
    d.identity("its lever arm, not zero", &lower.denominator, &double, &Relations::none())?;
    let moved = lower_moment_slope();
    d.identity(
        "and the numerator of (2) grows from the crown like beta² times the condition behind (16)",
        &moved,
        &(overturning::end_of_rotation(&ring()) * ring().thickness.int(2)),
        &Relations::none(),
    )?;
    d.conclude(
        "At l that is zero too, so the line of thrust stays at the intrados to higher order.",
    );
    Ok(Finding::AsPrinted)
}

/// The second derivative of the numerator of (2) to `beta`, at the crown.
fn lower_moment_slope() -> Fraction {
    let rules = along_the_joint();
    let numerator = thrust::lower(&Symbol::joint(), &ring()).numerator;
    let bend = numerator.derivative(&rules).derivative(&rules);
    let crown = |symbol: Symbol| match symbol {
        Symbol::Joint | Symbol::Sine => bend.int(0),
        Symbol::Cosine => bend.int(1),
        other => other.number(),
    };
    bend.evaluate(&bend, crown)
}

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

/// At one thickness, `A` grows with `delta_M`; so at one half opening the thickness does.
fn same_opening_compared(d: &mut Derivation) -> Result<Finding, Undecided> {
    one_joint_for_each_thickness(d)?;
    states_in_order(d)?;
    let (joint, ring, eta) = (Symbol::joint(), ring(), Symbol::Thickness.number());
    let lower = thrust::lower(&joint, &ring);
    let opening = lower.value() + overturning::opening_variable(&ring).value();
    let by_flag = [(Symbol::Flag, Polynomial::from(1))];
    let expected =
        eta.square() * &eta * &joint.cos / (eta.int(3) * &lower.denominator * ring.extrados());
    d.identity(
        "the derivative of A = h_L + 2 fac/(2 + eta) to delta_M, at a fixed joint and thickness",
        &opening.derivative(&by_flag),
        &expected,
        &Relations::none(),
    )?;
    let at_right_angle = |delta: &Ball, eta: &Ball| {
        let half = eta.pi() / eta.int(2);
        let right = Angle { rad: half, sin: eta.int(1), cos: eta.int(0) };
        cubic::in_thickness(&cubic::abbreviations(&right), delta, eta)
    };
    let (zero, two) = (Rational::new(), Rational::from(2));
    d.positive("p at beta = pi/2 with delta_M = 0, as a function of eta,", (&zero, &two), |eta| {
        at_right_angle(&eta.int(0), eta)
    })?;
    let overturned = overturning::opening_variable(&ring).value().derivative(&by_flag);
    let gain = eta.square() / (eta.int(6) * ring.extrados());
    d.identity("the derivative of (13) to delta_M", &overturned, &gain, &Relations::none())?;
    d.conclude(
        "The cubic grows with delta_M, so that it is positive at pi/2 for 0 <= delta_M <= 1: that every rotational joint is above \
         it and cos(beta) > 0. By the curve, dA/d delta_M is this partial derivative, since h_L is \
         stationary in beta: positive. So at one thickness alpha falls with delta_M, for rotation and \
         for overturning; as alpha grows with eta, at one half opening the thickness grows.",
    );
    let thickness = |weight| semicircular_state(weight).map(|state| state.thickness);
    let [heyman, milankovitch] = SelfWeight::ALL.map(thickness);
    let (heyman, milankovitch) = (heyman?, milankovitch?);
    let words = "the semicircle without limit of friction is thicker for Milankovitch's weight";
    d.certain(Support::Balls, words, heyman.is_less_than(&milankovitch))?;
    let shown = |value: &Ball| {
        Rounded::from_ball(value, 8)
            .map(|rounded| rounded.value.to_string())
            .ok_or_else(|| Undecided("the thickness of the semicircle".into()))
    };
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

/// A landmark with its variables.
fn enclosed(
    landmark: Landmark,
    weight: SelfWeight,
) -> Result<(CertifiedLandmark, Configuration<Ball>), Undecided> {
    let point = CertifiedLandmark::new(landmark, weight)?;
    let at = point.enclosure(128)?.configuration();
    Ok((point, at))
}

/// The state of the semicircle without limit of friction.
fn semicircular_state(weight: SelfWeight) -> Result<State, Undecided> {
    let alpha: ExactNumber = "pi/2".parse().map_err(|e| Undecided(format!("{e}")))?;
    let arch =
        Arch::new(weight, alpha, Friction::Infinite).map_err(|e| Undecided(e.to_string()))?;
    match arch.state(128) {
        Ok(Outcome::Stands(state)) if state.mode == Mode::Rotational => Ok(*state),
        Ok(_) => Err(Undecided("the state is not purely rotational".into())),
        Err(doubt) => Err(Undecided(doubt.question.into())),
    }
}

/// The values to few digits: landmark, weight, quantity, text, places where it stands.
const ROUNDED: &[(Landmark, SelfWeight, Quantity, &[&str])] = {
    use {Landmark::*, Quantity::*, SelfWeight::*};
    &[
        (WidestJoint, Milankovitch, RotationJointDegrees, &["64.2"]),
        (WidestJoint, Milankovitch, HalfOpeningDegrees, &["125.8"]),
        (RotationEnd, Milankovitch, HalfOpeningDegrees, &["148.4", "1.5e2"]),
        (RotationEnd, Milankovitch, Thickness, &["0.93"]),
        (RotationEnd, Heyman, HalfOpeningDegrees, &["151.7", "1.5e2"]),
        (OverturningEnd, Heyman, HalfOpeningDegrees, &["159.7", "1.6e2"]),
        (OverturningEnd, Milankovitch, HalfOpeningDegrees, &["151.7", "1.5e2"]),
        (Triple, Milankovitch, HalfOpening, &["2.43"]),
        (Triple, Milankovitch, HalfOpeningDegrees, &["139.2", "139", "1.4e2"]),
        (Triple, Milankovitch, Friction, &["1.277"]),
        (Triple, Milankovitch, FrictionAngleDegrees, &["51.9", "52", "5e1"]),
        (Triple, Milankovitch, RotationJointDegrees, &["59.7", "60"]),
        (Triple, Milankovitch, SlidingJointDegrees, &["18.3", "2e1"]),
        (Shift, Milankovitch, HalfOpeningDegrees, &["145.0", "145"]),
        (Shift, Milankovitch, FrictionAngleDegrees, &["57.0", "57"]),
        (Shift, Milankovitch, SlidingJointDegrees, &["16.0", "16"]),
        (Junction, Milankovitch, HalfOpeningDegrees, &["145.2"]),
        (Junction, Milankovitch, FrictionAngleDegrees, &["57.1"]),
        (Junction, Milankovitch, SlidingJointDegrees, &["16.0"]),
        (Border, Milankovitch, HalfOpeningDegrees, &["150.3", "150"]),
        (Border, Milankovitch, Friction, &["1.854"]),
        (Border, Milankovitch, FrictionAngleDegrees, &["61.7", "62", "6e1"]),
        (Border, Milankovitch, SlidingJointDegrees, &["13.9", "14"]),
    ]
};

/// Checks that `text` is the value rounded to its digits.
fn rounds_to(d: &mut Derivation, words: &str, value: &Ball, text: &str) -> Result<(), Undecided> {
    let printed: Decimal = text.parse().map_err(|e| Undecided(format!("{e}")))?;
    let rounded = Rounded::from_ball(value, printed.significant_digits())
        .ok_or_else(|| Undecided(format!("the rounding of {words}")))?;
    d.equal(
        format!("{words} to the digits of {text}"),
        &rounded.value.to_rational(),
        &printed.to_rational(),
    )
}

fn rounded_values(d: &mut Derivation) -> Result<Finding, Undecided> {
    for (landmark, weight, quantity, texts) in ROUNDED {
        let point = CertifiedLandmark::new(*landmark, *weight)?;
        let words = format!("{} at {}, {}", quantity.name(), landmark.symbol(), weight.name());
        let value = point
            .quantity(&point.enclosure(128)?, *quantity)
            .ok_or_else(|| Undecided(words.clone()))?;
        for text in *texts {
            rounds_to(d, &words, &value, text)?;
        }
    }
    Ok(Finding::AsPrinted)
}

fn semicircle(d: &mut Derivation) -> Result<Finding, Undecided> {
    for (weight, text) in [(SelfWeight::Milankovitch, "0.395"), (SelfWeight::Heyman, "0.396")] {
        let state = semicircular_state(weight)?;
        let half = state.thrust.pi() / state.thrust.int(2);
        let right = Angle { rad: half, sin: state.thrust.int(1), cos: state.thrust.int(0) };
        let friction = sliding::shoulder(&right, &state.thrust).value();
        let words = format!("the friction the shoulder asks for, {} weight,", weight.name());
        rounds_to(d, &words, &friction, text)?;
        let degrees = arctangent(&friction) * friction.int(180) / friction.pi();
        rounds_to(d, &format!("its angle in degrees, {} weight,", weight.name()), &degrees, "22")?;
        let joint = (state.thrust.clone() * (state.thrust.int(1) - &state.thrust)).sqrt();
        let inner = sliding::inner(&Angle::new(joint), &state.thrust).value();
        let words = format!("an inner joint asks for less, {} weight", weight.name());
        d.certain(Support::Balls, words, inner.is_less_than(&friction))?;
        let printed = Ball::enclosing(&Rational::from((395, 1000)), 128);
        let words = format!("it asks for more than 0.395 exactly, {} weight", weight.name());
        d.certain(Support::Balls, words, printed.is_less_than(&friction))?;
    }
    d.conclude(
        "0.395 is the rounded value for Milankovitch's weight; for Heyman's it is 0.396. Both round \
         down: 0.395 itself is a little too small.",
    );
    Ok(Finding::AsPrinted)
}
