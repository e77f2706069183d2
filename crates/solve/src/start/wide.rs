//! Start values where the half opening is asked for: how far a line of thrust, or what is left of friction,
//! reaches.
//!
//! The thrust and the joints above the shoulder do not see the half opening. At a given thrust the margin
//! at the shoulder's extrados first grows with the half opening and then falls, and so does what friction has
//! to spare: the widest half opening is the one zero of what falls.

use super::scale::Start;
use super::sliding::{inner_sliding, inverse_tangent};
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact, sliding};
use crate::number::Angle;
use crate::zero::zero;
use std::f64::consts::PI;

/// Below this thickness, and below this friction, and for a thrust as near to one, the leading terms are used:
/// the half opening is below about a tenth.
const THIN: f64 = 1e-6;
const SLIPPERY: f64 = 1e-5;
const NEARLY_ONE: f64 = 1e-4;

/// A candidate: the half opening of the purely rotational state with a thickness and a thrust.
pub fn widest_rotational<T: Start>(weight: SelfWeight, eta: &T, h: &T) -> T {
    if *eta < THIN {
        // eta = alpha⁴/48.
        return (eta.int(48) * eta).sqrt().sqrt();
    }
    let at = in_doubles(eta.to_double(), h.to_double());
    let moment = contact::crown_moment(&at);
    eta.like(widest_inside(weight, at, moment))
}

/// A candidate: the half opening at which the line of thrust that touches the intrados at a joint (rad)
/// reaches the extrados of the shoulder.
pub fn widest_touching(weight: SelfWeight, eta: f64, h: f64, joint: f64) -> f64 {
    let at = in_doubles(eta, h);
    let moment = -contact::intrados_margin(weight, &Angle::new(joint), &at, &0.0);
    widest_inside(weight, at, moment)
}

/// A thickness and a thrust, with no half opening.
fn in_doubles(eta: f64, h: f64) -> Configuration<f64> {
    Configuration::zero(&h).with(Unknown::Thickness, eta).with(Unknown::Thrust, h)
}

/// The half opening at which the margin at the shoulder's extrados is used up, for a thickness, a thrust and a crown
/// moment.
fn widest_inside(weight: SelfWeight, at: Configuration<f64>, moment: f64) -> f64 {
    let ring = Ring::new(weight, &at.thickness);
    // The margin grows while (1 + eta/2) (1 - h + beta cot(beta)) is above the centroid factor.
    let top = tangent_in_doubles(2.0 * ring.centroid_factor / ring.extrados() - 1.0 + at.thrust);
    zero(top, PI, |x| {
        let at = at.clone().with(Unknown::HalfOpening, x);
        contact::extrados_margin_at_shoulder(weight, &at, &moment)
    })
}

/// A candidate: the half opening at which the shoulder just slides at a thrust; the friction is not zero.
pub fn widest_without_sliding<T: Start>(h: &T, friction: &T) -> T {
    let rest = h.int(1) - h;
    if rest < NEARLY_ONE {
        // mu = alpha³/3 - (1 - h) alpha, in units of √(1 - h).
        let unit = rest.sqrt();
        let scaled = (friction.clone() / rest / &unit).to_double();
        let part = zero(1.0, (3.0 * scaled).cbrt() + 2.0, |x| x * x * x / 3.0 - x - scaled);
        return h.like(part) * unit;
    }
    let (thrust, inverse) = (h.to_double(), friction.to_double().recip().atan());
    // The shoulder asks for the least where it is the steepest joint.
    let found = zero(sliding::steepest_joint(&thrust), PI, |x| {
        inverse - inverse_tangent(&sliding::shoulder(&Angle::new(x), &thrust))
    });
    h.like(found)
}

/// A candidate: `alpha`, `h`, `beta_s` (rad) of the purely sliding state of a friction that is not zero.
pub fn widest_sliding<T: Start>(friction: &T) -> [T; 3] {
    if *friction < SLIPPERY {
        // mu = alpha³/12, 1 - h = alpha²/4, beta_s = alpha/2.
        let alpha = (friction.int(12) * friction).cube_root();
        let joint = alpha.ratio(1, 2) * &alpha;
        return [alpha, joint.int(1) - joint.square(), joint];
    }
    let [h, joint] = inner_sliding(friction);
    [widest_without_sliding(&h, friction), h, joint]
}

/// A candidate: the joint (rad) at which the line of thrust is tangent to the intrados, for `beta cot(beta)` below
/// one.
pub fn tangent_joint<T: Start>(times_cotangent: &T) -> T {
    let rest = times_cotangent.int(1) - times_cotangent;
    if rest < NEARLY_ONE {
        // 1 - beta²/3.
        return (rest.int(3) * rest).sqrt();
    }
    times_cotangent.like(tangent_in_doubles(times_cotangent.to_double()))
}

/// The joint (rad) with a `beta cot(beta)`, which falls.
fn tangent_in_doubles(times_cotangent: f64) -> f64 {
    zero(1e-9, PI, |x| x * x.cos() - times_cotangent * x.sin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::{rotational, sliding as purely_sliding};
    use rug::Float;

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
