//! The outcome of a proof.

use std::fmt;

/// What a proof says of a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The statement is true.
    Proved,
    /// The statement is false.
    Refuted,
    /// Nothing is known, for this reason.
    Undecided(String),
}

/// Why a proof did not succeed. It says nothing about the truth of the statement.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("undecided: {0}")]
pub struct Undecided(pub String);

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proved => f.write_str("proved"),
            Self::Refuted => f.write_str("refuted"),
            Self::Undecided(reason) => write!(f, "undecided: {reason}"),
        }
    }
}
