//! Rows of a batch by columns, in doubles: for arrays.

use super::batch::{Batch, BatchArches, Threads};
use super::in_lanes::{self, Answered};
use super::row::{BatchRow, RowVerdict, mode_code};
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
}

impl BatchColumns {
    /// So many rows of which nothing is known.
    fn open(rows: usize, quantities: usize) -> Self {
        let none = || [(); 3].map(|()| vec![f64::NAN; rows]);
        Self {
            verdicts: vec![RowVerdict::Undecided; rows],
            modes: vec![u8::MAX; rows],
            values: (0..quantities).map(|_| none()).collect(),
        }
    }

    /// The columns of rows.
    pub(super) fn of(rows: &[Arc<BatchRow>], quantities: usize) -> Self {
        let mut all = Self::open(rows.len(), quantities);
        rows.iter().enumerate().for_each(|(place, row)| all.put(place, row));
        all
    }

    /// Puts a row in its place.
    fn put(&mut self, place: usize, row: &BatchRow) {
        self.verdicts[place] = row.verdict;
        self.modes[place] = row.mode_code();
        for (quantity, columns) in self.values.iter_mut().enumerate() {
            let doubles = row.doubles(quantity);
            columns.iter_mut().zip(doubles).for_each(|(column, x)| column[place] = x);
        }
    }

    /// Puts an answer in its place, if all that is asked is decided.
    fn put_answer(&mut self, place: usize, answer: &Answered, batch: &Batch) -> bool {
        for (columns, of) in self.values.iter_mut().zip(&batch.quantities) {
            let Some(doubles) = answer.doubles(*of) else { return false };
            columns.iter_mut().zip(doubles).for_each(|(column, x)| column[place] = x);
        }
        let (verdict, mode) = answer.verdict();
        self.verdicts[place] = verdict;
        self.modes[place] = mode_code(mode);
        true
    }

    /// The columns of all rows of a batch.
    pub(super) fn new(batch: &Batch, arches: &impl BatchArches, threads: Threads) -> Self {
        let quantities = batch.quantities.len();
        let made = |answers: &[Answered]| {
            let mut columns = Self::open(answers.len(), quantities);
            let decided = |(place, answer): (usize, &Answered)| {
                columns.put_answer(place, answer, batch).then_some(answer.row)
            };
            let rows: Vec<Option<usize>> = answers.iter().enumerate().map(decided).collect();
            (rows, columns)
        };
        let mut all = Self::open(arches.count(), quantities);
        let mut is_open = vec![true; arches.count()];
        for (rows, columns) in in_lanes::pieces(batch, arches, threads, made) {
            for (place, row) in rows.iter().enumerate() {
                let Some(row) = *row else { continue };
                is_open[row] = false;
                all.verdicts[row] = columns.verdicts[place];
                all.modes[row] = columns.modes[place];
            }
            for (all, columns) in all.values.iter_mut().zip(&columns.values) {
                for (all, column) in all.iter_mut().zip(columns) {
                    let places = rows.iter().zip(column);
                    places.for_each(|(row, x)| row.iter().for_each(|row| all[*row] = *x));
                }
            }
        }
        let open: Vec<usize> = (0..is_open.len()).filter(|row| is_open[*row]).collect();
        for (row, found) in batch.by_openings(&open, arches, threads) {
            all.put(row, &found);
        }
        all
    }
}
