//! Double-double arithmetic, about 106 bits: what somebody would try for whom doubles are not enough.
//!
//! `+ - * /` and roots are those of the midpoints of balls, without their radii; sines are MPFR's, rounded.

use crate::number::{DoubleDouble, Field, Real, operators};
use crate::solve::Approximate;
use rug::Float;
use rug::float::Constant;
use std::cmp::Ordering;

/// Bits of a double-double number.
pub const BITS: u32 = 106;

/// A double-double number as the equations take it, of which no error is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unproved(DoubleDouble);

impl From<f64> for Unproved {
    fn from(x: f64) -> Self {
        Self(x.into())
    }
}

impl PartialOrd for Unproved {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        [self.0.hi(), self.0.lo()].partial_cmp(&[other.0.hi(), other.0.lo()])
    }
}

impl Unproved {
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

operators!(Unproved);

impl Field for Unproved {
    fn int(&self, n: i32) -> Self {
        Self::from(f64::from(n))
    }
}

impl Real for Unproved {
    fn pi(&self) -> Self {
        from_float(&Float::with_val(BITS, Constant::Pi))
    }

    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(&to_float(self));
        (from_float(&sin), from_float(&cos))
    }
}

impl Approximate for Unproved {
    fn exponent(&self) -> i64 {
        self.0.hi().exponent()
    }

    fn bits(&self) -> u32 {
        BITS
    }
}

/// The sum of the two doubles.
pub fn to_float(x: &Unproved) -> Float {
    Float::with_val(BITS, x.0.hi()) + x.0.lo()
}

fn from_float(x: &Float) -> Unproved {
    let high = x.to_f64();
    Unproved(DoubleDouble::sum(high, Float::with_val(BITS, x - high).to_f64()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arithmetic_has_twice_the_digits_of_a_double() {
        let one = Unproved::from(1.0);
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
