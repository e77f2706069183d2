//! What is exactly zero in an arch, which no enclosure tells and arithmetic does.
//!
//! Sines, cosines and tangents of rational angles are irrational (Lambert, Lindemann), and among those of
//! rational multiples of pi few are rational (Niven): a cosine only if it is 0, 1/2 or 1, a tangent only if it
//! is 0 or 1, up to the sign. So an arch of exact numbers is on few of its ties, and they can be named.

use super::{Arch, Friction};
use crate::number::ExactNumber;
use num_rational::BigRational;

/// Whether `sin(alpha) = mu cos(alpha)`: the friction angle is the half opening, and the shoulder slides at no
/// thrust. False where nobody knows, as for a coefficient that is a multiple of pi.
pub fn friction_angle_is_half_opening(arch: &Arch) -> bool {
    let alpha = arch.half_opening();
    match arch.friction() {
        Friction::Angle(phi) => {
            phi.is_rational() == alpha.is_rational() && phi.factor() == alpha.factor()
        }
        Friction::Coefficient(mu) => {
            mu.is_rational() && *mu.factor() == ratio(1, 1) && is_part_of_pi(alpha, 4)
        }
        Friction::Infinite => false,
    }
}

/// Whether `2 - eta = (2 + eta) cos(alpha)` for a rational thickness: about the crown's intrados the thrust at
/// the shoulder's extrados has no lever arm.
pub fn has_no_arm_at_crown(arch: &Arch, thickness: &ExactNumber) -> bool {
    let is = |divisor, numerator, denominator| {
        is_part_of_pi(arch.half_opening(), divisor)
            && *thickness.factor() == ratio(numerator, denominator)
    };
    is(3, 2, 3) || is(2, 2, 1)
}

fn is_part_of_pi(x: &ExactNumber, divisor: i32) -> bool {
    !x.is_rational() && *x.factor() == ratio(1, divisor)
}

fn ratio(numerator: i32, denominator: i32) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

#[cfg(all(test, feature = "mpfr"))]
mod tests {
    use super::*;
    use crate::arch::{Ring, SelfWeight, sliding, thrust};
    use crate::number::{Angle, Ball, Enclosure};

    fn arch(alpha: &str, mu: &str) -> Arch {
        Arch::parse("heyman", alpha, mu).unwrap()
    }

    /// What is said to be zero is, as far as 300 bits tell, and its neighbours are not.
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
        ] {
            assert_eq!(friction_angle_is_half_opening(&arch(alpha, mu)), tie, "{alpha} {mu}");
            if mu != "inf" {
                assert_eq!(friction(alpha, mu).excludes_zero(), !tie, "{alpha} {mu}");
            }
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
