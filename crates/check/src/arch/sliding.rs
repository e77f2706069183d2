//! The sliding equations (17) and (18): the friction a thrust asks for.

use super::{Quotient, statics};
use crate::number::{Angle, Field, Real};

/// Eq. (17), `mu_ss`: the friction at which the shoulder just slides, `-T/N` at `alpha`.
///
/// ```text
/// mu = (h sin(alpha) - alpha cos(alpha)) / (h cos(alpha) + alpha sin(alpha))
/// ```
///
/// `alpha` in `(0, pi)`, rad; `h` in units of `w r`, such that the normal force, the denominator, is
/// positive. Negative where the shoulder would slide the other way.
#[inline(always)]
pub fn shoulder<T: Field>(half_opening: &Angle<T>, thrust: &T) -> Quotient<T> {
    Quotient {
        numerator: -statics::shear_force(half_opening, thrust),
        denominator: statics::normal_force(half_opening, thrust),
    }
}

/// Eq. (17) solved for the thrust, `h_mu`: the largest thrust the shoulder can bear without sliding.
///
/// ```text
/// h = alpha (cos(alpha) + mu sin(alpha)) / (sin(alpha) - mu cos(alpha))
/// ```
///
/// `mu` is not negative; where `mu >= tan(alpha) > 0` the shoulder does not slide at any thrust and the
/// value means nothing.
#[inline(always)]
pub fn shoulder_thrust<T: Field>(half_opening: &Angle<T>, friction: &T) -> Quotient<T> {
    let Angle { rad, sin, cos } = half_opening;
    Quotient {
        numerator: (cos.clone() + friction.clone() * sin) * rad,
        denominator: sin.clone() - friction.clone() * cos,
    }
}

/// Eq. (18), `mu_is`: the friction at which the joint `beta_s` just slides inwards, to be taken where
/// `beta_s² = h (1 - h)` ([`steepest`]).
///
/// ```text
/// mu = ((1-h) cos(beta) - beta sin(beta)) / ((1-h) sin(beta) + beta cos(beta))
/// ```
///
/// `beta` in `[0, pi/2)`, rad, and `h` in `[0, 1]`, in units of `w r`; infinite where both are zero.
#[inline(always)]
pub fn inner<T: Field>(joint: &Angle<T>, thrust: &T) -> Quotient<T> {
    let rest = thrust.int(1) - thrust;
    Quotient {
        numerator: rest.clone() * &joint.cos - joint.rad.clone() * &joint.sin,
        denominator: rest * &joint.sin + joint.rad.clone() * &joint.cos,
    }
}

/// `beta_s² - h (1 - h)`: zero at the joint where `T/N` is largest, so that it slides first.
pub fn steepest<T: Field>(joint: &T, thrust: &T) -> T {
    joint.square() - (thrust.int(1) - thrust) * thrust
}

/// `beta_s = √(h (1 - h))`, rad: the joint where [`steepest`] is zero, for `h` in `[0, 1]`.
pub fn steepest_joint<T: Real>(thrust: &T) -> T {
    ((thrust.int(1) - thrust) * thrust).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    #[test]
    fn the_two_friction_formulas_are_the_statics() {
        // With beta² = h (1-h), (18) is T/N: h = 1/5 and beta = 2/5 make that exact.
        let joint = Angle { rad: Rational::from((2, 5)), sin: (3, 5).into(), cos: (4, 5).into() };
        let h = Rational::from((1, 5));
        assert_eq!(steepest(&joint.rad, &h), 0);
        let ratio = statics::shear_force(&joint, &h) / statics::normal_force(&joint, &h);
        assert_eq!(inner(&joint, &h).value(), ratio);
        assert_ne!(inner(&joint, &(h.clone() * Rational::from(2))).value(), ratio, "false twin");
        let mu = shoulder(&joint, &h).value();
        assert_eq!(shoulder_thrust(&joint, &mu).value(), h);
    }
}
