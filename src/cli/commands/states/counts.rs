//! Numbers of rows, and what the command says of them at its end.

use crate::sweep::failure::Failure;

/// Numbers of rows, by what became of them.
#[derive(Default)]
pub(super) struct Counts {
    bad: usize,
    undecided: usize,
    /// All of them; none if they were not read to their end.
    pub(super) rows: Option<u64>,
}

impl Counts {
    pub(super) fn add(&mut self, is_bad: bool, is_undecided: bool) {
        self.bad += usize::from(is_bad);
        self.undecided += usize::from(is_undecided);
    }

    pub(super) fn verdict(self) -> Result<(), Failure> {
        let Self { bad, undecided, rows } = self;
        match (rows, bad, undecided) {
            // The reader closed the pipe early.
            (None, ..) | (_, 0, 0) => Ok(()),
            (Some(rows), 0, undecided) => {
                Err(Failure::Undecided(format!("{undecided} of {rows} rows are undecided")))
            }
            (Some(rows), bad, _) => Err(Failure::Input(format!(
                "{bad} of {rows} rows could not be read; see their errors"
            ))),
        }
    }
}
