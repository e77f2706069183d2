//! Start values for small half openings, in the variables of order one of
//! [`arch::small`](crate::arch::small).

use super::rotation::scaled_rotational;
use super::scale::Start;
use crate::arch::small::{self, Scaled};
use crate::arch::{SelfWeight, Unknown};
use crate::zero::{linear_zero, zero};

/// `p`, `q`, `r` where the shoulder slides, from (17), which is linear in `r`, and from the rotational
/// state with that thrust, which has the half opening `alpha √(6r)` and `r = 1/6` nearly.
pub fn scaled_shoulder_sliding<T: Start>(weight: SelfWeight, at: &Scaled<T>) -> [T; 3] {
    let y = &at.opening.square;
    let r = linear_zero(y, |r| {
        small::shoulder(&at.clone().with(Unknown::Thrust, r)).residual(&at.friction)
    });
    let wider = y.int(6) * &r;
    let [p, q, _] = scaled_rotational(weight, &(y.clone() * &wider));
    [p * &wider, q * wider.square(), r]
}

/// `beta_r`, `h` of the largest thrust that a thickness bears with the line of thrust touching the intrados
/// below the crown, for a half opening below 1/2: the same as [`largest_thrust`](super::largest_thrust).
///
/// The gap is the margin at the shoulder's extrados and that at the joint's intrados, for one crown moment.
pub fn scaled_largest_thrust<T: Start>(weight: SelfWeight, alpha: &T, eta: &T) -> [T; 2] {
    let square = alpha.square();
    let q = (eta.clone() / square.square()).to_double();
    let given = Scaled::new(&square.to_double()).with(Unknown::Thickness, q);
    // (5) is linear in the deficit.
    let touching = |p: f64| {
        let at = given.clone().with(Unknown::RotationJoint, p);
        let r = linear_zero(&p, |r| small::tangency(weight, &at.clone().with(Unknown::Thrust, r)));
        at.with(Unknown::Thrust, r)
    };
    let gap = |at: &Scaled<f64>| {
        small::extrados_margin_at_shoulder(weight, at) + 0.5 * small::lower(weight, at)
    };
    let arm = |p: f64| small::arms(&given.clone().with(Unknown::RotationJoint, p)).1;
    let p = zero(0.0, zero(0.0, 1.0, arm), |p| gap(&touching(p)));
    let beta = alpha.like(p).sqrt() * alpha;
    [beta, alpha.int(1) - square * alpha.like(touching(p).deficit)]
}

/// `m`, `r`, `z` of the purely sliding state: the leading terms.
pub fn scaled_sliding<T: Start>(y: &T) -> [T; 3] {
    [12, 4, 2].map(|n| y.ratio(1, n))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::largest_thrust;
    use rug::Float;

    #[test]
    fn the_largest_thrust_is_that_of_the_printed_equations() {
        for weight in SelfWeight::ALL {
            for (alpha, eta) in [(0.24, 8e-5), (0.24, 2e-4), (0.1, 2.5e-6)] {
                let [joint, h] = [alpha, eta].map(|x| Float::with_val(64, x));
                let scaled = scaled_largest_thrust(weight, &joint, &h);
                for (x, y) in scaled.iter().zip(largest_thrust(weight, alpha, eta)) {
                    approx::assert_relative_eq!(x.to_f64(), y, max_relative = 1e-9);
                }
            }
        }
    }

    #[test]
    fn a_sliding_shoulder_uses_its_friction() {
        let y = Float::with_val(64, 0.02);
        let at = Scaled::new(&y).with(Unknown::Friction, Float::with_val(64, 0.1));
        let [p, q, r] = scaled_shoulder_sliding(SelfWeight::Heyman, &at);
        let at = at.with(Unknown::RotationJoint, p).with(Unknown::Thickness, q);
        let at = at.with(Unknown::Thrust, r);
        let shoulder = small::shoulder(&at).residual(&at.friction);
        assert!(shoulder.abs() < 1e-17);
        for rest in
            [small::lower(SelfWeight::Heyman, &at), small::tangency(SelfWeight::Heyman, &at)]
        {
            assert!(rest.clone().abs() < 1e-3, "{rest}");
        }
    }
}
