//! An equation of the form `x = numerator / denominator`, usable in both shapes.

use crate::number::Field;

/// `x = numerator / denominator`.
///
/// Most equations of the paper give a thrust as a moment over a lever arm, or a friction as a shear
/// over a normal force. As a residual, `denominator * x - numerator`, such an equation needs no
/// division and stays defined where the denominator vanishes; the two agree where it does not, which
/// a proof that uses the residual has to show.
#[derive(Clone, Debug)]
pub struct Quotient<T> {
    /// A moment or a shear force.
    pub numerator: T,
    /// A lever arm or a normal force.
    pub denominator: T,
}

impl<T: Field> Quotient<T> {
    /// `numerator / denominator`.
    #[inline(always)]
    pub fn value(&self) -> T {
        self.numerator.clone() / &self.denominator
    }

    /// `denominator * x - numerator`: zero where `x` is the value.
    #[inline(always)]
    pub fn residual(&self, x: &T) -> T {
        self.denominator.clone() * x - &self.numerator
    }

    /// `a/b - c/d` times `b d`: zero where the two values are equal.
    pub fn difference(&self, other: &Self) -> T {
        self.numerator.clone() * &other.denominator - other.numerator.clone() * &self.denominator
    }
}
