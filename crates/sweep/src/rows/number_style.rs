//! Numbers as other programs spell them, made into exact text that every command reads.

use crate::number::{BETWEEN, PLUS_MINUS, is_plain, is_range, of_fortran, spelt_range};
use std::borrow::Cow;

/// Spelling of the numbers of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NumberStyle {
    /// True if a comma may be the decimal point.
    pub decimal_comma: bool,
}

impl NumberStyle {
    /// A number as it is written here: `0.107D+00`, as Fortran has it, is `0.107e+00`, and with a decimal
    /// comma `1,5` is `1.5`. Any other text stays as it is.
    pub fn decimal(self, text: &str) -> Cow<'_, str> {
        let mut spelt = Cow::Borrowed(text);
        if self.decimal_comma && text.matches(',').count() == 1 && !text.contains('.') {
            spelt = text.replace(',', ".").into();
        }
        of_fortran(&spelt).map_or(spelt, Cow::Owned)
    }

    /// Respells a number with a unit behind it, where nothing but the exact value counts.
    pub fn exact(self, text: &str) -> Cow<'_, str> {
        let is_unit = |c: char| c.is_alphabetic() || c == '°' || c == ' ';
        let number = text.trim_end_matches(is_unit);
        match self.decimal(number) {
            Cow::Borrowed(_) => text.into(),
            Cow::Owned(spelt) => (spelt + &text[number.len()..]).into(),
        }
    }

    /// Respells a number or each part of a range; parts without a unit have that of their column.
    pub fn exact_range(self, text: &str, unit: &str) -> String {
        if is_plain(text) {
            return self.exact(text).into_owned() + unit;
        }
        if !self.decimal_comma && unit.is_empty() && is_range(text) {
            return text.trim().to_owned();
        }
        let part = |part: &str| {
            let unit = if is_bare(part.trim()) { unit } else { "" };
            format!("{}{unit}", self.exact(part.trim()))
        };
        let text = &*spelt_range(text);
        match [BETWEEN, PLUS_MINUS].into_iter().find(|sign| text.contains(sign)) {
            Some(sign) => text.split(sign).map(part).collect::<Vec<_>>().join(sign),
            None => part(text),
        }
    }
}

/// Tells whether a text is a number without a unit.
pub(super) fn is_bare(text: &str) -> bool {
    text.ends_with(|c: char| c.is_ascii_digit() || c == '.' || c == 'π') || text.ends_with("pi")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_other_programs_are_the_same_numbers() {
        let comma = NumberStyle { decimal_comma: true };
        for text in ["80deg", "1,5"] {
            assert_eq!(NumberStyle::default().exact(text), text);
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
    }

    #[test]
    fn each_part_of_a_range_is_spelt() {
        let comma = NumberStyle { decimal_comma: true };
        for (text, unit, expected) in [
            ("0,5..0,7", "", "0.5..0.7"),
            ("80,5±1,5", "deg", "80.5deg±1.5deg"),
            ("80 +- 1%", "deg", "80deg±1%"),
            ("80deg..1,5rad", "deg", "80deg..1.5rad"),
            ("80deg±1", "deg", "80deg±1deg"),
            ("0x1.8p+1..0.4D+01", "", "0x1.8p+1..0.4e+01"),
            ("0,5-0,7", "", "0.5..0.7"),
            ("3±2cm", "m", "3m±2cm"),
            ("3 m ± 2 cm", "", "3 m±2 cm"),
            ("80", "deg", "80deg"),
            ("80..", "deg", "80deg.."),
            ("0.5...0.7", "", "0.5...0.7"),
            ("1.5rad..100", "deg", "1.5rad..100deg"),
        ] {
            assert_eq!(comma.exact_range(text, unit), expected, "{text}");
        }
    }
}
