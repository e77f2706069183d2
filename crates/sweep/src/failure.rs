//! Why a command did not do what was asked.

use crate::certify::{Error, Refused};
use crate::check::{self, reason};
use std::fmt::Display;
use std::io;

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The input makes no sense.
    #[error("{0}")]
    Input(String),
    /// Not everything could be proved; what could has been printed.
    #[error("{0}")]
    Undecided(String),
    /// A file or a stream.
    #[error("{0}")]
    Io(String),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Refused(refused) => Self::Input(refused.to_string()),
            Error::Undecided(undecided) => Self::Undecided(undecided.to_string()),
        }
    }
}

impl From<Refused> for Failure {
    fn from(refused: Refused) -> Self {
        Self::from(Error::from(refused))
    }
}

impl From<check::Failure> for Failure {
    fn from(failure: check::Failure) -> Self {
        match failure {
            check::Failure::Refused(said) => Self::Undecided(said),
            check::Failure::Open(said) => Self::Io(said),
        }
    }
}

impl Failure {
    /// What could not be read, and why.
    pub fn reading(what: impl Display, error: &io::Error) -> Self {
        Self::Io(format!("cannot read {what}: {}", reason(error)))
    }

    /// What could not be written, and why.
    pub fn writing(what: impl Display, error: &io::Error) -> Self {
        Self::Io(format!("cannot write {what}: {}", reason(error)))
    }
}

/// Writes to standard output. A reader that closes the pipe early is no failure.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    Ok(check::print(bytes)?)
}
