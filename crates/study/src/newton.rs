//! Newton's method over any approximate number: what a careful user would write.

use super::{Task, double_double};
use crate::number::Real;
use crate::solve::{Approximate, newton_step};
use rug::Float;

/// Steps after which the iteration is given up.
const STEPS: usize = 100;

/// End of the iteration, and number of its steps.
pub struct Newton<T> {
    /// The last iterate.
    pub root: Vec<T>,
    /// Steps, each with one evaluation of the residuals and their slopes; none of a closed form.
    pub steps: usize,
}

/// Newton's method at the precision of the start, until a step is of the size of the rounding (`bits`)
/// or no longer gets smaller. `None` if it breaks down.
pub fn newton<T: Approximate + Real>(problem: &Task, start: &[T], bits: u32) -> Option<Newton<T>> {
    let mut root = start.to_vec();
    let mut last = i64::MAX;
    for steps in 1..=STEPS {
        let step = newton_step(&problem.residuals(&root))?;
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

/// Newton's method in doubles.
pub fn in_doubles(problem: &Task, start: &[f64]) -> Option<Newton<Float>> {
    let Newton { root, steps } = newton(problem, start, 53)?;
    Some(Newton { root: root.iter().map(|x| Float::with_val(53, x)).collect(), steps })
}

/// Newton's method in double-doubles.
pub fn in_double_doubles(problem: &Task, start: &[f64]) -> Option<Newton<Float>> {
    let start: Vec<double_double::Unproved> = start.iter().map(|&x| x.into()).collect();
    let Newton { root, steps } = newton(problem, &start, double_double::BITS)?;
    Some(Newton { root: root.iter().map(double_double::to_float).collect(), steps })
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
        let step = newton_step(&problem.residuals(&x))?;
        found.root = x.into_iter().zip(step).map(|(x, s)| x - s).collect();
        found.steps += 1;
    }
    Some(found)
}
