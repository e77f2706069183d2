//! Balls of fixed point: some words on the stack and a radius that is a double.
//!
//! The midpoint is `± m 2^-64(N-1)` with an integer `m` of `N` words, of which the topmost is the whole part, below
//! `2^31`. The radius counts units of the last place, `2^-64(N-1)`. Sums and products with integers are exact; any
//! other product or quotient is cut off, which is below one unit and `2^-58`.
//!
//! **The radius is rounded up**: it is a sum of products of doubles that are not negative, with at most sixteen
//! roundings on any path, each of which takes away less than a part `2^-53`; the last factor is [`UP`] `= 1 +
//! 2^-48`, which is more by a part `2^-49`. It is zero or at least one, and at most [`LARGEST`](ShortBall::LARGEST), so
//! that nothing overflows; what is beyond, or NaN, becomes the whole line. A bound of a size is zero or at least
//! `2^-1000`.

use super::words;
use super::{Ball, Magnitude};
use crate::number::{Field, power_of_two};
use rug::Integer;
use rug::float::Round;
use rug::integer::Order;
use std::cmp::Ordering;

/// All real numbers within a radius of a number of `N` words, 2 to 40.
#[derive(Clone, Copy, Debug)]
pub struct ShortBall<const N: usize> {
    negative: bool,
    /// The least significant first.
    words: [u64; N],
    /// Radius in units of the last place.
    rad: f64,
}

/// Rounds a radius up.
const UP: f64 = 1.0 + 32.0 * f64::EPSILON / 2.0;
/// Rounds a lower bound down.
const DOWN: f64 = 1.0 - 32.0 * f64::EPSILON / 2.0;
/// Above all whole parts.
const WHOLE_PART: u64 = 1 << 31;
/// The exponent of a radius in units of the last place, at most.
const MOST_PLACES: i32 = 960;
/// The exponent of the least bound of a size but zero.
const LEAST_EXPONENT: i32 = -1000;

impl<const N: usize> ShortBall<N> {
    /// The whole line: nothing is known.
    pub const WHOLE: Self = Self { negative: false, words: [0; N], rad: f64::INFINITY };

    /// Binary places.
    const PLACES: i32 = {
        assert!(2 <= N && N <= 40);
        64 * (N as i32 - 1)
    };

    /// The largest radius, in units of the last place: no more than one.
    const LARGEST: f64 =
        power_of_two(if Self::PLACES < MOST_PLACES { Self::PLACES } else { MOST_PLACES });

    #[inline]
    fn settled(negative: bool, words: [u64; N], rad: f64) -> Self {
        if words[N - 1] < WHOLE_PART && (0.0..=Self::LARGEST).contains(&rad) {
            Self { negative, words, rad }
        } else {
            Self::WHOLE
        }
    }

    /// The radius of what was cut off, at least one unit.
    #[inline]
    fn cut(negative: bool, words: [u64; N], rad: f64) -> Self {
        Self::settled(negative, words, (rad + 1.0) * UP)
    }

    /// The ball times `2^shift` in `M` words, cut off where it has further digits; for a `shift` within ±2600.
    pub fn shifted<const M: usize>(&self, shift: i32) -> ShortBall<M> {
        let places = shift + 64 * (M as i32 - N as i32);
        let (apart, up) = (places.div_euclid(64), places.rem_euclid(64));
        let from = |at: i32| {
            usize::try_from(at).ok().and_then(|at| self.words.get(at)).map_or(0, |word| *word)
        };
        // A word of the result, from the two that meet there.
        let word = |at: i32| match up {
            0 => from(at - apart),
            _ => from(at - apart) << up | from(at - apart - 1) >> (64 - up),
        };
        let above = (M as i32..N as i32 + apart + 1).any(|at| word(at) != 0);
        if above || !self.rad.is_finite() {
            return ShortBall::WHOLE;
        }
        let is_cut = (apart..0).any(|at| word(at) != 0);
        let words = std::array::from_fn(|at| word(at as i32));
        match is_cut || self.rad > 0.0 {
            // Above all radii, or below a unit, where the exponent is cut.
            true => ShortBall::cut(
                self.negative,
                words,
                self.rad * power_of_two(places.clamp(-1000, 1000)),
            ),
            false => ShortBall::settled(self.negative, words, 0.0),
        }
    }

    /// Gives the set as a ball of MPFR, with results to be rounded to `prec` bits.
    pub fn to_ball(&self, prec: u32) -> Ball {
        let places = 64 * (N as i64 - 1);
        let integer = Integer::from_digits(&self.words, Order::Lsf);
        let size = Ball::fixed(&integer, places as u32, prec);
        let mid = if self.negative { -size } else { size };
        mid.widened(Magnitude::upper_double(self.rad).shifted(-places))
    }

    /// Midpoint without a radius; zero for the whole line.
    pub fn midpoint(&self) -> Self {
        Self { rad: 0.0, ..*self }
    }

    /// Ball with the midpoint of this one and `more` added to the radius, a number that is not negative.
    pub fn widened(&self, more: f64) -> Self {
        let more = if more >= 0.0 { more } else { f64::INFINITY };
        let more = more * power_of_two(Self::PLACES.min(MOST_PLACES));
        // More places than a radius can have.
        let more = if Self::PLACES > MOST_PLACES && more > 0.0 { f64::INFINITY } else { more };
        Self::settled(self.negative, self.words, (self.rad + more.max(1.0)) * UP)
    }

    /// An upper bound of the size of all numbers of the ball.
    pub fn bound(&self) -> f64 {
        (self.size() + Self::size_of(self.rad)) * UP
    }

    /// An upper bound of so many units of the last place.
    fn size_of(units: f64) -> f64 {
        match units == 0.0 {
            true => 0.0,
            false => (units * power_of_two(-Self::PLACES.min(MOST_PLACES)))
                .max(power_of_two(LEAST_EXPONENT)),
        }
    }

    /// Tells whether the midpoint is zero.
    pub fn is_about_zero(&self) -> bool {
        self.words.iter().all(|word| *word == 0)
    }

    /// An upper bound of the size of the midpoint.
    fn size(&self) -> f64 {
        let (size, exponent) = self.leading();
        let exponent = (exponent - Self::PLACES).max(LEAST_EXPONENT);
        size * power_of_two(exponent)
    }

    /// An upper bound of the size of the midpoint in units of the last place.
    fn units(&self) -> f64 {
        let (size, exponent) = self.leading();
        if exponent > MOST_PLACES { f64::INFINITY } else { size * power_of_two(exponent) }
    }

    /// An upper bound of the midpoint in units of the last place, as a number and the power of two with which it is
    /// multiplied.
    fn leading(&self) -> (f64, i32) {
        // The first two words that are not zero, and one unit of the second for those below.
        let mut top = N - 1;
        while self.words[top] == 0 {
            if top == 0 {
                return (0.0, 0);
            }
            top -= 1;
        }
        let next = if top == 0 { 0.0 } else { (self.words[top - 1] as f64 + 1.0) / TWO_TO_64 };
        ((self.words[top] as f64 + next) * UP, 64 * top as i32)
    }

    /// Tells whether the ball is a whole number, exactly.
    #[inline]
    fn is_integer(&self) -> bool {
        self.rad == 0.0 && self.words[..N - 1].iter().all(|word| *word == 0)
    }

    fn times_integer(&self, n: u64, negative: bool) -> Self {
        let rad = self.rad * n as f64 * UP;
        Self::settled(self.negative != negative, words::multiple(&self.words, n), rad)
    }

    fn over_integer(&self, n: u64, negative: bool) -> Self {
        let (words, rest) = words::quotient(&self.words, n);
        let negative = self.negative != negative;
        match rest == 0 && self.rad == 0.0 {
            true => Self::settled(negative, words, 0.0),
            false => Self::cut(negative, words, self.rad / n as f64),
        }
    }
}

const TWO_TO_64: f64 = 18_446_744_073_709_551_616.0;

impl<const N: usize> Field for ShortBall<N> {
    fn int(&self, n: i32) -> Self {
        let mut words = [0; N];
        words[N - 1] = u64::from(n.unsigned_abs());
        Self::settled(n < 0, words, 0.0)
    }
}

impl<const N: usize> ShortBall<N> {
    fn negated(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    fn plus(self, other: &Self) -> Self {
        let rad = (self.rad + other.rad) * UP;
        if self.negative == other.negative {
            return Self::settled(self.negative, words::sum(&self.words, &other.words), rad);
        }
        match words::compare(&self.words, &other.words) {
            Ordering::Less => {
                Self::settled(other.negative, words::difference(&other.words, &self.words), rad)
            }
            _ => Self::settled(self.negative, words::difference(&self.words, &other.words), rad),
        }
    }

    fn minus(self, other: &Self) -> Self {
        self + -*other
    }

    /// Product of balls: for `|x - a| <= r` and `|y - b| <= s`, `|xy - ab| <= |a| s + (|b| + s) r`.
    fn times(self, other: &Self) -> Self {
        if other.is_integer() {
            return self.times_integer(other.words[N - 1], other.negative);
        }
        if self.is_integer() {
            return other.times_integer(self.words[N - 1], self.negative);
        }
        let rad = match self.rad == 0.0 && other.rad == 0.0 {
            true => 0.0,
            false => self.size() * other.rad + (other.size() + Self::size_of(other.rad)) * self.rad,
        };
        Self::cut(self.negative != other.negative, words::product(&self.words, &other.words), rad)
    }

    /// Quotient of balls: some quotient `q` of the midpoints `a` and `b`, with what it leaves: for `|x - a|
    /// <= r` and `|y - b| <= s`, `|x/y - q| <= |a - q b| / |b| + (r + |a/b| s) / (|b| - s)`.
    fn over(self, other: &Self) -> Self {
        if other.is_integer() && other.words[N - 1] != 0 {
            return self.over_integer(other.words[N - 1], other.negative);
        }
        // Twice, as a size is rounded up itself, unless it is tiny.
        let least = (other.size() * DOWN * DOWN - Self::size_of(other.rad)) * DOWN;
        if !(least > power_of_two(LEAST_EXPONENT + 100) && self.rad.is_finite()) {
            return Self::WHOLE;
        }
        let (a, b) = (self.midpoint(), other.midpoint());
        let sign = if b.negative { -1.0 } else { 1.0 };
        let mut inverse = Self::from(sign / b.size()).midpoint();
        // Each step doubles the bits; the first have at least 45.
        let mut bits = 45;
        while bits < 64 * N {
            let rest = (b.int(1) - b * inverse).midpoint();
            inverse = (inverse + (inverse * rest)).midpoint();
            bits *= 2;
        }
        let quotient = (a * inverse).midpoint();
        let left = a - quotient * b;
        let left = (left.units() + left.rad) / least;
        let size = quotient.size() + Self::size_of(left);
        let rad = left + (self.rad + size * other.rad) / least;
        Self::cut(quotient.negative, quotient.words, rad)
    }
}

operators!([const N: usize] ShortBall<N>);

/// The double, cut off where it has further digits.
impl<const N: usize> From<f64> for ShortBall<N> {
    fn from(x: f64) -> Self {
        if x == 0.0 {
            return Self { rad: 0.0, ..Self::WHOLE };
        }
        // |x| = mantissa 2^exponent.
        let exponent = (x.to_bits() >> 52 & 0x7ff) as i64 - 1075;
        let mantissa = x.to_bits() & ((1 << 52) - 1) | 1 << 52;
        let places = exponent + 64 * (N as i64 - 1);
        if !x.is_normal() || places >= 64 * N as i64 - 53 {
            // Smaller than all units, or larger than all numbers.
            let rad = if x.abs() < 1.0 { 1.0 } else { f64::INFINITY };
            return Self::settled(false, [0; N], rad);
        }
        let mut words = [0; N];
        let (rest, wide) = match places {
            0.. => (false, u128::from(mantissa) << (places % 64)),
            -63..0 => {
                (mantissa.trailing_zeros() < (-places) as u32, u128::from(mantissa >> -places))
            }
            _ => (true, 0),
        };
        let first = (places.max(0) / 64) as usize;
        words[first] = wide as u64;
        if first + 1 < N {
            words[first + 1] = (wide >> 64) as u64;
        }
        Self::settled(x < 0.0, words, f64::from(u8::from(rest)))
    }
}

/// Converts the set, but for what is cut off.
impl<const N: usize> From<&Ball> for ShortBall<N> {
    fn from(ball: &Ball) -> Self {
        let places = 64 * (N as i64 - 1);
        let Some((mantissa, exponent)) = ball.mid().to_integer_exp() else { return Self::WHOLE };
        let rad = ball.rad().shifted(places).to_float().to_f64_round(Round::Up);
        let shift = i64::from(exponent) + places;
        let (negative, size) = (mantissa < 0, mantissa.abs());
        let size = match i32::try_from(shift) {
            Ok(shift) if i64::from(size.significant_bits()) + i64::from(shift) <= 64 * N as i64 => {
                size << shift
            }
            _ => return Self::WHOLE,
        };
        let mut words = [0; N];
        size.write_digits(&mut words, Order::Lsf);
        // A number that is shifted down may lose digits.
        match shift < 0 || rad > 0.0 {
            true => Self::cut(negative, words, rad),
            false => Self::settled(negative, words, 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::{Float, Rational};

    /// A ball, and a number within it: `place` from -1 to 1 times the radius away from the midpoint.
    type Sample = (bool, Vec<u64>, u64, f64, f64);

    /// Words of zeros and ones, whole numbers, numbers without a whole part, sizes down to one unit.
    fn sample() -> impl Strategy<Value = Sample> {
        let word = prop_oneof![Just(0), Just(1), Just(u64::MAX), any::<u64>(), any::<u64>()];
        let top = prop_oneof![2 => Just(0u64), 2 => 0u64..9, 1 => 0..(1u64 << 32)];
        let rad = prop_oneof![Just(0.0), 1.0f64..9.0, (0i32..180).prop_map(|k| 2f64.powi(k))];
        let place = prop_oneof![Just(-1.0), Just(1.0), -1.0f64..=1.0];
        let zeros = prop_oneof![2 => Just(0usize), 1 => 0usize..6];
        (any::<bool>(), prop::collection::vec(word, 5), top, rad, place, zeros).prop_map(
            |(negative, mut words, top, rad, place, zeros)| {
                words.push(top);
                words.iter_mut().rev().take(zeros).for_each(|word| *word = 0);
                (negative, words, top, rad, place)
            },
        )
    }

    fn ball<const N: usize>((negative, words, _, rad, _): &Sample) -> ShortBall<N> {
        let words = std::array::from_fn(|i| words[i + 6 - N]);
        ShortBall::settled(*negative, words, *rad)
    }

    fn parts<const N: usize>(x: &ShortBall<N>) -> Option<(Rational, Rational)> {
        let integer = Integer::from_digits(&x.words, Order::Lsf);
        let places = 64 * (N as u32 - 1);
        let size = Rational::from(integer) >> places;
        let rad = Rational::from_f64(x.rad)? >> places;
        Some((if x.negative { -size } else { size }, rad))
    }

    fn number<const N: usize>(x: &ShortBall<N>, place: f64) -> Option<Rational> {
        let (mid, rad) = parts(x)?;
        Some(mid + rad * Rational::from_f64(place)?)
    }

    /// Tells whether a ball with a radius changed by a factor holds a number.
    fn holds<const N: usize>(x: &ShortBall<N>, truth: &Rational, factor: f64) -> bool {
        let Some((mid, rad)) = parts(x) else { return true };
        (mid - truth).abs() <= rad * Rational::from_f64(factor).unwrap()
    }

    /// Number of operations on two samples that do not hold the truth with radii scaled by a factor.
    fn misses<const N: usize>(a: &Sample, b: &Sample, factor: f64) -> usize {
        let (x, y) = (ball::<N>(a), ball::<N>(b));
        let (Some(p), Some(q)) = (number(&x, a.4), number(&y, b.4)) else { return 0 };
        let mut results = vec![
            (x + y, Rational::from(&p + &q)),
            (x - y, Rational::from(&p - &q)),
            (x * y, Rational::from(&p * &q)),
            (x * x.int(-7), p.clone() * -7),
            (x / x.int(12), p.clone() / 12),
            (x.square(), Rational::from(p.square_ref())),
            (ShortBall::from(&x.to_ball(500)), p.clone()),
            (x.shifted::<3>(0).shifted(0), p.clone()),
            (x.shifted::<4>(-130).shifted(130), p.clone()),
            (x.shifted(-7), p.clone() >> 7),
            (x.shifted(64), p.clone() << 64),
            (x.shifted(91), p.clone() << 91),
        ];
        if q != 0 {
            results.push((x / y, p / &q));
        } else {
            assert!(!(x / y).rad.is_finite(), "{y:?} holds zero");
        }
        results.iter().filter(|(found, truth)| !holds(found, truth, factor)).count()
    }

    proptest! {
        #![proptest_config(config(3000))]

        #[test]
        fn operations_hold_the_truth(a in sample(), b in sample()) {
            prop_assert_eq!(misses::<2>(&a, &b, 1.0), 0);
            prop_assert_eq!(misses::<3>(&a, &b, 1.0), 0);
            prop_assert_eq!(misses::<6>(&a, &b, 1.0), 0);
            let (x, y) = (ball::<6>(&a).midpoint(), ball::<6>(&b).midpoint());
            prop_assert!((x + y).rad == 0.0 || !(x + y).rad.is_finite(), "sums are exact");
            let size = parts(&x).unwrap().0.abs();
            prop_assert!(Rational::from_f64(x.size()).unwrap() >= size);
            prop_assert!(Rational::from_f64(x.size() * (1.0 - 1e-13)).unwrap() <= size);
            prop_assert_eq!(parts(&x), parts(&x.shifted::<6>(0)));
            prop_assert_eq!(parts(&x), parts(&x.shifted::<9>(-70).shifted::<6>(70)));
        }

        #[test]
        fn doubles_are_placed_where_they_belong(x in -2.0f64..2.0, exponent in -600i32..40) {
            let x = x * 2f64.powi(exponent);
            let truth = Rational::from_f64(x).unwrap();
            prop_assert!(holds(&ShortBall::<3>::from(x), &truth, 1.0));
            prop_assert!(holds(&ShortBall::<8>::from(x), &truth, 1.0));
            let fits = (-300..20).contains(&exponent);
            prop_assert!(!fits || ShortBall::<8>::from(x).rad == 0.0);
        }
    }

    /// False twin: radii that are too small are seen. And quotients are narrow.
    #[test]
    fn radii_are_needed_and_not_much_more() {
        let word = |x: u64| (false, vec![x; 6], 3u64, 0.0, 0.0);
        let (mut a, mut b) = (word(0x1234_5678_9abc_def1), word(0xfedc_ba98_7654_3211));
        (a.1[5], b.1[5]) = (1, 3);
        assert_eq!(misses::<6>(&a, &b, 1.0), 0);
        assert!(misses::<6>(&a, &b, 1e-3) >= 3);
        let quotient = ball::<6>(&a) / ball::<6>(&b);
        assert!(quotient.rad < 16.0, "{quotient:?}");
    }

    #[test]
    fn out_of_range_is_the_whole_line() {
        let big = ShortBall::<4>::from(2e9);
        assert!(big.rad == 0.0 && !(big * big).rad.is_finite() && !(big + big).rad.is_finite());
        let zero = ShortBall::<4>::from(0.0);
        assert!(!(big / zero).rad.is_finite() && !(zero * ShortBall::WHOLE).rad.is_finite());
        for x in [f64::NAN, f64::INFINITY, 1e300] {
            assert!(!ShortBall::<4>::from(x).rad.is_finite());
        }
        assert!(!ShortBall::<4>::from(&Ball::whole(64)).rad.is_finite());
        let far = Ball::exact(Float::with_val(64, 1) << 700, 64);
        assert!(!ShortBall::<4>::from(&far).rad.is_finite());
        assert!(ShortBall::<4>::WHOLE.to_ball(64).rad() == Magnitude::INFINITE);
    }
}
