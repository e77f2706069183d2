//! Rows answered on all cores a chunk at a time, so that memory does not grow with the file.

use super::progress::{ROWS, show_rows, styled};
use crate::sweep::rows::{Input, Numbered, RowSource};
use indicatif::ProgressBar;
use std::io::{self, BufReader, Write};
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

/// Answers the rows a chunk at a time and hands each chunk on, in the order of the rows. Answers how many rows there
/// were.
pub(super) fn in_order<T: Send + 'static, A: Send>(
    lines: impl Iterator<Item = Numbered<T>> + Send + 'static,
    (progress, together): (&Progress, Chunk),
    answers: impl Fn(Vec<Numbered<T>>) -> Vec<A>,
    mut take: impl FnMut(Vec<A>) -> io::Result<()>,
) -> io::Result<u64> {
    let together = match together {
        Chunk::WhatIsThere => 1,
        Chunk::Full => CHUNK,
    };
    let (sender, receiver) = mpsc::sync_channel(CHUNK / 2 / together);
    // After a failure nobody waits for this thread: it may itself wait for a row that never comes.
    let reader = thread::Builder::new().spawn(move || {
        let mut lines = lines.fuse();
        loop {
            let some: Vec<_> = lines.by_ref().take(together).collect();
            // The receiver goes away when the rows cannot be written.
            if some.is_empty() || sender.send(some).is_err() {
                break;
            }
        }
    })?;
    let mut rows = 0;
    while let Ok(mut chunk) = receiver.recv() {
        while chunk.len() < CHUNK
            && let Ok(more) = receiver.try_recv()
        {
            chunk.extend(more);
        }
        let count = chunk.len() as u64;
        let answers = answers(chunk);
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

/// Answers rows as they come, those of a file a chunk at a time, and writes what each is in the output; `take` gets the
/// answers. Answers how many rows there were.
pub(super) fn written<T: Send + 'static, A: Send>(
    rows: impl Iterator<Item = Numbered<T>> + Send + 'static,
    progress: &Progress,
    answers: impl Fn(Vec<Numbered<T>>) -> Vec<(A, io::Result<Vec<u8>>)>,
    out: &mut dyn Write,
    mut take: impl FnMut(A),
) -> io::Result<u64> {
    let together = if progress.is_of_file { Chunk::Full } else { Chunk::WhatIsThere };
    in_order(rows, (progress, together), answers, |answers: Vec<_>| {
        for (row, text) in answers {
            take(row);
            out.write_all(&text?)?;
        }
        out.flush()
    })
}

/// A bar with rate and time left, by the bytes read; hidden if standard error is not a terminal.
pub(super) struct Progress {
    bar: ProgressBar,
    /// True if the rows are those of a file, for which nobody waits.
    pub(super) is_of_file: bool,
}

impl Progress {
    /// A bar for the rows of a source; none for rows that are typed, between which it would stand.
    pub(crate) fn new(source: &RowSource) -> Self {
        if source.is_typed {
            return Self { bar: ProgressBar::hidden(), is_of_file: false };
        }
        let style = match source.length {
            Some(_) => ROWS,
            None => "{spinner} {msg}, {elapsed} elapsed",
        };
        let bar = styled(source.length, style);
        bar.set_message("waits for rows");
        Self { bar, is_of_file: source.length.is_some() }
    }

    /// Counts the bytes that are read.
    pub(crate) fn counted(&self, input: Input) -> Input {
        Box::new(BufReader::new(self.bar.wrap_read(input)))
    }
}
