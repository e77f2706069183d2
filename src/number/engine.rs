//! The arithmetic a certificate is checked in.

use super::Dyadic;
use crate::number::{AstroInterval, Enclosure};

/// Enclosures that can be made from exact binary numbers.
pub trait Engine: Enclosure {
    /// The number itself, with results to be rounded to at least `bits` bits.
    fn exact(value: &Dyadic, bits: usize) -> Self;

    /// All numbers within `radius` of `centre`.
    fn around(centre: &Dyadic, radius: &Dyadic, bits: usize) -> Self;
}

impl Engine for AstroInterval {
    fn exact(value: &Dyadic, bits: usize) -> Self {
        Self::dyadic(value.is_negative(), value.words(), value.exponent(), bits)
    }

    fn around(centre: &Dyadic, radius: &Dyadic, bits: usize) -> Self {
        let radius = Self::exact(radius, bits);
        Self::exact(centre, bits) + radius.symmetric()
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

        fn around(centre: &Dyadic, radius: &Dyadic, bits: usize) -> Self {
            Self::new(float(centre), Magnitude::upper(&float(radius)), precision(bits))
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
