//! Numbers as other programs spell them, made into exact text that every command reads.

use crate::number::{BETWEEN, PLUS_MINUS, hexadecimal, is_angle};
use std::borrow::Cow;

/// Spelling of the numbers of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spelling {
    /// True if a comma may be the decimal point.
    pub decimal_comma: bool,
}

impl Spelling {
    /// A number as it is written here: `0.107D+00`, as Fortran has it, is `0.107e+00`, and with a decimal
    /// comma `1,5` is `1.5`. Any other text stays as it is.
    pub fn decimal(self, text: &str) -> Cow<'_, str> {
        let mut spelt = Cow::Borrowed(text);
        if self.decimal_comma && text.matches(',').count() == 1 && !text.contains('.') {
            spelt = text.replace(',', ".").into();
        }
        if is_fortran(&spelt) {
            spelt = spelt.replace(['d', 'D'], "e").into();
        }
        spelt
    }

    /// Respells a number where nothing but the exact value counts, and with a unit behind the number: a
    /// hexadecimal double, `0x1.8p+1`, is the fraction that it is.
    pub fn exact(self, text: &str) -> Cow<'_, str> {
        let is_unit = |c: char| c.is_alphabetic() || c == '°' || c == ' ';
        let number = text.trim_end_matches(is_unit);
        let spelt = match hexadecimal(number) {
            Some(value) => value.to_string().into(),
            None => self.decimal(number),
        };
        if spelt == number {
            return Cow::Borrowed(text);
        }
        (spelt.into_owned() + &text[number.len()..]).into()
    }

    /// Respells a number or each part of a range; parts without a unit are of degrees, if they are said to be.
    pub fn exact_range(self, text: &str, degrees: bool) -> String {
        let part = |part: &str| {
            let is_bare = !part.trim().is_empty() && !part.contains('%') && !is_angle(part);
            let unit = if degrees && is_bare { "deg" } else { "" };
            format!("{}{unit}", self.exact(part.trim()))
        };
        let signs = [BETWEEN, PLUS_MINUS[0], PLUS_MINUS[1]];
        match signs.into_iter().find(|sign| text.contains(sign)) {
            Some(sign) => text.split(sign).map(part).collect::<Vec<_>>().join(sign),
            None => part(text),
        }
    }
}

/// Tells whether a text is a number with the exponent of Fortran's double precision.
fn is_fortran(text: &str) -> bool {
    let Some((number, power)) = text.split_once(['d', 'D']) else { return false };
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let number = number.strip_prefix(['+', '-']).unwrap_or(number);
    is_digits(&number.replacen('.', "", 1))
        && is_digits(power.strip_prefix(['+', '-']).unwrap_or(power))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Integer;

    #[test]
    fn numbers_of_other_programs_are_the_same_numbers() {
        let comma = Spelling { decimal_comma: true };
        let usual = Spelling::default();
        for (text, expected) in [
            ("0.107D+00", "0.107e+00"),
            (".5d-3", ".5e-3"),
            ("-1D5", "-1e5"),
            ("80deg", "80deg"),
            ("D5", "D5"),
            ("0x1.8p+1", "3"),
            ("-0X1P-3", "-1/8"),
            ("0x1.999999999999ap-4", "3602879701896397/36028797018963968"),
            ("0x1p-1074", &format!("1/{}", Integer::from(1) << 1074u32)),
            ("0x1p99999", "0x1p99999"),
            ("0xgp1", "0xgp1"),
            ("1,5", "1,5"),
        ] {
            assert_eq!(usual.exact(text), expected, "{text}");
        }
        for (text, expected) in [
            ("80,5 deg", "80.5 deg"),
            ("1,5", "1.5"),
            ("1,5D-3", "1.5e-3"),
            ("1.000,5", "1.000,5"),
            ("1,000,5", "1,000,5"),
        ] {
            assert_eq!(comma.exact(text), expected, "{text}");
        }
        assert_eq!(usual.decimal("0x1p0"), "0x1p0", "is no decimal");
    }

    #[test]
    fn each_part_of_a_range_is_spelt() {
        let comma = Spelling { decimal_comma: true };
        for (text, degrees, expected) in [
            ("0,5..0,7", false, "0.5..0.7"),
            ("80,5±1,5", true, "80.5deg±1.5deg"),
            ("80 +- 1%", true, "80deg+-1%"),
            ("80deg..1,5rad", true, "80deg..1.5rad"),
            ("80deg±1", true, "80deg±1deg"),
            ("0x1.8p+1..0.4D+01", false, "3..0.4e+01"),
            ("3 m ± 2 cm", false, "3 m±2 cm"),
            ("80", true, "80deg"),
            ("80..", true, "80deg.."),
            ("0.5...0.7", false, "0.5...0.7"),
            ("1.5rad..100", true, "1.5rad..100deg"),
        ] {
            assert_eq!(comma.exact_range(text, degrees), expected, "{text}");
        }
    }
}
