//! The decimals of a certificate, and what they say of the true value.

use super::{Decimal, Engine, Tens};
use std::fmt;

/// A decimal number as it is written: `[-]d[.d…][e±n]`. The zeros at the end of a whole number without a
/// point only show its size.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Written(Decimal);

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
        let decimal = Decimal::new(negative, &format!("{whole}{part}"), power - part.len() as i64);
        Some(Self(if mantissa.contains('.') { decimal } else { decimal.shortened() }))
    }

    /// Tells whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.0.digits().is_empty()
    }

    /// Number of significant digits that are written.
    pub fn significant_digits(&self) -> usize {
        self.0.significant_digits()
    }

    /// Enclosures of the two numbers between which the true value has to lie if this is its correct
    /// rounding to `digits` significant digits; `None` for zero, for a negative number, and if more
    /// digits are written.
    pub fn bounds<E: Engine>(&self, digits: usize, tens: &mut Tens<E>) -> Option<[E; 2]> {
        if self.is_zero() || self.0.is_negative() || self.significant_digits() > digits {
            return None;
        }
        let value = tens.integer(self.0.digits().as_bytes()) * tens.power(self.0.exponent());
        let missing = (digits - self.significant_digits()) as i64;
        let half = tens.power(self.0.exponent() - missing) / value.int(2);
        // Below a power of ten the places are ten times as fine.
        let is_power = self.0.digits().trim_end_matches('0') == "1";
        let below = if is_power { half.clone() / half.int(10) } else { half.clone() };
        Some([value.clone() - below, value + half])
    }
}

impl fmt::Display for Written {
    /// Writes the digits in the one spelling of [`Decimal`]: plain for ordinary sizes, else with a power of ten.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Enclosure, Field, Ternary};

    #[test]
    fn only_decimals_are_read() {
        let written = Written::parse("0.0120").unwrap();
        assert_eq!((written.significant_digits(), written.0.exponent()), (3, -4));
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
        let mut tens = Tens::<AstroInterval>::new(256);
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
            let [low, high] = Written::parse(text).unwrap().bounds(digits, &mut tens).unwrap();
            let holds = |millionths: i32| {
                let x = like.ratio(millionths, 1_000_000);
                low.is_less_than(&x).and(x.is_less_than(&high))
            };
            assert_eq!(holds(inside), Ternary::True, "{text}");
            assert_eq!(holds(outside), Ternary::False, "{text}");
        }
        let mut tens = Tens::<AstroInterval>::new(256);
        assert!(
            Written::parse("0.1234").unwrap().bounds(3, &mut tens).is_none(),
            "too many digits"
        );
        assert!(Written::parse("150.0").unwrap().bounds(2, &mut tens).is_none(), "the same");
        assert!(Written::parse("-1").unwrap().bounds(3, &mut tens).is_none());
    }
}
