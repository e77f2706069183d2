//! Double-double arithmetic, about 106 bits: what somebody would try for whom doubles are not enough.
//!
//! `+ - * /` and roots are those of the crate `qd`, which has no sines: they are MPFR's, rounded. (The
//! other kept crate, `twofloat` 0.8, has sines, to 23 digits; but its quotient of two numbers has the
//! digits of a double only, 1/3 for instance.)

use crate::number::{Field, Real, operators};
use crate::solve::Approximate;
use qd::Quad;
use rug::Float;

/// Bits of a double-double number.
pub const BITS: u32 = 106;

/// A number of the crate `qd` as the equations take it.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Qd(Quad);

impl From<f64> for Qd {
    fn from(x: f64) -> Self {
        Self(Quad::from(x))
    }
}

impl Qd {
    fn negated(self) -> Self {
        Self(-self.0)
    }

    fn plus(self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }

    fn minus(self, other: &Self) -> Self {
        Self(self.0 - other.0)
    }

    fn times(self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }

    fn over(self, other: &Self) -> Self {
        Self(self.0 / other.0)
    }
}

operators!(Qd);

impl Field for Qd {
    fn int(&self, n: i32) -> Self {
        Self::from(f64::from(n))
    }
}

impl Real for Qd {
    fn pi(&self) -> Self {
        Self(Quad::PI)
    }

    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(&to_float(self));
        (from_float(&sin), from_float(&cos))
    }
}

impl Approximate for Qd {
    fn exponent(&self) -> i64 {
        self.0.0.exponent()
    }

    fn bits(&self) -> u32 {
        BITS
    }
}

/// The sum of the two doubles.
pub fn to_float(x: &Qd) -> Float {
    Float::with_val(BITS, x.0.0) + x.0.1
}

fn from_float(x: &Float) -> Qd {
    let high = x.to_f64();
    Qd(Quad(high, Float::with_val(BITS, x - high).to_f64()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arithmetic_has_twice_the_digits_of_a_double() {
        let one = Qd::from(1.0);
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
