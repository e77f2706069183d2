//! The answer about all arches of a survey.

use crate::number::{Decimal, ExactNumber};
use crate::problem::measures::Length;
use crate::problem::survey::{Bounding, SurveyVerdict};
use crate::problem::{Arch, Mode, Quantity};
use crate::prover::Undecided;

/// Proved answer about every arch of a survey.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SurveyAnswer {
    /// Verdict on all arches; `None` if the survey has no thickness: then each has its least one.
    pub verdict: Option<Result<SurveyVerdict, Undecided>>,
    /// Arch of the survey that stands least easily: the thinnest over its least thickness.
    pub worst: SurveyedArch,
    /// Arch of the survey that stands most easily.
    pub best: SurveyedArch,
    /// Ranges of the quantities, in the order of [`Quantity::ASSESSMENT`] and the sizes behind them.
    pub ranges: Vec<QuantityRange>,
    /// Reason why a range is left out, where one is.
    pub open: Option<Undecided>,
    /// Collapse modes at the least thickness.
    pub modes: ModesFound,
}

/// Range of a quantity over the arches of a survey.
#[derive(Clone, Debug)]
pub struct QuantityRange {
    /// Quantity.
    pub of: Quantity,
    /// Value that none is below.
    pub lower: RangeEnd,
    /// Value that none is above.
    pub upper: RangeEnd,
}

/// End of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RangeEnd {
    /// Bound, rounded outwards.
    pub value: EndValue,
    /// Arch whose own value, rounded outwards, is the bound; `None` if the bound encloses and no more is known.
    pub at: Option<SurveyedArch>,
}

/// Bound of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EndValue {
    /// A number.
    Number(Decimal),
    /// No number: no thickness, or no friction, is enough.
    NotEnough,
    /// Nothing bounds the value.
    Unbounded,
}

/// Arch of a survey.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurveyedArch {
    /// Weight, half opening and friction.
    pub arch: Arch,
    /// Ratio of thickness to radius; `None` if the survey has no thickness.
    pub thickness: Option<ExactNumber>,
    /// Span, rise and thickness, where these are measured.
    pub measured: Option<[Length; 3]>,
}

/// Collapse modes at the least thickness, over the arches of a survey. Pure sliding, which is on the border to what
/// falls, is left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ModesFound {
    /// Modes each of which an arch of the survey has, in the order of [`Mode::ALL`].
    pub occur: Vec<Mode>,
    /// Modes that are not excluded besides.
    pub may_occur: Vec<Mode>,
    /// True if some arch stands at no thickness; `None` if that is not known.
    pub some_fall: Option<bool>,
}

impl SurveyedArch {
    /// A corner, or the arch at a place of a course.
    pub(super) fn new(of: Bounding, measured: Option<[Length; 3]>) -> Self {
        Self { arch: of.arch, thickness: of.thickness, measured }
    }
}

impl RangeEnd {
    /// Bound that is the value of an arch.
    pub(super) fn attained(value: EndValue, at: &SurveyedArch) -> Self {
        Self { value, at: Some(at.clone()) }
    }
}
