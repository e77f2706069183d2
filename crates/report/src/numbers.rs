//! Numbers for people: correctly rounded, without the zeros that say nothing.

use crate::number::{Ball, Rounded};
use std::fmt;

/// More digits than asked for are shown, at most so many, where the value may be half way between two decimals.
const MORE: usize = 6;

/// Text of a number, which has digits: there is no empty one that a sentence could be left with.
#[derive(PartialEq)]
pub struct NumberText(String);

impl fmt::Display for NumberText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

/// Value correctly rounded, if the ball decides it.
pub fn decided(x: &Ball, digits: usize) -> Option<NumberText> {
    in_digits(x, digits).map(|text| NumberText(without_zeros(&text)))
}

/// Value correctly rounded, with the zeros at its end, if the ball decides it.
pub fn in_digits(x: &Ball, digits: usize) -> Option<String> {
    in_digits_by(digits, |digits| Rounded::around(x, digits))
}

/// Value in so many digits, or in the fewest more, in which it is correctly rounded.
pub fn in_digits_by(digits: usize, rounded: impl Fn(usize) -> Option<Rounded>) -> Option<String> {
    Some((digits..=digits + MORE).find_map(rounded)?.value.to_string())
}

/// A value correctly rounded, in words where that is not decided.
pub fn rounded(x: &Ball, digits: usize) -> String {
    decided(x, digits).map_or_else(|| UNDECIDED.to_owned(), |text| text.0)
}

/// The word for a digit that is not proved.
pub const UNDECIDED: &str = "undecided";

/// Text without the zeros at the end of a decimal fraction.
pub fn without_zeros(text: &str) -> String {
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    }
}
