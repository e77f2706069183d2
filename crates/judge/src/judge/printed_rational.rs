//! Rational numbers as they are printed: short ones without a heap.

use crate::number::{Decimal, power_of_ten};
use rug::Rational;

/// The largest power of ten in 64 bits.
const MOST_PLACES: i64 = 19;

/// A rational number.
#[derive(Clone, Debug)]
pub(super) enum PrintedRational {
    /// `± integer / scale`: nearly every number that is printed.
    Short {
        negative: bool,
        integer: u64,
        scale: u64,
    },
    Long(Rational),
}

impl PrintedRational {
    /// An integer.
    pub(super) fn integer(integer: u64) -> Self {
        Self::Short { negative: false, integer, scale: 1 }
    }

    /// The value of a decimal.
    pub(super) fn decimal(x: &Decimal) -> Self {
        let digits = if x.digits().is_empty() { "0" } else { x.digits() };
        let places = (-MOST_PLACES..=0).contains(&x.exponent()).then(|| -x.exponent() as u32);
        match (digits.parse(), places) {
            (Ok(integer), Some(places)) => {
                Self::Short { negative: x.is_negative(), integer, scale: 10u64.pow(places) }
            }
            _ => Self::Long(x.to_rational()),
        }
    }

    /// `10^exponent`; `None` beyond what any number that is read has.
    pub(super) fn power_of_ten(exponent: i64) -> Option<Self> {
        let size = u32::try_from(exponent.unsigned_abs()).ok()?;
        Some(match exponent {
            ..0 => Self::Long(Rational::from(power_of_ten(size)).recip()),
            0..=MOST_PLACES => Self::integer(10u64.pow(size)),
            _ => Self::Long(power_of_ten(size).into()),
        })
    }

    /// `2^exponent`.
    pub(super) fn power_of_two(exponent: i32) -> Self {
        match exponent {
            0..64 => Self::integer(1 << exponent),
            _ => Self::Long(Rational::from(1) << exponent),
        }
    }

    pub(super) fn to_rational(&self) -> Rational {
        match self {
            &Self::Short { negative, integer, scale } => {
                let size = Rational::from((integer, scale));
                if negative { -size } else { size }
            }
            Self::Long(x) => x.clone(),
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        match self {
            Self::Short { integer, .. } => *integer == 0,
            Self::Long(x) => x.is_zero(),
        }
    }
}
