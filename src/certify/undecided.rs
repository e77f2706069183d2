//! The outcome of a proof that did not succeed.

/// Why a proof did not succeed. It says nothing about the truth of the statement.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("undecided: {0}")]
pub struct Undecided(pub String);
