//! Balls of double-doubles: a [`FloatBall`] of about 106 bits.
//!
//! Each operation errs by at most [`UNIT`](DoubleDouble::UNIT) `|hi|` at its midpoint `m = hi + lo`:
//! `|m| <= (1 + u) |hi|` with `u = 2^-53`, and the proved errors are at most `(15 + 2^-40) u² |m|`, so that
//! `16 u² |hi|` has room for that factor. Nothing overflows or underflows unseen, as the error of a Dekker product of
//! two midpoints, a multiple of `2^-(2 220 + 2 53)`, is exact. A low part may be of any size; where its products
//! underflow they add less than `2^-1070`, and `u² |hi| / 2` is above `2^-560`.

use super::float_ball::{Branchless, FloatBall, UP, anywhere, power_of_two};
use super::{DoubleBall, DoubleDouble, DoubleDoubleBy, Product};

/// All real numbers within a radius of a double-double.
pub type DoubleDoubleBall = FloatBall<DoubleDouble>;

impl DoubleDoubleBall {
    /// `± mantissa 2^exponent`, the mantissa in words of 64 bits, the least significant first: exactly if it has at
    /// most 106 bits, else with a bound of what is left.
    pub fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> Self {
        if let ([word], 0) = (mantissa, exponent) {
            // Nearly every number that is read: both halves are doubles.
            let [high, low] = [word >> 32, word & u64::from(u32::MAX)].map(|half| half as f64);
            let unit = if is_negative { -1.0 } else { 1.0 };
            return Self::exact(DoubleDouble::sum(unit * power_of_two(32) * high, unit * low));
        }
        let zeros = mantissa.iter().rev().take_while(|word| **word == 0).count();
        let Some((top, rest)) = mantissa[..mantissa.len() - zeros].split_last() else {
            return Self::exact(DoubleDouble::ZERO);
        };
        // The leading 126 bits, from three words of which the first begins with its highest bit.
        let word = |i: usize| u128::from(rest.len().checked_sub(i).map_or(0, |at| rest[at]));
        let shift = top.leading_zeros();
        let below = if shift > 0 { word(2) >> (64 - shift) } else { 0 };
        let head = (u128::from(*top) << 64 | word(1)) << shift | below;
        let is_cut = head & 3 != 0
            || (word(2) << shift) as u64 != 0
            || rest.iter().rev().skip(2).any(|word| *word != 0);
        let leading = (head >> 2) as i128;
        let exponent = exponent + 64 * (rest.len() as i64 + 1) - i64::from(shift) - 126;
        if exponent > 200 {
            return Self::WHOLE;
        }
        // Smaller ones are out of the range of a ball, and become a part of the radius.
        let unit = power_of_two(exponent.max(-700) as i32);
        // Both conversions round to nearest, and what they leave is an integer.
        let hi = leading as f64;
        let low = leading - hi as i128;
        let lo = low as f64;
        let left = (low - lo as i128).unsigned_abs() + u128::from(is_cut);
        let sign = if is_negative { -unit } else { unit };
        Self::new(DoubleDouble::sum(sign * hi, sign * lo), unit * left as f64)
    }

    /// The bits of both parts of the midpoint and of the radius.
    #[inline]
    pub fn to_bits(&self) -> [u64; 3] {
        [self.mid.hi(), self.mid.lo(), self.rad].map(f64::to_bits)
    }

    /// The double nearest to every number of the ball, ties to even; `None` if they may differ, and outside
    /// `2^±200`.
    #[inline]
    pub fn nearest_double(&self) -> Option<f64> {
        let (double, rest) = (self.mid.hi(), self.mid.lo());
        let size = double.abs();
        // A sum of two doubles is normalised so that its first part is the nearest double.
        let is_exact = self.rad == 0.0;
        let is_near = (rest.abs() + self.rad) * UP < 0.5 * (size - size.next_down());
        let in_range =
            size == 0.0 && is_exact || (power_of_two(-200)..power_of_two(200)).contains(&size);
        // Adding zero makes a negative zero positive.
        (in_range && (is_exact || is_near)).then_some(double + 0.0)
    }
}

/// Balls of double-doubles, apart by their parts, as they go through lanes: high and low parts of the midpoints, radii.
#[derive(Clone, Copy, Debug)]
pub struct BallColumn<const N: usize>([[f64; N]; 3]);

impl<const N: usize> BallColumn<N> {
    /// Balls of which nothing is known.
    pub const WHOLE: Self = Self([[0.0; N], [0.0; N], [f64::INFINITY; N]]);

    /// Puts a ball in a place.
    #[inline(always)]
    pub fn put(&mut self, place: usize, ball: &DoubleDoubleBall) {
        let Self([highs, lows, radii]) = self;
        (highs[place], lows[place], radii[place]) = (ball.mid.hi(), ball.mid.lo(), ball.rad);
    }

    /// Puts what lanes have found in a place, without a branch.
    #[inline(always)]
    pub fn put_found<P: Product>(
        &mut self,
        place: usize,
        found: &FloatBall<DoubleDoubleBy<P>, Branchless>,
    ) {
        let mid = DoubleDouble::sum(found.mid.hi(), found.mid.lo());
        let (is_kept, rad) = anywhere(mid.hi().abs(), found.rad);
        let mid = if is_kept { mid } else { DoubleDouble::ZERO };
        self.put(place, &DoubleDoubleBall::within(mid, rad));
    }

    /// The ball in a place.
    #[inline(always)]
    pub fn get(&self, place: usize) -> DoubleDoubleBall {
        let Self([highs, lows, radii]) = self;
        DoubleDoubleBall::within(DoubleDouble::constant(highs[place], lows[place]), radii[place])
    }

    /// The ball in a place, for lanes with products by `P`.
    #[inline(always)]
    pub fn given<P: Product>(&self, place: usize) -> FloatBall<DoubleDoubleBy<P>, Branchless> {
        let Self([highs, lows, radii]) = self;
        FloatBall::within(DoubleDoubleBy::constant(highs[place], lows[place]), radii[place])
    }
}

#[cfg(feature = "mpfr")]
mod mpfr {
    use super::{DoubleDouble, DoubleDoubleBall, UP};
    use crate::number::float_ball::SMALLEST;
    use crate::number::{Ball, Magnitude};
    use rug::{Float, float::Round};

    impl DoubleDoubleBall {
        /// Gives the set as a ball of MPFR, with results to be rounded to `prec` bits. Only a midpoint that spans
        /// more than 256 bits is rounded, outward.
        pub fn to_ball(&self, prec: u32) -> Ball {
            let part = |x: f64| Ball::exact(Float::with_val(53, x), prec.max(256));
            let mid = part(self.mid.hi()) + part(self.mid.lo());
            // The sum has more bits than asked for: they are kept.
            let mid = Ball::new(mid.mid().clone(), mid.rad(), prec);
            mid.widened(Magnitude::upper(&Float::with_val(53, self.rad)))
        }
    }

    /// The set of a ball of MPFR, but for roundings: outward.
    impl From<&Ball> for DoubleDoubleBall {
        fn from(ball: &Ball) -> Self {
            let away = |x: &Float| x.to_f64_round(Round::AwayZero).abs();
            let rad = away(&ball.rad().to_float());
            let hi = ball.mid().to_f64();
            if hi != 0.0 && hi.abs() < SMALLEST {
                return Self::new(DoubleDouble::ZERO, (away(ball.mid()) + rad) * UP);
            }
            // Enough bits for exact differences.
            let bits = ball.mid().prec() + 64;
            let mid = DoubleDouble::sum(hi, Float::with_val(bits, ball.mid() - hi).to_f64());
            let rest = Float::with_val(bits, ball.mid() - mid.hi()) - mid.lo();
            Self::new(mid, (rad + away(&rest)) * UP)
        }
    }
}

impl From<DoubleDoubleBall> for DoubleBall {
    #[inline(always)]
    fn from(ball: DoubleDoubleBall) -> Self {
        ball.in_doubles()
    }
}

impl From<DoubleBall> for DoubleDoubleBall {
    #[inline(always)]
    fn from(ball: DoubleBall) -> Self {
        ball.in_double_doubles()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, Magnitude};
    use crate::number::{Enclosure, Ternary};
    use rug::Float;

    /// The low part counts: `1 - 2^-54 ± r` for an `r` next to one.
    #[test]
    fn a_sign_that_hangs_on_the_low_part_is_not_guessed() {
        let almost = DoubleDouble::sum(1.0, -f64::EPSILON / 4.0);
        let sign = |rad| DoubleDoubleBall::new(almost, rad).is_positive();
        assert_eq!(sign(1.0f64.next_down()), Ternary::Undecided);
        assert_eq!([sign(1.0), sign(0.5)], [Ternary::Undecided, Ternary::True]);
        assert_eq!((-DoubleDoubleBall::new(almost, 0.5)).is_positive(), Ternary::False);
    }

    /// A ball by its parts, of which zeros of both signs are one.
    fn parts(ball: &DoubleDoubleBall) -> [f64; 3] {
        [ball.mid().hi(), ball.mid().lo(), ball.rad()]
    }

    /// Columns hold the ball that is made of each row alone, at every edge.
    #[test]
    fn columns_put_into_range_what_they_are_given() {
        let (inf, nan) = (f64::INFINITY, f64::NAN);
        let [small, large] = [-220, 220].map(power_of_two);
        let middles =
            [0.0, 5e-324, small.next_down(), small, 1.5, large, large.next_up(), inf, nan];
        let least = power_of_two(-330);
        let radii = [0.0, 5e-324, least, 1e-20, large, large.next_up(), inf, nan, 1.0];
        let mut column = BallColumn::<2>::WHOLE;
        assert!((0..2).all(|place| !column.get(place).is_bounded()));
        for (middle, rad) in middles.into_iter().flat_map(|x| radii.map(|rad| (x, rad))) {
            for (middle, rad) in [(middle, rad), (-middle, rad), (middle, -rad)] {
                let mid = DoubleDouble::sum(middle, middle * 1e-20);
                column.put_found(1, &FloatBall::<DoubleDouble, Branchless>::new(mid, rad));
                let [found, expected] = [column.get(1), DoubleDoubleBall::new(mid, rad)];
                assert_eq!(parts(&found), parts(&expected), "{middle} {rad}");
                assert_eq!(parts(&expected)[2].is_finite(), found.is_bounded(), "{middle} {rad}");
                column.put(0, &found);
                assert_eq!(column.get(0).to_bits(), found.to_bits());
            }
        }
    }

    /// A word alone is the same number as with a word of zeros above it.
    #[test]
    fn a_whole_number_of_one_word_is_exact() {
        let words = [0, 1, u64::from(u32::MAX), (1 << 53) + 1, 1 << 63 | 1, u64::MAX - 1, u64::MAX];
        for (word, is_negative) in words.into_iter().flat_map(|w| [(w, false), (w, true)]) {
            let [one, two] = [&[word][..], &[word, 0]];
            let [one, two] = [one, two].map(|of| DoubleDoubleBall::of_words(is_negative, of, 0));
            assert_eq!(parts(&one), parts(&two), "{word} {is_negative}");
            assert_eq!(one.rad(), 0.0);
        }
    }

    /// Numbers of more bits than fit, far out of range, next to a tie: held, and tightly.
    #[test]
    fn a_ball_of_mpfr_is_held_and_comes_back() {
        let third = Float::with_val(500, 1) / 3u32;
        let tie = Float::with_val(500, 1) + f64::EPSILON * 1.5 - Float::with_val(500, 1e-40);
        let far = |shift: i32| Float::with_val(500, &third << shift);
        for mid in
            [third.clone(), -third.clone(), tie, far(-230), far(-1080), far(-5000), far(5000)]
        {
            for rad in
                [Magnitude::ZERO, Magnitude::power_of_two(-60), Magnitude::power_of_two(-2000)]
            {
                let ball = Ball::new(mid.clone(), rad, 500);
                let found = DoubleDoubleBall::from(&ball);
                let back = found.to_ball(500);
                assert!(back.lower() <= ball.lower() && ball.upper() <= back.upper(), "{ball:?}");
                let moderate = mid.get_exp().is_some_and(|e| (-200..200).contains(&e));
                assert!(!moderate || found.rad() < 1e-32 || !rad.is_zero(), "{ball:?} {found:?}");
                let short = DoubleBall::from(found);
                let short = DoubleDoubleBall::from(short).to_ball(500);
                assert!(short.lower() <= back.lower() && back.upper() <= short.upper());
            }
        }
        assert!(!DoubleDoubleBall::from(&Ball::whole(64)).is_bounded());
        assert_eq!(DoubleDoubleBall::from(&Ball::integer(7, 64)).rad(), 0.0);
    }
}
