//! Start values of what slides: each the zero of one growing function.
//!
//! At the thrust `h = sin²θ` the steepest joint is `beta_s = sin θ cos θ`. The friction that it asks for
//! falls from infinity to zero as `θ` grows from 0 to a right angle.

use super::scale::Start;
use super::scaled::scaled_sliding;
use crate::arch::{Quotient, sliding};
use crate::number::Angle;
use crate::zero::zero;
use std::f64::consts::FRAC_PI_2;

/// Below this half opening the leading terms are used.
const SMALL: f64 = 0.01;
/// Below this friction the leading terms are used.
const SLIPPERY: f64 = 1e-6;
/// Below this angle `θ` is half of it.
const STEEP: f64 = 1e-3;

/// A candidate for a positive friction: the thrust and the sliding joint (rad) at which an inner joint just
/// slides.
pub fn inner_sliding<T: Start>(friction: &T) -> [T; 2] {
    let one = friction.int(1);
    if *friction < SLIPPERY {
        // (1 - h)³ = (3/2 mu)², the leading term.
        let rest = (one.ratio(3, 2) * friction).cube_root().square();
        let h = one - &rest;
        return [h.clone(), (rest * h).sqrt()];
    }
    let target = (one / friction).arctangent();
    let theta = match target.to_double() {
        moderate if moderate > STEEP => target.like(slope_angle(moderate)),
        _ => target.ratio(1, 2) * target,
    };
    let (sin, cos) = theta.sin_cos();
    [sin.square(), sin * cos]
}

/// `h` and `beta_s` at which an inner joint just slides, in doubles.
pub(super) fn inner_sliding_in_doubles(friction: f64) -> [f64; 2] {
    steepest(slope_angle(friction.recip().atan()))
}

/// `θ` where the steepest joint asks for a friction whose inverse tangent is known.
fn slope_angle(inverse: f64) -> f64 {
    // It is θ + beta_s, and beta_s is not above θ.
    zero(0.5 * inverse, inverse, |theta| {
        inverse_tangent(&friction_inside(steepest(theta))) - inverse
    })
}

/// `h` and `beta_s`.
fn steepest(theta: f64) -> [f64; 2] {
    let (sin, cos) = theta.sin_cos();
    [sin * sin, sin * cos]
}

/// (18).
pub(super) fn friction_inside([h, joint]: [f64; 2]) -> Quotient<f64> {
    sliding::inner(&Angle::new(joint), &h)
}

/// `acot(mu)`, which is finite for every friction.
pub(super) fn inverse_tangent(friction: &Quotient<f64>) -> f64 {
    friction.denominator.atan2(friction.numerator)
}

/// A candidate: `mu`, `h`, `beta_s` (rad) of the purely sliding state at a half opening in `(0, pi)`, rad.
pub fn sliding<T: Start>(alpha: &T) -> [T; 3] {
    if *alpha < SMALL {
        let y = alpha.square();
        let [m, r, z] = scaled_sliding(&y);
        return [m * &y * alpha, y.int(1) - r * y, z * alpha];
    }
    // Next to pi the sine needs the digits of the half opening.
    let opening = Angle::new(alpha.clone()).map(|x| x.to_double());
    sliding_in_doubles(&opening).map(|x| alpha.like(x))
}

/// Sliding state in doubles.
pub(super) fn sliding_in_doubles(opening: &Angle<f64>) -> [f64; 3] {
    let excess = |theta: f64| {
        let at @ [h, _] = steepest(theta);
        inverse_tangent(&friction_inside(at)) - inverse_tangent(&sliding::shoulder(opening, &h))
    };
    // The shoulder asks for the more the larger the thrust.
    let most = inverse_tangent(&sliding::shoulder(opening, &0.0)).min(FRAC_PI_2);
    let at @ [h, joint] = steepest(zero(0.0, most, excess));
    [friction_inside(at).value(), h, joint]
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Float;

    #[test]
    fn the_least_frictions_have_a_start() {
        for friction in [1.01e-6, 0.99e-6, 1e-15, 1e-100] {
            let [h, joint] = inner_sliding(&Float::with_val(2000, friction));
            let again = sliding::inner(&Angle::new(joint), &h).value().to_f64();
            approx::assert_relative_eq!(again, friction, max_relative = 1e-2);
        }
    }

    #[test]
    fn the_purely_sliding_state_uses_its_friction_at_both_joints() {
        for alpha in [0.02, 0.3, 1.0, 2.0, 2.8, 3.1] {
            let [mu, h, joint] = sliding(&Float::with_val(64, alpha)).map(|x| x.to_f64());
            let shoulder = sliding::shoulder(&Angle::new(alpha), &h).value();
            approx::assert_relative_eq!(shoulder, mu, max_relative = 1e-6);
            approx::assert_relative_eq!(joint * joint, h * (1.0 - h), max_relative = 1e-9);
            let [again, _] = inner_sliding(&Float::with_val(64, mu)).map(|x| x.to_f64());
            approx::assert_relative_eq!(again, h, max_relative = 1e-6);
        }
    }
}
