//! Rows of a batch by columns, in doubles: for arrays.

use super::row::{BatchRow, RowValue, RowVerdict, mode_code, side};
use crate::problem::Mode;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Rows of a batch by columns.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchColumns {
    /// The verdicts, whose codes are their numbers.
    pub verdicts: Vec<RowVerdict>,
    /// The modes, by their places in [`Mode::ALL`](crate::problem::Mode::ALL); 255 where there is none.
    pub modes: Vec<u8>,
    /// Of each quantity the nearest doubles, the lower and the upper bounds; not a number where there is no value.
    pub values: Vec<[Vec<f64>; 3]>,
    /// Reasons of the rows that are undecided or refused, by their places, in order.
    pub reasons: BTreeMap<usize, String>,
}

impl BatchColumns {
    /// Columns of so many rows of which nothing is known.
    pub fn open(rows: usize, quantities: usize) -> Self {
        let none = || [(); 3].map(|()| vec![f64::NAN; rows]);
        Self {
            verdicts: vec![RowVerdict::Undecided; rows],
            modes: vec![u8::MAX; rows],
            values: (0..quantities).map(|_| none()).collect(),
            reasons: BTreeMap::new(),
        }
    }

    /// The codes of the verdicts.
    pub fn verdict_codes(&self) -> Vec<u8> {
        self.verdicts.iter().map(|verdict| *verdict as u8).collect()
    }

    /// Place of the true value of a quantity in a row: -1 below the double, 0 on it, 1 above it; none where that is not
    /// proved, or there is no value.
    pub fn side(&self, quantity: usize, row: usize) -> Option<i32> {
        let [double, lower, upper] = self.values[quantity].each_ref().map(|column| column[row]);
        side(double, [lower, upper])
    }

    /// Puts rows that are columns themselves into some places.
    pub fn put_all(&mut self, places: &[usize], rows: Self) {
        for (from, to) in places.iter().enumerate() {
            self.verdicts[*to] = rows.verdicts[from];
            self.modes[*to] = rows.modes[from];
        }
        for (all, columns) in self.values.iter_mut().zip(&rows.values) {
            for (all, column) in all.iter_mut().zip(columns) {
                places.iter().zip(column).for_each(|(to, x)| all[*to] = *x);
            }
        }
        self.reasons.extend(rows.reasons.into_iter().map(|(from, why)| (places[from], why)));
    }

    /// The rows of columns; those that follow each other and are the same share one.
    pub fn rows(&self) -> Vec<Arc<BatchRow>> {
        let bits = |row: usize| {
            let values = self.values.iter().flatten().map(move |column| column[row].to_bits());
            (self.verdicts[row], self.modes[row], values)
        };
        let same = |row: usize| {
            let (one, other) = (bits(row - 1), bits(row));
            (one.0, one.1) == (other.0, other.1) && one.2.eq(other.2)
        };
        let mut all: Vec<Arc<BatchRow>> = Vec::with_capacity(self.verdicts.len());
        for row in 0..self.verdicts.len() {
            let found = match all.last() {
                Some(last) if last.reason.is_none() && same(row) => Arc::clone(last),
                _ => Arc::new(self.row(row)),
            };
            all.push(found);
        }
        all
    }

    fn row(&self, row: usize) -> BatchRow {
        let value = |columns: &[Vec<f64>; 3]| {
            let [double, lower, upper] = columns.each_ref().map(|column| column[row]);
            (!double.is_nan()).then_some(RowValue { double, bounds: [lower, upper], text: None })
        };
        BatchRow {
            verdict: self.verdicts[row],
            mode: Mode::ALL.get(usize::from(self.modes[row])).copied(),
            values: self.values.iter().map(value).collect(),
            reason: self.reasons.get(&row).cloned(),
        }
    }

    /// Puts a row in its place.
    pub(super) fn put(&mut self, place: usize, row: &BatchRow) {
        self.verdicts[place] = row.verdict;
        self.modes[place] = row.mode_code();
        self.reasons.extend(row.reason.clone().map(|why| (place, why)));
        for (quantity, columns) in self.values.iter_mut().enumerate() {
            let doubles = row.doubles(quantity);
            columns.iter_mut().zip(doubles).for_each(|(column, x)| column[place] = x);
        }
    }

    /// Adds a row of a verdict and a mode, with its doubles.
    pub(super) fn push(
        &mut self,
        (verdict, mode): (RowVerdict, Option<Mode>),
        doubles: &[[f64; 3]],
    ) {
        for (columns, doubles) in self.values.iter_mut().zip(doubles) {
            columns.iter_mut().zip(doubles).for_each(|(column, x)| column.push(*x));
        }
        self.verdicts.push(verdict);
        self.modes.push(mode_code(mode));
    }
}
