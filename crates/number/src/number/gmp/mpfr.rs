//! `rug::Float`: MPFR numbers rounded to nearest, the arithmetic of candidates.
//!
//! rug's binary operators take the precision of the **left** operand; values that meet in one
//! formula are therefore made with one precision.

use super::{Field, Real};
use rug::Float;
use rug::float::Constant;

impl Field for Float {
    fn int(&self, n: i32) -> Self {
        Float::with_val(self.prec(), n)
    }

    fn square(&self) -> Self {
        Float::with_val(self.prec(), self.square_ref())
    }
}

impl Real for Float {
    fn pi(&self) -> Self {
        Float::with_val(self.prec(), Constant::Pi)
    }

    fn sqrt(&self) -> Self {
        Float::with_val(self.prec(), self.sqrt_ref())
    }

    fn sin_cos(&self) -> (Self, Self) {
        self.clone().sin_cos(Float::new(self.prec()))
    }
}
