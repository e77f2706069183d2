//! A row of a batch: what is known of an arch, in doubles.

use crate::certify::state::Figure;
use crate::number::worded;
use crate::problem::Mode;

worded! {
    /// Verdict on a row, by the code that it has in arrays.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    #[repr(u8)]
    pub enum RowVerdict {
        /// The arch stands: at some thickness, or at the one that it has.
        Stands = "stands",
        /// The arch falls.
        Falls = "falls",
        /// Nothing is known.
        Undecided = "undecided",
        /// The row makes no sense: a number is none, or out of its range.
        Refused = "refused",
    }
    /// Verdicts in the order of their codes.
    pub const ALL;
    /// The name used in files.
    pub fn name -> &'static str;
}

/// Row of a batch, until it is in its columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BatchRow {
    /// Verdict on the arch.
    pub verdict: RowVerdict,
    /// Collapse mode at the least thickness, where that is asked and known.
    pub mode: Option<Mode>,
    /// Values of the quantities, where there are any.
    pub values: Vec<Option<RowValue>>,
    /// Reason why the row is undecided or refused.
    pub reason: Option<String>,
}

/// Value of a row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RowValue {
    /// The nearest double, and outward bounds; all infinite where the value is.
    pub doubles: [f64; 3],
    /// The digits, where they are asked for.
    pub text: Option<Box<str>>,
}

impl RowValue {
    /// The value of a figure, infinite without one.
    pub(super) fn new(figure: Option<&Figure>, has_text: bool) -> Self {
        let text = || figure.map_or("inf".into(), |figure| figure.to_string().into());
        let doubles = figure.map_or([f64::INFINITY; 3], |x| {
            let [lower, upper] = x.bounds();
            [x.double, lower, upper]
        });
        Self { doubles, text: has_text.then(text) }
    }
}
