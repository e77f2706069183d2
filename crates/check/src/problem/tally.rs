//! Counters of evaluations, for each thread: what a result cost.
//!
//! An evaluation is counted where an equation is used, not in the equation, which stays a formula. What
//! runs on other threads is not seen; the proofs evaluate their equations on the thread that asks.

use super::Equation;
use std::cell::Cell;
use std::ops::AddAssign;

/// Number of evaluations of each equation. Counts only: nothing of it is a result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    equations: [u64; Equation::ALL.len()],
    /// Conditions of admissibility and of least thickness whose sign was looked at.
    pub conditions: u64,
    /// Landmarks that were consulted.
    pub landmarks: u64,
    /// Steps of Newton's method, of any length.
    pub newton_steps: u64,
    /// The largest working precision, in bits.
    pub working_bits: u32,
}

impl Tally {
    /// Number of times that an equation was evaluated, whatever the number type and the precision.
    pub fn of(&self, equation: Equation) -> u64 {
        self.equations[equation as usize]
    }

    /// Evaluations of all equations.
    pub fn evaluations(&self) -> u64 {
        self.equations.iter().sum()
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        for (count, more) in self.equations.iter_mut().zip(other.equations) {
            *count += more;
        }
        self.conditions += other.conditions;
        self.landmarks += other.landmarks;
        self.newton_steps += other.newton_steps;
        self.working_bits = self.working_bits.max(other.working_bits);
    }
}

thread_local! {
    static CURRENT: Cell<Tally> = Cell::default();
}

/// The result of a job and what this thread evaluated for it. Jobs may be nested: the outer one counts
/// what the inner one does.
///
/// ```
/// use couplet_check::arch::{Configuration, SelfWeight};
/// use couplet_check::problem::{Equation, System, tally};
/// let at = Configuration::zero(&0.0);
/// let (_, tally) = tally::measure(|| System::inner_sliding(SelfWeight::Heyman).residuals(&at));
/// assert_eq!((tally.of(Equation::Steepest), tally.evaluations()), (1, 2));
/// ```
pub fn measure<T>(job: impl FnOnce() -> T) -> (T, Tally) {
    let before = CURRENT.take();
    let result = job();
    let during = CURRENT.get();
    change(|tally| *tally += before);
    (result, during)
}

fn change(count: impl FnOnce(&mut Tally)) {
    CURRENT.with(|current| {
        let mut tally = current.get();
        count(&mut tally);
        current.set(tally);
    });
}

/// Counts an evaluation of an equation.
pub fn equation(equation: Equation) {
    change(|tally| tally.equations[equation as usize] += 1);
}

/// Counts a condition whose sign is looked at.
pub fn condition() {
    change(|tally| tally.conditions += 1);
}

/// Counts a landmark that is consulted.
pub fn landmark() {
    change(|tally| tally.landmarks += 1);
}

/// Counts a step of Newton's method.
pub fn newton_step() {
    change(|tally| tally.newton_steps += 1);
}

/// Notes a working precision.
pub fn working_bits(bits: u32) {
    change(|tally| tally.working_bits = tally.working_bits.max(bits));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outer_job_counts_what_an_inner_one_does_and_forgets_nothing() {
        let ((inner, after), outer) = measure(|| {
            equation(Equation::Tangency);
            let ((), inner) = measure(|| equation(Equation::Tangency));
            (0..3).for_each(|_| condition());
            (inner, measure(|| ()).1)
        });
        assert_eq!((inner.of(Equation::Tangency), inner.conditions), (1, 0));
        assert_eq!((outer.of(Equation::Tangency), outer.conditions), (2, 3));
        assert_eq!(after, Tally::default());
    }
}
