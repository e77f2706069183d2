//! What is proved of all arches of a survey.

use crate::number::{Decimal, ExactNumber};
use crate::problem::measures::Length;
use crate::problem::survey::Bounding;
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
    /// Collapse modes at the least thickness.
    pub modes: ModesFound,
}

/// Verdict on all arches of a survey.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SurveyVerdict {
    /// Every arch stands.
    AllStand,
    /// No arch stands.
    NoneStands,
    /// The best arch stands, and the worst does not.
    BothOccur,
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

impl SurveyVerdict {
    /// The verdict in the words used in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AllStand => "all_stand",
            Self::NoneStands => "none_stands",
            Self::BothOccur => "both_occur",
        }
    }

    /// The verdict in a sentence.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::AllStand => "every arch stands",
            Self::NoneStands => "no arch stands",
            Self::BothOccur => "some arches stand, others do not",
        }
    }
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

    /// End without bound.
    pub(super) fn unbounded(at: &SurveyedArch) -> Self {
        Self::attained(EndValue::Unbounded, at)
    }
}
