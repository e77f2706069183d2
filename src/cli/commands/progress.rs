//! Progress bars on standard error, hidden if it is not a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Digits in all from which the work takes about a second.
const LONG: usize = 200_000;

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
