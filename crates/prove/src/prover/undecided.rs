//! The outcome of a proof that did not succeed.

use crate::number::says;
use crate::problem::Mode;
use std::borrow::Cow;

/// Why a proof did not succeed. It says nothing about the truth of the statement.
///
/// What was asked made sense: a question that makes none is [`Refused`](super::Refused).
///
/// ```
/// use couplet_prove::certify::Open;
/// use couplet_prove::prelude::*;
/// // Next to the friction at which the mode changes: more than doubles can tell.
/// let arch = Arch::parse("heyman", "pi/2", "0.39583203813806954")?;
/// let open = arch.state_in_doubles().unwrap_err();
/// assert_eq!(open.kind, Open::Comparison);
/// assert_eq!(open.between, [Mode::Rotational, Mode::SlidingRotational]);
/// // With more bits it is proved.
/// assert!(arch.certify(17).is_ok());
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Undecided {
    /// Question that could not be told.
    pub reason: Cow<'static, str>,
    /// Kind of that question.
    pub kind: Open,
    /// The most bits with which it was tried, where more were tried until it stayed open.
    pub bits: Option<u32>,
    /// The collapse modes, or the mode and nothing, between which an arch stands.
    pub between: Vec<Mode>,
    /// A bound of the difference that could not be told from zero, where one was looked at.
    pub gap: Option<f64>,
}

says!(Undecided { Self { reason, .. } => "undecided: {reason}"; });

/// Kind of question that stayed open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Open {
    /// A comparison: a sign, or an order. The arch lies on a boundary, or nearer to one than the bits tell.
    Comparison,
    /// The last digit of a value, or its nearest double: the value is a tie, or nearer to one than the bits tell.
    Rounding,
    /// A root: none is found, or none is proved to be the only one in a box.
    Root,
}

/// An answer that is known; `None` if there is no such thing; or the reason why it stays open.
pub type Answered<T> = Result<Option<T>, Undecided>;

impl Undecided {
    /// A comparison that stayed open for this reason.
    pub fn new(reason: impl Into<Cow<'static, str>>) -> Self {
        let (kind, reason) = (Open::Comparison, reason.into());
        Self { reason, kind, bits: None, between: Vec::new(), gap: None }
    }

    /// A value whose digits are not decided.
    pub fn rounding(reason: impl Into<Cow<'static, str>>) -> Self {
        Self { kind: Open::Rounding, ..Self::new(reason) }
    }

    /// A root that is not proved.
    pub(crate) fn root(reason: impl Into<Cow<'static, str>>) -> Self {
        Self { kind: Open::Root, ..Self::new(reason) }
    }

    /// Undecided answer where the search finds nothing to prove.
    #[doc(hidden)]
    pub fn no_solution() -> Self {
        Self::root("no solution of the equations is found")
    }

    /// Undecided answer where no box around a candidate is mapped into itself.
    pub(crate) fn not_alone() -> Self {
        Self::root("whether the solution that is found is the only one near it")
    }

    /// Undecided answer where a Jacobian may be singular.
    pub(crate) fn singular() -> Self {
        Self::root("whether two solutions meet where one is found")
    }

    /// Undecided answer where a box is not inside the one in which the root is known to be unique.
    #[doc(hidden)]
    pub fn astray() -> Self {
        Self::root("whether more digits are those of the same solution")
    }

    /// Adds the modes between which the question is open.
    pub fn between(self, modes: &[Mode]) -> Self {
        Self { between: modes.to_vec(), ..self }
    }

    /// Adds the bits that were tried.
    pub(crate) fn at(self, bits: u32) -> Self {
        Self { bits: Some(bits), ..self }
    }

    /// Adds a statement before the reason.
    pub fn about(self, statement: &str) -> Self {
        Self { reason: format!("{statement}: {}", self.reason).into(), ..self }
    }
}
