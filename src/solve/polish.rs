//! Newton's method for the unknowns of a mode at a given arch, from a rough start.

use super::inverse;
use crate::arch::{Configuration, Equation, SelfWeight, Unknown};
use crate::number::Dual;
use rug::Float;

/// Beside a limit where two roots meet Newton's method halves the distance before it squares it.
const STEPS: usize = 200;

/// A candidate for the `unknowns` that satisfy the `equations`, everything else as in `given`. `None`
/// if the iteration leaves the positive numbers or does not settle.
pub fn polish(
    weight: SelfWeight,
    (unknowns, equations): (&[Unknown], &[Equation]),
    given: &Configuration<Float>,
    start: &[Float],
) -> Option<Vec<Float>> {
    let given = given.clone().map(Dual::constant);
    let mut x = start.to_vec();
    for _ in 0..STEPS {
        let at = unknowns
            .iter()
            .zip(&x)
            .enumerate()
            .fold(given.clone(), |at, (index, (&unknown, x))| {
                at.with(unknown, Dual::variable(x.clone(), index))
            });
        let residuals: Vec<_> = equations.iter().map(|e| e.residual(weight, &at)).collect();
        let jacobian =
            residuals.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect();
        let inverse = inverse(jacobian)?;
        let mut settled = true;
        for (x, row) in x.iter_mut().zip(&inverse) {
            let zero = Float::new(x.prec());
            let step =
                row.iter().zip(&residuals).fold(zero, |sum, (y, r)| sum + y.clone() * r.value());
            // A variable never crosses zero: a longer step stops half-way there.
            let next = Float::with_val(x.prec(), &*x - &step);
            if next > 0 {
                settled &= is_last(&step, x);
                *x = next;
            } else {
                settled = false;
                *x /= 2;
            }
            if !x.is_finite() || x.is_zero() {
                return None;
            }
        }
        if settled {
            return Some(x);
        }
    }
    None
}

/// Whether a step is so short that what it leaves, about its square, is as good as nothing.
fn is_last(step: &Float, x: &Float) -> bool {
    match (step.get_exp(), x.get_exp()) {
        (None, _) => true,
        (Some(step), Some(size)) => i64::from(step) < i64::from(size) - i64::from(x.prec()) / 2 + 6,
        _ => false,
    }
}
