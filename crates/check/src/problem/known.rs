//! Knowledge of a quantity, and how it compares with a bound.

use crate::number::{Dyadic, Enclosure, Engine, Ternary};

/// Knowledge of a quantity.
pub enum Known<E> {
    /// An enclosure.
    Enclosed(E),
    /// The angle whose tangent is enclosed, between 0 and a right angle.
    AngleOfTangent(E),
    /// Without bound.
    Infinite,
}

/// Bits of a correction, which is small: what it lacks is smaller still.
const FEW: usize = 128;
/// Largest number of times that an angle is corrected.
const CORRECTIONS: usize = 4;

impl<E: Engine> Known<E> {
    /// An enclosure, in numbers of `bits` bits; of an angle known by its tangent, from a number `near` it: the
    /// nearer, the cheaper. `None` for infinity, and where `near` is not between 0 and a right angle.
    ///
    /// With sine `s` and cosine `c` of `near`, the tangent `T` is that of `near + atan t`, `t = (T c - s) / (c + T s)`,
    /// as the two angles are less than a right angle apart where the divisor is positive; and
    /// `|atan t - t| <= |t|³`.
    pub fn enclosed(&self, near: &E, bits: usize) -> Option<E> {
        let tangent = match self {
            Self::Enclosed(x) => return Some(x.clone()),
            Self::AngleOfTangent(tangent) => tangent,
            Self::Infinite => return None,
        };
        let up_to = |exponent| E::zero(FEW).widened_by(&Dyadic::new(false, vec![1], exponent));
        let (unit, small) = (up_to(0), up_to(-((bits / 3) as i32)));
        let mut angle = near.clone();
        for _ in 0..CORRECTIONS {
            let near = angle.midpoint();
            let (sin, cos) = near.sin_cos();
            let across = (tangent.clone() * &cos - &sin).with_bits(FEW);
            let along = tangent.with_bits(FEW) * sin.with_bits(FEW) + cos.with_bits(FEW);
            let in_quadrant =
                near.is_positive().and(near.is_less_than(&near.int(2))).and(cos.is_positive());
            if !in_quadrant.and(along.is_positive()).is_proved() {
                return None;
            }
            let t = across / along;
            angle = near + &t + t.square() * &t * &unit;
            if t.lies_inside(&small) {
                break;
            }
        }
        Some(angle)
    }
}

impl<E: Enclosure> Known<E> {
    /// Tells whether the quantity is exactly zero: nothing above it, nothing below.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Enclosed(x) => {
                x.is_positive() == Ternary::False && (-x.clone()).is_positive() == Ternary::False
            }
            _ => false,
        }
    }

    /// Tells whether the quantity is infinite.
    pub fn is_infinite(&self) -> bool {
        matches!(self, Self::Infinite)
    }
}
