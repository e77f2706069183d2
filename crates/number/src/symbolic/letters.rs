//! The indeterminates as polynomials, numbers and angles.

use super::{Fraction, Polynomial, Symbol};
use crate::number::Angle;

/// Letters that a formula is written with.
pub trait Letters: Sized {
    /// The indeterminate as a polynomial.
    fn polynomial(self) -> Polynomial;

    /// The indeterminate as a number.
    fn number(self) -> Fraction;

    /// The rotational joint `beta`, with `S` and `C`.
    fn joint() -> Angle<Fraction>;

    /// The sliding joint `beta_s`, with its sine and cosine.
    fn sliding_joint() -> Angle<Fraction>;

    /// The half opening `alpha`, with its sine and cosine.
    fn half_opening() -> Angle<Fraction>;
}

impl Letters for Symbol {
    fn polynomial(self) -> Polynomial {
        Polynomial::symbol(self)
    }

    fn number(self) -> Fraction {
        Fraction::from(self.polynomial())
    }

    fn joint() -> Angle<Fraction> {
        Angle { rad: Self::Joint, sin: Self::Sine, cos: Self::Cosine }.map(Self::number)
    }

    fn sliding_joint() -> Angle<Fraction> {
        let (rad, sin, cos) = (Self::SlidingJoint, Self::SineOfSliding, Self::CosineOfSliding);
        Angle { rad, sin, cos }.map(Self::number)
    }

    fn half_opening() -> Angle<Fraction> {
        let (rad, sin, cos) = (Self::HalfOpening, Self::SineOfOpening, Self::CosineOfOpening);
        Angle { rad, sin, cos }.map(Self::number)
    }
}
