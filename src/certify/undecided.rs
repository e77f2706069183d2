//! The outcome of a proof that did not succeed.

use crate::number::{Ball, Enclosure, Magnitude, Ternary};
use crate::problem::{Condition, Mode};
use rug::float::Round;
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

/// Whether a margin is positive, if that can be told.
pub(crate) fn decide(
    margin: &Ball,
    question: &'static str,
    between: &[Mode],
) -> Result<bool, Undecided> {
    match margin.is_positive() {
        Ternary::True => Ok(true),
        Ternary::False => Ok(false),
        Ternary::Undecided => {
            let gap = Magnitude::upper(margin.mid()).plus(margin.rad()).to_float();
            // A margin without bound is no difference that is nearly zero.
            let gap = Some(gap.to_f64_round(Round::Up)).filter(|gap| gap.is_finite());
            let between = if gap.is_some() { between } else { &[] };
            Err(Undecided { gap, ..Undecided::new(question).between(between) })
        }
    }
}

/// Requires a margin to be positive for a proof to go on; where it is not, nothing is known.
pub(crate) fn require(margin: &Ball, question: &'static str) -> Result<(), Undecided> {
    match decide(margin, question, &[])? {
        true => Ok(()),
        false => Err(Undecided::new(question)),
    }
}

/// Requires a condition of a mode. A candidate that is proved to fail it is not the state of the arch: then it
/// is beside the point, not on a boundary.
pub(crate) fn require_condition(
    condition: Condition,
    margin: &Ball,
    mode: Mode,
) -> Result<(), Undecided> {
    match decide(margin, condition.label(), &[mode])? {
        true => Ok(()),
        false => Err(Undecided::new(format!(
            "the root found for {mode} is not the state of the arch, as this fails: {}",
            condition.label()
        ))),
    }
}
