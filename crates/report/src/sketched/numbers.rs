//! Numbers as they are shown in pictures and below them.

use super::metres::Size;
use crate::number::Ball;
use crate::picture::text;

/// Digits that are shown.
pub(super) const DIGITS: usize = 6;
pub(super) const FEW: usize = 4;

/// More digits than asked for are shown, at most so many, where the value may be half way between two decimals.
const MORE: usize = 6;

/// Value correctly rounded, if the ball decides it.
pub(crate) fn decided(x: &Ball, digits: usize) -> Option<String> {
    in_digits(&Size::from(x.clone()), digits).map(|text| shortened(&text))
}

/// A value correctly rounded.
pub(super) fn rounded(x: &Ball, digits: usize) -> String {
    shown(&Size::from(x.clone()), digits)
}

/// A size correctly rounded.
pub(super) fn shown(x: &Size, digits: usize) -> String {
    shortened(&in_full(x, digits))
}

/// Number with the zeros at its end, where others of as many digits stand beside it.
pub(super) fn in_full(x: &Size, digits: usize) -> String {
    in_digits(x, digits).unwrap_or_else(|| "undecided".to_owned())
}

fn in_digits(x: &Size, digits: usize) -> Option<String> {
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
