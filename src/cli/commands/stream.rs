//! Rows answered on all cores a chunk at a time, so that memory does not grow with the file.

use super::progress::{ROWS, show_rows, styled};
use crate::sweep::rows::{Input, Numbered, RowSource};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::io::{self, BufReader};
use std::sync::mpsc;
use std::thread;

/// Rows that are read, answered, and handed on before the next are read.
pub(super) const CHUNK: usize = 512;

/// Size of the chunks in which rows are answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Chunk {
    /// All that has been read, however few: interactive input is answered row by row.
    WhatIsThere,
    /// As many rows as a chunk may have.
    Full,
}

/// Answers the rows on all cores and hands each chunk on in the order of the rows. Answers how many rows
/// there were.
pub(super) fn in_order<T: Send + 'static, A: Send, E: From<io::Error>>(
    lines: impl Iterator<Item = Numbered<T>> + Send + 'static,
    (progress, together): (&Progress, Chunk),
    answer: impl Fn(Numbered<T>) -> A + Sync,
    mut take: impl FnMut(Vec<A>) -> Result<(), E>,
) -> Result<u64, E> {
    let (sender, receiver) = mpsc::sync_channel(CHUNK / 2);
    // After a failure nobody waits for this thread: it may itself wait for a row that never comes.
    let reader = thread::Builder::new().spawn(move || {
        for line in lines {
            // The receiver goes away when the rows cannot be written.
            if sender.send(line).is_err() {
                break;
            }
        }
    })?;
    let mut rows = 0;
    while let Ok(first) = receiver.recv() {
        let mut chunk = vec![first];
        while chunk.len() < CHUNK {
            let next = match together {
                Chunk::WhatIsThere => receiver.try_recv().ok(),
                Chunk::Full => receiver.recv().ok(),
            };
            let Some(line) = next else { break };
            chunk.push(line);
        }
        let count = chunk.len() as u64;
        let answers = chunk.into_par_iter().map(&answer).collect();
        // Where rows go to the terminal too, they do not stand behind the bar.
        progress.bar.suspend(|| take(answers))?;
        rows += count;
        show_rows(&progress.bar, rows);
    }
    progress.bar.finish_and_clear();
    // There are no more rows because there are none, not because the thread is gone.
    reader.join().map_err(|_| io::Error::other("the rows could not be read to their end"))?;
    Ok(rows)
}

/// A bar with rate and time left, by the bytes read; hidden if standard error is not a terminal.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar for the rows of a source; none for rows that are typed, between which it would stand.
    pub(crate) fn new(source: &RowSource) -> Self {
        if source.is_typed {
            return Self { bar: ProgressBar::hidden() };
        }
        let style = match source.length {
            Some(_) => ROWS,
            None => "{spinner} {msg}, {elapsed} elapsed",
        };
        let bar = styled(source.length, style);
        bar.set_message("waits for rows");
        Self { bar }
    }

    /// Counts the bytes that are read.
    pub(crate) fn counted(&self, input: Input) -> Input {
        Box::new(BufReader::new(self.bar.wrap_read(input)))
    }
}
