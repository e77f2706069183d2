//! Why a command did not do what was asked.

use crate::ask::Misfit;
use crate::atlas::NoSketch;
use crate::certify::{Error, Refused, Undecided};
use crate::check::{self, reason};
use crate::number::{ParseExactError, says};
use crate::problem::{ArchError, stones::StonesError};
use std::fmt::Display;
use std::io;

/// Why a command did not do what was asked.
#[derive(Debug)]
pub enum Failure {
    /// The input makes no sense.
    Input(String),
    /// Not everything could be proved; what could has been printed.
    Undecided(String),
    /// A file or a stream.
    Io(String),
}

says!(Failure {
    Self::Input(text) | Self::Undecided(text) | Self::Io(text) => "{text}";
});

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Refused(refused) => refused.into(),
            Error::Undecided(undecided) => undecided.into(),
        }
    }
}

impl From<check::CheckFailure> for Failure {
    fn from(failure: check::CheckFailure) -> Self {
        match failure {
            check::CheckFailure::Refused(said) => Self::Undecided(said),
            check::CheckFailure::Open(said) => Self::Io(said),
        }
    }
}

impl From<NoSketch> for Failure {
    /// Nothing to draw is a wrong question, or an open one.
    fn from(none: NoSketch) -> Self {
        match none {
            NoSketch::Undecided(_) => Self::Undecided(none.to_string()),
            _ => Self::Input(none.to_string()),
        }
    }
}

/// Errors that are failures of one kind.
macro_rules! failures {
    ($($kind:ident: $($error:ty),+;)+) => {$($(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::$kind(error.to_string())
            }
        }
    )+)+};
}

failures! {
    Input: &str, String, Misfit, Refused, ParseExactError, ArchError, StonesError;
    Undecided: Undecided;
}

impl Failure {
    /// A failure to read: the source, and the reason.
    pub fn reading(what: impl Display, error: &io::Error) -> Self {
        Self::Io(format!("cannot read {what}: {}", reason(error)))
    }

    /// A failure if anything stays open.
    pub fn of_open<T: Display>(open: impl IntoIterator<Item = T>) -> Result<(), Self> {
        let open: Vec<String> = open.into_iter().map(|open| open.to_string()).collect();
        match open.is_empty() {
            true => Ok(()),
            false => Err(Self::Undecided(open.join("; "))),
        }
    }

    /// A failure if anything of what was to be `done` stays open.
    pub fn unless_all(done: &str, open: &[impl AsRef<str>]) -> Result<(), Self> {
        let open: Vec<&str> = open.iter().map(AsRef::as_ref).collect();
        let all = format!("not everything was {done}: {}", open.join(", "));
        Self::of_open((!open.is_empty()).then_some(all))
    }

    /// A failure to write: the destination, and the reason; of what cannot be written as asked the reason alone.
    pub fn writing(what: impl Display, error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::InvalidInput && error.get_ref().is_some() {
            return Self::Input(error.to_string());
        }
        Self::Io(format!("cannot write {what}: {}", reason(error)))
    }
}

/// Writes to standard output. A reader that closes the pipe early is no failure.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    Ok(check::print(bytes)?)
}
