//! How every number type is made and compared.

use couplet::number::{
    AstroInterval, Ball, Dual, Enclosure, Engine, ExactNumber, Field, FloatBall, Midpoint,
};
use rug::{Float, Rational};

/// How a number type is made from an exact value, and when two of its values may be the same.
pub(super) trait Sample: Field {
    /// The value, as well as the type can hold it.
    fn sample(value: &Rational) -> Self;
    /// Whether two values can be the same number; for an exact type, whether they are.
    fn agrees(&self, other: &Self) -> bool;
    /// A value that is certainly another one, at any size: `x² + 1` is at least `2 |x|`.
    fn spoiled(&self) -> Self {
        self.clone() + self.square() + self.int(1)
    }
}

/// Precision of the samples in bits.
pub(super) const BITS: u32 = 192;

impl Sample for f64 {
    fn sample(value: &Rational) -> Self {
        value.to_f64()
    }
    fn agrees(&self, other: &Self) -> bool {
        approx::relative_eq!(*self, *other, max_relative = 1e-9, epsilon = 1e-9)
    }
}

impl Sample for Float {
    fn sample(value: &Rational) -> Self {
        Float::with_val(BITS, value)
    }
    fn agrees(&self, other: &Self) -> bool {
        let difference = Float::with_val(BITS, self - other).abs();
        let scale = Float::with_val(BITS, 1).max(&self.clone().abs());
        difference <= scale >> 100
    }
}

impl Sample for Rational {
    fn sample(value: &Rational) -> Self {
        value.clone()
    }
    fn agrees(&self, other: &Self) -> bool {
        self == other
    }
}

impl Sample for Ball {
    fn sample(value: &Rational) -> Self {
        Ball::enclosing(value, BITS)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.overlaps(other)
    }
}

impl Sample for AstroInterval {
    fn sample(value: &Rational) -> Self {
        ExactNumber::from(value).enclosure(BITS)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.overlaps(other)
    }
}

impl<M: Midpoint> Sample for FloatBall<M>
where
    Self: Engine,
{
    fn sample(value: &Rational) -> Self {
        ExactNumber::from(value).enclosure(M::BITS)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.overlaps(other)
    }
}

/// The first component of the gradient is a variable, so that derivatives take part.
impl<T: Sample> Sample for Dual<T> {
    fn sample(value: &Rational) -> Self {
        Dual::variable(T::sample(value), 0)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.value().agrees(other.value()) && self.derivative(0).agrees(&other.derivative(0))
    }
}
