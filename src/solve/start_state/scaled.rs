//! Start values for small half openings, in the variables of order one of
//! [`arch::small`](crate::arch::small).

use super::ends::Small;
use crate::arch::SelfWeight;
use crate::arch::small::{Scaled, normal_force};
use crate::number::Stumpff;
use rug::Float;

/// `p`, `q`, `r` of the purely rotational state at `y = alpha²`; `None` if there is no series.
pub fn scaled_rotational(weight: SelfWeight, y: &Float) -> Option<[Float; 3]> {
    Some(Small::of(weight)?.scaled(y))
}

/// `p`, `q`, `r` where the shoulder slides, from (17), which is linear in `r`, and from the rotational
/// state with that thrust, which has the half opening `alpha √(6r)` and `r = 1/6` nearly.
pub fn scaled_shoulder_sliding(weight: SelfWeight, at: &Scaled<Float>) -> Option<[Float; 3]> {
    let (y, c) = (&at.opening.square, &at.opening.functions);
    let bits = y.prec();
    // `at` has no deficit yet, so that this is N(alpha) without it.
    let gap = Float::with_val(bits, &c[2] - &c[3]) - normal_force(at) * &at.friction;
    let r = gap / (c[1].clone() - Float::with_val(bits, y * &at.friction) * &c[0]);
    let wider = Float::with_val(bits, &r * 6u32);
    let [p, q, _] = scaled_rotational(weight, &Float::with_val(bits, y * &wider))?;
    Some([p * &wider, q * wider.square(), r])
}

/// `beta_r`, `h` of the largest thrust that a thickness bears with the line of thrust touching the intrados
/// below the crown, for a half opening below 1/2: the same gap as in
/// [`largest_thrust`](super::largest_thrust), over `alpha⁴`.
///
/// As a function of the deficit `r` the gap is concave; its smaller zero is left of its maximum.
pub fn scaled_largest_thrust(weight: SelfWeight, alpha: &Float, eta: &Float) -> [Float; 2] {
    let bits = alpha.prec();
    let square = Float::with_val(bits, alpha.square_ref());
    let y = square.to_f64();
    let q = (Float::with_val(bits, eta) / Float::with_val(bits, square.square_ref())).to_f64();
    let (eta, delta) = (eta.to_f64(), f64::from(weight.flag()));
    // What the thickness adds to (5), over y.
    let added = (y * q + delta * eta * y * q / 6.0) / (2.0 - eta);
    // (5) fixes the joint: p (c_2 - c_3)/c_1 at y p.
    let joint = |r: f64| {
        let target = (r - added).max(0.0);
        (0..40).fold(3.0 * target, |p, _| {
            let c = (y * p).min(1.0).stumpff(4);
            target * c[1] / (c[2] - c[3])
        })
    };
    let shoulder = y.stumpff(5);
    let gap = |r: f64| {
        let p = joint(r);
        let c = (y * p).min(1.0).stumpff(5);
        // k (1 - cos) + x sin(x) - (1 - cos) over y², for x² = y s, without its part of order y.
        let rise = |s: f64, c: &[f64]| s * (r * c[2] - s * (c[3] - 2.0 * c[4]));
        // The same with that part, over y: it is multiplied with the thickness.
        let lift = |s: f64, c: &[f64]| s * (y * r * c[2] + c[1] - c[2]);
        let drop = shoulder[2] - p * c[2];
        q * (1.0 - y * r) + rise(1.0, &shoulder) - rise(p, &c)
            + 0.5 * y * q * (lift(1.0, &shoulder) + lift(p, &c))
            - delta * y * eta * q * drop / 12.0
    };
    let (mut low, mut high) = (added, added + 1.0);
    for _ in 0..80 {
        let third = (high - low) / 3.0;
        if gap(low + third) < gap(high - third) { low += third } else { high -= third }
    }
    let mut least = added;
    for _ in 0..60 {
        let middle = 0.5 * (least + high);
        if gap(middle) > 0.0 { high = middle } else { least = middle }
    }
    let beta = Float::with_val(bits, joint(high)).sqrt() * alpha;
    [beta, 1 - square * high]
}

/// `m`, `r`, `z` of the purely sliding state: the leading terms.
pub fn scaled_sliding(y: &Float) -> [Float; 3] {
    [12u32, 4, 2].map(|n| Float::with_val(y.prec(), n).recip())
}
