//! The outcome of a proof that did not succeed.

use crate::problem::Mode;
use std::borrow::Cow;

/// Why a proof did not succeed. It says nothing about the truth of the statement.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("undecided: {reason}")]
#[non_exhaustive]
pub struct Undecided {
    /// What could not be told.
    pub reason: Cow<'static, str>,
    /// The collapse modes, or the mode and nothing, between which an arch stands.
    pub between: Vec<Mode>,
    /// A bound of the difference that could not be told from zero, where one was looked at.
    pub gap: Option<f64>,
}

impl Undecided {
    /// A proof that failed for this reason.
    pub fn new(reason: impl Into<Cow<'static, str>>) -> Self {
        Self { reason: reason.into(), between: Vec::new(), gap: None }
    }

    /// The same, between these modes.
    pub fn between(self, modes: &[Mode]) -> Self {
        Self { between: modes.to_vec(), ..self }
    }

    /// The same, with a statement before the reason.
    pub fn about(self, statement: &str) -> Self {
        Self { reason: format!("{statement}: {}", self.reason).into(), ..self }
    }
}
