//! Newton's method in MPFR arithmetic, with the Jacobian from dual numbers.

use super::{Candidate, inverse};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::Dual;
use crate::problem::{Equation, Point, System, tally};
use rug::Float;

/// Beside a limit where two roots meet Newton's method halves the distance before it squares it.
const STEPS: usize = 200;
/// Bits by which the last step may be longer than half the precision; the result has twice as many
/// fewer than it holds.
const SLACK: i64 = 6;
/// Steps shorter than this part of their variables, in bits, are short.
const SHORT: i64 = -24;

/// A candidate root of `system` to `bits` bits, from a start value nearby. `None` if the iteration
/// does not settle on positive numbers.
pub fn newton(system: &System, start: &[f64], bits: u32) -> Option<Candidate> {
    let prec = bits + 4 * SLACK as u32;
    let start = start.iter().map(|v| Float::with_val(prec, v)).collect();
    let root = settle(start, |x| system.residuals(&Point::new(system, x).variables()))?;
    Some(Candidate(root.iter().map(|x| Float::with_val(bits, x)).collect()))
}

/// A candidate for the `unknowns` that satisfy the `equations`, everything else as in `given`.
pub fn polish(
    weight: SelfWeight,
    (unknowns, equations): (&[Unknown], &[Equation]),
    given: &Configuration<Float>,
    start: &[Float],
) -> Option<Vec<Float>> {
    let given = given.clone().map(Dual::constant);
    settle(start.to_vec(), |x| {
        let variables = unknowns.iter().zip(x).enumerate();
        let at = variables.fold(given.clone(), |at, (index, (&unknown, x))| {
            at.with(unknown, Dual::variable(x.clone(), index))
        });
        equations.iter().map(|equation| equation.residual(weight, &at)).collect()
    })
}

/// Newton's method for positive unknowns. `None` if it leaves the numbers or does not settle.
///
/// It settles when the steps are short, or when short steps no longer get shorter: then they are the
/// rounding of an ill-conditioned system, and whether the digits are enough is for the proof to say.
pub fn settle(
    mut x: Vec<Float>,
    residuals: impl Fn(&[Float]) -> Vec<Dual<Float>>,
) -> Option<Vec<Float>> {
    let mut last = i64::MAX;
    for _ in 0..STEPS {
        tally::newton_step();
        let residuals = residuals(&x);
        let jacobian =
            residuals.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect();
        let inverse = inverse(jacobian)?;
        let (mut settled, mut longest) = (true, i64::MIN);
        for (x, row) in x.iter_mut().zip(&inverse) {
            let zero = Float::new(x.prec());
            let step =
                row.iter().zip(&residuals).fold(zero, |sum, (y, r)| sum + y.clone() * r.value());
            // A variable never crosses zero: a longer step stops half-way there.
            let next = Float::with_val(x.prec(), &*x - &step);
            if next > 0 {
                settled &= is_last(&step, x);
                longest = longest.max(relative_exponent(&step, x));
                *x = next;
            } else {
                (settled, longest) = (false, i64::MAX);
                *x /= 2;
            }
            if !x.is_finite() || x.is_zero() {
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
fn relative_exponent(step: &Float, x: &Float) -> i64 {
    match (step.get_exp(), x.get_exp()) {
        (Some(step), Some(size)) => i64::from(step) - i64::from(size),
        (None, _) => i64::MIN,
        _ => i64::MAX,
    }
}

/// Whether a step is so short that what it leaves, about its square, is as good as nothing.
fn is_last(step: &Float, x: &Float) -> bool {
    relative_exponent(step, x) < SLACK - i64::from(x.prec()) / 2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;

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
