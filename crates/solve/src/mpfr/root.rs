//! A root of a system to any number of bits: as much of the way as doubles go, and the rest in MPFR.

use crate::arch::Configuration;
use crate::linear::newton_step;
use crate::newton::{SLACK, settle};
use crate::problem::System;
use rug::Float;

/// Approximate values of the unknowns of a system, in its order. Nothing is known of their error.
#[derive(Clone, Debug)]
pub struct Candidate(pub Vec<Float>);

/// From four digits three steps are enough for doubles.
const STEPS_IN_DOUBLES: usize = 10;
/// After a step of this part of a variable the next would be rounding.
const SHORT_IN_DOUBLES: f64 = 1e-7;

/// A candidate root of `system`, whose unknowns are positive, to `bits` bits.
///
/// It is assumed that `start` has a value for each unknown, in the order of the system, near a simple root.
/// Nothing is guaranteed: from elsewhere the answer may be another root. `None` if the iteration does not
/// settle as [`settle`] has it.
pub fn newton(system: &System, start: &[f64], bits: u32) -> Option<Candidate> {
    let prec = bits + 4 * SLACK as u32;
    let start = in_doubles(system, start).unwrap_or_else(|| start.to_vec());
    let start = start.into_iter().map(|v| Float::with_val(prec, v)).collect();
    let given = Configuration::zero(&Float::new(prec));
    let at = |x: &[Float]| system.variables(&system.place(given.clone(), x));
    let root = settle(start, |x| system.residuals(&at(x)))?;
    Some(Candidate(root.iter().map(|x| Float::with_val(bits, x)).collect()))
}

/// Newton's steps in doubles: as much of the way as doubles go, which cost nothing beside MPFR; `None` where
/// they lose it.
fn in_doubles(system: &System, start: &[f64]) -> Option<Vec<f64>> {
    let mut x = start.to_vec();
    for _ in 0..STEPS_IN_DOUBLES {
        let at = system.variables(&system.place(Configuration::zero(&0.0), &x));
        let steps = newton_step(&system.residuals(&at))?;
        let parts: Vec<f64> = steps.iter().zip(&x).map(|(step, x)| (step / x).abs()).collect();
        // A step of half a variable would lead elsewhere, or nowhere.
        if !parts.iter().all(|part| *part < 0.5) {
            return None;
        }
        x.iter_mut().zip(steps).for_each(|(x, step)| *x -= step);
        if parts.iter().all(|part| *part < SHORT_IN_DOUBLES) {
            return Some(x);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Doubles do most of the way, and a start from which they lose it is left as it was.
    #[test]
    fn doubles_come_near_the_root_or_say_nothing() {
        use crate::arch::SelfWeight::Heyman;
        use crate::problem::Landmark::OverturningEnd;
        let system = OverturningEnd.system(Heyman);
        let root = newton(&system, &[2.786], 200).unwrap().0[0].to_f64();
        let near = in_doubles(&system, &[2.786]).unwrap()[0];
        approx::assert_relative_eq!(near, root, max_relative = 1e-14);
        assert!(
            in_doubles(&system, &[1e-3]).is_none() && in_doubles(&system, &[f64::NAN]).is_none()
        );
    }
}
