//! The answer about all arches of a survey.

use crate::number::{Ball, Decimal, ExactNumber, Field, Rounded};
use crate::problem::measures::Length;
use crate::problem::survey::{Side, Survey, SurveyVerdict};
use crate::problem::{Arch, Mode, Quantity};
use crate::prover::Undecided;
use std::fmt;

/// Digits of an end that only encloses: more would say nothing.
pub(super) const ENCLOSED_DIGITS: usize = 5;

/// Bits of a product of two numbers.
const BITS: u32 = 128;

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

impl ModesFound {
    /// Tells whether every arch collapses by rotation alone.
    pub(super) fn is_rotation_alone(&self) -> bool {
        self.occur == [Mode::Rotational]
            && self.may_occur.is_empty()
            && self.some_fall == Some(false)
    }
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

impl SurveyAnswer {
    /// Ends of the range of a quantity, where they are numbers.
    pub fn numbers(&self, of: Quantity) -> Option<[ExactNumber; 2]> {
        let range = self.ranges.iter().find(|range| range.of == of)?;
        let number = |end: &RangeEnd| match &end.value {
            EndValue::Number(number) => Some(ExactNumber::from(number.to_rational())),
            _ => None,
        };
        Some([number(&range.lower)?, number(&range.upper)?])
    }

    /// Adds the weight and the thrusts in kN, of arches whose half opening (rad) and whose `w r` in kN are between two
    /// numbers: each end is a product of two, which encloses. Without a thrust of arches that all stand they stay open.
    pub fn add_forces(
        &mut self,
        half_opening: &[ExactNumber; 2],
        force: &[ExactNumber; 2],
        digits: usize,
    ) {
        let [light, heavy] = force.each_ref().map(|force| force.enclosure::<Ball>(BITS));
        let end = |ratio: Ball, up: bool| {
            // What is negative is least beside the heaviest.
            let unit = if up == ratio.mid().is_sign_negative() { &light } else { &heavy };
            let force = ratio * unit;
            // The end itself is rounded outward: the ball may hold a tie, which no digits decide.
            let bound = if up { force.upper() } else { force.lower() }.to_rational()?;
            let force = Rounded::from_rational(&bound, digits.min(ENCLOSED_DIGITS))?;
            Some(EndValue::Number(if up { force.upper } else { force.lower }))
        };
        let [narrow, wide] = half_opening.each_ref().map(|alpha| alpha.enclosure::<Ball>(BITS));
        let weight = [end(narrow.int(2) * narrow, false), end(wide.int(2) * wide, true)];
        let told = |(ratio, of)| {
            let range = self.ranges.iter().find(|range| range.of == ratio)?;
            let ends = [(&range.lower, false), (&range.upper, true)];
            let ends = ends.map(|(at, up)| match &at.value {
                EndValue::Number(number) => end(Rounded::exact(number.clone()).enclosure(BITS), up),
                other => Some(other.clone()),
            });
            Some((of, ends))
        };
        let thrusts = [
            (Quantity::LeastThrust, Quantity::LeastForce),
            (Quantity::LargestThrust, Quantity::LargestForce),
            (Quantity::Thrust, Quantity::Force),
        ];
        let told: Vec<_> = thrusts.into_iter().filter_map(told).collect();
        if told.is_empty() && matches!(self.verdict, Some(Ok(SurveyVerdict::AllStand))) {
            self.open.get_or_insert(Undecided::new("how large the thrusts are"));
        }
        for (of, ends) in told.into_iter().chain([(Quantity::Weight, weight)]) {
            if let [Some(lower), Some(upper)] = ends {
                self.ranges.push(QuantityRange::enclosed(of, [lower, upper]));
            }
        }
    }
}

impl QuantityRange {
    /// The range between two bounds that no arch need attain.
    pub(super) fn enclosed(of: Quantity, ends: [EndValue; 2]) -> Self {
        let [lower, upper] = ends.map(|value| RangeEnd { value, at: None });
        Self { of, lower, upper }
    }
}

impl RangeEnd {
    /// Bound that is the value of an arch.
    pub(super) fn attained(value: EndValue, at: &SurveyedArch) -> Self {
        Self { value, at: Some(at.clone()) }
    }
}
