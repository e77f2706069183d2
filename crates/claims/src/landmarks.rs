//! The landmark points: what holds beyond the equations that define them.

use super::along::{landmark, parsed, standing};
use super::letters::{ring, variables};
use super::sliding::ratio_without_thrust;
use super::{Checked, Derivation, Support, claims};
use crate::arch::{Ring, SelfWeight, Unknown, contact, overturning, sliding, thrust};
use crate::certify::state::{Certify, State};
use crate::number::{Angle, Ball, Field, Real, Ternary};
use crate::problem::{Fixed, Landmark, Mode};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};
use rug::Rational;

claims! {
    AsPrinted("landmark-T", "Sec. 2.2, Fig. 8", triple_point):
        "at T the mode [r,r,s] meets the other three: (3) holds there too";
    AsPrinted("landmark-S", "Sec. 3, Fig. 9", shift_point):
        "at S, and where beta_r = beta_s, the modes [r,r,s] and [r,s,r] coincide";
    AsPrinted("landmark-J", "Sec. 3, Fig. 10", junction_point):
        "at J the modes [r,s,r] and [r,s] meet: the line of thrust touches the intrados at the crown and has, to \
         first order, the direction of the intrados there";
    Ours("landmark-B", "Fig. 11", border_point):
        "at B, where beta_r = 0, the tangency condition (5) does not hold";
    AsPrinted("landmark-l", "Sec. 3, Tables 3-4", no_thrust_needs_unlimited_friction):
        "states without thrust, l, L and all purely overturning ones, strictly require infinite friction, against \
         inner sliding; and (2) holds at l too";
}

pub(super) fn certain_if(holds: bool) -> Ternary {
    if holds { Ternary::True } else { Ternary::Undecided }
}

fn triple_point(d: &mut Derivation) -> Checked {
    let (at, ring) = (variables(), ring());
    let upper = thrust::upper(&at.half_opening, &at.rotation_joint, &ring).residual(&at.thrust);
    let whole = thrust::whole(&at.half_opening, &ring).residual(&at.thrust);
    let lower = thrust::lower(&at.rotation_joint, &ring).residual(&at.thrust);
    d.identity("(3), cleared, is (4) less (2), cleared", &upper, whole - lower)?;
    for weight in SelfWeight::ALL {
        let at = landmark(Landmark::Triple, weight)?;
        let ring = Ring::new(weight, &at.thickness);
        let (shoulder, haunch) = (&at.half_opening, &at.rotation_joint);
        let arm = |[shoulder, haunch]: [&Angle<Ball>; 2]| {
            thrust::upper(shoulder, haunch, &ring).denominator
        };
        let words = format!("the lever arm in (3) at T, {weight} weight");
        // Between a haunch that is at the shoulder and a shoulder that is at the haunch it is negative.
        d.above_zero(words, [&arm([shoulder, haunch]), &arm([haunch, shoulder])])?;
    }
    d.conclude(
        "T is defined by (2), (4), (5), (17), (18), so (3), (5), (18) hold: those of [r,r,s].",
    )
}

fn shift_point(d: &mut Derivation) -> Checked {
    let [below, above] = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
    for weight in SelfWeight::ALL {
        d.certain(
            Support::Algebra,
            "both modes have the equations (3), (5), (18); only the order of the joints tells them apart",
            [above, Mode::Rotational],
            |other| Ok(certain_if(below.system(weight) == other.system(weight))),
        )?;
        let points = [Landmark::Shift, Landmark::Junction];
        d.certain(Support::Algebra, "S has them all, and beta_r = beta_s", points, |point| {
            let system = point.system(weight);
            let same = system.fixed_value(Unknown::RotationJoint)
                == Some(Fixed::SameAs(Unknown::SlidingJoint));
            let equations = below.system(weight).equations;
            let all = equations.iter().all(|equation| system.equations.contains(equation));
            Ok(certain_if(same && all))
        })?;
    }
    Ok(())
}

fn junction_point(d: &mut Derivation) -> Checked {
    let at = variables();
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &at.thickness);
        let tangency = thrust::tangency(&at.thrust.int(1), &ring).residual(&at.thrust);
        let words = format!(
            "(5) in the limit beta -> 0, cleared, is twice the slope of the distance from the \
             intrados over sin(beta) at the crown, {weight} weight"
        );
        let slope = contact::crown_slope(weight, &at) * at.thrust.int(2);
        d.identity(words, &tangency, &slope)?;
        let words = "J has (3) at beta = 0 and (18), the equations of [r,s]";
        let points = [Landmark::Junction, Landmark::Shift];
        d.certain(Support::Algebra, words, points, |point| {
            let system = point.system(weight);
            let equations = Mode::OverturningSliding.system(weight).equations;
            let all = equations.iter().all(|equation| system.equations.contains(equation));
            let crown = system.fixed_value(Unknown::RotationJoint) == Some(Fixed::Integer(0));
            Ok(certain_if(all && crown))
        })?;
    }
    d.conclude(
        "[r,s] needs this slope not to be negative, and [r,s,r] has the line of thrust touch at \
         beta_r > 0: they meet where it is zero.",
    )
}

fn border_point(d: &mut Derivation) -> Checked {
    let two = Rational::from(2);
    for weight in SelfWeight::ALL {
        let ring = Ring::new(weight, &two);
        let symbolic = Ring::new(weight, &Fraction::from(two.clone()));
        let cotangent = Symbol::joint().times_cotangent();
        let residual = thrust::tangency(&cotangent, &symbolic).residual(&Symbol::Thrust.number());
        let value = two.clone() * &ring.centroid_factor;
        let words =
            format!("(5), cleared, at eta = 2, whatever the joint and the thrust, {weight} weight");
        d.identity(words, &residual, Fraction::from(value.clone()))?;
        d.differ("its residual", &value, &Rational::new())?;
    }
    Ok(())
}

fn no_thrust_needs_unlimited_friction(d: &mut Derivation) -> Checked {
    ratio_without_thrust(d)?;
    d.conclude(
        "It is cot(beta), which is unbounded next to the crown: no finite friction is enough there.",
    )?;
    let none = ring().thickness.int(0);
    let crown = Angle::zero(&none);
    let lower = thrust::lower(&crown, &ring());
    d.identity("(2) at beta = 0 and h = 0", lower.residual(&none), &none)?;
    let double = ring().thickness.int(2) * ring().thickness;
    d.identity("its lever arm, not zero", &lower.denominator, &double)?;
    let moved = lower_moment_slope();
    let words =
        "and the numerator of (2) grows from the crown like beta² times the condition behind (16)";
    d.identity(words, &moved, overturning::end_of_rotation(&ring()) * ring().thickness.int(2))?;
    d.conclude(
        "At l that is zero too, so the line of thrust stays at the intrados to higher order.",
    )
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

/// A value for each of the two self-weights.
pub(super) fn both<T>(of: impl Fn(SelfWeight) -> Checked<T>) -> Checked<[T; 2]> {
    let [heyman, milankovitch] = SelfWeight::ALL.map(of);
    Ok([heyman?, milankovitch?])
}

/// The state of an arch at its least thickness; the half opening and the friction as text.
pub(super) fn state_of(half_opening: &str, friction: &str, weight: SelfWeight) -> Checked<State> {
    standing(parsed(weight, half_opening, friction)?.state(128)?)
}

/// The thickness of a semicircle with unlimited friction, and the friction that its shoulder asks for.
pub(super) fn semicircle(weight: SelfWeight) -> Checked<[Ball; 2]> {
    let State { thickness, thrust, .. } = state_of("pi/2", "inf", weight)?;
    let half = thrust.pi() / thrust.int(2);
    let right = Angle { rad: half, sin: thrust.int(1), cos: thrust.int(0) };
    Ok([thickness, sliding::shoulder(&right, &thrust).value()])
}
