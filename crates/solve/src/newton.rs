//! Newton's method, with the Jacobian from dual numbers, at the precision of its numbers.

use super::linear::{Approximate, newton_step};
use crate::number::Dual;
use crate::problem::tally;

/// Beside a limit where two roots meet Newton's method halves the distance before it squares it.
const STEPS: usize = 200;
/// Bits by which the last step may be longer than half the precision; the result has twice as many
/// fewer than it holds.
pub(super) const SLACK: i64 = 6;
/// Steps shorter than this part of their variables, in bits, are short.
const SHORT: i64 = -24;

/// Newton's method for positive unknowns, at the precision of the start.
///
/// It is assumed that `residuals` has as many entries as there are unknowns, with the derivatives to them, and
/// that a simple root is near. The method settles when a step is so short that what it leaves, about its
/// square, is as good as nothing, or when short steps no longer get shorter: then they are the rounding of an
/// ill-conditioned system, and whether the digits are enough is for the proof to say. The unknowns stay
/// positive. `None` if the Jacobian is singular, the numbers overflow or nothing settles in 200 steps.
///
/// Not guaranteed: that there is a root next to the answer, or that it is the root nearest to the start.
pub fn settle<T: Approximate>(
    mut x: Vec<T>,
    residuals: impl Fn(&[T]) -> Vec<Dual<T>>,
) -> Option<Vec<T>> {
    let mut last = i64::MAX;
    for _ in 0..STEPS {
        tally::newton_step();
        let steps = newton_step(&residuals(&x))?;
        let (mut settled, mut longest) = (true, i64::MIN);
        for (x, step) in x.iter_mut().zip(steps) {
            // A variable never crosses zero: a longer step stops half-way there.
            let next = x.clone() - &step;
            if next > x.int(0) {
                settled &= is_last(&step, x);
                longest = longest.max(relative_exponent(&step, x));
                *x = next;
            } else {
                (settled, longest) = (false, i64::MAX);
                *x = x.ratio(1, 2) * &*x;
            }
            if x.exponent() == i64::MIN {
                return None;
            }
        }
        if settled || (longest < SHORT && longest >= last) {
            return Some(x);
        }
        last = longest;
    }
    None
}

/// The size of a step beside its variable, in bits.
fn relative_exponent<T: Approximate>(step: &T, x: &T) -> i64 {
    match (step.exponent(), x.exponent()) {
        (i64::MIN, _) => i64::MIN,
        (_, i64::MIN) => i64::MAX,
        (step, size) => step - size,
    }
}

/// Tells whether a step is so short that what it leaves, about its square, is as good as nothing.
fn is_last<T: Approximate>(step: &T, x: &T) -> bool {
    relative_exponent(step, x) < SLACK - i64::from(x.bits()) / 2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;
    use rug::Float;

    fn one(start: f64, residual: impl Fn(Dual<Float>) -> Dual<Float>) -> Option<Float> {
        let start = vec![Float::with_val(200, start)];
        settle(start, |x| vec![residual(Dual::variable(x[0].clone(), 0))]).map(|x| x[0].clone())
    }

    #[test]
    fn a_root_is_found_to_nearly_all_bits() {
        let root = one(1.0, |x| x.square() - x.int(2)).unwrap();
        let error = Float::with_val(200, root - Float::with_val(300, 2).sqrt()).abs();
        assert!(error < Float::with_val(200, 1) >> 180);
    }

    #[test]
    fn a_start_that_would_cross_zero_comes_back() {
        // From 10 the full step on 1/x = 2 leads far below zero.
        assert!(one(10.0, |x| x.int(1) / &x - x.int(2)).is_some());
    }

    #[test]
    fn where_there_is_no_root_none_is_claimed() {
        assert!(one(1.0, |x| x.square() + x.int(1)).is_none());
    }
}
