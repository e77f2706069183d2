//! Start values where the line of thrust touches the intrados with the shoulder on its extrados, in doubles.
//!
//! At a joint (5) fixes the thrust for a thickness and the thickness for a thrust. What (3) leaves is then a
//! function of the joint alone.

use crate::arch::haunch::Haunch;
use crate::arch::{Ring, SelfWeight, thrust};
use crate::number::Angle;
use crate::zero::{quadratic_zero, zero};
use std::f64::consts::FRAC_PI_2;

/// The least start value of a joint: nearer to zero Newton's method finds the way by halving.
pub(super) const LEAST_JOINT: f64 = 1e-9;

/// The joint at which a function is zero; its square is below a bound.
pub(super) fn joint_where(square: f64, f: impl Fn(&Angle<f64>) -> f64) -> Angle<f64> {
    let least = LEAST_JOINT * LEAST_JOINT;
    Angle::new(zero(least, square, |square| f(&Angle::new(square.sqrt()))).sqrt())
}

/// A bound of the square of a joint that touches with a thrust of `h` or more: by (5) `h` is not above
/// `beta cot(beta)`, which is below `1 - beta²/3`, and negative beyond a right angle.
pub(super) fn touching_square(h: f64) -> f64 {
    (3.0 * (1.0 - h)).min(FRAC_PI_2 * FRAC_PI_2)
}

/// The ring that the line of thrust touches at a joint with this thrust: (5) is quadratic in its thickness.
pub(super) fn touched_ring(weight: SelfWeight, times_cotangent: f64, h: f64) -> Ring<f64> {
    let gap = |eta| thrust::tangency(&times_cotangent, &Ring::new(weight, &eta)).residual(&h);
    Ring::new(weight, &quadratic_zero(gap))
}

/// The ring with which the half arch turns about the crown's intrados at a half opening (rad) and a thrust.
pub(super) fn ring_at_crown(weight: SelfWeight, alpha: f64, h: f64) -> Ring<f64> {
    let (opening, crown) = (Angle::new(alpha), Angle::zero(&alpha));
    let ring = |eta| Ring::new(weight, &eta);
    ring(quadratic_zero(|eta| thrust::upper(&opening, &crown, &ring(eta)).residual(&h)))
}

/// A start with a sliding inner joint: the thickness, and the rotational joint unless it is the crown.
pub struct InnerStart {
    /// `eta`.
    pub thickness: f64,
    /// `beta_r`, rad, or `None` if the intrados is touched at the crown.
    pub joint: Option<f64>,
    /// True if doubles may be wrong about that: the joint is at the crown or next to it.
    pub is_near_crown: bool,
}

/// The thicknesses of a touched crown and of a touched joint next to it differ by this part at most.
const NEAR_CROWN: f64 = 1e-6;

/// A candidate: the thickness at a half opening (rad) and a thrust that the sliding of an inner joint fixes.
///
/// The gap between the moments about the shoulder's extrados and about the touching joint grows with the
/// thickness, which falls with the joint.
pub fn rotational_sliding(weight: SelfWeight, alpha: f64, h: f64) -> InnerStart {
    let opening = Angle::new(alpha);
    let gap =
        |joint: &Angle<f64>, ring: &Ring<f64>| thrust::upper(&opening, joint, ring).residual(&h);
    let at_crown = ring_at_crown(weight, alpha, h).thickness;
    let touched = touched_ring(weight, 1.0, h).thickness;
    let is_near_crown = at_crown > touched * (1.0 - NEAR_CROWN);
    if at_crown >= touched {
        return InnerStart { thickness: at_crown, joint: None, is_near_crown };
    }
    let ring = |joint: &Angle<f64>| touched_ring(weight, joint.times_cotangent(), h);
    let joint = joint_where(touching_square(h), |joint| gap(joint, &ring(joint)));
    InnerStart { thickness: ring(&joint).thickness, joint: Some(joint.rad), is_near_crown }
}

/// A candidate: the square of the joint at which the line of thrust touches the intrados, at a half opening (rad) and a
/// thrust; negative where it would do so beyond the crown.
pub fn touching_square_below(weight: SelfWeight, alpha: f64, h: f64) -> f64 {
    let opening = Angle::new(alpha);
    zero(-1.0, touching_square(h), |square| {
        let at = Haunch::at_square(&square);
        let of_joint = [&at.cosine, &at.times_sine, &at.times_cotangent];
        let thickness = thrust::touched_below(&opening, of_joint, &h).value();
        thrust::tangency(&at.times_cotangent, &Ring::new(weight, &thickness)).residual(&h)
    })
}

/// A candidate: `beta_r` (rad), `h` of the largest thrust that a thickness bears with the line of thrust
/// touching the intrados below the crown, at a half opening (rad) at which (3) bounds the thrust at the crown.
///
/// The gap is concave in the thrust, which falls with the joint, and the lever arm in (3) is its slope: the
/// larger zero is at a joint with a positive arm.
pub fn largest_thrust(weight: SelfWeight, alpha: f64, eta: f64) -> [f64; 2] {
    let (opening, ring) = (Angle::new(alpha), Ring::new(weight, &eta));
    let upper = |joint: &Angle<f64>| thrust::upper(&opening, joint, &ring);
    let thrust = |joint: &Angle<f64>| thrust::tangency(&joint.times_cotangent(), &ring).value();
    let bound = touching_square(0.0).min(alpha * alpha);
    let farthest = joint_where(bound, |joint| upper(joint).denominator).rad;
    let joint = joint_where(farthest * farthest, |joint| upper(joint).residual(&thrust(joint)));
    [joint.rad, thrust(&joint).max(LEAST_JOINT)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (3) and (5) hold at a joint.
    fn assert_touches(weight: SelfWeight, alpha: f64, joint: f64, eta: f64, h: f64) {
        let (opening, joint, ring) =
            (Angle::new(alpha), Angle::new(joint), Ring::new(weight, &eta));
        let tangency = thrust::tangency(&joint.times_cotangent(), &ring);
        for found in [thrust::upper(&opening, &joint, &ring), tangency] {
            approx::assert_relative_eq!(found.value(), h, max_relative = 1e-9);
        }
    }

    #[test]
    fn the_line_of_thrust_touches_at_the_start() {
        for weight in SelfWeight::ALL {
            for (alpha, h) in [(1.0, 0.7), (2.0, 0.4), (2.45, 0.1), (2.53, 0.07)] {
                let start = rotational_sliding(weight, alpha, h);
                assert_touches(weight, alpha, start.joint.unwrap(), start.thickness, h);
            }
            for (alpha, eta) in [(0.5, 0.003), (1.57, 0.12), (2.0, 0.4), (2.5, 0.8)] {
                let [joint, h] = largest_thrust(weight, alpha, eta);
                assert_touches(weight, alpha, joint, eta, h);
                // Towards thinner arches it falls.
                assert!(largest_thrust(weight, alpha, 0.99 * eta)[1] < h);
            }
        }
    }

    #[test]
    fn at_a_small_thrust_the_crown_is_touched() {
        let start = rotational_sliding(SelfWeight::Milankovitch, 2.62, 0.01);
        let (opening, crown) = (Angle::new(2.62), Angle::zero(&0.0));
        let ring = Ring::new(SelfWeight::Milankovitch, &start.thickness);
        assert!(start.joint.is_none());
        let h = thrust::upper(&opening, &crown, &ring).value();
        approx::assert_relative_eq!(h, 0.01, max_relative = 1e-9);
    }
}
