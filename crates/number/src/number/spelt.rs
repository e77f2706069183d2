//! Numbers as people and other programs spell them, in the one spelling that is read: what has one meaning is respelt,
//! and nothing else.

use num_bigint::BigInt;
use num_rational::BigRational;
use std::borrow::Cow;

/// Hexadecimal digits of the longest double, and a bound of its powers of two.
const MAX_DIGITS: usize = 16;
const MAX_POWER: u32 = 1_100;

/// A number with or without a unit as it is read: `−1.5` with the minus of typography, `80º` with the ordinal of
/// Spanish keyboards, `Pi/2`, Fortran's `0.107D+00`, and `0x1.8p+1`, which is the fraction that it is.
///
/// ```
/// use couplet_number::number::spelt;
/// assert_eq!(["−1", "80º", "PI/2", "1.5D0", "0x1p-1m"].map(spelt), ["-1", "80°", "pi/2", "1.5e0", "1/2m"]);
/// ```
pub fn spelt(text: &str) -> Cow<'_, str> {
    let text = text.trim();
    let mut spelt = Cow::Borrowed(text);
    if !text.is_ascii() {
        spelt = text.replace('\u{2212}', "-").replace('º', "°").into();
    }
    if let Some(place) = spelt.to_ascii_lowercase().find("pi")
        && !spelt[place..].starts_with("pi")
    {
        spelt.to_mut().replace_range(place..place + 2, "pi");
    }
    let is_unit = |c: char| c.is_alphabetic() || "° '\"".contains(c);
    let number = spelt.trim_end_matches(is_unit);
    let exact = hexadecimal(number).map(|exact| exact.to_string()).or_else(|| of_fortran(number));
    match exact {
        Some(exact) => (exact + &spelt[number.len()..]).into(),
        None => spelt,
    }
}

/// Tells whether a text is digits with one point at the most, as nearly all numbers of files are: one number without a
/// sign or a unit, spelt as it is read.
pub fn is_plain(text: &str) -> bool {
    let points = text.bytes().filter(|byte| *byte == b'.').count();
    !text.is_empty()
        && points <= 1
        && text.bytes().all(|byte| byte == b'.' || byte.is_ascii_digit())
}

/// The exact value of a double in hexadecimal as C and many others write it, `0x1.8p+1`; `None` if a text
/// is not of that form, or longer or larger than a double needs.
pub fn hexadecimal(text: &str) -> Option<BigRational> {
    let (is_negative, size) = match text.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let size = size.strip_prefix("0x").or_else(|| size.strip_prefix("0X"))?;
    let (mantissa, power) = size.split_once(['p', 'P'])?;
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{part}");
    let is_digits = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_hexdigit());
    let power: i32 = power.parse().ok()?;
    if !is_digits || digits.len() > MAX_DIGITS || power.unsigned_abs() > MAX_POWER {
        return None;
    }
    let integer = BigInt::parse_bytes(digits.as_bytes(), 16)?;
    let (integer, power) =
        (if is_negative { -integer } else { integer }, power - 4 * part.len() as i32);
    Some(over_twos(integer << power.max(0), power.min(0).unsigned_abs().into()))
}

/// `above/2^twos` in lowest terms, as every double is. Its twos are counted: to seek a common divisor takes longer than
/// all else of a double.
pub(super) fn over_twos(above: BigInt, twos: u64) -> BigRational {
    let common = above.trailing_zeros().map_or(twos, |of_above| of_above.min(twos));
    BigRational::new_raw(above >> common, BigInt::from(1) << (twos - common))
}

/// A number with the exponent of Fortran's double precision, with the usual one.
pub fn of_fortran(text: &str) -> Option<String> {
    let (number, power) = text.split_once(['d', 'D'])?;
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let size = number.strip_prefix(['+', '-']).unwrap_or(number);
    let is_one = is_digits(&size.replacen('.', "", 1))
        && is_digits(power.strip_prefix(['+', '-']).unwrap_or(power));
    is_one.then(|| format!("{number}e{power}"))
}

/// Text of a rational number: a decimal if it ends, else a fraction.
pub fn decimal(number: &BigRational) -> String {
    let below = number.denom();
    let twos = below.trailing_zeros().unwrap_or(0) as usize;
    let (mut odd, mut fives) = (below >> twos, 0);
    let five = BigInt::from(5);
    while &odd % &five == BigInt::ZERO {
        (odd, fives) = (odd / &five, fives + 1);
    }
    if odd != BigInt::from(1) {
        return number.to_string();
    }
    let places = twos.max(fives);
    let scaled = number.numer() * (BigInt::from(10).pow(places as u32) / below);
    let written: Result<super::Decimal, _> = format!("{scaled}e-{places}").parse();
    written.map_or_else(|_| number.to_string(), |decimal| decimal.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_other_programs_are_the_same_numbers() {
        for (text, expected) in [
            ("0.107D+00", "0.107e+00"),
            (".5d-3", ".5e-3"),
            ("-1D5", "-1e5"),
            ("80deg", "80deg"),
            ("D5", "D5"),
            ("0x1.8p+1", "3"),
            ("-0X1P-3", "-1/8"),
            ("0x1.999999999999ap-4", "3602879701896397/36028797018963968"),
            ("0x1p-1074", &format!("1/{}", BigInt::from(1) << 1074)),
            ("0x1p99999", "0x1p99999"),
            ("0xgp1", "0xgp1"),
            ("0x1.1.1p1", "0x1.1.1p1"),
            ("1,5", "1,5"),
            (" \u{2212}80\u{ba} ", "-80°"),
            ("2Pi/3", "2pi/3"),
        ] {
            assert_eq!(spelt(text), expected, "{text}");
        }
    }

    #[test]
    fn doubles_in_hexadecimal_are_exact() {
        for (text, x) in [
            ("0x1p+0", 1.0),
            ("0x1.999999999999ap-4", 0.1),
            ("-0X1.4P1", -2.5),
            ("0x1p-1074", 5e-324),
            ("0x0.8p0", 0.5),
            ("0x1.fffffffffffffp+1023", f64::MAX),
        ] {
            assert_eq!(hexadecimal(text), BigRational::from_float(x), "{text}");
        }
        for text in ["", "0x", "0xp1", "0x1", "0x1p", "0x1p99999999999", "1p1"] {
            assert_eq!(hexadecimal(text), None, "{text}");
        }
    }
}
