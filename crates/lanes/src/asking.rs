//! Rows that go through one proof together.

use super::piece::Proof;
use super::width::Width;
use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure};

/// Rows that go through one proof, and what is given of them.
pub(super) struct Asking<const IN: usize> {
    rows: Vec<usize>,
    given: Vec<[DoubleDoubleBall; IN]>,
}

impl<const IN: usize> Default for Asking<IN> {
    fn default() -> Self {
        Self { rows: Vec::new(), given: Vec::new() }
    }
}

impl<const IN: usize> Asking<IN> {
    /// Adds a row.
    pub(super) fn push(&mut self, row: usize, given: [DoubleDoubleBall; IN]) {
        self.rows.push(row);
        self.given.push(given);
    }

    /// The rows, with what is given of each.
    pub(super) fn into_rows(self) -> impl Iterator<Item = (usize, [DoubleDoubleBall; IN])> {
        self.rows.into_iter().zip(self.given)
    }

    /// Tells the rows of which something is proved, with what is given and found of each. A proof that no row asks for
    /// is not made, nor are its tables.
    pub(super) fn each<const ANGLES: usize, const OUT: usize, P: Proof<IN, ANGLES, OUT>>(
        &self,
        width: Width,
        proof: impl FnOnce() -> P,
        mut tell: impl FnMut(usize, [DoubleDoubleBall; IN], [DoubleDoubleBall; OUT]),
    ) {
        if self.rows.is_empty() {
            return;
        }
        let found = width.prove(&proof(), &self.given);
        for ((row, given), found) in self.rows.iter().zip(&self.given).zip(found) {
            if let Some(found) = found {
                tell(*row, *given, found);
            }
        }
    }
}

/// Zero.
pub(super) fn zero() -> DoubleDoubleBall {
    DoubleDoubleBall::exact(DoubleDouble::ZERO)
}

/// Numbers of a half opening for the proof that it overturns without a limit of friction.
pub(super) fn overturning_at(alpha: DoubleDoubleBall) -> [DoubleDoubleBall; 4] {
    [alpha, DoubleDoubleBall::WHOLE, zero(), zero()]
}

/// The double next to the middle of a ball.
pub(super) fn double(x: &DoubleDoubleBall) -> f64 {
    x.mid().hi()
}

/// Tells whether one is proved to be below the other.
pub(super) fn is_below(one: &DoubleDoubleBall, other: &DoubleDoubleBall) -> bool {
    one.is_less_than(other).is_proved()
}
