//! Ties: exact zeros of an arch, which no enclosure tells and arithmetic does.
//!
//! Sines, cosines and tangents of rational angles are irrational (Lambert, Lindemann), and among those of
//! rational multiples of pi few are rational (Niven): a cosine only if it is 0, 1/2 or 1, a tangent only if it
//! is 0 or 1, up to the sign. So an arch of exact numbers is on few of its ties, and they can be named; where the
//! half opening is given by the tangent of its half, all are rational.

use crate::arch::mechanism::Contact;
use crate::number::{ExactNumber, Form, rational_sine_and_cosine, root};
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Arch, Friction};
use num_rational::BigRational;

/// Tells whether `sin(alpha) = mu cos(alpha)`: the friction angle is the half opening, and the shoulder
/// slides at no thrust. False where nobody knows, as for a coefficient that is a multiple of pi.
pub fn friction_angle_is_half_opening(arch: &Arch) -> bool {
    let alpha = arch.half_opening();
    match arch.friction() {
        Friction::Angle(phi) => phi.form() == alpha.form() && phi.factor() == alpha.factor(),
        Friction::Coefficient(mu) => {
            mu.is_rational() && tangent(alpha).as_ref() == Some(mu.factor())
        }
        Friction::Infinite => false,
    }
}

/// Tells whether `2 - eta = (2 + eta) cos(alpha)` for a rational thickness: about the crown's intrados the
/// thrust at the shoulder's extrados has no lever arm.
pub fn has_no_arm_at_crown(arch: &Arch, thickness: &ExactNumber) -> bool {
    // `1 - cos = tan(alpha/2)² (1 + cos)`, so it says that `eta = 2 tan(alpha/2)²`.
    squared_half_tangent(arch.half_opening())
        .is_some_and(|q| q * ratio(2, 1) == *thickness.factor())
}

/// Tells whether the thrust at which a joint slides is exactly zero. Inwards it is `beta cot(beta + phi)`,
/// outwards `beta cot(beta - phi)`: so the joint's angle and that of friction, which lies below a right
/// angle, are one together, or differ by one. Below the crown; false for hinges.
pub fn slides_at_no_thrust(stones: &Stones, friction: &Friction, contact: JointContact) -> bool {
    let (Some(phi), Some(beta)) = (friction_turn(friction), stones.exact_turn(contact.1)) else {
        return false;
    };
    match contact.0 {
        Contact::Inwards => beta + phi == ratio(1, 2),
        Contact::Outwards => beta - phi == ratio(1, 2),
        Contact::Extrados | Contact::Intrados => false,
    }
}

/// The angle of friction over pi where it is rational: a rational tangent is 0 or 1 there.
fn friction_turn(friction: &Friction) -> Option<BigRational> {
    match friction {
        Friction::Angle(phi) => (phi.form() == Form::TimesPi).then(|| phi.factor().clone()),
        Friction::Coefficient(mu) if !mu.is_rational() => None,
        Friction::Coefficient(mu) if *mu.factor() == ratio(0, 1) => Some(ratio(0, 1)),
        Friction::Coefficient(mu) => (*mu.factor() == ratio(1, 1)).then(|| ratio(1, 4)),
        Friction::Infinite => None,
    }
}

/// `tan(alpha)` where it is rational and not zero, below a right angle.
fn tangent(alpha: &ExactNumber) -> Option<BigRational> {
    let q = alpha.factor();
    match alpha.form() {
        Form::TimesPi => (*q == ratio(1, 4)).then(|| ratio(1, 1)),
        Form::TwiceArctangent => Some(q * ratio(2, 1) / (ratio(1, 1) - q * q)),
        Form::ArctangentOfRoot if *q < ratio(0, 1) => root(&(-q).recip()),
        Form::Rational | Form::ArctangentOfRoot => None,
    }
}

/// `tan(alpha/2)²` where it is rational.
fn squared_half_tangent(alpha: &ExactNumber) -> Option<BigRational> {
    let [_, cosine] = rational_sine_and_cosine(alpha);
    cosine.map(|cosine| (ratio(1, 1) - &cosine) / (ratio(1, 1) + cosine))
}

fn ratio(numerator: i32, denominator: i32) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::joint::Grip;
    use crate::arch::{Ring, SelfWeight, sliding, thrust};
    use crate::number::{Angle, Ball, Enclosure, Field};

    fn arch(alpha: &str, mu: &str) -> Arch {
        Arch::parse("heyman", alpha, mu).unwrap()
    }

    /// Every tie that is said to be zero is so, as far as 300 bits tell, and its neighbours are not.
    #[test]
    fn the_ties_are_ties() {
        let friction = |alpha, mu| {
            let given = arch(alpha, mu).given::<Ball>(300);
            sliding::shoulder_thrust(&given.half_opening, &given.friction).denominator
        };
        for (alpha, mu, tie) in [
            ("pi/4", "1", true),
            ("45deg", "1", true),
            ("30deg", "30deg", true),
            ("pi/6", "tan(30deg)", true),
            ("1/2", "tan(0.5)", true),
            ("pi/4", "1.0000000000000000000000001", false),
            ("0.785398163397448309615", "1", false),
            ("3pi/4", "1", false),
            ("1/2", "tan(0.5000000000000000000001)", false),
            ("pi/4", "inf", false),
            ("2atan(1/3)", "3/4", true),
            ("atan(√(1/4))", "1/2", true),
            ("pi-atan(√(1/4))", "1/2", false),
            ("atan(√(3/5))", "tan(atan(√(3/5)))", true),
            ("2atan(1/3)", "tan(2atan(1/3))", true),
            ("2atan(1/3)", "0.7500000000000000000000001", false),
            ("2atan(3)", "3/4", false),
        ] {
            assert_eq!(friction_angle_is_half_opening(&arch(alpha, mu)), tie, "{alpha} {mu}");
            if mu != "inf" {
                assert_eq!(friction(alpha, mu).excludes_zero(), !tie, "{alpha} {mu}");
            }
        }
        let slips = |alpha: &str, stones, mu: &str, contact: Contact, joint| {
            let stones = Stones::equal(stones, alpha.parse().unwrap()).unwrap();
            let friction: Friction = mu.parse().unwrap();
            let at = Angle::new(stones.joint::<Ball>(joint, 300));
            let given = arch(alpha, mu).given::<Ball>(300);
            let one = given.friction.int(1);
            let ring = Ring::new(SelfWeight::Heyman, &one);
            let grip = Grip { shear: one, normal: given.friction };
            let load = contact.row(&at, &ring, &grip).load;
            (slides_at_no_thrust(&stones, &friction, (contact, joint)), !load.excludes_zero())
        };
        use Contact::{Extrados, Intrados, Inwards, Outwards};
        for (alpha, stones, mu, contact, joint, tie) in [
            ("2pi/3", 8, "60deg", Inwards, 1, true),
            ("2pi/3", 8, "60deg", Inwards, 2, false),
            ("2pi/3", 8, "60deg", Outwards, 1, false),
            ("3pi/4", 9, "45deg", Outwards, 4, true),
            ("3pi/4", 9, "1", Outwards, 4, true),
            ("3pi/4", 9, "1", Inwards, 1, true),
            ("3pi/4", 9, "1", Inwards, 4, false),
            ("3pi/4", 9, "1.0000000000000000000000001", Outwards, 4, false),
            ("2.356194490192344928846", 9, "1", Outwards, 4, false),
            ("pi/2", 4, "0", Inwards, 2, true),
            ("pi/2", 4, "0", Outwards, 2, true),
            ("3pi/4", 9, "45deg", Intrados, 4, false),
            ("3pi/4", 9, "45deg", Extrados, 4, false),
        ] {
            let found = slips(alpha, stones, mu, contact, joint);
            assert_eq!(found, (tie, tie), "{alpha} {stones} {mu} {contact:?} {joint}");
        }
        let arm = |alpha: &str, eta: &str| {
            let given = arch(alpha, "1").given::<Ball>(300);
            let ring =
                Ring::new(SelfWeight::Heyman, &eta.parse::<ExactNumber>().unwrap().enclosure(300));
            let crown = Angle::zero(&given.thrust);
            thrust::upper(&given.half_opening, &crown, &ring).denominator
        };
        for (alpha, eta, tie) in [
            ("60deg", "2/3", true),
            ("pi/2", "2", true),
            ("60deg", "0.66666666666666666666666666666", false),
            ("1.0471975511965977462", "2/3", false),
            ("pi/2", "2/3", false),
            ("2atan(1/2)", "0.5", true),
            // cos = 2/3.
            ("atan(√(5/4))", "2/5", true),
            ("atan(√(5/4))", "0.40000000000000000000000001", false),
            ("2atan(1)", "2", true),
            ("2atan(1/2)", "0.50000000000000000000000001", false),
        ] {
            assert_eq!(
                has_no_arm_at_crown(&arch(alpha, "1"), &eta.parse().unwrap()),
                tie,
                "{alpha} {eta}"
            );
            assert_eq!(arm(alpha, eta).excludes_zero(), !tie, "{alpha} {eta}");
        }
    }
}
