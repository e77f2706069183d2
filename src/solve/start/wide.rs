//! Start values where the half opening is asked for: how far a line of thrust, or what is left of friction,
//! reaches.
//!
//! The thrust and the joints above the shoulder do not see the half opening. At a given thrust the margin
//! at the shoulder's extrados first grows with the half opening and then falls, and so does what friction has
//! to spare: the widest half opening is the one zero of what falls.

use super::sliding::inner_sliding;
use crate::arch::{Ring, SelfWeight, statics};
use crate::number::Angle;
use crate::solve::zero::zero;
use rug::Float;
use std::f64::consts::PI;

/// Below this thickness, and below this friction, and for a thrust as near to one, the leading terms are used:
/// the half opening is below about a tenth.
const THIN: f64 = 1e-6;
const SLIPPERY: f64 = 1e-5;
const NEARLY_ONE: f64 = 1e-4;

/// A candidate: the half opening of the purely rotational state with a thickness and a thrust.
pub fn widest_rotational(weight: SelfWeight, eta: &Float, h: &Float) -> Float {
    if *eta < THIN {
        // eta = alpha⁴/48.
        return Float::with_val(eta.prec(), eta * 48u32).sqrt().sqrt();
    }
    let (eta_in_doubles, h) = (eta.to_f64(), h.to_f64());
    let ring = Ring::new(weight, &eta_in_doubles);
    Float::with_val(eta.prec(), widest_inside(&ring, h, (1.0 + 0.5 * eta_in_doubles) * h))
}

/// A candidate: the half opening at which the line of thrust that touches the intrados at a joint (rad)
/// reaches the extrados of the shoulder.
pub fn widest_touching(weight: SelfWeight, eta: f64, h: f64, joint: f64) -> f64 {
    let (ring, joint) = (Ring::new(weight, &eta), Angle::new(joint));
    let normal = statics::normal_force(&joint, &h);
    let moment = (1.0 - 0.5 * eta) * normal - ring.centroid_factor * joint.versine();
    widest_inside(&ring, h, moment)
}

/// The half opening at which the margin at the shoulder's extrados is used up, for a thrust and a crown moment.
fn widest_inside(ring: &Ring<f64>, h: f64, moment: f64) -> f64 {
    let outer = 0.5 * ring.extrados();
    // The margin grows while outer (1 - h + beta cot(beta)) is above the centroid factor.
    let turning = ring.centroid_factor / outer - 1.0 + h;
    let top = zero(1e-9, PI, |x| x * x.cos() - turning * x.sin());
    zero(top, PI, |x| {
        let joint = Angle::new(x);
        outer * statics::normal_force(&joint, &h) - moment - ring.centroid_factor * joint.versine()
    })
}

/// A candidate: the half opening at which the shoulder just slides at a thrust; the friction is not zero.
pub fn widest_without_sliding(h: &Float, friction: &Float) -> Float {
    let bits = h.prec();
    let rest = Float::with_val(bits, 1 - h);
    if rest < NEARLY_ONE {
        // mu = alpha³/3 - (1 - h) alpha, in units of √(1 - h).
        let unit = rest.clone().sqrt();
        let scaled = (Float::with_val(bits, friction / rest) / &unit).to_f64();
        let part = zero(1.0, (3.0 * scaled).cbrt() + 2.0, |x| x * x * x / 3.0 - x - scaled);
        return unit * part;
    }
    let (h, angle) = (h.to_f64(), friction.to_f64().atan());
    // The resultant leans by alpha - atan(alpha/h) against the joint: least at the steepest joint.
    let steepest = (h * (1.0 - h)).sqrt();
    let found = zero(steepest, PI, |x| x - x.atan2(h) - angle);
    Float::with_val(bits, found)
}

/// A candidate: `alpha`, `h`, `beta_s` (rad) of the purely sliding state of a friction that is not zero.
pub fn widest_sliding(friction: &Float) -> [Float; 3] {
    let bits = friction.prec();
    if *friction < SLIPPERY {
        // mu = alpha³/12, 1 - h = alpha²/4, beta_s = alpha/2.
        let alpha = Float::with_val(bits, friction * 12u32).cbrt();
        let joint = Float::with_val(bits, &alpha / 2u32);
        return [alpha, 1 - Float::with_val(bits, joint.square_ref()), joint];
    }
    let [h, joint] = inner_sliding(friction);
    [widest_without_sliding(&h, friction), h, joint]
}

/// A candidate: the joint (rad) at which the line of thrust is tangent to the intrados, for `beta cot(beta)`
/// between `beta cot(beta)` at a right angle and a half, and one.
pub fn tangent_joint(times_cotangent: &Float) -> Float {
    let bits = times_cotangent.prec();
    let rest = Float::with_val(bits, 1 - times_cotangent);
    if rest < NEARLY_ONE {
        // 1 - beta²/3.
        return (rest * 3u32).sqrt();
    }
    let target = times_cotangent.to_f64();
    Float::with_val(bits, zero(1e-9, PI, |x| x * x.cos() - target * x.sin()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::sliding;
    use crate::solve::start::{rotational, sliding as purely_sliding};

    #[test]
    fn the_half_opening_is_found_again() {
        for alpha in [1e-12, 0.03, 0.1, 0.7, 1.5, 2.2, 2.5] {
            let half_opening = Float::with_val(200, alpha);
            for weight in SelfWeight::ALL {
                let [_, eta, h] = rotational(weight, &half_opening);
                let found = widest_rotational(weight, &eta, &h).to_f64();
                approx::assert_relative_eq!(found, alpha, max_relative = 1e-2);
            }
            let [mu, h, joint] = purely_sliding(&half_opening);
            let found = widest_sliding(&mu);
            for (x, y) in found.iter().zip([&half_opening, &h, &joint]) {
                approx::assert_relative_eq!(x.to_f64(), y.to_f64(), max_relative = 1e-2);
            }
        }
        for (h, mu) in [(0.1, 1.3), (0.6, 0.4), (0.9, 0.05), (1e-9, 3.0)] {
            let [thrust, friction] = [h, mu].map(|x| Float::with_val(64, x));
            let alpha = widest_without_sliding(&thrust, &friction).to_f64();
            let again = sliding::shoulder(&Angle::new(alpha), &h).value();
            approx::assert_relative_eq!(again, mu, max_relative = 1e-9);
        }
    }

    #[test]
    fn the_tangent_joint_is_that_of_its_cotangent() {
        for joint in [1e-5f64, 0.02, 0.5, 1.1] {
            let times_cotangent = Float::with_val(64, joint / joint.tan());
            let found = tangent_joint(&times_cotangent).to_f64();
            approx::assert_relative_eq!(found, joint, max_relative = 1e-4);
        }
    }
}
