//! The numbers in which start values are made.

use crate::number::{Real, Stumpff};
use rug::Float;

/// A double; or an MPFR number, where start values leave the range of doubles or need more digits.
pub trait Start: Real + Stumpff + PartialOrd<f64> {
    /// The double nearest to it.
    fn to_double(&self) -> f64;

    /// First digits of the number.
    fn rough(&self) -> Self;

    /// `x` with the precision of this number.
    fn like(&self, x: f64) -> Self;

    /// The `e` with its size in `[2^(e-1), 2^e)`; `None` for zero and what is not finite.
    fn exponent_of_size(&self) -> Option<i64>;

    /// The number times `2^power`.
    fn shifted(self, power: i64) -> Self;

    /// The cube root.
    fn cube_root(self) -> Self;

    /// The arctangent.
    fn arctangent(self) -> Self;
}

impl Start for f64 {
    fn to_double(&self) -> f64 {
        *self
    }

    fn rough(&self) -> Self {
        *self
    }

    fn like(&self, x: f64) -> Self {
        x
    }

    fn exponent_of_size(&self) -> Option<i64> {
        let is_ordinary = *self != 0.0 && self.is_finite();
        is_ordinary.then(|| self.abs().log2().floor() as i64 + 1)
    }

    fn shifted(self, power: i64) -> Self {
        self * (power as f64).exp2()
    }

    fn cube_root(self) -> Self {
        self.cbrt()
    }

    fn arctangent(self) -> Self {
        self.atan()
    }
}

impl Start for Float {
    fn to_double(&self) -> f64 {
        self.to_f64()
    }

    fn rough(&self) -> Self {
        Self::with_val(64, self)
    }

    fn like(&self, x: f64) -> Self {
        Self::with_val(self.prec(), x)
    }

    fn exponent_of_size(&self) -> Option<i64> {
        self.get_exp().map(i64::from)
    }

    fn shifted(self, power: i64) -> Self {
        self << i32::try_from(power).unwrap_or(i32::MIN)
    }

    fn cube_root(self) -> Self {
        self.cbrt()
    }

    fn arctangent(self) -> Self {
        self.atan()
    }
}
