//! The arithmetic a certificate is checked in.

use super::Dyadic;
use crate::number::{AstroInterval, Enclosure};

/// Enclosures that can be made from exact binary numbers.
pub trait Engine: Enclosure {
    /// The number itself, with results to be rounded to at least `bits` bits.
    fn exact(value: &Dyadic, bits: usize) -> Self;

    /// Zero, with results to be rounded to at least `bits` bits.
    fn zero(bits: usize) -> Self {
        Self::exact(&Dyadic::new(false, Vec::new(), 0), bits)
    }

    /// The same set, or one that holds it, with results to be rounded to at least `bits` bits.
    fn with_bits(&self, bits: usize) -> Self;

    /// All numbers within `radius` of one of this set.
    fn widened_by(&self, radius: &Dyadic) -> Self;

    /// All numbers within `radius` of `centre`, with results to be rounded to at least `bits` bits.
    fn around(centre: &Dyadic, radius: &Dyadic, bits: usize) -> Self {
        Self::exact(centre, bits).widened_by(radius)
    }
}

impl Engine for AstroInterval {
    fn exact(value: &Dyadic, bits: usize) -> Self {
        Self::dyadic(value.is_negative(), value.words(), value.exponent(), bits)
    }

    fn with_bits(&self, bits: usize) -> Self {
        self.with_precision(bits)
    }

    fn widened_by(&self, radius: &Dyadic) -> Self {
        self.clone() + Self::exact(radius, self.prec).symmetric()
    }
}

#[cfg(feature = "mpfr")]
mod mpfr {
    use super::{Dyadic, Engine};
    use crate::number::{Ball, Magnitude};
    use rug::integer::Order;
    use rug::{Float, Integer};

    impl Engine for Ball {
        fn exact(value: &Dyadic, bits: usize) -> Self {
            Self::exact(float(value), precision(bits))
        }

        fn with_bits(&self, bits: usize) -> Self {
            self.with_precision(precision(bits))
        }

        fn widened_by(&self, radius: &Dyadic) -> Self {
            self.clone().widened(Magnitude::upper(&float(radius)))
        }
    }

    fn precision(bits: usize) -> u32 {
        u32::try_from(bits).unwrap_or(u32::MAX)
    }

    fn float(value: &Dyadic) -> Float {
        let mantissa = Integer::from_digits(value.words(), Order::Lsf);
        let size =
            Float::with_val(mantissa.significant_bits().max(2), mantissa) << value.exponent();
        if value.is_negative() { -size } else { size }
    }

    impl From<&Float> for Dyadic {
        /// The number itself; zero for what is not finite.
        fn from(value: &Float) -> Self {
            let (mantissa, exponent) = value.to_integer_exp().unwrap_or_default();
            // Trailing zeros would only make the text longer.
            let zeros = mantissa.find_one(0).unwrap_or(0);
            let words = Integer::from(&mantissa >> zeros).to_digits(Order::Lsf);
            Self::new(mantissa < 0, words, exponent + zeros as i32)
        }
    }
}
