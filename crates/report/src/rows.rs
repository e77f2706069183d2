//! Answers written as they come: memory does not grow with their number.

use super::answer::Answer;
use rayon::prelude::*;
use std::io;

/// A file written group by group; every method returns its next bytes.
pub trait Rows: Send {
    /// The header.
    fn begin(&mut self) -> io::Result<Vec<u8>> {
        Ok(Vec::new())
    }

    /// Writes some answers.
    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>>;

    /// The footer.
    fn end(self: Box<Self>) -> io::Result<Vec<u8>> {
        Ok(Vec::new())
    }
}

/// A row for each answer, made on all cores.
pub(super) fn in_parallel(
    answers: &[Answer],
    row: impl Fn(&Answer) -> io::Result<Vec<u8>> + Send + Sync,
) -> io::Result<Vec<u8>> {
    Ok(answers.par_iter().map(row).collect::<io::Result<Vec<_>>>()?.concat())
}
