//! Sliding in angles: the inclination of the force on a joint, the friction angle, and a cycloid.
//!
//! The force on the joint at `beta` is inclined by `atan(beta/h)` to the horizontal, so that `T/N =
//! tan(atan(beta/h) - beta)`. An inner joint slides where that is steepest; with the inclination `chi` there
//!
//! ```text
//! h = cos² chi,   beta_s = sin chi cos chi,   phi = chi - sin chi cos chi                        (18)
//! h = alpha cot(alpha - phi)                                                                     (17)
//! ```
//!
//! The first is a cycloid, `(2 phi, 2 (1 - h)) = (t - sin t, 1 - cos t)` with `t = 2 chi`. Neither has a root
//! or a quotient that vanishes, and both are analytic at unlimited friction, `phi = chi = pi/2`, `h = 0`.

use crate::number::{Angle, Field, Real, Stumpff};

/// (18): the thrust `h = cos² chi` at which an inner joint slides, by the inclination of the force there.
#[inline(always)]
pub fn thrust<T: Field>(inclination: &Angle<T>) -> T {
    inclination.cos.square()
}

/// (18): the joint `beta_s = sin chi cos chi` that slides, rad.
#[inline(always)]
pub fn joint<T: Field>(inclination: &Angle<T>) -> T {
    inclination.sin.clone() * &inclination.cos
}

/// (18): the friction angle `phi = chi - sin chi cos chi`, rad. It grows with the inclination, at the rate `2
/// sin² chi`.
#[inline(always)]
pub fn friction_angle<T: Field>(inclination: &Angle<T>) -> T {
    inclination.rad.clone() - joint(inclination)
}

/// (17): `h sin(alpha - phi) - alpha cos(alpha - phi)`, zero where the shoulder slides. `inclination` is that of
/// the force on the shoulder, `alpha - phi`.
#[inline(always)]
pub fn shoulder<T: Field>(half_opening: &T, inclination: &Angle<T>, thrust: &T) -> T {
    thrust.clone() * &inclination.sin - half_opening.clone() * &inclination.cos
}

/// (17) solved for the thrust, `h = alpha cot(alpha - phi)`: the largest that the shoulder can bear.
pub fn shoulder_thrust<T: Real>(half_opening: &T, friction_angle: &T) -> T {
    let inclination = Angle::new(half_opening.clone() - friction_angle);
    half_opening.clone() * inclination.cos / inclination.sin
}

/// (17) of the purely sliding states over `chi³`, regular where the arch is flat: with `q = (alpha - phi)/chi`,
/// the inclination at the shoulder over that inside,
///
/// ```text
/// q [q² (c_2 - c_3) - c_1(chi²)² c_1] - 4 c_3(4 chi²) c_0,   c_n at q² chi²
/// ```
///
/// `q = 2` at `chi = 0`. The squares of the angles `chi`, `2 chi` and `q chi` are in the range of
/// [Stumpff's functions](crate::number::Stumpff).
pub fn flat_shoulder<T: Stumpff>(ratio: &T, inclination: &T) -> T {
    let square = inclination.square();
    let shoulder = (ratio.square() * &square).stumpff(4);
    let inner = square.stumpff(2);
    let twice = (square.int(4) * &square).stumpff(4);
    flat_shoulder_from(ratio, &shoulder, &inner[1].square(), &twice)
}

/// Half opening at a flat shoulder from Stumpff's functions at the squares of `q chi` and `2 chi`, and from
/// `(1 - h)/chi²`, which is `c_1(chi²)²` where an inner joint slides too.
pub fn flat_shoulder_from<T: Field>(ratio: &T, shoulder: &[T], deficit: &T, twice: &[T]) -> T {
    let lever = (shoulder[2].clone() - &shoulder[3]) * ratio * ratio;
    let rest = lever - deficit.clone() * &shoulder[1];
    rest * ratio - ratio.int(4) * &twice[3] * &shoulder[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::sliding;

    #[test]
    fn the_cycloid_is_equation_18() {
        for chi in [0.2f64, 0.7, 1.4] {
            let chi = Angle::new(chi);
            let (h, beta) = (thrust(&chi), Angle::new(joint(&chi)));
            approx::assert_abs_diff_eq!(sliding::steepest(&beta.rad, &h), 0.0, epsilon = 1e-15);
            let mu = sliding::inner(&beta, &h).value();
            approx::assert_relative_eq!(mu, friction_angle(&chi).tan(), max_relative = 1e-10);
        }
    }

    #[test]
    fn the_thrust_of_a_shoulder_that_slides_is_the_printed_one() {
        let (alpha, phi) = (Angle::new(1.3f64), 0.4f64);
        let printed = sliding::shoulder_thrust(&alpha, &phi.tan()).value();
        approx::assert_relative_eq!(shoulder_thrust(&1.3, &phi), printed, max_relative = 1e-13);
    }

    #[test]
    fn the_flat_form_is_equation_17_over_a_cube() {
        let (chi, q) = (Angle::new(0.3f64), 1.7);
        let alpha = q * chi.rad + friction_angle(&chi);
        let printed = shoulder(&alpha, &Angle::new(q * chi.rad), &thrust(&chi));
        let cube = chi.rad.powi(3);
        approx::assert_relative_eq!(
            flat_shoulder(&q, &chi.rad),
            printed / cube,
            max_relative = 1e-10
        );
        // Where the arch is flat q = 2.
        approx::assert_abs_diff_eq!(flat_shoulder(&2.0, &0.0), 0.0, epsilon = 1e-15);
    }
}
