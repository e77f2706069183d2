//! Progress on standard error: bars, hidden if it is not a terminal, and how long work takes if that is long.

use super::memory;
use crate::arch::SelfWeight;
use crate::certify::CertifiedLandmark;
use crate::cli::line::{is_heard, say};
use crate::number::bits_of;
use crate::problem::Landmark;
use crate::report::words::count;
use crate::sweep::failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Digits in all from which the work takes about a second.
const LONG: usize = 200_000;
/// Seconds from which it is said how long work takes.
const WORTH_WORDS: f64 = 5.0;
/// Digits of the landmark by which this machine is measured, and the power of the digits with which time grows.
const MEASURED: (usize, f64) = (10_000, 1.35);

/// A bar of rows, with rate and time left.
pub(super) const ROWS: &str =
    "{spinner} {bar:40} {percent:>3}%  {msg}, {elapsed} elapsed, about {eta} left";

/// Shows how many rows are done, and at what rate.
pub(super) fn show_rows(bar: &ProgressBar, rows: u64) {
    let rate = rows as f64 / bar.elapsed().as_secs_f64().max(1e-3);
    bar.set_message(format!("{}, {rate:.0} rows/s", count(rows, "row", "rows")));
}

/// A bar in a style; without a length it only turns.
pub(super) fn styled(length: Option<u64>, style: &str) -> ProgressBar {
    let bar = length.map_or_else(ProgressBar::new_spinner, ProgressBar::new);
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// A bar of `ticks` ticks for constants of so many digits; it shows nothing for short work. Refused where there is not
/// enough memory.
pub(super) fn bar(ticks: u64, sizes: &[usize]) -> Result<ProgressBar, Failure> {
    if sizes.iter().sum::<usize>() < LONG {
        return Ok(ProgressBar::hidden());
    }
    tell(sizes, 1.0)?;
    let style = "{spinner} {bar:40} {percent:>3}%  {elapsed} elapsed, about {eta} left";
    Ok(styled(Some(ticks), style))
}

/// Tells how long it takes, if that is long, to refine landmarks to so many digits and to do so many times as much.
/// Refused where there is not enough memory.
pub(super) fn tell(sizes: &[usize], times: f64) -> Result<(), Failure> {
    let digits: usize = sizes.iter().sum();
    if digits < LONG {
        return Ok(());
    }
    memory::has_room(sizes)?;
    let start = Instant::now();
    let (few, power) = MEASURED;
    let measured = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman)
        .and_then(|landmark| landmark.enclosure(bits_of(few)));
    let one = start.elapsed().as_secs_f64() * times;
    let seconds = |size: &usize| one * (*size as f64 / few as f64).powf(power);
    let longest = sizes.iter().map(seconds).fold(0.0, f64::max);
    let all = sizes.iter().map(seconds).sum::<f64>() / rayon::current_num_threads() as f64;
    let seconds = f64::max(longest, all);
    if measured.is_ok() && seconds > WORTH_WORDS {
        say(&format!("couplet: {digits} digits in all take about {seconds:.0} s"));
    }
    Ok(())
}

/// Does work, and says on a terminal that it takes long if it does.
pub(super) fn told<T>(what: &'static str, work: impl FnOnce() -> T) -> T {
    if is_heard() {
        return work();
    }
    let (_working, over) = channel::<()>();
    let wait = move || {
        let patience = Duration::from_secs_f64(WORTH_WORDS);
        let takes_long = over.recv_timeout(patience) == Err(RecvTimeoutError::Timeout);
        if takes_long && io::stderr().is_terminal() {
            say(&format!("couplet: {what} takes more than {WORTH_WORDS} s"));
        }
    };
    // Where no thread can start nothing is said.
    let _ = thread::Builder::new().spawn(wait);
    work()
}
