//! An angle together with its sine and cosine.

use super::{Dual, Field, Real};

/// An angle in radians with its sine and cosine.
///
/// Handing all three to an equation leaves it algebraic: it asks for a [`Field`] only, and runs
/// over exact numbers too.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle<T> {
    /// The angle in radians.
    pub rad: T,
    /// Sine of the angle.
    pub sin: T,
    /// Cosine of the angle.
    pub cos: T,
}

impl<T: Real> Angle<T> {
    /// The angle of `rad` radians.
    pub fn new(rad: T) -> Self {
        let (sin, cos) = rad.sin_cos();
        Self { rad, sin, cos }
    }
}

impl<T: Field> Angle<T> {
    /// The angle zero, "like" `like`.
    #[inline(always)]
    pub fn zero(like: &T) -> Self {
        Self { rad: like.int(0), sin: like.int(0), cos: like.int(1) }
    }

    /// `1 - cos`, the versine.
    #[inline(always)]
    pub fn versine(&self) -> T {
        self.cos.int(1) - &self.cos
    }

    /// `rad * cot(rad)`, which is 0/0 at zero: there the value of the limit is exactly one.
    #[inline(always)]
    pub fn times_cotangent(&self) -> T {
        self.rad.clone() * &self.cos / &self.sin
    }

    /// The angle as unknown number `index`: a value with derivative one, whose sine and cosine
    /// have the derivatives cosine and minus sine.
    pub fn variable(&self, index: usize) -> Angle<Dual<T>> {
        let one = self.rad.int(1);
        Angle {
            rad: Dual::with_derivative(self.rad.clone(), index, one),
            sin: Dual::with_derivative(self.sin.clone(), index, self.cos.clone()),
            cos: Dual::with_derivative(self.cos.clone(), index, -self.sin.clone()),
        }
    }
}

impl<T> Angle<T> {
    /// The angle with its three values in another number.
    #[inline(always)]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Angle<U> {
        Angle { rad: f(self.rad), sin: f(self.sin), cos: f(self.cos) }
    }
}
