//! The decimals of a certificate, and what they say of the true value.

use super::{Decimal, Engine};
use crate::number::Enclosure;
use std::fmt;

/// A decimal number as it is written: `[-]d[.d…][e±n]`. The zeros at the end of a whole number without a
/// point only show its size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    negative: bool,
    /// All digits without the point, from the first that is not zero; empty for zero.
    digits: Vec<u8>,
    /// The power of ten of the last digit.
    exponent: i64,
}

/// The largest power of ten in a certificate, of either sign.
const MAX_EXPONENT: i64 = 3_000_000;

impl Written {
    /// Reads the text; `None` if it is not of that form.
    pub fn parse(text: &str) -> Option<Self> {
        let (negative, size) = match text.strip_prefix('-') {
            Some(size) => (true, size),
            None => (false, text),
        };
        let (mantissa, power) = size.split_once('e').unwrap_or((size, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let has_one_start = whole.len() == 1 || !whole.starts_with('0');
        let is_sound = is_number(whole) && is_number(part) && has_one_start;
        let power: i64 = power.parse().ok().filter(|_| !power.starts_with('+'))?;
        if !is_sound || !(-MAX_EXPONENT..=MAX_EXPONENT).contains(&power) {
            return None;
        }
        let part = if mantissa.contains('.') { part } else { "" };
        // Zero has one form.
        if whole == "0" && part.bytes().all(|b| b == b'0') && text != "0" {
            return None;
        }
        let all = whole.bytes().chain(part.bytes()).map(|b| b - b'0');
        let mut digits: Vec<u8> = all.skip_while(|digit| *digit == 0).collect();
        let mut exponent = power - part.len() as i64;
        if !mantissa.contains('.') {
            let significant =
                digits.iter().rposition(|digit| *digit != 0).map_or(0, |last| last + 1);
            exponent += (digits.len() - significant) as i64;
            digits.truncate(significant);
        }
        Some(Self { negative, digits, exponent })
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// How many significant digits are written.
    pub fn significant_digits(&self) -> usize {
        self.digits.len()
    }

    /// Enclosures of the two numbers between which the true value has to lie if this is its correct
    /// rounding to `digits` significant digits; `None` for zero, for a negative number, and if more
    /// digits are written.
    pub fn bounds<E: Engine>(&self, digits: usize, like: &E) -> Option<[E; 2]> {
        if self.is_zero() || self.negative || self.significant_digits() > digits {
            return None;
        }
        // In units of a twentieth of the last place to which it is rounded.
        let missing = digits - self.significant_digits();
        let unit = power_of_ten(self.exponent - missing as i64 - 1, like) / like.int(2);
        let value = integer(&self.digits, like) * power_of_ten(missing as i64, like) * like.int(20);
        // Below a power of ten the places are ten times as fine.
        let is_power = self.digits[0] == 1 && self.digits[1..].iter().all(|digit| *digit == 0);
        let below = if is_power { 1 } else { 10 };
        let bound = |step: i32| (value.clone() + like.int(step)) * &unit;
        Some([bound(-below), bound(10)])
    }
}

impl fmt::Display for Written {
    /// The same digits in the one spelling of [`Decimal`]: plain for ordinary sizes, else with a power of ten.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.digits.iter().map(|digit| char::from(b'0' + digit)).collect();
        Decimal::new(self.negative, digits, self.exponent).fmt(f)
    }
}

/// Digits that fit an `i32`.
const CHUNK: usize = 9;

/// The integer with the digits given, most significant first: split so that the part below has
/// `9 * 2^k` digits, whose powers of ten are squared one from the other.
fn integer<E: Enclosure>(digits: &[u8], like: &E) -> E {
    let mut powers = vec![power_of_ten(CHUNK as i64, like)];
    while CHUNK << powers.len() < digits.len() {
        powers.push(powers[powers.len() - 1].square());
    }
    joined(digits, &powers, like)
}

fn joined<E: Enclosure>(digits: &[u8], powers: &[E], like: &E) -> E {
    let Some((power, smaller)) = powers.split_last() else {
        return like.int(digits.iter().fold(0, |sum, digit| 10 * sum + i32::from(*digit)));
    };
    let below = CHUNK << smaller.len();
    if digits.len() <= below {
        return joined(digits, smaller, like);
    }
    let (top, rest) = digits.split_at(digits.len() - below);
    joined(top, smaller, like) * power + joined(rest, smaller, like)
}

/// `10^n`, by squaring.
fn power_of_ten<E: Enclosure>(n: i64, like: &E) -> E {
    let mut power = like.int(1);
    for bit in (0..64 - n.unsigned_abs().leading_zeros()).rev() {
        power = power.square();
        if n.unsigned_abs() >> bit & 1 == 1 {
            power = power * like.int(10);
        }
    }
    if n < 0 { like.int(1) / power } else { power }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Field, Ternary};

    #[test]
    fn only_decimals_are_read() {
        let written = Written::parse("0.0120").unwrap();
        assert_eq!((written.significant_digits(), written.exponent), (3, -4));
        assert!(Written::parse("0").unwrap().is_zero());
        for text in [
            "",
            ".",
            ".5",
            "+1",
            "1e",
            "1e5000000",
            "1e-9223372036854775808",
            "0x1",
            "1..2",
            "nan",
            "inf",
            "1 ",
            "１",
            "1.",
            "01",
            "00.5",
            "1e+5",
            "-0",
            "0.0",
            "0e0",
        ] {
            assert_eq!(Written::parse(text), None, "{text}");
        }
        assert!(Written::parse("10").is_some() && Written::parse("1.5e-8").is_some());
    }

    #[test]
    fn every_spelling_is_displayed_in_one() {
        let shown = |text: &str| Written::parse(text).unwrap().to_string();
        for text in ["0.06180", "6.180e-2", "6180e-5", "0.0000618e3", "0.006180e1"] {
            let digits = Written::parse(text).unwrap().significant_digits();
            assert_eq!(shown(text), if digits == 3 { "0.0618" } else { "0.06180" }, "{text}");
        }
        assert_eq!(shown("0.0000208e-9"), "2.08e-14");
        assert_eq!(shown("1400"), "1400");
        assert_eq!(shown("14e2"), "1400");
        assert_eq!(shown("0"), "0");
        assert_eq!(shown("1e3000000"), "1e3000000");
    }

    #[test]
    fn the_bounds_are_those_of_a_correct_rounding() {
        let like = AstroInterval::integer(0, 256);
        // text, digits, a value inside and one outside, in units of 10^-6.
        let cases = [
            ("0.123", 3, 123_499, 123_501),
            ("0.123", 3, 122_501, 122_499),
            ("0.5", 4, 500_049, 500_051),
            ("1.00", 3, 1_004_999, 1_005_001),
            ("1.00", 3, 999_501, 999_499),
            ("1.25e-1", 3, 125_400, 125_600),
            ("100", 1, 149_999_999, 150_000_001),
            ("150", 2, 145_000_001, 144_999_999),
        ];
        for (text, digits, inside, outside) in cases {
            let [low, high] = Written::parse(text).unwrap().bounds(digits, &like).unwrap();
            let holds = |millionths: i32| {
                let x = like.ratio(millionths, 1_000_000);
                low.is_less_than(&x).and(x.is_less_than(&high))
            };
            assert_eq!(holds(inside), Ternary::True, "{text}");
            assert_eq!(holds(outside), Ternary::False, "{text}");
        }
        let long: String = ('1'..='9').cycle().take(100).collect();
        let digits: Vec<u8> = long.bytes().map(|b| b - b'0').collect();
        let wide = AstroInterval::integer(0, 512);
        let third =
            integer(&digits, &wide) - integer(&digits[..91], &wide) * power_of_ten(9, &wide);
        assert!(third.overlaps(&wide.int(234_567_891)), "split and joined");
        assert!(!third.overlaps(&wide.int(234_567_892)));
        assert!(Written::parse("0.1234").unwrap().bounds(3, &like).is_none(), "too many digits");
        assert!(Written::parse("150.0").unwrap().bounds(2, &like).is_none(), "the same");
        assert!(Written::parse("-1").unwrap().bounds(3, &like).is_none());
    }
}
