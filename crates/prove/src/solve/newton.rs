//! Newton's method in MPFR arithmetic, with the Jacobian from dual numbers.

use super::Candidate;
use super::linear::newton_step;
use crate::arch::Configuration;
use crate::number::Dual;
use crate::problem::{System, tally};
use rug::Float;

/// Beside a limit where two roots meet Newton's method halves the distance before it squares it.
const STEPS: usize = 200;
/// Bits by which the last step may be longer than half the precision; the result has twice as many
/// fewer than it holds.
const SLACK: i64 = 6;
/// From four digits three steps are enough for doubles.
const STEPS_IN_DOUBLES: usize = 10;
/// After a step of this part of a variable the next would be rounding.
const SHORT_IN_DOUBLES: f64 = 1e-7;
/// Steps shorter than this part of their variables, in bits, are short.
const SHORT: i64 = -24;

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

/// Newton's method for positive unknowns, at the precision of the start.
///
/// It is assumed that `residuals` has as many entries as there are unknowns, with the derivatives to them, and
/// that a simple root is near. The method settles when a step is so short that what it leaves, about its
/// square, is as good as nothing, or when short steps no longer get shorter: then they are the rounding of an
/// ill-conditioned system, and whether the digits are enough is for the proof to say. The unknowns stay
/// positive. `None` if the Jacobian is singular, the numbers overflow or nothing settles in 200 steps.
///
/// Not guaranteed: that there is a root next to the answer, or that it is the root nearest to the start.
pub fn settle(
    mut x: Vec<Float>,
    residuals: impl Fn(&[Float]) -> Vec<Dual<Float>>,
) -> Option<Vec<Float>> {
    let mut last = i64::MAX;
    for _ in 0..STEPS {
        tally::newton_step();
        let steps = newton_step(&residuals(&x))?;
        let (mut settled, mut longest) = (true, i64::MIN);
        for (x, step) in x.iter_mut().zip(steps) {
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

/// Tells whether a step is so short that what it leaves, about its square, is as good as nothing.
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

    #[test]
    fn where_there_is_no_root_none_is_claimed() {
        assert!(one(1.0, |x| x.square() + x.int(1)).is_none());
    }
}
