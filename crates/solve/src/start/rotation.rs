//! Start values of the purely rotational states.
//!
//! They are one curve, along which the thickness grows and the thrust falls strictly from `alpha = 0` to the
//! end `l`: a half opening, a thrust or a thickness fixes the state. In doubles it is the zero of one function
//! of the joint; towards the two ends, where that loses digits, it is expanded.

use super::scale::Start;
use super::touch::{LEAST_JOINT, joint_where, touched_ring, touching_square};
use crate::arch::{PerWeight, Quotient, Ring, SelfWeight, overturning, thrust};
use crate::number::{Angle, Real};
use std::sync::OnceLock;

/// Below this half opening the series in `alpha²` are used.
const SMALL: f64 = 0.1;

/// Within this distance from `A_l` the state is found from that at this distance.
const NEAR: f64 = 1e-6;

/// `A - A_l` at a half opening: positive where there are rotational states.
pub(super) fn before_end<T: Real>(weight: SelfWeight, alpha: T) -> T {
    let end = end(weight, &alpha);
    thrust::opening_variable(&Angle::new(alpha)).value()
        - overturning::opening_variable(&end).value()
}

/// The ring of the end `l`.
fn end<T: Real>(weight: SelfWeight, like: &T) -> Ring<T> {
    Ring::new(weight, &overturning::thickness_at_end(weight, &like.int(3).sqrt()))
}

/// Tells whether a half opening seems to be below that of `l`, by its first digits.
pub fn seems_to_rotate(weight: SelfWeight, alpha: &impl Start) -> bool {
    before_end(weight, alpha.to_double()) > 0.0
}

/// A candidate: `beta_r` (rad), `eta`, `h` of the purely rotational state at a half opening (rad) above
/// zero and below that of `l`.
pub fn rotational<T: Start>(weight: SelfWeight, alpha: &T) -> [T; 3] {
    if *alpha < SMALL {
        let y = alpha.square();
        let [ratio, thickness, deficit] = series(&y);
        return [ratio.sqrt() * alpha, thickness * y.square(), y.int(1) - deficit * y];
    }
    if before_end(weight, alpha.to_double()) < NEAR {
        let part = before_end(weight, alpha.clone()) / alpha.like(NEAR);
        return near_end(weight, &part);
    }
    rotational_in_doubles(weight, alpha.to_double()).map(|x| alpha.like(x))
}

/// Rotational state of half openings that are neither small nor next to the end.
pub(super) fn rotational_in_doubles(weight: SelfWeight, alpha: f64) -> [f64; 3] {
    let a = thrust::opening_variable(&Angle::new(alpha)).value();
    let (joint, ring) = with_opening_variable(weight, a);
    [joint.rad, ring.thickness, a - overturning::opening_variable(&ring).value()]
}

/// The joint and the ring at an opening variable: (4) along the states in which (2), (4) and (5) have one
/// thickness.
fn with_opening_variable(weight: SelfWeight, a: f64) -> (Angle<f64>, Ring<f64>) {
    let ring = |joint: &Angle<f64>| Ring::new(weight, &thrust::rotating(joint, &a).value());
    // By (4) and (5) beta cot(beta) is above A - 1.
    let joint = joint_where(touching_square(a - 1.0), |joint| {
        let ring = ring(joint);
        touching(joint, &ring).residual(&(a - overturning::opening_variable(&ring).value()))
    });
    let ring = ring(&joint);
    (joint, ring)
}

/// The thrust that (2) and (5) have in common.
fn touching(joint: &Angle<f64>, ring: &Ring<f64>) -> Quotient<f64> {
    thrust::touching(&joint.versine(), &(joint.rad / joint.sin - 1.0), ring)
}

/// `beta_r`, `eta - eta_l` and `h` of the state at the distance `NEAR` from `A_l`.
fn beside_end(weight: SelfWeight) -> [f64; 3] {
    static KEPT: PerWeight<OnceLock<[f64; 3]>> =
        PerWeight { heyman: OnceLock::new(), milankovitch: OnceLock::new() };
    *KEPT.get(weight).get_or_init(|| {
        let at_end = end(weight, &1.0);
        let a = overturning::opening_variable(&at_end).value() + NEAR;
        let (joint, ring) = with_opening_variable(weight, a);
        [joint.rad, ring.thickness - at_end.thickness, touching(&joint, &ring).value()]
    })
}

/// Next to the end `beta_r²` and `eta - eta_l` grow like `x = A - A_l`, and `h` like its square: they are in
/// proportion to those at `x = NEAR`, to three digits. `part` is `x/NEAR`.
fn near_end<T: Start>(weight: SelfWeight, part: &T) -> [T; 3] {
    let [joint, gap, thrust] = beside_end(weight).map(|x| part.like(x));
    let thickness = end(weight, part).thickness + gap * part;
    if *part <= 0.0 {
        return [part.like(LEAST_JOINT), thickness, part.like(LEAST_JOINT)];
    }
    [part.sqrt() * joint, thickness, part.square() * thrust]
}

/// A candidate: `beta_r`, `eta`, `h` where the curve of rotational states has the thrust `h`.
pub fn rotational_with_thrust<T: Start>(weight: SelfWeight, h: &T) -> [T; 3] {
    // 1 - h = alpha²/6 for small openings.
    let alpha = ((h.int(1) - h) * h.int(6)).sqrt();
    let [beta, eta] = if alpha < SMALL {
        let [beta, eta, _] = rotational(weight, &alpha);
        [beta, eta]
    } else {
        let [.., beside] = beside_end(weight);
        let part = (h.clone() / h.like(beside)).sqrt();
        if part < 1.0 {
            let [beta, eta, _] = near_end(weight, &part);
            [beta, eta]
        } else {
            with_thrust(weight, h.to_double()).map(|x| h.like(x))
        }
    };
    [beta, eta, h.clone()]
}

/// `beta_r`, `eta` at a thrust, in doubles: what (2) and (5) have in common along the states that (5) allows.
pub(super) fn with_thrust(weight: SelfWeight, h: f64) -> [f64; 2] {
    let ring = |joint: &Angle<f64>| touched_ring(weight, joint.times_cotangent(), h);
    let joint = joint_where(touching_square(h), |joint| touching(joint, &ring(joint)).residual(&h));
    [joint.rad, ring(&joint).thickness]
}

/// A candidate: `beta_r`, `h` where the curve of rotational states has the thickness `eta`, below that of `l`.
pub fn rotational_with_thickness<T: Start>(weight: SelfWeight, eta: &T) -> [T; 2] {
    // eta = alpha⁴/48 for small openings.
    let alpha = (eta.int(48) * eta).sqrt().sqrt();
    if alpha < SMALL {
        let [beta, _, h] = rotational(weight, &alpha);
        return [beta, h];
    }
    let [_, gap, _] = beside_end(weight);
    let part = (eta.clone() - end(weight, eta).thickness) / eta.like(gap);
    if part < 1.0 {
        let [beta, _, h] = near_end(weight, &part);
        return [beta, h];
    }
    let ring = Ring::new(weight, &eta.to_double());
    let joint = joint_where(touching_square(0.0), |joint| {
        let tangency = thrust::tangency(&joint.times_cotangent(), &ring);
        tangency.residual(&touching(joint, &ring).value())
    });
    [joint.rad, touching(&joint, &ring).value()].map(|x| eta.like(x))
}

/// A candidate: `p = (beta_r/alpha)²`, `q = eta/alpha⁴` and `r = (1 - h)/alpha²` of the purely rotational
/// state at `y = alpha²`.
pub fn scaled_rotational<T: Start>(weight: SelfWeight, y: &T) -> [T; 3] {
    if *y < SMALL * SMALL {
        return series(y);
    }
    let y_in_doubles = y.to_double();
    let [beta, eta, h] = rotational_in_doubles(weight, y_in_doubles.sqrt());
    [beta * beta, eta / y_in_doubles, 1.0 - h].map(|x| y.like(x / y_in_doubles))
}

/// The coefficients of the powers of `y` in `p`, `q` and `r`, as far as they are the same for both weights. A
/// test computes them: [`expansion::by_opening`](crate::expansion::by_opening).
const SERIES: [[(i32, i32); 3]; 3] = [
    [(1, 2), (-17, 240), (523, 50400)],
    [(1, 48), (-1, 480), (19, 43200)],
    [(1, 6), (-11, 1440), (67, 60480)],
];

fn series<T: Start>(y: &T) -> [T; 3] {
    SERIES.map(|coefficients| {
        coefficients.iter().rev().fold(y.int(0), |sum, &(n, d)| sum * y + y.ratio(n, d))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Configuration, Unknown};
    use crate::expansion::by_opening;
    use crate::number::Dual;
    use crate::problem::Mode;
    use crate::settle;
    use rug::{Float, Rational};

    #[test]
    fn the_series_are_those_of_both_weights() {
        for weight in SelfWeight::ALL {
            let found = by_opening(weight, 6).unwrap();
            let known = [
                found.joint_squared.coefficients(1),
                found.thickness.coefficients(2),
                (-found.thrust).coefficients(1),
            ];
            for (known, constants) in known.iter().zip(SERIES) {
                assert_eq!(known[..3], constants.map(Rational::from), "{weight:?}");
            }
        }
    }

    /// `beta_r`, `eta`, `h` to many digits.
    fn polished(weight: SelfWeight, alpha: &Float) -> [Float; 3] {
        let system = Mode::Rotational.system(weight);
        let given = Configuration::zero(alpha).with(Unknown::HalfOpening, alpha.clone());
        let at = |x: &[Float]| system.variables(&system.place(given.clone(), x));
        let root = settle(rotational(weight, alpha).to_vec(), |x| system.residuals(&at(x)));
        root.unwrap().try_into().unwrap()
    }

    fn assert_close(found: &[Float], truth: &[Float], digits: f64, what: &str) {
        for (x, y) in found.iter().zip(truth) {
            let error = Float::with_val(64, (x.clone() - y) / y).abs();
            assert!(error < digits, "{what}: {x} is not {y}");
        }
    }

    #[test]
    fn the_start_is_the_state_to_many_digits() {
        for weight in SelfWeight::ALL {
            let end = if weight == SelfWeight::Heyman { 2.648 } else { 2.590 };
            let mut last = [f64::INFINITY, 0.0];
            for step in 1..=500 {
                let alpha = Float::with_val(300, end * f64::from(step) / 500.0);
                let start = rotational(weight, &alpha);
                let truth = polished(weight, &alpha);
                let what = format!("{weight:?} {alpha}");
                assert_close(&start, &truth, 1e-6, &what);
                let [beta, eta, h] = &truth;
                assert!(*h < last[0] && *eta > last[1], "{what}");
                last = [h.to_f64(), eta.to_f64()];
                if alpha > 0.2 {
                    let [found, thickness, _] = rotational_with_thrust(weight, h);
                    assert_close(&[found, thickness], &truth[..2], 1e-6, &what);
                    let found = rotational_with_thickness(weight, eta);
                    assert_close(&found, &[beta.clone(), h.clone()], 1e-6, &what);
                }
                let y = Float::with_val(300, alpha.square_ref());
                let [p, q, r] = scaled_rotational(weight, &y);
                let unscaled = [(p * &y).sqrt(), q * y.clone().square(), 1 - r * y];
                assert_close(&unscaled, &truth, 1e-6, &what);
            }
        }
    }

    /// At every distance from the end, and in the last digits of the precision.
    #[test]
    fn the_start_is_near_next_to_the_end() {
        for weight in SelfWeight::ALL {
            let end = settle(vec![Float::with_val(600, 2.6)], |x| {
                let alpha = Angle::new(x[0].clone()).variable(0);
                let ring = end(weight, &x[0]);
                let a = overturning::opening_variable(&ring).value();
                vec![thrust::opening_variable(&alpha).residual(&Dual::constant(a))]
            });
            let end = &end.unwrap()[0];
            for exponent in [10, 16, 20, 30, 60, 120] {
                let alpha = Float::with_val(600, end - (Float::with_val(600, 1) >> exponent));
                let (start, truth) = (rotational(weight, &alpha), polished(weight, &alpha));
                let what = format!("{weight:?} 2^-{exponent}");
                assert_close(&start, &truth, 1e-3, &what);
                let [beta, eta, h] = &truth;
                let [found, thickness, _] = rotational_with_thrust(weight, h);
                assert_close(&[found, thickness], &truth[..2], 1e-3, &what);
                let found = rotational_with_thickness(weight, eta);
                assert_close(&found, &[beta.clone(), h.clone()], 1e-3, &what);
            }
        }
    }
}
