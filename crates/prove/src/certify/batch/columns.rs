//! Rows of a batch by columns, in doubles: for arrays.

use super::row::{BatchRow, RowVerdict};
use crate::problem::Mode;
use std::collections::BTreeMap;

/// Rows of a batch by columns.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchColumns {
    /// The verdicts, whose codes are their numbers.
    pub verdicts: Vec<RowVerdict>,
    /// The modes, by their places in [`Mode::ALL`](crate::problem::Mode::ALL); 255 where there is none.
    pub modes: Vec<u8>,
    /// Of each quantity the nearest doubles, the lower and the upper bounds; not a number where there is no value.
    pub values: Vec<[Vec<f64>; 3]>,
    /// Of each quantity the digits, where they are asked for; none where there is no value.
    pub texts: Vec<Vec<Option<Box<str>>>>,
    /// Reasons of the rows that are undecided or refused, by their places, in order.
    pub reasons: BTreeMap<usize, String>,
}

impl BatchColumns {
    /// Columns of so many rows of which nothing is known, without digits.
    pub fn open(rows: usize, quantities: usize) -> Self {
        let none = || [(); 3].map(|()| vec![f64::NAN; rows]);
        Self {
            verdicts: vec![RowVerdict::Undecided; rows],
            modes: vec![u8::MAX; rows],
            values: (0..quantities).map(|_| none()).collect(),
            texts: Vec::new(),
            reasons: BTreeMap::new(),
        }
    }

    /// The codes of the verdicts.
    pub fn verdict_codes(&self) -> Vec<u8> {
        self.verdicts.iter().map(|verdict| *verdict as u8).collect()
    }

    /// The mode of a row, where there is one.
    pub fn mode(&self, row: usize) -> Option<Mode> {
        Mode::ALL.get(usize::from(self.modes[row])).copied()
    }

    /// The nearest double of a quantity in a row, where there is a value.
    pub fn double(&self, quantity: usize, row: usize) -> Option<f64> {
        Some(self.values[quantity][0][row]).filter(|double| !double.is_nan())
    }

    /// Place of the true value of a quantity in a row: -1 below the double, 0 on it, 1 above it; none where that is not
    /// proved, or there is no value.
    pub fn side(&self, quantity: usize, row: usize) -> Option<i32> {
        let [double, lower, upper] = self.values[quantity].each_ref().map(|column| column[row]);
        match (lower >= double, upper <= double) {
            (true, true) => Some(0),
            (true, false) => Some(1),
            (false, true) => Some(-1),
            (false, false) => None,
        }
    }

    /// Puts rows that are columns themselves into some places, in any order.
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

    /// Adds the rows of others, which have neither digits nor reasons, behind these.
    pub(super) fn append(&mut self, rows: Self) {
        self.verdicts.extend(rows.verdicts);
        self.modes.extend(rows.modes);
        for (all, columns) in self.values.iter_mut().zip(rows.values) {
            all.iter_mut().zip(columns).for_each(|(all, column)| all.extend(column));
        }
    }

    /// Puts a row in its place.
    pub(super) fn put(&mut self, place: usize, row: &BatchRow) {
        let doubles = row.values.iter().map(|value| Some(value.as_ref()?.doubles));
        let doubles = doubles.map(|doubles| doubles.unwrap_or([f64::NAN; 3]));
        self.set(place, (row.verdict, row.mode), doubles);
        self.reasons.extend(row.reason.clone().map(|why| (place, why)));
        for (texts, value) in self.texts.iter_mut().zip(&row.values) {
            texts[place] = value.as_ref().and_then(|value| value.text.clone());
        }
    }

    /// Puts the verdict and the mode of a row in its place, with its doubles.
    #[inline(always)]
    pub(super) fn set(
        &mut self,
        place: usize,
        (verdict, mode): (RowVerdict, Option<Mode>),
        doubles: impl Iterator<Item = [f64; 3]>,
    ) {
        self.verdicts[place] = verdict;
        self.modes[place] = mode.map_or(u8::MAX, |mode| mode as u8);
        for ([all, lowers, uppers], doubles) in self.values.iter_mut().zip(doubles) {
            [all[place], lowers[place], uppers[place]] = doubles;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;

    #[test]
    fn a_code_is_a_place_among_all() {
        let modes = Mode::ALL.into_iter().enumerate();
        assert!(modes.into_iter().all(|(place, mode)| mode as usize == place));
        let weights = SelfWeight::ALL.into_iter().enumerate();
        assert!(weights.into_iter().all(|(place, weight)| weight as usize == place));
    }

    #[test]
    fn rows_find_their_places_in_any_order() {
        // The third has as many places as lie between its ends, in another order.
        for places in [&[1, 2, 3][..], &[2], &[0, 2, 1, 3], &[3, 1], &[0, 2, 3], &[]] {
            let mut rows = BatchColumns::open(places.len(), 1);
            rows.modes = places.iter().map(|place| *place as u8).collect();
            rows.values[0][2] = places.iter().map(|place| *place as f64).collect();
            let mut all = BatchColumns::open(4, 1);
            all.put_all(places, rows);
            for row in 0..4 {
                let is_put = places.contains(&row);
                assert_eq!(all.modes[row], if is_put { row as u8 } else { u8::MAX }, "{places:?}");
                let value = all.values[0][2][row];
                assert!(if is_put { value == row as f64 } else { value.is_nan() }, "{places:?}");
            }
        }
    }
}
