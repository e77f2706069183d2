//! The answer about all arches of a survey.

use crate::number::{Decimal, ExactNumber};
use crate::problem::measures::Length;
use crate::problem::survey::{Side, Survey, SurveyVerdict};
use crate::problem::{Arch, Mode, Quantity};
use crate::prover::Undecided;
use std::fmt;

/// Proved answer about every arch of a survey. Where something is sought, an arch has a half opening of one radian, or
/// friction without limit, in its place.
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
    /// Collapse modes at the least thickness, where they are told.
    pub modes: Option<ModesFound>,
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
    /// No number: no thickness, or no friction, is enough, or nothing stands.
    NotEnough,
    /// No least number: however small it is, it is enough.
    AnyIsEnough,
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

impl fmt::Display for EndValue {
    /// Number, `none` where none is enough, `any` where each is, or `inf`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::NotEnough => f.write_str("none"),
            Self::AnyIsEnough => f.write_str("any"),
            Self::Unbounded => f.write_str("inf"),
        }
    }
}

impl SurveyedArch {
    /// The arch that decides on a side.
    pub(super) fn decisive(survey: &Survey, side: Side) -> Option<Self> {
        let (of, measured) = match survey.decisive(side) {
            Some(place) => (survey.bounding(side, [&place; 2])?, survey.measured(side, &place)),
            None => (survey.corner(side)?, None),
        };
        Some(Self { arch: of.arch, thickness: of.thickness, measured })
    }
}

impl RangeEnd {
    /// Bound that is the value of an arch.
    pub(super) fn attained(value: EndValue, at: &SurveyedArch) -> Self {
        Self { value, at: Some(at.clone()) }
    }
}
