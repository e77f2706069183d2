//! Double-double arithmetic, about 106 bits: what somebody would try for whom doubles are not enough.
//!
//! `+ - * /` and roots are those of the crate `qd`, which has no sines: they are MPFR's, rounded. (The
//! other kept crate, `twofloat` 0.8, has sines, to 23 digits; but its quotient of two numbers has the
//! digits of a double only, 1/3 for instance.)

use crate::number::{Field, Real};
use crate::solve::Approximate;
use qd::Quad;
use rug::Float;

/// Bits of a double-double number.
pub const BITS: u32 = 106;

impl Field for Quad {
    fn int(&self, n: i32) -> Self {
        Quad::from(f64::from(n))
    }
}

impl Real for Quad {
    fn pi(&self) -> Self {
        Quad::PI
    }

    fn sqrt(&self) -> Self {
        Quad::sqrt(*self)
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(&to_float(self));
        (from_float(&sin), from_float(&cos))
    }
}

impl Approximate for Quad {
    fn exponent(&self) -> i64 {
        self.0.exponent()
    }
}

/// The sum of the two doubles.
pub fn to_float(x: &Quad) -> Float {
    Float::with_val(BITS, x.0) + x.1
}

fn from_float(x: &Float) -> Quad {
    let high = x.to_f64();
    Quad(high, Float::with_val(BITS, x - high).to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arithmetic_has_twice_the_digits_of_a_double() {
        let one = Quad::from(1.0);
        let exact = |n: u32| Float::with_val(200, n);
        let cases = [
            (one.ratio(1, 3), exact(1) / 3u32),
            (Real::sqrt(&one.int(2)), exact(2).sqrt()),
            (Real::sin_cos(&one).0, exact(1).sin()),
            (one.pi(), exact(4) * exact(1).atan()),
        ];
        for (found, truth) in cases {
            let error = truth - to_float(&found);
            assert!(error.clone().abs() < 1e-30, "{error}");
        }
    }
}
