//! Balls of three words: a [`FloatBall`] of about 150 bits.
//!
//! The errors of operations are below half of [`UNIT`](TripleWord::UNIT), as parts of the result, so that `UNIT |hi|`
//! has room for `|m| <= (1 + u + 2^-63) |hi|`, with `u = 2^-53`; and so has the last factor of each radius, where the
//! leading double stands for the midpoint.

use super::triple_word::TripleWord;
use super::{Ball, Magnitude};
use crate::number::float_ball::UP;
use crate::number::{DoubleBall, DoubleDouble, DoubleDoubleBall, FloatBall, power_of_two};
use rug::float::Round;
use rug::integer::Order;
use rug::{Float, Integer};

/// All real numbers within a radius of a number of three words.
pub type TripleWordBall = FloatBall<TripleWord>;

impl TripleWordBall {
    /// `± mantissa 2^exponent`, the mantissa in words of 64 bits, the least significant first: exactly if it has at
    /// most 192 bits, else with a bound of what is left.
    pub fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> Self {
        let (mid, is_cut) = TripleWord::of_words(is_negative, mantissa, exponent);
        Self::new(mid, if is_cut { mid.hi().abs() * TripleWord::CUT } else { 0.0 })
    }

    /// Gives the set as a ball of MPFR, with results to be rounded to `prec` bits.
    pub fn to_ball(&self, prec: u32) -> Ball {
        let (negative, words, exponent) = self.mid().parts();
        let mut mid = Float::with_val(192, Integer::from_digits(&words, Order::Lsf)) << exponent;
        if negative {
            mid = -mid;
        }
        Ball::new(mid, Magnitude::upper(&Float::with_val(53, self.rad())), prec)
    }
}

/// The set of a ball of MPFR, but for roundings: outward.
impl From<&Ball> for TripleWordBall {
    fn from(ball: &Ball) -> Self {
        let (mantissa, exponent) = ball.mid().to_integer_exp().unwrap_or_default();
        let words: Vec<u64> = mantissa.to_digits(Order::Lsf);
        let mid = Self::of_words(mantissa < 0, &words, exponent.into());
        mid.widened(ball.rad().to_float().to_f64_round(Round::Up))
    }
}

impl From<DoubleBall> for TripleWordBall {
    #[inline]
    fn from(ball: DoubleBall) -> Self {
        Self::new(DoubleDouble::exact(ball.mid()).into(), ball.rad())
    }
}

/// Converts the set to a ball around a double next to the midpoint, outward.
impl From<TripleWordBall> for DoubleBall {
    #[inline]
    fn from(ball: TripleWordBall) -> Self {
        let hi = ball.mid().hi();
        let rest = if ball.mid().is_double() { 0.0 } else { hi.abs() * power_of_two(-52) };
        Self::new(hi, (ball.rad() + rest) * UP)
    }
}

/// Converts the set to a ball around a double-double next to the midpoint, outward.
impl From<TripleWordBall> for DoubleDoubleBall {
    #[inline]
    fn from(ball: TripleWordBall) -> Self {
        let rest =
            if ball.mid().is_double() { 0.0 } else { ball.mid().hi().abs() * power_of_two(-103) };
        Self::new(ball.mid().to_double_double(), (ball.rad() + rest) * UP)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(config(2000))]

        /// Words of ones and of zeros, a low part or none.
        #[test]
        fn conversions_hold_the_set(
            words in prop::collection::vec(prop_oneof![Just(0u64), Just(u64::MAX), any::<u64>()], 1..6),
            shift in -400i32..-60, radius in 60i32..200, is_exact in any::<bool>(),
        ) {
            let mid = Float::with_val(400, Integer::from_digits(&words, Order::Lsf)) << shift;
            let rad = if is_exact { Magnitude::ZERO } else { Magnitude::upper(&Float::with_val(53, &mid >> radius)) };
            let ball = Ball::new(mid, rad, 400);
            let found = TripleWordBall::from(&ball);
            let back = found.to_ball(400);
            prop_assert!(back.lower() <= ball.lower() && ball.upper() <= back.upper(), "{ball:?} {found:?}");
            let both = DoubleDoubleBall::from(found);
            let off = Float::with_val(800, both.mid().hi()) + both.mid().lo() - back.mid();
            prop_assert!(off.abs() + found.rad() <= both.rad(), "{found:?} {both:?}");
            let double = DoubleBall::from(found);
            let off = Float::with_val(800, double.mid()) - back.mid();
            prop_assert!(off.abs() + found.rad() <= double.rad(), "{found:?} {double:?}");
            let again = TripleWordBall::from(double);
            prop_assert!(again.mid().is_double() && again.mid().hi() == double.mid());
            prop_assert_eq!(again.rad(), double.rad());
            let is_tight = found.rad() <= (found.mid().hi().abs() * TripleWord::CUT) * 1.01;
            // No radius is below 2^-330.
            prop_assert!(is_tight || !is_exact || found.mid().hi().abs() < 1e-41);
        }
    }
}
