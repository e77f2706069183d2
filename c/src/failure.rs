//! Why a call has no answer.

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
