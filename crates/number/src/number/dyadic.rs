//! Exact binary numbers as text: `-0x1f3p-12` is `-499 / 2^12`.

use super::{DoubleDouble, says};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// `± mantissa * 2^exponent`, exactly. The mantissa is an integer.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Dyadic {
    negative: bool,
    /// Words of 64 bits, the least significant first, without zeros at the top; empty for zero.
    words: Vec<u64>,
    exponent: i32,
}

/// The largest exponent of a number in a certificate, of either sign.
pub const MAX_EXPONENT: i32 = 10_000_000;

/// Reason why a text is not an exact binary number.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseDyadicError {
    /// The text is not `[-]0x<hexadecimal digits>p<exponent>`.
    Syntax,
    /// The exponent is too large.
    Exponent,
}

says!(ParseDyadicError {
    Self::Syntax => "it is not of the form -0x1f3p-12";
    Self::Exponent => "its exponent is beyond ±{MAX_EXPONENT}";
});

impl Dyadic {
    /// The number from its sign, the words of its mantissa (least significant first), and exponent.
    pub fn new(negative: bool, mut words: Vec<u64>, exponent: i32) -> Self {
        while words.last() == Some(&0) {
            words.pop();
        }
        let exponent = if words.is_empty() { 0 } else { exponent };
        Self { negative: negative && !words.is_empty(), words, exponent }
    }

    /// Tells whether the number is below zero.
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// Tells whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.words.is_empty()
    }

    /// The mantissa, least significant word first, no zeros at the top.
    pub fn words(&self) -> &[u64] {
        &self.words
    }

    /// The power of two that multiplies the mantissa.
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The number of bits of the mantissa.
    pub fn bits(&self) -> usize {
        self.words.last().map_or(0, |top| 64 * self.words.len() - top.leading_zeros() as usize)
    }
}

/// The number to 110 bits; zero for what is not finite.
impl From<DoubleDouble> for Dyadic {
    fn from(x: DoubleDouble) -> Self {
        if x.hi() == 0.0 {
            return Self::new(false, Vec::new(), 0);
        }
        let exponent = x.hi().abs().log2().floor() as i32 - 110;
        // In two steps: the power of a tiny number is no double.
        let steps = [-exponent / 2, -exponent - -exponent / 2].map(|step| f64::from(step).exp2());
        let part = |x: f64| (x * steps[0] * steps[1]).round() as i128;
        let mantissa = part(x.hi()) + part(x.lo());
        let size = mantissa.unsigned_abs();
        let zeros = size.trailing_zeros() % 128;
        let size = size >> zeros;
        Self::new(mantissa < 0, vec![size as u64, (size >> 64) as u64], exponent + zeros as i32)
    }
}

/// The number itself; zero for what is not finite.
impl From<f64> for Dyadic {
    fn from(x: f64) -> Self {
        DoubleDouble::exact(x).into()
    }
}

impl FromStr for Dyadic {
    type Err = ParseDyadicError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        use ParseDyadicError::{Exponent, Syntax};
        let (negative, size) = match text.strip_prefix('-') {
            Some(size) => (true, size),
            None => (false, text),
        };
        let (mantissa, exponent) =
            size.strip_prefix("0x").and_then(|rest| rest.split_once('p')).ok_or(Syntax)?;
        let is_hexadecimal =
            mantissa.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
        let sign_and_digits = exponent.strip_prefix('-').unwrap_or(exponent);
        let is_decimal = sign_and_digits.bytes().all(|b| b.is_ascii_digit());
        if mantissa.is_empty() || !is_hexadecimal || sign_and_digits.is_empty() || !is_decimal {
            return Err(Syntax);
        }
        let exponent: i32 = exponent.parse().map_err(|_| Exponent)?;
        if exponent.unsigned_abs() > MAX_EXPONENT.unsigned_abs() {
            return Err(Exponent);
        }
        // Sixteen digits are a word; the text is ASCII, so that it can be cut anywhere.
        let word = |chunk: &[u8]| {
            chunk.iter().fold(0u64, |word, digit| {
                let value = char::from(*digit).to_digit(16).unwrap_or(0);
                word << 4 | u64::from(value)
            })
        };
        let words = mantissa.as_bytes().rchunks(16).map(word).collect();
        Ok(Self::new(negative, words, exponent))
    }
}

impl fmt::Display for Dyadic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        let Some((top, rest)) = self.words.split_last() else { return f.write_str("0x0p0") };
        write!(f, "{sign}0x{top:x}")?;
        rest.iter().rev().try_for_each(|word| write!(f, "{word:016x}"))?;
        write!(f, "p{}", self.exponent)
    }
}

impl Serialize for Dyadic {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Dyadic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(|error: ParseDyadicError| {
            let shown: String = text.chars().take(24).collect();
            D::Error::custom(format_args!("{shown:?} is not a valid certificate number: {error}"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]

        #[test]
        fn text_and_back_loses_nothing(
            negative in any::<bool>(), words in prop::collection::vec(any::<u64>(), 0..6), exponent in -9999i32..9999,
        ) {
            let number = Dyadic::new(negative, words, exponent);
            prop_assert_eq!(number.to_string().parse::<Dyadic>(), Ok(number));
        }
    }

    #[test]
    fn a_double_double_is_written_exactly() {
        assert_eq!(Dyadic::from(0.75).to_string(), "0x3p-2");
        assert_eq!(Dyadic::from(-1.0).to_string(), "-0x1p0");
        assert_eq!(
            Dyadic::from(DoubleDouble::sum(1.0, (-80f64).exp2())).to_string(),
            "0x100000000000000000001p-80"
        );
        assert_eq!(Dyadic::from(DoubleDouble::ZERO).to_string(), "0x0p0");
    }

    #[test]
    fn every_double_is_itself() {
        let exact = |x: f64| Dyadic::from(x).to_string();
        assert_eq!(exact(f64::from_bits(1)), "0x1p-1074");
        assert_eq!(exact(-f64::MIN_POSITIVE), "-0x1p-1022");
        assert_eq!(exact(3.0 * (-950f64).exp2()), "0x3p-950");
        assert_eq!(exact(f64::MAX), "0x1fffffffffffffp971");
        for x in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(exact(x), "0x0p0", "{x}");
        }
    }

    #[test]
    fn only_the_one_form_is_read() {
        let number: Dyadic = "-0x1f3p-12".parse().unwrap();
        assert_eq!(
            (number.is_negative(), number.words(), number.exponent()),
            (true, &[499][..], -12)
        );
        assert_eq!("0x00p9".parse::<Dyadic>().unwrap().to_string(), "0x0p0");
        for text in [
            "", "1", "0x", "0xp1", "0x1", "0x1p", "0x1p-", "0xFp1", "+0x1p1", "0x1p+1", "0x1.8p1",
            "--0x1p1", "0x1p1 ", "0xéép1",
        ] {
            assert_eq!(text.parse::<Dyadic>(), Err(ParseDyadicError::Syntax), "{text}");
        }
        for text in ["0x1p10000001", "0x1p-10000001", "0x1p99999999999999999999"] {
            assert_eq!(text.parse::<Dyadic>(), Err(ParseDyadicError::Exponent), "{text}");
        }
    }
}
