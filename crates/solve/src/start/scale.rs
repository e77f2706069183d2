//! The numbers in which start values are made.

use crate::linear::Approximate;
use crate::number::{Dyadic, Real, Stumpff};

/// A double; or an MPFR number, where start values leave the range of doubles or need more digits.
pub trait Start: Approximate + Real + Stumpff + PartialOrd<f64> {
    /// Bits that are kept of a difference of two of these numbers that are near to each other.
    const KEPT: u32;

    /// The number itself, as a certificate has it.
    fn exact(&self) -> Dyadic;

    /// The double nearest to it.
    fn to_double(&self) -> f64;

    /// The number to so many bits, where these numbers can be shorter than they are.
    fn cut(self, bits: u32) -> Self;

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
    const KEPT: u32 = 13;

    fn exact(&self) -> Dyadic {
        Dyadic::from(*self)
    }

    fn to_double(&self) -> f64 {
        *self
    }

    fn cut(self, _bits: u32) -> Self {
        self
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
