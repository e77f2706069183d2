//! Why a call has no answer.

use std::fmt::Display;

/// Why there is no answer.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The question makes no sense.
    Usage(String),
    /// Threads cannot be started.
    Resource(String),
    /// A mistake of couplet's own.
    Fault(String),
}

/// The failure of a question that makes no sense.
pub(crate) fn wrong(error: impl Display) -> Failure {
    Failure::Usage(error.to_string())
}
