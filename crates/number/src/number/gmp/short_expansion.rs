//! The decimals of a short number by products with powers of ten, on the stack.
//!
//! A number of a few hundred bits stands in words behind a point and one before it. Its product with `10^19` has the
//! next 19 digits before the point, exactly; nothing is divided, and the last words become zero one by one. What
//! remains behind the last digit is compared with the radius, in units of `2^-64`.

use super::{Ball, Magnitude};
use rug::integer::Order;

/// Words behind the point, at most: those of a number of so many less one. Others are quicker beyond.
const WORDS: usize = 72;
/// Digits of a word.
const CHUNK: usize = 19;
/// Smaller numbers, by their exponent, are left to others; larger ones have no room before the point.
const EXPONENTS: std::ops::RangeInclusive<i32> = -60..=63;

/// The cell of the decimal grid in which all numbers of a ball lie strictly, as `count` digits and the power of ten of
/// the last, of the size of the numbers. `None` where that is not told: a number that is long, tiny or large, or a ball
/// that is no narrower than what is compared.
pub(super) fn cell(ball: &Ball, count: usize) -> Option<(String, i64)> {
    let exponent = ball.mid().get_exp().filter(|exponent| EXPONENTS.contains(exponent))?;
    let mut fraction = FixedPoint::new(ball, exponent)?;
    let mut text = DecimalDigits(Vec::with_capacity(count));
    if fraction.whole > 0 {
        text.push(fraction.whole, fraction.whole.ilog10() as usize + 1);
    }
    let mut places = 0;
    while text.0.len() < count {
        // Zeros in front are no digits, and come one by one.
        let size = if text.0.is_empty() { 1 } else { CHUNK.min(count - text.0.len()) };
        let next = fraction.times(10u64.pow(size as u32));
        places += size;
        if next > 0 || !text.0.is_empty() {
            text.push(next, size);
        }
    }
    let rest = fraction.rest();
    let scale = Magnitude::from_integer(10).power(places as u32);
    let radius = ball.rad().times(scale).shifted(64).ceil()?;
    let is_inside = text.0.len() == count && rest > radius && rest.checked_add(radius).is_some();
    is_inside.then(|| String::from_utf8(text.0).ok()).flatten().map(|text| (text, -(places as i64)))
}

/// A number in fixed point that is not negative: a word before the point, and those behind it, the least significant
/// first.
struct FixedPoint {
    whole: u64,
    words: [u64; WORDS + 1],
    /// The words that may not be zero.
    used: std::ops::Range<usize>,
}

impl FixedPoint {
    /// The size of the midpoint, which is below `2^exponent` and no less than half of that.
    fn new(ball: &Ball, exponent: i32) -> Option<Self> {
        let significand = ball.mid().get_significand()?;
        let bits = significand.significant_bits();
        // Two words more than the number has, as it is shifted down by less than one, and has one before the point.
        let length = bits.div_ceil(64) as usize + 1;
        if length > WORDS {
            return None;
        }
        let mut words = [0; WORDS + 1];
        significand.write_digits(&mut words[..length - 1], Order::Lsf);
        let shift = u32::try_from(exponent + (64 * length) as i32 - bits as i32).ok()?;
        let (apart, shift) = ((shift / 64) as usize, shift % 64);
        for at in (0..=length).rev() {
            // The word that comes to stand here, from the two that meet.
            let [here, below] =
                [apart, apart + 1].map(|k| at.checked_sub(k).map_or(0, |at| words[at]));
            words[at] = if shift == 0 { here } else { here << shift | below >> (64 - shift) };
        }
        Some(Self { words, whole: words[length], used: 0..length })
    }

    /// Multiplies what is behind the point, and gives what comes before it.
    fn times(&mut self, factor: u64) -> u64 {
        let words = &mut self.words[self.used.clone()];
        let carry = words.iter_mut().fold(0, |carry, word| {
            let term = u128::from(*word) * u128::from(factor) + u128::from(carry);
            *word = term as u64;
            (term >> 64) as u64
        });
        let zeros = words.iter().take_while(|word| **word == 0).count();
        self.used.start += zeros;
        carry
    }

    /// Part behind the point in units of `2^-64`, rounded down.
    fn rest(&self) -> u64 {
        self.words[self.used.end - 1]
    }
}

/// Decimal digits.
struct DecimalDigits(Vec<u8>);

impl DecimalDigits {
    /// Appends a number, of so many digits with zeros in front.
    fn push(&mut self, mut number: u64, size: usize) {
        let mut digits = [0; CHUNK + 1];
        for pair in digits.chunks_exact_mut(2).rev() {
            let rest = (number % 100) as u8;
            (pair[0], pair[1]) = (b'0' + rest / 10, b'0' + rest % 10);
            number /= 100;
        }
        self.0.extend_from_slice(&digits[digits.len() - size..]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::ops::Pow;
    use rug::{Float, Integer, Rational};

    /// The digits by one product of rational numbers, if all of the ball lies in one cell.
    fn slow(ball: &Ball, count: usize) -> Option<(String, i64)> {
        let (mid, rad) = (ball.mid().to_rational()?.abs(), ball.rad().to_float().to_rational()?);
        let floor = |x: Rational, exponent: i64| {
            let scale = Rational::from(10).pow(exponent.unsigned_abs() as u32);
            let (rest, whole) =
                if exponent < 0 { x * scale } else { x / scale }.fract_floor(Integer::new());
            (whole, rest)
        };
        let length = |exponent| floor(mid.clone(), exponent).0.to_string().len();
        let estimate = mid.to_f64().log10() as i64 - count as i64;
        let exponent = (estimate - 2..estimate + 3).find(|exponent| length(*exponent) == count)?;
        let (low, rest) = floor(Rational::from(&mid - &rad), exponent);
        let (high, _) = floor(mid.clone() + rad, exponent);
        (low == high && rest != 0).then(|| (low.to_string(), exponent))
    }

    proptest! {
        #![proptest_config(config(1000))]

        /// Numbers of every size and length, next to the grid too, with radii of every size: digits are those of
        /// rational numbers, and most are found.
        #[test]
        fn digits_are_those_of_rational_numbers(
            words in prop::collection::vec(prop_oneof![Just(0u64), Just(u64::MAX), any::<u64>()], 1..72),
            prec in 1u32..4608, exponent in -64i32..66, radius in 1i64..4700, count in 1usize..1300, negative in any::<bool>(),
            is_decimal in any::<bool>(),
        ) {
            let mut mid = Float::with_val(prec, Integer::from_digits(&words, Order::Lsf));
            prop_assume!(!mid.is_zero());
            mid >>= mid.get_exp().unwrap() - exponent;
            if is_decimal {
                let scale = Integer::from(10).pow(count as u32 / 2);
                let digits = Float::with_val(prec + 5000, &mid * &scale).to_integer().unwrap();
                mid = Float::with_val(prec, Rational::from((digits + 1, scale)));
            }
            let ball = Ball::new(if negative { -mid } else { mid }, Magnitude::power_of_two(-radius), prec);
            let (found, truth) = (cell(&ball, count), slow(&ball, count));
            prop_assert!(found.is_none() || found == truth, "{:?} {:?}", found, truth);
            let is_easy = !is_decimal && EXPONENTS.contains(&exponent) && count > 20 && prec as usize > 4 * count + 70
                && radius as usize > 4 * count + 70 && words.len() * 64 > 4 * count + 70 && words.iter().all(|word| (1..u64::MAX).contains(word));
            prop_assert!(found.is_some() || !is_easy, "{ball:?}");
        }
    }

    #[test]
    fn what_is_next_to_the_grid_is_not_told() {
        let half = |rad: i64| {
            Ball::new(Float::with_val(200, 0.5) + 1e-25, Magnitude::power_of_two(-rad), 200)
        };
        assert_eq!(cell(&half(100), 20).unwrap(), ("50000000000000000000".to_owned(), -20));
        assert!(cell(&half(80), 20).is_none(), "a radius that reaches the grid");
        let exact = Ball::exact(Float::with_val(64, 0.5), 200);
        assert!(cell(&exact, 20).is_none(), "on the grid");
        let long = Ball::exact(Float::with_val(64 * WORDS as u32, 3).sqrt(), 64);
        assert!(cell(&long, 20).is_none() && cell(&Ball::whole(64), 20).is_none());
        assert!(
            cell(&Ball::integer(0, 64), 5).is_none()
                && cell(&Ball::integer(1 << 30, 64), 5).is_none()
        );
    }
}
