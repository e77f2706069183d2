//! ExactNumber input: decimals, fractions and multiples of pi, read as text and never rounded.

use super::{Ball, Decimal, ParseDecimalError, Real};
use rug::{Integer, Rational};
use std::fmt;
use std::str::FromStr;

/// A number given exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExactNumber {
    /// The rational number, or the rational factor of pi.
    factor: Rational,
    times_pi: bool,
    /// As it was given.
    text: String,
}

/// Texts longer than this are refused; it is far more than any number of digits worth giving.
const MAX_LENGTH: usize = 20_000;
/// Exponents beyond this are refused.
const MAX_EXPONENT: u32 = 1_000;
/// The same in bits, and a little more.
const MAX_BITS: u32 = 3_330;

/// Why a text is not an exact number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ParseExactError {
    /// None of the forms that are read.
    #[error(
        "'{0}' is not a number: give a decimal (0.1), a fraction (1/3) or a multiple of pi (2pi/3)"
    )]
    Syntax(String),
    /// Too long to be meant.
    #[error("a number of {0} characters is too long: at most {MAX_LENGTH} are read")]
    Length(usize),
    /// Too large or too small to be meant.
    #[error("'{0}' is out of range: numbers from 1e-{MAX_EXPONENT} to 1e{MAX_EXPONENT} are read")]
    Range(String),
    /// Degrees of a multiple of pi.
    #[error("'{0}' has two units")]
    Units(String),
}

impl ExactNumber {
    /// An exact rational number.
    pub fn rational(value: impl Into<Rational>) -> Self {
        let factor = value.into();
        let text = factor.to_string();
        Self { factor, times_pi: false, text }
    }

    /// The angle of so many degrees, in radians: `value pi / 180`. For a rational number; a multiple of
    /// pi has its unit already.
    pub fn degrees(&self) -> Self {
        let factor = Rational::from(&self.factor / 180);
        Self { factor, times_pi: true, text: format!("{}deg", self.text) }
    }

    /// Reads an angle in radians, or in degrees with `deg` behind.
    pub fn angle(text: &str) -> Result<Self, ParseExactError> {
        let Some(degrees) = text.strip_suffix("deg") else { return text.parse() };
        let degrees: Self = degrees.parse()?;
        match degrees.is_rational() {
            true => Ok(degrees.degrees()),
            false => Err(ParseExactError::Units(text.to_owned())),
        }
    }

    /// Whether this is a rational number, not a multiple of pi.
    pub fn is_rational(&self) -> bool {
        !self.times_pi
    }

    /// The rational number, or the rational factor of pi.
    pub fn factor(&self) -> &Rational {
        &self.factor
    }

    /// The double nearest to it, ties to even: what a program in double precision makes of it at best.
    /// `None` beyond the largest double.
    pub fn nearest_double(&self) -> Option<f64> {
        // Few bits decide nearly always; a tie is rational, and exact in the bits of a long number.
        let found =
            [128, 4096, 80_000].iter().find_map(|&bits| self.enclosure(bits).nearest_double());
        found.filter(|x| x.is_finite())
    }

    /// An enclosure of `prec` bits, at least one.
    pub fn enclosure(&self, prec: u32) -> Ball {
        let factor = Ball::enclosing(&self.factor, prec);
        if self.times_pi { factor.pi() * factor } else { factor }
    }
}

impl fmt::Display for ExactNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl FromStr for ExactNumber {
    type Err = ParseExactError;

    /// Reads `0.1`, `1e-30`, `1/3`, `pi`, `pi/2`, `2pi/3`, `0.8*pi`.
    ///
    /// ```
    /// use couplet::number::ExactNumber;
    /// let tenth: ExactNumber = "0.1".parse().unwrap();
    /// assert_eq!(*tenth.factor(), rug::Rational::from((1, 10)));
    /// let angle: ExactNumber = "2pi/3".parse().unwrap();
    /// assert!(!angle.is_rational());
    /// ```
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text.len() > MAX_LENGTH {
            return Err(ParseExactError::Length(text.len()));
        }
        let shown = || text.chars().take(40).collect::<String>();
        let syntax = || ParseExactError::Syntax(shown());
        let (numerator, denominator) = match text.split_once('/') {
            Some((numerator, denominator)) => (numerator, Some(denominator)),
            None => (text, None),
        };
        let (numerator, times_pi) =
            match numerator.strip_suffix("pi").or(numerator.strip_suffix('π')) {
                Some(rest) => (rest.strip_suffix('*').unwrap_or(rest), true),
                None => (numerator, false),
            };
        let decimal = |text: &str| {
            let decimal: Decimal = text.parse().map_err(|error| match error {
                ParseDecimalError::Exponent(_) => ParseExactError::Range(shown()),
                ParseDecimalError::Syntax(_) => syntax(),
            })?;
            let in_range = decimal.magnitude().unsigned_abs() <= u64::from(MAX_EXPONENT)
                && decimal.exponent().unsigned_abs() <= (MAX_EXPONENT as usize + MAX_LENGTH) as u64;
            if decimal.digits().is_empty() {
                return Ok(Rational::new());
            }
            in_range.then(|| decimal.to_rational()).ok_or_else(|| ParseExactError::Range(shown()))
        };
        let mut factor = match numerator {
            "" if times_pi => Rational::from(1),
            "-" if times_pi => Rational::from(-1),
            number => decimal(number)?,
        };
        if let Some(denominator) = denominator {
            let denominator: Integer = denominator.parse().map_err(|_| syntax())?;
            if denominator <= 0 {
                return Err(syntax());
            }
            factor /= denominator;
        }
        // A division can leave the range too: 1e-1000/1000….
        let (above, below) = (factor.numer().significant_bits(), factor.denom().significant_bits());
        if factor != 0 && above.abs_diff(below) > MAX_BITS {
            return Err(ParseExactError::Range(shown()));
        }
        Ok(Self { factor, times_pi, text: text.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(text: &str) -> Rational {
        text.parse::<ExactNumber>().unwrap().factor().clone()
    }

    #[test]
    fn numbers_are_read_exactly() {
        assert_eq!(factor("0.1"), Rational::from((1, 10)));
        assert_eq!(factor("1/3"), Rational::from((1, 3)));
        assert_eq!(factor("pi"), 1);
        assert_eq!(factor("0.5*pi"), Rational::from((1, 2)));
        assert_eq!(factor("1.5pi/3"), Rational::from((1, 2)));
        assert_eq!(factor("0"), 0);
        let hundred = format!("0.{}1", "0".repeat(99));
        assert_eq!(factor(&hundred), factor("1e-100"));
        assert_eq!(
            *"45".parse::<ExactNumber>().unwrap().degrees().factor(),
            Rational::from((1, 4))
        );
    }

    #[test]
    fn absurd_input_is_refused() {
        let long = "1".repeat(1_000_000);
        let tiny = format!("1e-1000/1{}", "0".repeat(18_000));
        for bad in [
            "",
            "nan",
            "inf",
            "1e1000000000",
            "1e-2000",
            "1/0",
            "1/-3",
            "pi2",
            "1//2",
            "e",
            &long,
            &tiny,
        ] {
            assert!(bad.parse::<ExactNumber>().is_err(), "{}", &bad[..bad.len().min(20)]);
        }
    }

    #[test]
    fn an_absurd_exponent_is_a_number_out_of_range() {
        for far in ["1e2000", "1e-999999999", "1e99999999999999999999", "1e-99999999pi"] {
            let error = far.parse::<ExactNumber>().unwrap_err();
            assert_eq!(error, ParseExactError::Range(far.to_owned()));
        }
    }

    #[test]
    fn the_nearest_double_is_that_of_the_compiler() {
        for text in ["0.1", "1e-320", "1.5707963267948966", "2.4703282292062328e-324", "1e-400"] {
            let number: ExactNumber = text.parse().unwrap();
            assert_eq!(number.nearest_double(), text.parse().ok(), "{text}");
        }
        let right = "90".parse::<ExactNumber>().unwrap().degrees();
        assert_eq!(right.nearest_double(), Some(std::f64::consts::FRAC_PI_2));
        assert_eq!("1e309".parse::<ExactNumber>().unwrap().nearest_double(), None);
        // Exactly between two doubles.
        let tie: ExactNumber = "9007199254740993".parse().unwrap();
        assert_eq!(tie.nearest_double(), Some(9007199254740992.0));
    }

    #[test]
    fn the_enclosure_holds_the_number() {
        assert!("1/3".parse::<ExactNumber>().unwrap().enclosure(200).contains(&(1, 3).into()));
        let right = "90".parse::<ExactNumber>().unwrap().degrees().enclosure(200);
        let (_, cos) = right.sin_cos();
        assert!(cos.contains(&Rational::new()));
    }
}
