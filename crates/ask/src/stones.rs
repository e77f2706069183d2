//! Numbers of stones, one or all of a range, and joints by their angles.

use super::asked::{ArchAsked, Field};
use super::question::{Misfit, Spelling};
use crate::number::{BETWEEN, ExactNumber, ParseExactError, spelt_range};
use crate::problem::stones::{MOST_STONES, Stones, StonesError};

/// Stones that are asked about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StonesAsked {
    /// Numbers of stones of one angle, all from the first to the last.
    Numbers {
        /// The first number.
        first: u64,
        /// The last number.
        last: u64,
        /// True if they are written as a range, which may be of one number.
        is_range: bool,
    },
    /// Joints by their angles.
    Joints(Stones),
}

/// Numbers in a range at most.
pub const MOST_NUMBERS: u64 = 10_000;

impl StonesAsked {
    /// Stones of a question, if any.
    pub(super) fn of(asked: &ArchAsked) -> Result<Option<Self>, Misfit> {
        let (field, stones) = match (&asked.stones, &asked.joints) {
            (Some(text), _) => {
                let why = || {
                    format!(
                        "stones are a whole number from 2 to {MOST_STONES}, or a range of at most {MOST_NUMBERS}, as in \
                         2..200"
                    )
                };
                (Field::Stones, Self::numbers(text).ok_or_else(why))
            }
            (None, Some(text)) => (Field::Joints, Self::joints(text)),
            (None, None) => return Ok(None),
        };
        stones.map(Some).map_err(|why| Misfit::new(field, why))
    }

    /// Number of stones, or a range of them.
    fn numbers(text: &str) -> Option<Self> {
        let number = |text: &str| {
            let number = text.trim().parse::<u64>().ok();
            number.filter(|number| (2..=MOST_STONES).contains(number))
        };
        let text = &*spelt_range(text);
        let (first, last) = text.split_once(BETWEEN).unwrap_or((text, text));
        let (first, last) = (number(first)?, number(last)?);
        let count = (last + 1u64).checked_sub(first)?;
        let is_range = text.contains(BETWEEN);
        (1..=MOST_NUMBERS).contains(&count).then_some(Self::Numbers { first, last, is_range })
    }

    /// Joints of the half arch, by angles with commas between them.
    fn joints(text: &str) -> Result<Self, String> {
        let angles: Result<Vec<ExactNumber>, ParseExactError> =
            text.split(',').map(|angle| angle.trim().parse()).collect();
        let angles = angles.map_err(|error| error.to_string())?;
        Stones::joints(angles).map(Self::Joints).map_err(|error| error.to_string())
    }

    /// Stones of a question with ranges, if any: those of friction and thickness leave the joints where they are.
    pub(super) fn of_ranges(asked: &ArchAsked, spelling: Spelling) -> Result<Option<Self>, Misfit> {
        let Some(stones) = Self::of(asked)? else { return Ok(None) };
        let name = spelling.of(Field::Stones);
        let mut moves = vec![Field::HalfOpening, Field::Span, Field::Rise];
        if asked.span.is_some() || asked.rise.is_some() {
            moves.push(Field::Radius);
        }
        if let Some(field) = asked.ranges().find(|field| moves.contains(field)) {
            let field = spelling.of(field);
            let message = format!(
                "{name} does not go with the range of {field}, which moves the joints: give friction and thickness ranges"
            );
            return Err(Misfit::new(Field::Stones, message));
        }
        if stones.is_range() {
            let message = format!("a range of arches has one number of stones: give {name} one");
            return Err(Misfit::new(Field::Stones, message));
        }
        Ok(Some(stones))
    }

    /// Tells whether a range is asked for.
    pub fn is_range(&self) -> bool {
        matches!(self, Self::Numbers { is_range: true, .. })
    }

    /// The divisions of an arch of this half opening.
    pub fn all(&self, half_opening: &ExactNumber) -> Result<Vec<Stones>, StonesError> {
        match self {
            Self::Joints(stones) => Ok(vec![stones.clone()]),
            Self::Numbers { first, last, .. } => {
                let equal = |stones| Stones::equal(stones, half_opening.clone());
                (*first..=*last).map(equal).collect()
            }
        }
    }
}
