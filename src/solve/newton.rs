//! Newton's method in MPFR arithmetic, with the Jacobian from dual numbers.

use super::{Candidate, inverse};
use crate::arch::{Point, System};
use rug::Float;

/// Steps that are always enough when the start value has a few good digits: the digits double.
const STEPS: usize = 40;

/// A candidate root of `system` to about `bits` bits, from a start value nearby. `None` if the
/// iteration leaves the numbers or does not settle.
pub fn newton(system: &System, start: &[f64], bits: u32) -> Option<Candidate> {
    let mut x: Vec<Float> = start.iter().map(|v| Float::with_val(bits, v)).collect();
    for _ in 0..STEPS {
        let residuals = system.residuals(&Point::new(system, &x).variables());
        let jacobian =
            residuals.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect();
        let inverse = inverse(jacobian)?;
        let mut settled = true;
        for (x, row) in x.iter_mut().zip(&inverse) {
            let step = row
                .iter()
                .zip(&residuals)
                .fold(Float::new(bits), |sum, (y, r)| sum + y.clone() * r.value());
            settled &= is_small(&step, x, bits);
            *x -= step;
            if !x.is_finite() {
                return None;
            }
        }
        if settled {
            return Some(Candidate(x));
        }
    }
    None
}

/// Whether a step has come down to half the bits of `x`, so that it was the last one needed.
fn is_small(step: &Float, x: &Float, bits: u32) -> bool {
    match (step.get_exp(), x.get_exp()) {
        (None, _) => true,
        (Some(step), Some(x)) => step < x - bits as i32 / 2 - 4,
        _ => false,
    }
}
