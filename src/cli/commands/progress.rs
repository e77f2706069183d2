//! A progress bar on standard error, for work that takes a second or more.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Digits in all from which the work takes about a second.
const LONG: usize = 200_000;

/// A bar of `ticks` ticks for a number of digits in all; it shows nothing for short work, or where
/// standard error is not a terminal.
pub fn bar(ticks: u64, digits: usize) -> ProgressBar {
    if digits < LONG {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(ticks);
    if let Ok(style) = ProgressStyle::with_template(
        "{spinner} {bar:40} {percent:>3}%  {elapsed} elapsed, about {eta} left",
    ) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
