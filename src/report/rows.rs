//! Answers that are written as they come, so that memory does not grow with their number.

use super::answer::Answer;
use rayon::prelude::*;
use std::io;

/// A file that is written group by group. What is returned are its next bytes.
pub trait Rows: Send {
    /// What stands before all answers.
    fn begin(&mut self) -> io::Result<Vec<u8>> {
        Ok(Vec::new())
    }

    /// Some answers.
    fn group(&mut self, answers: &[Answer]) -> io::Result<Vec<u8>>;

    /// What stands behind all answers.
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
