//! The arithmetic a certificate is checked in.

use super::end::End;
use super::interval::Interval;
use super::tangent::angle_of_tangent;
use super::{DoubleBall, Dyadic, Enclosure, FloatBall, Midpoint};

/// Enclosures that can be made from exact binary numbers.
///
/// Balls of doubles have the bits that they have, whatever is asked for, and hold a number that has more.
pub trait Engine: Enclosure {
    /// The number itself, with results to be rounded to at least `bits` bits.
    fn exact(value: &Dyadic, bits: usize) -> Self;

    /// Zero, with results to be rounded to at least `bits` bits.
    fn zero(bits: usize) -> Self {
        Self::exact(&Dyadic::new(false, Vec::new(), 0), bits)
    }

    /// Gives the set, or one that holds it, with results to be rounded to at least `bits` bits.
    fn with_bits(&self, bits: usize) -> Self;

    /// All numbers within `radius` of one of this set.
    fn widened_by(&self, radius: &Dyadic) -> Self;

    /// The arctangent of a positive number, with results to be rounded to about `bits` bits.
    fn arctangent(&self, bits: usize) -> Self {
        angle_of_tangent(self, bits)
    }

    /// All numbers within `radius` of `centre`, with results to be rounded to at least `bits` bits.
    fn around(centre: &Dyadic, radius: &Dyadic, bits: usize) -> Self {
        Self::exact(centre, bits).widened_by(radius)
    }
}

impl<E: End> Engine for Interval<E> {
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

/// The bits that lead, and a bound of what is left as radius.
impl<M: Midpoint> Engine for FloatBall<M>
where
    Self: Into<DoubleBall>,
{
    fn exact(value: &Dyadic, _bits: usize) -> Self {
        M::of_words(value.is_negative(), value.words(), value.exponent().into())
    }

    fn with_bits(&self, _bits: usize) -> Self {
        *self
    }

    fn widened_by(&self, radius: &Dyadic) -> Self {
        let radius: DoubleBall = <Self as Engine>::exact(radius, 0).into();
        self.widened(radius.mid().abs()).widened(radius.rad())
    }
}

#[cfg(feature = "mpfr")]
mod mpfr {
    use super::{Dyadic, Engine};
    use crate::number::{Ball, Magnitude, arctangent};
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

        fn arctangent(&self, _bits: usize) -> Self {
            arctangent(self)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, DoubleDoubleBall, test_config::config};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(config(2000))]

        /// Mantissas of any length with ones, zeros and ties where they are cut; exponents beyond all ranges.
        #[test]
        fn balls_of_doubles_hold_the_number(
            negative in any::<bool>(),
            words in prop::collection::vec(prop_oneof![Just(0u64), Just(1), Just(u64::MAX), any::<u64>()], 0..6),
            exponent in prop_oneof![-400i32..200, -2000i32..2000, Just(i32::MAX), Just(i32::MIN / 2)],
        ) {
            let number = Dyadic::new(negative, words, exponent);
            let few = (-180..180).contains(&(i64::from(number.exponent()) + number.bits() as i64)) || number.is_zero();
            let found = <DoubleDoubleBall as Engine>::exact(&number, 0);
            let short = <DoubleBall as Engine>::exact(&number, 0);
            if exponent.unsigned_abs() < 10_000 {
                let truth = <Ball as Engine>::exact(&number, 1000);
                prop_assert!(found.to_ball(1000).overlaps(&truth));
                prop_assert!(DoubleDoubleBall::from(short).to_ball(1000).overlaps(&truth));
                let widened = <DoubleDoubleBall as Engine>::zero(0).widened_by(&number);
                prop_assert!(widened.to_ball(1000).overlaps(&truth));
            }
            prop_assert!(!few || number.bits() > 106 || found.rad() == 0.0, "exact: {number}");
            prop_assert!(!few || found.rad() <= found.mid().hi().abs() * 1e-31);
            prop_assert!(!few || number.bits() > 53 || short.rad() == 0.0, "exact: {number}");
        }
    }
}
