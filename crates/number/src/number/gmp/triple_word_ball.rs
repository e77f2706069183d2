//! Balls of three words: a [`FloatBall`] of about 150 bits.
//!
//! The errors of operations are below half of [`UNIT`](TripleWord::UNIT), as parts of the result, so that `UNIT |hi|` has
//! room for `|m| <= (1 + u + 2^-63) |hi|`, with `u = 2^-53`; and so has the last factor of each radius, where the leading
//! double stands for the midpoint.

use super::triple_word::TripleWord;
use super::{Ball, Magnitude, triple_word_sine};
use crate::number::float_ball::UP;
use crate::number::{DoubleBall, DoubleDouble, DoubleDoubleBall, FloatBall, Midpoint, power_of_two};
use rug::float::Round;
use rug::integer::Order;
use rug::{Float, Integer};

/// All real numbers within a radius of a number of three words.
pub type TripleWordBall = FloatBall<TripleWord>;

/// Pi, cut off.
const PI: TripleWord =
    TripleWord::constant([0x2902_4e08_8a67_cc74, 0xc4c6_628b_80dc_1cd1, 0xc90f_daa2_2168_c234], -190);

/// What 192 bits leave of a number, as a part of it.
const CUT: f64 = power_of_two(-190);

impl Midpoint for TripleWord {
    const ZERO: Self = Self::ZERO;
    const UNIT: f64 = Self::UNIT;
    const BITS: u32 = 150;
    const PI: (Self, f64) = (PI, CUT);
    const SINE_ERROR: f64 = triple_word_sine::ERROR;

    #[inline(always)]
    fn hi(self) -> f64 {
        self.hi()
    }

    #[inline(always)]
    fn shortened(self) -> f64 {
        self.shortened()
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn sin_cos(self) -> [(Self, f64); 2] {
        let (sin, cos) = triple_word_sine::sin_cos(self);
        [(sin, 0.0), (cos, 0.0)]
    }

    fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> TripleWordBall {
        cut(TripleWord::of_words(is_negative, mantissa, exponent))
    }
}

/// The ball of a number that may be cut off.
fn cut((mid, is_cut): (TripleWord, bool)) -> TripleWordBall {
    TripleWordBall::new(mid, if is_cut { mid.hi().abs() * CUT } else { 0.0 })
}

impl TripleWordBall {
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
        cut(TripleWord::of_float(ball.mid())).widened(ball.rad().to_float().to_f64_round(Round::Up))
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
        let rest = if ball.mid().is_double() { 0.0 } else { ball.mid().hi().abs() * power_of_two(-103) };
        Self::new(ball.mid().to_double_double(), (ball.rad() + rest) * UP)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use crate::number::{Enclosure, Real};
    use proptest::prelude::*;
    use rug::float::Constant;

    #[test]
    fn pi_lies_within_its_radius_and_not_within_half_of_it() {
        let pi = TripleWordBall::WHOLE.pi();
        let error = Float::with_val(300, Constant::Pi) - pi.to_ball(300).mid();
        assert!(error <= pi.rad() && error > 0.25 * pi.rad());
    }

    #[test]
    fn what_is_out_of_range_is_widened_or_the_whole_line() {
        let of = |x: f64| TripleWordBall::from(&Ball::exact(Float::with_val(53, x), 64));
        assert!(of(1e-67).rad() >= 1e-67 && !of(1e67).is_bounded());
        assert!(!TripleWordBall::from(&Ball::whole(64)).is_bounded());
        assert!(!TripleWordBall::new(DoubleDouble::exact(f64::INFINITY).into(), 0.0).is_bounded());
        assert!(!DoubleBall::from(TripleWordBall::WHOLE).is_bounded());
        assert_eq!(of(0.0).rad(), 0.0);
    }

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
            let held = |x: &Ball, by: &Ball| by.lower() <= x.lower() && x.upper() <= by.upper();
            let back = found.to_ball(400);
            prop_assert!(held(&ball, &back), "{ball:?} {found:?}");
            let [short, shorter] = [
                DoubleDoubleBall::from(found).to_ball(400),
                DoubleDoubleBall::from(DoubleBall::from(found)).to_ball(400),
            ];
            prop_assert!(held(&back, &short) && held(&back, &shorter), "{found:?}");
            let again = TripleWordBall::from(DoubleBall::from(found)).to_ball(400);
            prop_assert!(held(&shorter, &again) && held(&again, &shorter));
            let is_tight = found.rad() <= (found.mid().hi().abs() * CUT) * 1.01;
            prop_assert!(is_tight || !is_exact || found.mid().hi().abs() < 1e-66);
        }
    }
}
