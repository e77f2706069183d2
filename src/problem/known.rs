//! What is known of a quantity, and how it compares with a bound.

use crate::number::{Enclosure, Ternary};

/// What is known of a quantity.
pub enum Known<E> {
    /// An enclosure.
    Enclosed(E),
    /// The angle whose tangent is enclosed, between 0 and a right angle.
    AngleOfTangent(E),
    /// Without bound.
    Infinite,
}

impl<E: Enclosure> Known<E> {
    /// Whether the quantity, in degrees if `degrees`, lies between two bounds. `True` is a proof.
    pub fn lies_between(&self, [low, high]: &[E; 2], degrees: bool) -> Ternary {
        let in_radians = |bound: &E| {
            if degrees { bound.clone() * bound.pi() / bound.int(180) } else { bound.clone() }
        };
        let (low, high) = (in_radians(low), in_radians(high));
        match self {
            Self::Enclosed(x) => low.is_less_than(x).and(x.is_less_than(&high)),
            // For angles between 0 and a right angle the tangent grows: no arctangent is needed.
            Self::AngleOfTangent(tangent) => {
                let ((sin, cos), (other_sin, other_cos)) = (low.sin_cos(), high.sin_cos());
                let in_quadrant =
                    low.is_positive().and(high.is_less_than(&(high.pi() / high.int(2))));
                in_quadrant
                    .and(cos.is_positive())
                    .and(other_cos.is_positive())
                    .and(sin.is_less_than(&(cos * tangent)))
                    .and((other_cos * tangent).is_less_than(&other_sin))
            }
            Self::Infinite => Ternary::False,
        }
    }

    /// Whether the quantity is exactly zero: nothing above it, nothing below.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Enclosed(x) => {
                x.is_positive() == Ternary::False && (-x.clone()).is_positive() == Ternary::False
            }
            _ => false,
        }
    }

    /// Whether it is infinite.
    pub fn is_infinite(&self) -> bool {
        matches!(self, Self::Infinite)
    }
}
