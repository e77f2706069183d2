//! A summary of all rows: counts, a histogram and the worst rows. It does not grow with the file.

use super::row::JudgedRow;
use crate::arch::SelfWeight;
use crate::judge::{CorrectDigits, Demand, ErrorSide, Judged, PrintedVerdict, Verdict};
use crate::number::Decimal;
use crate::problem::Quantity;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A summary of all rows.
#[derive(Debug, Default)]
pub struct JudgeSummary {
    pub(super) demand: Demand,
    /// The weight that was assumed, as neither the rows nor the user said any.
    pub(super) assumed: Option<SelfWeight>,
    /// Rows that are kept as the worst, and as the first that cannot be judged.
    kept: usize,
    pub(super) rows: u64,
    pub(super) verdicts: BTreeMap<Verdict, u64>,
    pub(super) quantities: Vec<QuantitySummary>,
    pub(super) thinner: u64,
    pub(super) thicker: u64,
    /// Rows by the digits to which their worst number is correct.
    pub(super) histogram: BTreeMap<CorrectDigits, u64>,
    /// Rows from the worst.
    pub(super) worst: Vec<JudgedRow>,
    /// The first that cannot be judged.
    pub(super) unjudged: Vec<JudgedRow>,
}

/// A summary of one quantity.
#[derive(Debug)]
pub(super) struct QuantitySummary {
    pub(super) quantity: Quantity,
    pub(super) judged: u64,
    pub(super) correctly_rounded: u64,
    pub(super) faithful: u64,
    pub(super) nearest_doubles: u64,
    pub(super) least: CorrectDigits,
    pub(super) largest_relative: Option<Decimal>,
}

impl JudgeSummary {
    /// Summary of no rows; `kept` is how many of the worst are to be kept.
    pub fn new(demand: Demand, assumed: Option<SelfWeight>, kept: usize) -> Self {
        Self { demand, assumed, kept, ..Self::default() }
    }

    /// Counts a row.
    pub fn add(&mut self, row: JudgedRow) {
        self.rows += 1;
        let verdict = row.verdict();
        *self.verdicts.entry(verdict).or_default() += 1;
        if let Some(digits) = row.correct_digits() {
            *self.histogram.entry(digits).or_default() += 1;
        }
        match row.judgement().and_then(|judgement| judgement.side()) {
            Some(ErrorSide::Thinner) => self.thinner += 1,
            Some(ErrorSide::Thicker) => self.thicker += 1,
            None => {}
        }
        for number in row.numbers() {
            self.quantity(number.quantity).add(number);
        }
        self.keep(row);
    }

    /// Number of all rows.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Number of rows that pass.
    pub fn accepted(&self) -> u64 {
        self.verdicts.iter().filter(|(v, _)| v.is_accepted()).map(|(_, count)| count).sum()
    }

    /// Number of rows with a verdict.
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts.get(&verdict).copied().unwrap_or(0)
    }

    fn quantity(&mut self, quantity: Quantity) -> &mut QuantitySummary {
        let place = self.quantities.iter().position(|m| m.quantity == quantity);
        let place = place.unwrap_or_else(|| {
            self.quantities.push(QuantitySummary::new(quantity));
            self.quantities.len() - 1
        });
        &mut self.quantities[place]
    }

    fn keep(&mut self, row: JudgedRow) {
        let verdict = row.verdict();
        if !verdict.is_judged() {
            if self.unjudged.len() < self.kept {
                self.unjudged.push(row);
            }
            return;
        }
        let has_numbers = !row.numbers().is_empty();
        if verdict == Verdict::CorrectlyRounded || (verdict == Verdict::Correct && !has_numbers) {
            return;
        }
        // Behind its equals: of these, the first rows are kept.
        let place = self.worst.partition_point(|kept| by_gravity(kept, &row) != Ordering::Less);
        if place < self.kept {
            self.worst.insert(place, row);
            self.worst.truncate(self.kept);
        }
    }
}

impl QuantitySummary {
    fn new(quantity: Quantity) -> Self {
        let least = CorrectDigits::Exact;
        Self {
            quantity,
            judged: 0,
            correctly_rounded: 0,
            faithful: 0,
            nearest_doubles: 0,
            least,
            largest_relative: None,
        }
    }

    fn add(&mut self, number: &Judged) {
        self.judged += 1;
        self.correctly_rounded += u64::from(number.is_correctly_rounded());
        self.faithful += u64::from(number.rounding == Some(PrintedVerdict::Faithful));
        self.nearest_doubles += u64::from(number.is_nearest_double == Some(true));
        self.least = self.least.min(number.correct_digits);
        let relative = number.errors.as_ref().and_then(|errors| errors.relative.clone());
        if by_size(self.largest_relative.as_ref(), relative.as_ref()) == Ordering::Less {
            self.largest_relative = relative;
        }
    }

    /// Numbers a unit of the last place or more away, or not numbers where the truth is one.
    pub(super) fn wrong(&self) -> u64 {
        self.judged - self.correctly_rounded - self.faithful
    }
}

/// The graver verdict is greater; then fewer correct digits; then the larger relative error.
fn by_gravity(a: &JudgedRow, b: &JudgedRow) -> Ordering {
    let fewer = || b.correct_digits().cmp(&a.correct_digits());
    let relative = || by_size(worst_relative(a), worst_relative(b));
    a.verdict().cmp(&b.verdict()).then_with(fewer).then_with(relative)
}

fn worst_relative(row: &JudgedRow) -> Option<&Decimal> {
    let errors = row.numbers().iter().filter_map(|n| n.errors.as_ref()?.relative.as_ref());
    errors.max_by(|a, b| by_size(Some(a), Some(b)))
}

/// Order of two sizes that are not negative; none is the least.
fn by_size(a: Option<&Decimal>, b: Option<&Decimal>) -> Ordering {
    fn key(x: &Decimal) -> (bool, i64, &str) {
        let zero = x.digits().is_empty();
        (!zero, if zero { 0 } else { x.magnitude() }, x.digits())
    }
    a.map(key).cmp(&b.map(key))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_compared_exactly() {
        let size = |text: &str| text.parse::<Decimal>().unwrap();
        let rising = ["0", "1e-20", "9.99e-20", "0.012", "0.0123", "0.9", "1.01", "20"];
        for pair in rising.windows(2) {
            let (a, b) = (size(pair[0]), size(pair[1]));
            assert_eq!(by_size(Some(&a), Some(&b)), Ordering::Less, "{pair:?}");
        }
        assert_eq!(by_size(None, Some(&size("0"))), Ordering::Less);
    }
}
