//! Decimal output in which every digit is proved.

use super::{Ball, Enclosure, expansion, short_expansion};
use crate::number::Decimal;
use rug::float::Round;
use rug::ops::{Pow, PowAssignRound};
use rug::{Float, Integer, Rational};
use std::cmp::Ordering;
use std::fmt;

/// A real number known to lie between two decimals, with its correctly rounded value.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rounded {
    /// The true value rounded to nearest.
    pub value: Decimal,
    /// Decimal not above the true value.
    pub lower: Decimal,
    /// Decimal not below the true value.
    pub upper: Decimal,
}

/// From so many digits on they are found by splitting.
const MANY: usize = 2_000;

/// The bits that hold `digits` decimal digits: `digits log2(10)`, rounded up.
pub fn bits_of(digits: usize) -> u32 {
    (digits as f64 * std::f64::consts::LOG2_10).ceil() as u32
}

impl fmt::Debug for Rounded {
    /// The value and its bounds as they are written.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { value, lower, upper } = self;
        write!(f, "{value} in [{lower}, {upper}]")
    }
}

impl Rounded {
    /// The true value of `ball` rounded to `digits` significant digits, if the ball is narrow
    /// enough to decide it: all its numbers must round to the same decimal and lie between the
    /// same two neighbours. `None` asks for a narrower ball; of no digits there is none. A tie is never decided.
    ///
    /// ```
    /// use couplet_number::number::{Ball, Field, Rounded};
    /// let third = Ball::integer(1, 100) / Ball::integer(3, 100);
    /// let rounded = Rounded::from_ball(&third, 5).unwrap();
    /// assert_eq!(rounded.value.to_string(), "0.33333");
    /// assert_eq!(rounded.lower.to_string(), "0.33333");
    /// assert_eq!(rounded.upper.to_string(), "0.33334");
    /// ```
    pub fn from_ball(ball: &Ball, digits: usize) -> Option<Self> {
        if digits == 0 || !ball.is_bounded() {
            return None;
        }
        let negative = ball.mid().is_sign_negative();
        let long = || {
            let (low, high) = (ball.lower(), ball.upper());
            let (low, high) = if negative { (-high, -low) } else { (low, high) };
            let split = if digits < MANY { None } else { by_splitting(&low, &high, digits) };
            split.or_else(|| at_once(&low, &high, digits))
        };
        let short = short_expansion::cell(ball, digits + 1);
        let (mut text, exponent) = short.or_else(|| ball.excludes_zero().then(long).flatten())?;
        let last = text.pop()?;
        let below = Decimal::new(negative, &text, exponent + 1);
        let above = below.next();
        Some(Self::between([below, above], last >= '5', negative))
    }

    /// The correct rounding of every number in a ball, decided too for numbers next to a decimal of so many digits, as
    /// those are that were given as one; the bounds are those of all. `None` if they round to different decimals.
    ///
    /// ```
    /// use couplet_number::number::{Ball, Field, Rounded};
    /// let tenth = Ball::integer(1, 100) / Ball::integer(10, 100);
    /// assert!(Rounded::from_ball(&tenth, 5).is_none());
    /// let around = Rounded::around(&tenth, 5).unwrap();
    /// assert_eq!(around.value.to_rational() * 10u32, 1);
    /// ```
    pub fn around(ball: &Ball, digits: usize) -> Option<Self> {
        let by_ends = || {
            let end = |end: Float| Self::from_rational(&end.to_rational()?, digits);
            let (low, high) = (end(ball.lower())?, end(ball.upper())?);
            let is_same = low.value.to_rational() == high.value.to_rational();
            is_same.then_some(Self { value: high.value, lower: low.lower, upper: high.upper })
        };
        // Nearly always, and many times as fast.
        Self::from_ball(ball, digits).or_else(by_ends)
    }

    /// The true value of `ball` in as many digits as are decided, `most` at most; `None` where not even one is.
    ///
    /// ```
    /// use couplet_number::number::{Ball, Field, Rounded};
    /// let ratio = |n| Ball::integer(n, 100) / Ball::integer(100_000, 100);
    /// let near = ratio(149).hull(&ratio(152));
    /// assert_eq!(Rounded::most(&near, 6).unwrap().value.to_string(), "0.0015");
    /// assert!(Rounded::most(&(near.clone() - near), 6).is_none());
    /// ```
    pub fn most(ball: &Ball, most: usize) -> Option<Self> {
        (1..=most).rev().find_map(|digits| Self::around(ball, digits))
    }

    /// A value between two decimals, given by their size, that rounds to the first or up to the second.
    pub(super) fn between([below, above]: [Decimal; 2], up: bool, negative: bool) -> Self {
        let value = if up { above.clone() } else { below.clone() };
        let (lower, upper) = if negative { (above, below) } else { (below, above) };
        Self { value, lower, upper }
    }

    /// Ball of `bits` bits about the bounds.
    pub fn enclosure(&self, bits: u32) -> Ball {
        let ends = [&self.lower, &self.upper];
        let [lower, upper] = ends.map(|end| Ball::enclosing(&end.to_rational(), bits));
        lower.hull(&upper)
    }

    /// An exact value: all three are the same decimal.
    pub fn exact(value: Decimal) -> Self {
        Self { lower: value.clone(), upper: value.clone(), value }
    }

    /// The rational number `value`, rounded to `digits` significant digits if it does not end
    /// before.
    pub fn from_rational(value: &Rational, digits: usize) -> Option<Self> {
        if digits == 0 {
            return None;
        }
        if let Some(exact) = terminating(value, digits) {
            return Some(Self::exact(exact));
        }
        // A fraction that does not end, or ends just behind, is decided exactly: the cell it lies
        // in is found in integers, and a tie rounds to even.
        let size = value.clone().abs();
        let mut exponent = decimal_magnitude(&Float::with_val(64, &size)) - digits as i64;
        let floor = |exponent: i64| -> (Integer, Rational) {
            let power = Integer::from(10).pow(exponent.unsigned_abs() as u32);
            let scaled = if exponent < 0 { size.clone() * power } else { size.clone() / power };
            let (fraction, whole) = scaled.fract_floor(Integer::new());
            (whole, fraction)
        };
        let (mut whole, mut fraction) = floor(exponent);
        let mut text = whole.to_string_radix(10);
        while text.len() != digits {
            exponent += text.len() as i64 - digits as i64;
            (whole, fraction) = floor(exponent);
            text = whole.to_string_radix(10);
        }
        let negative = *value < 0;
        let below = Decimal::new(negative, &text, exponent);
        let above = below.next();
        let up = match fraction.cmp(&Rational::from((1, 2))) {
            Ordering::Less => false,
            Ordering::Greater => true,
            Ordering::Equal => whole.is_odd(),
        };
        Some(Self::between([below, above], up, negative))
    }
}

/// The exact value of `rational` where its decimal expansion ends within `digits` significant
/// digits.
fn terminating(rational: &Rational, digits: usize) -> Option<Decimal> {
    // The expansion ends after as many places as the denominator has factors 2 or 5.
    let (rest, twos) = rational.denom().clone().remove_factor(&Integer::from(2));
    let (rest, fives) = rest.remove_factor(&Integer::from(5));
    let places = twos.max(fives);
    if rest != 1 {
        return None;
    }
    let scaled = rational.clone().abs() * Integer::from(10).pow(places);
    let text = scaled.numer().to_string();
    let decimal = Decimal::new(*rational < 0, &text, -i64::from(places)).shortened();
    (decimal.significant_digits() <= digits).then_some(decimal)
}

/// An estimate, off by one at most, of the power of ten just above a positive number.
fn decimal_magnitude(x: &Float) -> i64 {
    let (head, exponent) = x.to_f64_exp();
    ((head.log2() + f64::from(exponent)) * std::f64::consts::LOG10_2).floor() as i64 + 1
}

/// The cell of the decimal grid in which all numbers from `low` to `high` lie strictly, as `digits + 1` digits and
/// the power of ten of the last: one digit more than asked for tells the halves of a unit apart. `None` if they lie
/// in more than one.
fn at_once(low: &Float, high: &Float, digits: usize) -> Option<(String, i64)> {
    let mut exponent = decimal_magnitude(low) - digits as i64 - 1;
    // Binary places kept behind that grid: all that the number has.
    let fraction = low.prec().saturating_sub(bits_of(digits)).max(64);
    let mut scaled = scaled(low, exponent, fraction)?;
    let mut text = Integer::from(&scaled >> fraction).to_string_radix(10);
    // The estimate of the magnitude may be off by one either way.
    while text.len() != digits + 1 {
        exponent += text.len() as i64 - digits as i64 - 1;
        scaled = self::scaled(low, exponent, fraction)?;
        text = Integer::from(&scaled >> fraction).to_string_radix(10);
    }
    let start = scaled.keep_bits(fraction);
    let end = Integer::from(&start + 1) + scaled_width(low, high, exponent, fraction)?;
    (!start.is_zero() && end.significant_bits() <= fraction).then_some((text, exponent))
}

/// Rounds by splitting the digits, where that tells, which is fast.
fn by_splitting(low: &Float, high: &Float, digits: usize) -> Option<(String, i64)> {
    let count = digits + 1;
    let bits = expansion::width(count);
    let estimate = decimal_magnitude(low);
    let fraction = |magnitude| {
        let x = scaled(low, magnitude, bits)?;
        let tenfold = Integer::from(&x >> (bits - 8)) * 10;
        (x.significant_bits() <= bits && tenfold >> 8 > 0).then_some((x, magnitude))
    };
    let (x, magnitude) = (estimate - 1..=estimate + 1).find_map(fraction)?;
    let found = expansion::expansion(&x, bits, count)?;
    let exponent = magnitude - count as i64;
    let end = scaled_width(low, high, exponent, expansion::MARGIN)? + found.rest + 2u32;
    (found.rest > 0 && end.significant_bits() <= expansion::MARGIN)
        .then_some((found.digits, exponent))
}

/// `floor(x / 10^exponent * 2^fraction)` for a non-negative `x`; `None` if `x` is not finite.
fn scaled(x: &Float, exponent: i64, fraction: u32) -> Option<Integer> {
    let (mantissa, shift) = x.to_integer_exp()?;
    let five = Integer::from(5).pow(u32::try_from(exponent.unsigned_abs()).ok()?);
    // x / 10^e = mantissa * 2^(shift - e) * 5^-e; floors of non-negative numbers in a row are one.
    let power = i64::from(shift) - exponent + i64::from(fraction);
    let shifted = |n: Integer| {
        let places = power.unsigned_abs() as u32;
        if power < 0 { n >> places } else { n << places }
    };
    Some(if exponent <= 0 { shifted(mantissa * five) } else { shifted(mantissa) / five })
}

/// `(high - low) / 10^exponent * 2^fraction`, rounded up to an integer; `None` if it is not finite.
fn scaled_width(low: &Float, high: &Float, exponent: i64, fraction: u32) -> Option<Integer> {
    let mut scale = Float::with_val(64, 10);
    scale.pow_assign_round(i32::try_from(-exponent).ok()?, Round::Up);
    let width = Float::with_val_round(64, high - low, Round::Up).0;
    let scaled = Float::with_val_round(64, &width * &scale, Round::Up).0 << fraction;
    scaled.is_finite().then(|| scaled.ceil().to_integer())?
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Field, Magnitude};
    use proptest::prelude::*;

    fn narrow(value: &Rational) -> Ball {
        Ball::enclosing(value, 400)
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]
        /// Values made to lie next to a rounding boundary: a decimal with one digit 5 (or nothing)
        /// behind, moved by a hair.
        #[test]
        fn rounding_next_to_a_boundary(
            head in 1u64..u64::MAX, five in any::<bool>(), up in any::<bool>(), hair in 1u32..60,
            scale in -30i32..30, negative in any::<bool>(), digits in 19usize..24,
        ) {
            let base = head.to_string();
            let padded = format!("{base:0<digits$}");
            let text = format!("{}{}{}e{scale}", if negative { "-" } else { "" }, &padded[..digits], if five { "5" } else { "0" });
            let grid = text.parse::<Decimal>().unwrap().to_rational();
            let step = grid.clone().abs() / Integer::from(Integer::u_pow_u(10, digits as u32 + hair));
            let x = if up { grid + step } else { grid - step };
            let r = Rounded::from_ball(&narrow(&x), digits).expect("narrow enough");
            let (lower, value, upper) = (r.lower.to_rational(), r.value.to_rational(), r.upper.to_rational());
            prop_assert!(lower <= x && x <= upper);
            let unit = Rational::from(&upper - &lower);
            prop_assert!((Rational::from(&value - &x)).abs() * 2 <= unit);
            prop_assert!(value == lower || value == upper);
            prop_assert_eq!(r.value.significant_digits(), digits);
            let direct = Rounded::from_rational(&x, digits).unwrap();
            prop_assert_eq!(direct, r);
        }
    }

    #[test]
    fn what_cannot_be_decided_is_not() {
        let half =
            Ball::enclosing(&Rational::from((1, 2)), 64).widened(Magnitude::power_of_two(-60));
        assert!(Rounded::from_ball(&half, 5).is_none(), "0.5 ± tiny has two neighbours");
        assert!(Rounded::from_ball(&Ball::whole(64), 5).is_none());
        assert!(Rounded::from_ball(&half.int(0), 5).is_none());
        let tie = Ball::enclosing(&Rational::from((5, 4)), 64);
        assert!(Rounded::from_ball(&tie, 2).is_none(), "1.25 to two digits is a tie");
    }

    /// Both ways find the same cell, for numbers of many sizes, and for none that is not decided.
    #[test]
    fn splitting_finds_the_same() {
        for (digits, size) in [(MANY, -3), (MANY, 0), (MANY + 1, 2), (5000, 40), (MANY, -700)] {
            let prec = bits_of(digits) + 96;
            let x: Float = Float::with_val(prec, 2).sqrt() * Float::with_val(prec, 10).pow(size);
            let next: Float = x.clone() * (1 + (Float::with_val(prec, 1) >> (prec - 40)));
            let found = by_splitting(&x, &next, digits).expect("decided");
            assert_eq!(found, at_once(&x, &next, digits).unwrap());
            assert_eq!(found.0.len(), digits + 1);
            let wide: Float = x.clone() * (1 + (Float::with_val(prec, 1) >> bits_of(digits - 1)));
            assert!(by_splitting(&x, &wide, digits).is_none(), "two cells");
            assert!(at_once(&x, &wide, digits).is_none(), "two cells");
        }
        // 1/4 and a hair more lies next to the grid: splitting cannot tell, and the other way does.
        let prec = bits_of(MANY) + 200;
        let quarter = Float::with_val(prec, 0.25);
        let hair = Float::with_val(prec, 1) >> (prec - 10);
        let (low, high) = (quarter.clone() + &hair, quarter.clone() + hair * 2u32);
        assert!(by_splitting(&low, &high, MANY).is_none());
        assert_eq!(at_once(&low, &high, MANY).unwrap().0, format!("25{}", "0".repeat(MANY - 1)));
        assert_eq!(at_once(&quarter, &high, MANY), None, "on the grid");
    }

    #[test]
    fn a_carry_runs_through() {
        let x = narrow(&Rational::from((99_999_996, 100_000_000)));
        let r =
            Rounded::from_ball(&(x + narrow(&Rational::from((1, 1_000_000_007u64)))), 5).unwrap();
        assert_eq!((r.lower.to_string(), r.upper.to_string()), ("0.99999".into(), "1.0000".into()));
        assert_eq!(r.value.to_string(), "1.0000");
    }

    #[test]
    fn exact_values_are_exact() {
        let third = Rational::from((2, 3));
        assert_eq!(Rounded::from_rational(&third, 4).unwrap().value.to_string(), "0.6667");
        let two = Rounded::from_rational(&Rational::from(2), 30).unwrap();
        assert_eq!(two.lower, two.upper);
        assert_eq!(two.value.to_string(), "2");
        let tie = Rounded::from_rational(&Rational::from((25, 2)), 2).unwrap();
        assert_eq!(tie.value.to_string(), "12");
    }
}
