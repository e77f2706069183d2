//! Why a command did not do what was asked.

use crate::certify::{Error, Refused};
use std::fmt::Display;
use std::io::{self, Write};

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

/// The kind of an error in plain words. Its own text may name a temporary file, which the user does not know.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file or folder".into(),
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "expected a folder, found a file".into()
        }
        io::ErrorKind::Other => error.to_string(),
        kind => kind.to_string(),
    }
}

/// Writes to standard output. A reader that closes the pipe early is no failure.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::writing("to standard output", &error))
        }
        _ => Ok(()),
    }
}
