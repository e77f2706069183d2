//! What reads the values of options.

use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::problem::Landmark;
use crate::report::words::list;
use crate::report::{Content, Format};
use crate::scene::MAX_ARCH_DIGITS;

/// A landmark by its symbol.
pub(super) fn landmark(text: &str) -> Result<Landmark, String> {
    Landmark::ALL.into_iter().find(|landmark| landmark.symbol() == text).ok_or_else(|| {
        format!("a landmark is one of {}", list(Landmark::ALL.map(Landmark::symbol)))
    })
}

/// A self-weight model by its name.
pub(super) fn weight(text: &str) -> Result<SelfWeight, String> {
    SelfWeight::ALL.into_iter().find(|weight| weight.name() == text).ok_or_else(|| {
        format!("a weight is one of {}", list(SelfWeight::ALL.map(SelfWeight::name)))
    })
}

/// What reads the name of a format.
pub(super) fn format(
    content: Content,
) -> impl Fn(&str) -> Result<&'static Format, String> + Clone + Send + Sync + 'static {
    move |name| {
        let format = Format::named(content, name)
            .ok_or_else(|| format!("a format is one of {}", Format::names(content)))?;
        format.missing().map_or(Ok(format), Err)
    }
}

/// What an option of formats is for.
pub(super) fn format_help(content: Content) -> String {
    format!("Output format: {}", Format::names(content))
}

/// A number of significant digits.
pub(super) fn digits(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|digits| (1..=MAX_DIGITS).contains(digits))
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_DIGITS}"))
}

/// The same for a state.
pub(super) fn state_digits(text: &str) -> Result<usize, String> {
    digits(text)
        .ok()
        .filter(|digits| *digits <= MAX_ARCH_DIGITS)
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_ARCH_DIGITS}"))
}
