//! Numbers as they are shown in pictures and below them.

use super::metres::{Metres, Size};
use crate::number::Ball;
use crate::picture::text;
use std::fmt;

/// Digits that are shown.
pub(super) const DIGITS: usize = 6;
pub(super) const FEW: usize = 4;

/// More digits than asked for are shown, at most so many, where the value may be half way between two decimals.
const MORE: usize = 6;

/// Text of a number, which has digits: there is no empty one that a sentence could be left with.
#[derive(PartialEq)]
pub(crate) struct NumberText(String);

impl fmt::Display for NumberText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

/// Value correctly rounded, if the ball decides it.
pub(crate) fn decided(x: &Ball, digits: usize) -> Option<NumberText> {
    in_digits(x, digits).map(|text| NumberText(shortened(&text)))
}

/// Value correctly rounded, with the zeros at its end, if the ball decides it.
pub(crate) fn in_digits(x: &Ball, digits: usize) -> Option<String> {
    size_in_digits(&Size::from(x.clone()), digits)
}

/// A value correctly rounded.
pub(crate) fn rounded(x: &Ball, digits: usize) -> String {
    shown(&Size::from(x.clone()), digits)
}

/// A size correctly rounded.
pub(super) fn shown(x: &Size, digits: usize) -> String {
    shortened(&in_full(x, digits))
}

/// A length in the unit of who asks: `33 ft`.
pub(super) fn told(of: &Metres, length: &Size, digits: usize) -> String {
    format!("{} {}", shown(&length.over(&of.unit.metres()), digits), of.unit.name())
}

/// Number with the zeros at its end, where others of as many digits stand beside it.
pub(super) fn in_full(x: &Size, digits: usize) -> String {
    size_in_digits(x, digits).unwrap_or_else(|| "undecided".to_owned())
}

fn size_in_digits(x: &Size, digits: usize) -> Option<String> {
    let rounded = (digits..=digits + MORE).find_map(|digits| x.rounded(digits));
    Some(rounded?.value.to_string())
}

/// Text without the zeros at the end of a decimal fraction.
fn shortened(text: &str) -> String {
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    }
}

/// A joint in degrees, for the picture.
pub(super) fn label(symbol: &str, joint: f64) -> String {
    match joint.to_degrees() {
        small if small < 0.1 => format!("{symbol} {small:.1e}°"),
        degrees => format!("{symbol} {degrees:.1}°"),
    }
}

/// A length for the eye, in units of `r`.
pub(super) fn length(by: f64) -> String {
    match by {
        small if small < 1e-3 => {
            let order = small.log10().floor();
            format!("{:.1}×{} r", small / 10f64.powf(order), text::power_of_ten(order as i64))
        }
        by => format!("{by:.3} r"),
    }
}
