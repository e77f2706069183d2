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

/// Row of a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchRow {
    /// Verdict on the arch.
    pub verdict: RowVerdict,
    /// Collapse mode at the least thickness, where that is asked and known.
    pub mode: Option<Mode>,
    /// Values of the quantities, where there are any.
    pub values: Vec<Option<RowValue>>,
    /// Reason why the row is undecided or refused.
    pub reason: Option<String>,
}

/// Value of a row; all three doubles are infinite where the value is.
#[derive(Clone, Debug, PartialEq)]
pub struct RowValue {
    /// The nearest double.
    pub double: f64,
    /// Outward bounds.
    pub bounds: [f64; 2],
    /// The digits, where they are asked for.
    pub text: Option<Box<str>>,
}

impl BatchRow {
    /// The place of the mode in [`Mode::ALL`]; 255 where there is none.
    pub fn mode_code(&self) -> u8 {
        mode_code(self.mode)
    }

    /// The nearest double of a quantity, by its place, with its bounds; not a number where there is no value.
    pub fn doubles(&self, place: usize) -> [f64; 3] {
        match &self.values[place] {
            Some(RowValue { double, bounds: [lower, upper], .. }) => [*double, *lower, *upper],
            None => [f64::NAN; 3],
        }
    }
}

/// Place of a value within bounds, as [`RowValue::side`] tells it.
pub(super) fn side(double: f64, [lower, upper]: [f64; 2]) -> Option<i32> {
    match (lower >= double, upper <= double) {
        (true, true) => Some(0),
        (true, false) => Some(1),
        (false, true) => Some(-1),
        (false, false) => None,
    }
}

/// The place of a mode in [`Mode::ALL`]; 255 where there is none.
pub(super) fn mode_code(mode: Option<Mode>) -> u8 {
    let place = mode.and_then(|mode| Mode::ALL.iter().position(|of| *of == mode));
    place.and_then(|place| u8::try_from(place).ok()).unwrap_or(u8::MAX)
}

impl RowValue {
    /// The value of a figure, infinite without one.
    pub(super) fn new(figure: Option<&Figure>, has_text: bool) -> Self {
        let text = || figure.map_or("inf".into(), |figure| figure.to_string().into());
        let doubles = figure.map(|x| (x.double, x.bounds()));
        let (double, bounds) = doubles.unwrap_or((f64::INFINITY, [f64::INFINITY; 2]));
        Self { double, bounds, text: has_text.then(text) }
    }

    /// Place of the true value: -1 below the double, 0 on it, 1 above it; none where that is not proved.
    pub fn side(&self) -> Option<i32> {
        side(self.double, self.bounds)
    }
}
