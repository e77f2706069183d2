//! Digits lost where the problem is hard: ladders of distances towards each limit.
//!
//! The [condition number](super::condition) of a problem says how many digits of the result the input
//! decides. What a method loses beyond it, the method has lost.

use super::closed::{ClosedForm, RootBranch, printed, trigonometric};
use super::double_double;
use super::enclosure::{error, relative_radius};
use super::limits::StudyLimit;
use super::newton::{Newton, doubling, in_double_doubles, in_doubles};
use super::row::{digits_lost, timed};
use super::target::{LimitTarget, WEIGHT, factored};
use crate::arch::overturning;
use crate::number::{Angle, Ball};
use crate::problem::Mode;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};
use serde::Serialize;
use std::time::Duration;

/// One method on one rung.
#[derive(Clone, Debug, Default, Serialize)]
#[non_exhaustive]
pub struct Rung {
    /// Limit that is approached.
    pub limit: &'static str,
    /// Value that is computed.
    pub output: &'static str,
    /// `log10` of the distance from the limit.
    pub distance_log10: i32,
    /// Method of its computation.
    pub method: &'static str,
    /// The bits that the method was given, or needed.
    pub working_bits: u32,
    /// `log10` of the condition number.
    pub condition_log10: f64,
    /// `log10` of the relative error.
    pub error_relative_log10: Option<f64>,
    /// Decimal digits lost: those of the precision beyond the error. For a certified result those of the
    /// working precision beyond what is proved.
    pub digits_lost: Option<f64>,
    /// Median CPU time, s.
    pub cpu_seconds: f64,
    /// `proved`, `computed`, or why there is no value.
    pub verdict: &'static str,
}

/// Digits that a certified result is asked for.
const DIGITS: f64 = 16.0;
/// The largest working precision that is tried.
const MOST_BITS: u32 = 1 << 14;

fn tenth_to(k: u32) -> Rational {
    Rational::from((Integer::from(1), Integer::from(10).pow(k)))
}

/// All methods on one rung.
pub fn climb(limit: &StudyLimit, k: u32, budget: Duration) -> Vec<Rung> {
    let rung = |method, working_bits| Rung {
        limit: limit.name,
        output: limit.output,
        distance_log10: -(k as i32),
        method,
        working_bits,
        ..Rung::default()
    };
    let nothing = |verdict| vec![Rung { verdict, ..rung("certified", 0) }];
    let Some(target) = (limit.at)(&tenth_to(k)) else { return nothing("no problem") };
    // The reference: many more bits than any method is given.
    let high = 2048 + 48 * k;
    let Some(truth) = target.enclosure(high) else { return nothing("no reference") };
    let Some(condition_log10) = target.condition(high) else { return nothing("no condition") };
    let rung = |method, bits| Rung { condition_log10, ..rung(method, bits) };
    let mut rungs = Vec::new();
    let mut add = |method, bits, job: &dyn Fn() -> Option<Float>| {
        rungs.push(computed(job, &truth, rung(method, bits), budget));
    };
    let double = |x: f64| Some(Float::with_val(53, x));
    if let LimitTarget::Closed { joint } = &target {
        let joint = joint.to_f64();
        add("closed form, double", 53, &|| {
            double(printed(ClosedForm::Thickness, RootBranch::Upper, joint))
        });
        add("trigonometric form, double", 53, &|| {
            double(trigonometric(ClosedForm::Thickness, RootBranch::Upper, &Angle::new(joint)))
        });
    }
    if let LimitTarget::Overturning { distance } = &target {
        let x = distance.to_f64();
        let a = 2.0 / 3.0 + x;
        add("(15) as printed, double", 53, &|| double(overturning::thickness(WEIGHT, &a)));
        add("(15) from A - 2/3, double", 53, &|| double(factored(&x)));
        let a = Float::with_val(256, Rational::from((2, 3)) + distance);
        add("(15) as printed, 256 bits", 256, &|| Some(overturning::thickness(WEIGHT, &a)));
    }
    if let Some(problem) = target.problem() {
        let index = target.index();
        let start: Option<Vec<f64>> =
            target.start(512).map(|start| start.iter().map(Float::to_f64).collect());
        if let Some(start) = start.filter(|x| x.iter().all(|x| x.is_normal())) {
            let output = |found: Option<Newton<Float>>| Some(found?.root.swap_remove(index));
            add("equations, Newton, double", 53, &|| output(in_doubles(&problem, &start)));
            add("equations, Newton, double-double", double_double::BITS, &|| {
                output(in_double_doubles(&problem, &start))
            });
            add("equations, Newton, 256 bits", 256, &|| output(doubling(&problem, &start, 256)));
        }
        if limit.is_small {
            add("scaled equations, 53 bits", 53, &|| target.scaled(53));
        }
        if matches!(target, LimitTarget::State { mode: Mode::Rotational, .. }) {
            add("start value, double", 53, &|| Some(target.start(53)?.swap_remove(index)));
        }
    }
    rungs.push(certified(&target, &truth, rung("certified", 0), budget));
    rungs
}

/// Result of a method in the bits that it was given, with its error; without one if the method finds no value.
fn computed(job: &dyn Fn() -> Option<Float>, truth: &Ball, rung: Rung, budget: Duration) -> Rung {
    let timed = timed(budget, job);
    let found = Rung { cpu_seconds: timed.cpu[1].as_secs_f64(), verdict: "no value", ..rung };
    let Some(value) = timed.value.filter(|x| x.is_finite()) else { return found };
    let relative = error(&value, truth).relative;
    Rung {
        error_relative_log10: Some(relative),
        digits_lost: Some(digits_lost(found.working_bits, relative)),
        verdict: "computed",
        ..found
    }
}

/// The certified result: the working precision is doubled until sixteen digits are proved.
fn certified(target: &LimitTarget, truth: &Ball, rung: Rung, budget: Duration) -> Rung {
    let mut bits = 64;
    while bits <= MOST_BITS {
        let proved = target.enclosure(bits).filter(|ball| -relative_radius(ball) >= DIGITS);
        if let Some(ball) = proved {
            let timed = timed(budget, || target.enclosure(bits));
            let digits = f64::from(bits) * std::f64::consts::LOG10_2;
            return Rung {
                working_bits: bits,
                error_relative_log10: Some(error(ball.mid(), truth).relative),
                digits_lost: Some((digits + relative_radius(&ball)).max(0.0)),
                cpu_seconds: timed.cpu[1].as_secs_f64(),
                verdict: "proved",
                ..rung
            };
        }
        // Steps of a quarter: the precision that is needed shows.
        bits += (bits / 4).next_multiple_of(32);
    }
    Rung { verdict: "undecided", ..rung }
}

/// The rungs that are climbed: powers of a tenth.
pub const FULL: [u32; 13] = [1, 2, 3, 4, 6, 8, 12, 16, 20, 30, 40, 50, 60];
/// Distances for a quick look.
pub const QUICK: [u32; 5] = [1, 3, 8, 20, 60];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::LIMITS;

    /// The certified path proves every rung, and its error is what it claims.
    #[test]
    fn every_rung_is_proved() {
        for limit in &LIMITS {
            for k in [1, 12, 60] {
                let rungs = climb(limit, k, Duration::ZERO);
                let certified = rungs.last().unwrap();
                assert_eq!(certified.verdict, "proved", "{} 1e-{k}: {certified:?}", limit.name);
                assert!(certified.error_relative_log10.unwrap() <= -DIGITS);
            }
        }
    }
}
