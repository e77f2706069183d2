//! Newton's method over any approximate number: what a careful user would write.

use super::Task;
use crate::number::Real;
use rug::Float;

/// A number with a size, so that a pivot and a last step can be chosen.
pub trait Approximate: Real {
    /// The exponent of its size in base two; very small for zero.
    fn exponent(&self) -> i64;
}

impl Approximate for f64 {
    fn exponent(&self) -> i64 {
        if *self == 0.0 { i64::MIN } else { self.abs().log2().floor() as i64 }
    }
}

impl Approximate for Float {
    fn exponent(&self) -> i64 {
        self.get_exp().map_or(i64::MIN, i64::from)
    }
}

/// Steps after which the iteration is given up.
const STEPS: usize = 100;

/// Where the iteration ended, and how many steps it took.
pub struct Newton<T> {
    /// The last iterate.
    pub root: Vec<T>,
    /// Steps, each with one evaluation of the residuals and their slopes.
    pub steps: usize,
}

/// Newton's method at the precision of the start, until a step is of the size of the rounding (`bits`)
/// or no longer gets smaller. `None` if it breaks down.
pub fn newton<T: Approximate>(problem: &Task, start: &[T], bits: u32) -> Option<Newton<T>> {
    let mut root = start.to_vec();
    let mut last = i64::MAX;
    for steps in 1..=STEPS {
        let step = step(problem, &root)?;
        let relative =
            root.iter().zip(&step).map(|(x, s)| s.exponent().saturating_sub(x.exponent()));
        let size = relative.max().unwrap_or(i64::MIN);
        for (x, s) in root.iter_mut().zip(step) {
            *x = x.clone() - s;
        }
        let settled = size <= 1 - i64::from(bits);
        let stuck = size >= last && size < -i64::from(bits) / 2;
        if settled || stuck {
            return Some(Newton { root, steps });
        }
        last = size;
    }
    None
}

/// The Newton step, by elimination with the largest pivot.
pub fn step<T: Approximate>(problem: &Task, x: &[T]) -> Option<Vec<T>> {
    let n = x.len();
    let residuals = problem.residuals(x);
    let mut rows: Vec<Vec<T>> = residuals
        .iter()
        .map(|r| (0..n).map(|k| r.derivative(k)).chain([r.value().clone()]).collect())
        .collect();
    for column in 0..n {
        let pivot = (column..n).max_by_key(|&row| rows[row][column].exponent())?;
        rows.swap(column, pivot);
        let head = rows[column].clone();
        if head[column].exponent() == i64::MIN {
            return None;
        }
        for (_, entries) in rows.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = entries[column].clone() / &head[column];
            for (entry, above) in entries.iter_mut().zip(&head).skip(column) {
                *entry = entry.clone() - factor.clone() * above;
            }
        }
    }
    (0..n).map(|i| Some(rows[i][n].clone() / &rows[i][i])).collect()
}

/// Newton's method in MPFR, the precision doubled with each step from a start in doubles.
pub fn doubling(problem: &Task, start: &[f64], bits: u32) -> Option<Newton<Float>> {
    let first = 64.min(bits);
    let start: Vec<Float> = start.iter().map(|x| Float::with_val(first, x)).collect();
    let mut found = newton(problem, &start, first)?;
    let mut precision = first;
    // Ten bits are lost to the condition of the system; the last step is at full precision.
    while precision < bits {
        precision = (2 * precision - 20).min(bits);
        let x: Vec<Float> = found.root.iter().map(|x| Float::with_val(precision, x)).collect();
        let step = step(problem, &x)?;
        found.root = x.into_iter().zip(step).map(|(x, s)| x - s).collect();
        found.steps += 1;
    }
    Some(found)
}
