//! Doubles in hexadecimal, which are exact.

use rug::{Integer, Rational};

/// Hexadecimal digits of the longest double, and a bound of its powers of two.
const MAX_DIGITS: usize = 16;
const MAX_POWER: u32 = 1_100;

/// The exact value of a double in hexadecimal as C and many others write it, `0x1.8p+1`; `None` if a text
/// is not of that form, or longer or larger than a double needs.
///
/// ```
/// assert_eq!(couplet_number::number::hexadecimal("-0x1.8p+1").unwrap(), -3);
/// assert_eq!(couplet_number::number::hexadecimal("1.8"), None);
/// ```
pub fn hexadecimal(text: &str) -> Option<Rational> {
    let lower = text.to_ascii_lowercase();
    let (is_negative, size) = match lower.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, lower.strip_prefix('+').unwrap_or(&lower)),
    };
    let (mantissa, power) = size.strip_prefix("0x")?.split_once('p')?;
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{part}");
    let is_digits = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_hexdigit());
    let power: i32 = power.parse().ok()?;
    if !is_digits || digits.len() > MAX_DIGITS || power.unsigned_abs() > MAX_POWER {
        return None;
    }
    let integer = Integer::from_str_radix(&digits, 16).ok()?;
    let value = Rational::from(integer) << (power - 4 * part.len() as i32);
    Some(if is_negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

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
            assert_eq!(hexadecimal(text), Rational::from_f64(x), "{text}");
        }
        for text in
            ["", "0x", "0xp1", "0x1", "0xgp1", "0x1p", "0x1p99999999999", "0x1.1.1p1", "1p1"]
        {
            assert_eq!(hexadecimal(text), None, "{text}");
        }
    }
}
