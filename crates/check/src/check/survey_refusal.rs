//! Reasons why a certificate of a survey is refused, beside those of the certificates in it.

use crate::number::says;
use crate::problem::survey::{Side, SurveyVerdict};

/// Reason why a certificate of a survey is refused; parts are counted from 1. It says nothing about the truth of the
/// verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SurveyRefusal {
    /// Neither of two shapes, or both.
    Shape,
    /// A name that does not exist.
    Name {
        /// Entry that should be named.
        place: &'static str,
        /// Text that stands there.
        text: String,
    },
    /// A range that does not have two ends.
    Ends(&'static str),
    /// An end that is not exact and in its range.
    Given {
        /// Range of the survey, or part and range of its step.
        place: &'static str,
        /// Text that stands there.
        text: String,
    },
    /// Ranges that make no survey.
    Survey(String),
    /// Another number of parts than the verdict on the survey needs.
    Parts {
        /// Number of parts there are.
        found: usize,
        /// Number of parts that are needed.
        expected: usize,
    },
    /// A part on a side that says nothing for the verdict.
    Side(usize, Side),
    /// A step where no course is, or none where one is.
    Step(usize),
    /// A step that is not on a leg of the course.
    Beside(usize),
    /// A step that does not begin where the course is covered up to.
    Gap(usize),
    /// A course that is not covered up to its end.
    End,
    /// A single arch is needed, and not a step.
    Wide(usize),
    /// The certificate of a part says something else than the verdict needs there.
    Claim {
        /// Part that is meant.
        part: usize,
        /// True if it has to say that its arch stands, false if that it does not.
        stands: bool,
        /// The verdict on the survey.
        verdict: SurveyVerdict,
    },
    /// The arch of a part is not the one that decides there.
    Arch {
        /// Part that is meant.
        part: usize,
        /// Measure that differs.
        place: &'static str,
    },
}

says!(SurveyRefusal {
    Self::Shape => "survey: needs exactly one of 'free', 'spanned'";
    Self::Name { place, text } => "survey: there is no {place} '{text}'";
    Self::Ends(place) => "survey: {place} does not have two ends";
    Self::Given { place, text } => "survey: {place} '{text}' is not possible";
    Self::Survey(why) => "survey: {why}";
    Self::Parts { found, expected } => "parts: there are {found} and not {expected}";
    Self::Side(part, side) => "part {part}: it is not on the {} side", side.name();
    Self::Step(part) => "part {part}: a step belongs to a survey of spans and rises, and to no other";
    Self::Beside(part) => "part {part}: the step is not on a leg of the course";
    Self::Gap(part) => "part {part}: the step does not begin where the course is covered up to";
    Self::End => "parts: the course is not covered up to its end";
    Self::Wide(part) => "part {part}: the ends of the step are not the same, so that it is no single arch";
    Self::Claim { part, stands, verdict } =>
        "part {part}: for {} its certificate has to say that the arch {}",
        verdict.name(), if *stands { "stands" } else { "does not stand" };
    Self::Arch { part, place } => "part {part}: the {place} is not that of the arch that decides there";
});
