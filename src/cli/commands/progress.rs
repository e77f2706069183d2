//! Progress bars on standard error, hidden if it is not a terminal.

use crate::report::words::count;
use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Digits in all from which the work takes about a second.
const LONG: usize = 200_000;

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

/// A bar of `ticks` ticks for a number of digits in all; it shows nothing for short work.
pub(super) fn bar(ticks: u64, digits: usize) -> ProgressBar {
    if digits < LONG {
        return ProgressBar::hidden();
    }
    styled(Some(ticks), "{spinner} {bar:40} {percent:>3}%  {elapsed} elapsed, about {eta} left")
}
