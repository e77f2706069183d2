//! Decimal text, read exactly.

use super::digits::DecimalDigits;
use super::{says, shown_as_text};
use std::fmt;
use std::str::FromStr;

/// The decimal number `sign digits * 10^exponent`, with `digits` an integer.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Decimal {
    negative: bool,
    /// Decimal digits without leading zeros; empty for zero.
    digits: DecimalDigits,
    exponent: i64,
}

/// Reason why a text is not a decimal number.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseDecimalError {
    /// The text is not digits with at most one point, a sign and an exponent.
    Syntax(String),
    /// The exponent is beyond ±1,000,000.
    Exponent(String),
}

says!(ParseDecimalError {
    Self::Syntax(text) => "'{text}' is not a decimal number";
    Self::Exponent(text) => "'{text}' has an exponent beyond ±{MAX_EXPONENT}";
});

const MAX_EXPONENT: i64 = 1_000_000;

shown_as_text!(Decimal);

/// A power of ten.
#[cfg(feature = "mpfr")]
pub fn power_of_ten(exponent: u32) -> rug::Integer {
    use rug::{Integer, ops::Pow};
    let short = 10u128.checked_pow(exponent);
    short.map_or_else(|| Integer::from(10).pow(exponent), Integer::from)
}

impl Decimal {
    /// The decimal of a sign, digits and the power of ten of the last digit.
    pub(super) fn new(negative: bool, digits: &str, exponent: i64) -> Self {
        Self::joined(negative, [digits, ""], exponent)
    }

    fn joined(negative: bool, [head, tail]: [&str; 2], exponent: i64) -> Self {
        let head = head.trim_start_matches('0');
        let tail = if head.is_empty() { tail.trim_start_matches('0') } else { tail };
        let negative = negative && !(head.is_empty() && tail.is_empty());
        Self { negative, digits: DecimalDigits::joined(head, tail), exponent }
    }

    /// The number of significant digits as written.
    pub fn significant_digits(&self) -> usize {
        self.digits().len()
    }

    /// The significant digits, without leading zeros.
    pub fn digits(&self) -> &str {
        self.digits.as_str()
    }

    /// Tells whether the decimal is below zero.
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The power of ten of the last written digit: one unit of the last place is `10^exponent`.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The power of ten just above the number: `10^(magnitude-1) <= |x| < 10^magnitude`.
    pub fn magnitude(&self) -> i64 {
        self.exponent + self.digits().len() as i64
    }

    /// The exact value.
    #[cfg(feature = "mpfr")]
    pub fn to_rational(&self) -> rug::Rational {
        use rug::{Integer, Rational};
        let digits = if self.digits().is_empty() { "0" } else { self.digits() };
        let integer = match digits.parse::<u64>() {
            Ok(integer) => integer.into(),
            Err(_) => Integer::from_str_radix(digits, 10).unwrap_or_default(),
        };
        let scale = power_of_ten(self.exponent.unsigned_abs() as u32);
        let value = if self.exponent < 0 {
            Rational::from((integer, scale))
        } else {
            Rational::from(integer * scale)
        };
        if self.negative { -value } else { value }
    }

    /// The decimal without the zeros at its end.
    pub(super) fn shortened(&self) -> Self {
        let kept = self.digits().trim_end_matches('0');
        let zeros = (self.digits().len() - kept.len()) as i64;
        Self::new(self.negative, kept, self.exponent + zeros)
    }

    /// The next decimal of so many digits, away from zero.
    pub fn next(&self) -> Self {
        let mut digits = self.digits().as_bytes().to_vec();
        for digit in digits.iter_mut().rev() {
            if *digit < b'9' {
                *digit += 1;
                break;
            }
            *digit = b'0';
        }
        let mut text = String::from_utf8(digits).unwrap_or_default();
        let mut exponent = self.exponent;
        if text.bytes().all(|d| d == b'0') {
            // 999 becomes 100 and a higher power of ten: the number of digits stays.
            text.pop();
            text.insert(0, '1');
            exponent += 1;
        }
        Self::new(self.negative, &text, exponent)
    }
}

impl fmt::Display for Decimal {
    /// Plain digits for ordinary sizes, scientific notation outside `1e-7 … 1e21`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.digits().is_empty() {
            return f.write_str("0");
        }
        const ZEROS: &str = "00000000000000000000";
        let magnitude = self.magnitude();
        if !(-6..=21).contains(&magnitude) {
            return fmt::LowerExp::fmt(self, f);
        }
        let sign = if self.negative { "-" } else { "" };
        let parts = match magnitude - self.digits().len() as i64 {
            _ if magnitude <= 0 => [sign, "0.", &ZEROS[..-magnitude as usize], self.digits()],
            zeros @ 0.. => [sign, self.digits(), &ZEROS[..zeros as usize], ""],
            _ => {
                let (head, tail) = self.digits().split_at(magnitude as usize);
                [sign, head, ".", tail]
            }
        };
        parts.iter().try_for_each(|part| f.write_str(part))
    }
}

impl fmt::LowerExp for Decimal {
    /// Scientific notation: every digit that is written is one of the number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (head, tail) = self.digits().split_at(self.digits().len().min(1));
        let (sign, point) =
            (if self.negative { "-" } else { "" }, if tail.is_empty() { "" } else { "." });
        [sign, head, point, tail].iter().try_for_each(|part| f.write_str(part))?;
        write!(f, "e{}", self.magnitude() - 1)
    }
}

impl FromStr for Decimal {
    type Err = ParseDecimalError;

    /// Reads `-12.5`, `1e-30`, `.5`, exactly. Trailing zeros count as digits.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let shown = || super::shown(text);
        let syntax = || ParseDecimalError::Syntax(shown());
        let (negative, rest) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (number, power) = match rest.split_once(['e', 'E']) {
            Some((number, power)) => (number, power),
            None => (rest, "0"),
        };
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        let all_digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
        let unsigned = power.strip_prefix(['+', '-']).unwrap_or(power);
        if whole.len() + fraction.len() == 0
            || !all_digits(whole)
            || !all_digits(fraction)
            || unsigned.is_empty()
            || !all_digits(unsigned)
        {
            return Err(syntax());
        }
        let power = power
            .parse::<i64>()
            .ok()
            .filter(|p| p.unsigned_abs() <= MAX_EXPONENT as u64)
            .ok_or_else(|| ParseDecimalError::Exponent(shown()))?;
        Ok(Self::joined(negative, [whole, fraction], power - fraction.len() as i64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]
        #[test]
        fn text_goes_round(negative in any::<bool>(), n in any::<u128>(), exponent in -400i64..400) {
            let decimal = Decimal::new(negative, &n.to_string(), exponent);
            let back: Decimal = decimal.to_string().parse().unwrap();
            prop_assert_eq!(back.to_rational(), decimal.to_rational());
        }
    }

    #[test]
    fn sizes_far_from_one_are_scientific() {
        assert_eq!("1.5e-30".parse::<Decimal>().unwrap().to_string(), "1.5e-30");
        assert_eq!("-0.001".parse::<Decimal>().unwrap().to_string(), "-0.001");
        for bad in
            ["", ".", "1e", "1.2.3", "0x10", "nan", "1e9999999", "1e-9223372036854775808", "--1"]
        {
            assert!(bad.parse::<Decimal>().is_err(), "{bad}");
        }
    }
}
