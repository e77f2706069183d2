//! Row of measurements: one method on one case.

use super::enclosure::ErrorSizes;
use crate::certify::processor_time;
use serde::Serialize;
use std::cmp::Ordering;
use std::time::{Duration, Instant};

/// One measurement. Empty where a column does not apply.
#[derive(Clone, Debug, Default, Serialize)]
#[non_exhaustive]
pub struct Measurement {
    /// The kind of quantity: `eta-cubic`, `landmark`, `state`, …
    pub quantity: String,
    /// Name of the case: a joint and a branch, a landmark, a mode.
    pub case: String,
    /// Method of its computation.
    pub method: String,
    /// The bits the method was given.
    pub precision_bits: Option<u32>,
    /// Threads.
    pub threads: usize,
    /// Median CPU time of warm repeats, s.
    pub cpu_seconds: f64,
    /// The quartile of these times below it, s.
    pub cpu_lower_seconds: f64,
    /// Upper end of the processor time, s.
    pub cpu_upper_seconds: f64,
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
    /// CPU time of the repeats: the lower quartile, the median, the upper quartile.
    pub cpu: [Duration; 3],
    /// Median wall time of the repeats.
    pub wall: Duration,
}

/// Shorter than this a clock does not tell: so long are calls put together.
const SHORTEST: Duration = Duration::from_micros(50);

/// Calls once cold, then so often that `budget` is about used up (at least once, and in 25 rounds at the most).
pub fn timed<T>(budget: Duration, job: impl Fn() -> T) -> Timed<T> {
    let round = |calls: u32| {
        let (cpu, wall) = (processor_time(), Instant::now());
        let mut value = std::hint::black_box(job());
        for _ in 1..calls {
            value = std::hint::black_box(job());
        }
        (value, processor_time().saturating_sub(cpu) / calls, wall.elapsed() / calls)
    };
    let (mut value, first, elapsed) = round(1);
    let one = elapsed.as_nanos().max(1);
    let calls = (SHORTEST.min(budget).as_nanos() / one).clamp(1, 1000) as u32;
    let rounds = (budget.as_nanos() / (one * u128::from(calls))).clamp(1, 25);
    let (mut cpus, mut walls) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let (again, cpu, wall) = round(calls);
        value = again;
        cpus.push(cpu);
        walls.push(wall);
    }
    let [_, wall, _] = quartiles(walls).unwrap_or_default();
    Timed { value, first, cpu: quartiles(cpus).unwrap_or_default(), wall }
}

/// The lower quartile, the median and the upper quartile of some numbers, or times; none of none.
pub fn quartiles<T: PartialOrd + Copy>(mut values: Vec<T>) -> Option<[T; 3]> {
    values.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
    let last = values.len().checked_sub(1)?;
    Some([last / 4, values.len() / 2, last - last / 4].map(|place| values[place]))
}

/// Decimal digits of a precision that a value with this `log10` of its relative error has lost.
pub fn digits_lost(bits: u32, relative: f64) -> f64 {
    let digits = f64::from(bits) * std::f64::consts::LOG10_2;
    (digits + relative).clamp(0.0, digits)
}

/// The largest resident memory of the process, where Linux tells.
pub fn peak_memory_kb() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

impl Measurement {
    /// The row with the times of a measurement.
    pub fn with_times<T>(mut self, timed: &Timed<T>) -> Self {
        self.threads = 1;
        let [lower, median, upper] = timed.cpu.map(|time| time.as_secs_f64());
        (self.cpu_lower_seconds, self.cpu_seconds, self.cpu_upper_seconds) = (lower, median, upper);
        self.first_seconds = timed.first.as_secs_f64();
        self.wall_seconds = timed.wall.as_secs_f64();
        self.peak_memory_kb = peak_memory_kb();
        self
    }

    /// The row with the times of the first call, of what keeps parts of its proofs for the next.
    pub fn of_the_first_call(mut self) -> Self {
        let first = self.first_seconds;
        (self.cpu_lower_seconds, self.cpu_seconds, self.cpu_upper_seconds) = (first, first, first);
        self.wall_seconds = first;
        self
    }

    /// The row with the worst of several errors, for values of `bits` bits.
    pub fn with_errors(mut self, errors: &[ErrorSizes], bits: u32) -> Self {
        let worst =
            |f: fn(&ErrorSizes) -> f64| errors.iter().map(f).fold(f64::NEG_INFINITY, f64::max);
        let relative = worst(|e| e.relative);
        self.error_absolute_log10 = Some(worst(|e| e.absolute));
        self.error_relative_log10 = Some(relative);
        self.error_units = Some(worst(|e| e.units));
        self.digits_lost = Some(digits_lost(bits, relative));
        self
    }
}
