//! Numbers as they are shown in pictures and below them.

use super::metres::{Metres, Size};
use crate::picture::text;
use crate::report::numbers::{UNDECIDED, in_digits_by, without_zeros};

/// Digits that are shown.
pub(super) const DIGITS: usize = 6;
pub(super) const FEW: usize = 4;

/// A size correctly rounded.
pub(super) fn shown(x: &Size, digits: usize) -> String {
    without_zeros(&in_full(x, digits))
}

/// A length in the unit of who asks: `33 ft`.
pub(super) fn told(of: &Metres, length: &Size, digits: usize) -> String {
    format!("{} {}", shown(&length.over(&of.unit.metres()), digits), of.unit.name())
}

/// Number with the zeros at its end, where others of as many digits stand beside it.
pub(super) fn in_full(x: &Size, digits: usize) -> String {
    in_digits_by(digits, |digits| x.rounded(digits)).unwrap_or_else(|| UNDECIDED.to_owned())
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
