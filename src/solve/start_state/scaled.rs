//! Start values for small half openings, in the variables of order one of
//! [`arch::small`](crate::arch::small).

use super::ends::Small;
use crate::arch::SelfWeight;
use crate::arch::small::{Scaled, normal_force};
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

/// `m`, `r`, `z` of the purely sliding state: the leading terms.
pub fn scaled_sliding(y: &Float) -> [Float; 3] {
    [12u32, 4, 2].map(|n| Float::with_val(y.prec(), n).recip())
}
