//! What is measured of one method on one case.

use super::enclosure::Errors;
use crate::problem::tally::processor_time;
use serde::Serialize;
use std::time::{Duration, Instant};

/// One measurement. Empty where a column does not apply.
#[derive(Clone, Debug, Default, Serialize)]
#[non_exhaustive]
pub struct Row {
    /// The kind of quantity: `eta-cubic`, `landmark`, `state`, …
    pub quantity: String,
    /// Which of them: a joint and a branch, a landmark, a mode.
    pub case: String,
    /// How it was computed.
    pub method: String,
    /// The bits the method was given.
    pub precision_bits: Option<u32>,
    /// Threads.
    pub threads: usize,
    /// Median CPU time of warm repeats, s.
    pub cpu_seconds: f64,
    /// CPU time of the first call, s.
    pub first_seconds: f64,
    /// Median wall time of warm repeats, s.
    pub wall_seconds: f64,
    /// `log10` of the largest absolute error of an unknown.
    pub error_absolute_log10: Option<f64>,
    /// `log10` of the largest relative error.
    pub error_relative_log10: Option<f64>,
    /// The largest error in units of the last place.
    pub error_units: Option<f64>,
    /// `log10` of the largest relative error that the method itself claims, if it does.
    pub claimed_relative_log10: Option<f64>,
    /// Decimal digits that the method proves.
    pub certified_digits: Option<f64>,
    /// Decimal digits of the precision that are lost.
    pub digits_lost: Option<f64>,
    /// The bits that the method needed to work in.
    pub working_bits: Option<u32>,
    /// Evaluations of single equations, each with its slopes; those of (7) and (12) by balls are not
    /// counted.
    pub evaluations: Option<usize>,
    /// Newton steps.
    pub newton_steps: Option<usize>,
    /// Largest resident memory of the process so far, kB.
    pub peak_memory_kb: Option<u64>,
    /// `proved`, `computed`, or why there is no value.
    pub verdict: String,
}

/// A value with what it took.
pub struct Timed<T> {
    /// The value of the last call.
    pub value: T,
    /// CPU time of the first call.
    pub first: Duration,
    /// Median CPU time of the repeats.
    pub cpu: Duration,
    /// Median wall time of the repeats.
    pub wall: Duration,
}

/// Calls once cold, then so often that `budget` is about used up (at least three times, unless one call
/// takes longer than that).
pub fn timed<T>(budget: Duration, job: impl Fn() -> T) -> Timed<T> {
    let once = || {
        let (cpu, wall) = (processor_time(), Instant::now());
        let value = std::hint::black_box(job());
        (value, processor_time().saturating_sub(cpu), wall.elapsed())
    };
    let (mut value, first, elapsed) = once();
    let repeats = match elapsed.as_nanos() {
        0 => 25,
        one => (budget.as_nanos() / one).clamp(1, 25) as usize,
    };
    let (mut cpus, mut walls) = (Vec::new(), Vec::new());
    for _ in 0..repeats {
        let (again, cpu, wall) = once();
        value = again;
        cpus.push(cpu);
        walls.push(wall);
    }
    Timed { value, first, cpu: median(cpus), wall: median(walls) }
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}

/// The largest resident memory of the process, where Linux tells.
pub fn peak_memory_kb() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

impl Row {
    /// The row with the times of a measurement.
    pub fn with_times<T>(mut self, timed: &Timed<T>) -> Self {
        self.threads = 1;
        self.cpu_seconds = timed.cpu.as_secs_f64();
        self.first_seconds = timed.first.as_secs_f64();
        self.wall_seconds = timed.wall.as_secs_f64();
        self.peak_memory_kb = peak_memory_kb();
        self
    }

    /// The row with the worst of several errors, for values of `bits` bits.
    pub fn with_errors(mut self, errors: &[Errors], bits: u32) -> Self {
        let worst = |f: fn(&Errors) -> f64| errors.iter().map(f).fold(f64::NEG_INFINITY, f64::max);
        let relative = worst(|e| e.relative);
        self.error_absolute_log10 = Some(worst(|e| e.absolute));
        self.error_relative_log10 = Some(relative);
        self.error_units = Some(worst(|e| e.units));
        let digits = f64::from(bits) * std::f64::consts::LOG10_2;
        self.digits_lost = Some((digits + relative).clamp(0.0, digits));
        self
    }
}
