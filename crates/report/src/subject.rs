//! Subject of an answer: a landmark, an arch, a question the other way round.

use super::given::GivenDoubles;
use crate::arch::SelfWeight;
use crate::certify::state::find::{Given, Question};
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction, Landmark, Line, Sought};

/// Subject of an answer.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A landmark point.
    Landmark {
        /// Landmark that is meant.
        landmark: Landmark,
        /// The self-weight model.
        weight: SelfWeight,
    },
    /// An arch. What was given is text from outside, a fraction as a decimal where it ends.
    Arch {
        /// Tells arches apart: the line of the query.
        line: u64,
        /// The self-weight model.
        weight: SelfWeight,
        /// The half opening as given.
        half_opening: String,
        /// The friction as given.
        friction: String,
        /// The thickness as given, where the arch has one.
        thickness: Option<String>,
        /// Given values as numbers.
        doubles: GivenDoubles,
    },
    /// A question the other way round. What was given is text from outside.
    Sought {
        /// Tells questions apart.
        line: u64,
        /// The self-weight model.
        weight: SelfWeight,
        /// Quantity that is asked for.
        sought: Sought,
        /// The line of the map on which it is asked for.
        boundary: Option<Line>,
        /// The half opening as given.
        half_opening: Option<String>,
        /// The friction as given.
        friction: Option<String>,
        /// The thickness as given.
        thickness: Option<String>,
    },
    /// A query that could not be read.
    Query {
        /// Line of the query in its input.
        line: u64,
    },
}

impl Subject {
    /// An arch, with its given values as doubles or without.
    pub(super) fn arch(
        line: u64,
        (arch, thickness): (&Arch, Option<&ExactNumber>),
        doubles: bool,
    ) -> Self {
        let made = doubles.then(|| GivenDoubles::new(arch, thickness));
        Self::Arch {
            line,
            weight: arch.weight(),
            half_opening: arch.half_opening().in_decimals(),
            friction: in_decimals(arch.friction()),
            thickness: thickness.map(ExactNumber::in_decimals),
            doubles: made.unwrap_or_default(),
        }
    }

    pub(super) fn sought(line: u64, weight: SelfWeight, question: &Question) -> Self {
        let (boundary, half_opening, friction) = match question {
            Question::HalfOpening { friction, .. } => (None, None, Some(friction)),
            Question::Friction { half_opening, .. } => (None, Some(half_opening), None),
            Question::Boundary { line, given: Given::HalfOpening(alpha) } => {
                (Some(*line), Some(alpha), None)
            }
            Question::Boundary { line, given: Given::Friction(mu) } => {
                (Some(*line), None, Some(mu))
            }
        };
        Self::Sought {
            line,
            weight,
            sought: question.sought(),
            boundary,
            half_opening: half_opening.map(ExactNumber::in_decimals),
            friction: friction.map(in_decimals),
            thickness: question.thickness().map(ExactNumber::in_decimals),
        }
    }

    /// Tells whether the subject is an arch of a given thickness.
    pub fn is_assessed(&self) -> bool {
        matches!(self, Self::Arch { thickness: Some(_), .. })
    }

    /// The landmark, if it is one.
    pub fn landmark(&self) -> Option<Landmark> {
        match self {
            Self::Landmark { landmark, .. } => Some(*landmark),
            Self::Arch { .. } | Self::Sought { .. } | Self::Query { .. } => None,
        }
    }

    /// The line of a query.
    pub fn line(&self) -> Option<u64> {
        match self {
            Self::Landmark { .. } => None,
            Self::Arch { line, .. } | Self::Sought { line, .. } | Self::Query { line } => {
                Some(*line)
            }
        }
    }

    /// Half opening, friction and thickness as given, where they are.
    pub(super) fn given(&self) -> [Option<&str>; 3] {
        match self {
            Self::Arch { half_opening, friction, thickness, .. } => {
                [Some(half_opening), Some(friction), thickness.as_deref()]
            }
            Self::Sought { half_opening, friction, thickness, .. } => {
                [half_opening, friction, thickness].map(Option::as_deref)
            }
            Self::Landmark { .. } | Self::Query { .. } => [None; 3],
        }
    }

    /// Values of an arch as numbers.
    pub(super) fn doubles(&self) -> GivenDoubles {
        match self {
            Self::Arch { doubles, .. } => *doubles,
            _ => GivenDoubles::default(),
        }
    }

    /// The self-weight model, where it could be read.
    pub fn weight(&self) -> Option<SelfWeight> {
        match self {
            Self::Landmark { weight, .. }
            | Self::Arch { weight, .. }
            | Self::Sought { weight, .. } => Some(*weight),
            Self::Query { .. } => None,
        }
    }
}

/// Text of a friction, a fraction as a decimal where it ends.
fn in_decimals(friction: &Friction) -> String {
    match friction {
        Friction::Coefficient(mu) => mu.in_decimals(),
        other => other.to_string(),
    }
}
