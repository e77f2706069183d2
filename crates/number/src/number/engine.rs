//! The arithmetic a certificate is checked in.

use super::{AstroInterval, DoubleBall, Dyadic, Enclosure, FloatBall, Midpoint};

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

    /// The arctangent of a positive number, to about `bits` bits relative to its size.
    ///
    /// ```text
    /// atan(q) = 2 atan(q / (1 + √(1 + q²)))        atan(x) = x (1 - x²/3 + x⁴/5 - …)
    /// ```
    ///
    /// The angle is halved until it is small and its series summed. All of it is done in enclosures, so that only the
    /// tail needs a bound of its own: it is at most the first term left out, as the terms alternate and fall.
    fn arctangent(&self, bits: usize) -> Self {
        // Balls of doubles say nothing of their bits.
        let bits = bits.max(128);
        let halvings = bits.isqrt() / 2 + 4;
        // The angle was below pi/2, so what is left is below `tan(pi/2 / 2^halvings) <= 2^-small`.
        let small = halvings - 1;
        let terms = bits / (2 * small) + 1;
        let half = |x: Self| x.clone() / ((x.square() + &x.int(1)).sqrt() + &x.int(1));
        let x = (0..halvings).fold(self.clone(), |x, _| half(x));
        let square = x.square();
        let place = |k: usize| square.ratio(1, 2 * k as i32 + 1);
        let sum = (0..terms).rev().fold(square.int(0), |sum, k| place(k) - sum * &square);
        let tail = Dyadic::new(false, vec![1], -((2 * small * terms) as i32));
        // Twice the angle so often is an exact shift.
        let doublings = Self::exact(&Dyadic::new(false, vec![1], halvings as i32), bits);
        x * sum.widened_by(&tail) * doublings
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
    use crate::number::{AstroInterval, Ball, DoubleDoubleBall, Ternary, test_config::config};
    use proptest::prelude::*;

    /// The tangent of the angle is the number, however small or large that is, and not its neighbour.
    fn turns_back<E: Engine>(bits: usize, sharp: i32) {
        for (n, d) in [(1, 1_000_000), (1, 3), (3, 5), (1, 1), (7, 2), (1_000_000, 1)] {
            let q = E::zero(bits).ratio(n, d);
            let angle = q.arctangent(bits);
            let (sin, cos) = angle.sin_cos();
            let rest = sin - cos.clone() * &q;
            assert!(rest.overlaps(&q.int(0)), "{n}/{d}");
            // The angle of so much more is larger by about its own `2^-sharp`, or by `2^-sharp`.
            let near = E::exact(&Dyadic::new(false, vec![1], -sharp), bits) * (q.square() + &q);
            let other = (q.clone() + near).arctangent(bits);
            assert_eq!(angle.is_less_than(&other), Ternary::True, "{n}/{d}");
        }
    }

    #[test]
    fn the_tangent_of_the_angle_is_the_number() {
        turns_back::<DoubleDoubleBall>(0, 90);
        for bits in [64, 200, 1000, 4000] {
            turns_back::<AstroInterval>(bits, bits as i32 - 30);
        }
    }

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
