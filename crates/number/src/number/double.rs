//! `f64`: a quick look. Nothing that comes out of it is certified.

use super::{Field, Real};

/// The `e` with `2^e <= x < 2^(e+1)`, for positive doubles; -1023 for zero and for those that are not normal.
pub(super) fn exponent(x: f64) -> i32 {
    (x.to_bits() >> 52) as i32 - 1023
}

impl Field for f64 {
    fn int(&self, n: i32) -> Self {
        f64::from(n)
    }
}

impl Real for f64 {
    fn pi(&self) -> Self {
        std::f64::consts::PI
    }

    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }

    fn sin_cos(&self) -> (Self, Self) {
        f64::sin_cos(*self)
    }
}
