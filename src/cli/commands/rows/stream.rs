//! Rows answered on all cores a chunk at a time, so that memory does not grow with the file.

use super::super::progress::styled;
use super::read::{Line, Source};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::io::Read;

/// Rows that are read, answered, and handed on before the next are read.
pub(crate) const CHUNK: usize = 2048;

/// Answers the rows on all cores and hands each chunk on in the order of the rows, until there are no
/// more or `take` says with `false` that it has enough. Answers how many rows were handed on.
pub(crate) fn in_order<T: Send, A: Send, E>(
    mut lines: impl Iterator<Item = Line<T>>,
    progress: &Progress,
    answer: impl Fn(Line<T>) -> A + Sync,
    mut take: impl FnMut(Vec<A>) -> Result<bool, E>,
) -> Result<u64, E> {
    let mut rows = 0;
    loop {
        let chunk: Vec<Line<T>> = lines.by_ref().take(CHUNK).collect();
        if chunk.is_empty() {
            break;
        }
        let count = chunk.len() as u64;
        if !take(chunk.into_par_iter().map(&answer).collect())? {
            break;
        }
        rows += count;
        progress.show(rows);
    }
    progress.bar.finish_and_clear();
    Ok(rows)
}

/// A bar with rate and time left, by the bytes read; hidden if standard error is not a terminal.
pub(crate) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar for the rows of a source.
    pub(crate) fn new(source: &Source) -> Self {
        let style = match source.length {
            Some(_) => {
                "{spinner} {bar:40} {percent:>3}%  {msg}, {elapsed} elapsed, about {eta} left"
            }
            None => "{spinner} {msg}, {elapsed} elapsed",
        };
        Self { bar: styled(source.length, style) }
    }

    /// Counts the bytes that are read.
    pub(crate) fn counted(&self, input: impl Read + 'static) -> impl Read + 'static {
        self.bar.wrap_read(input)
    }

    fn show(&self, rows: u64) {
        let rate = rows as f64 / self.bar.elapsed().as_secs_f64().max(1e-3);
        self.bar.set_message(format!("{rows} rows, {rate:.0} rows/s"));
    }
}
