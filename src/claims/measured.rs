//! Numbers where a sentence has none: proved bounds in few digits.

use super::{Derivation, Finding, Support};
use crate::certify::Undecided;
use crate::number::{Ball, Decimal, Enclosure, Rounded};

/// Bounds of values: decimals next to each, between which it is proved to lie.
#[derive(Default)]
pub(super) struct Bounds {
    above: Vec<String>,
    below: Vec<String>,
}

impl Bounds {
    /// Checks between which neighbours of few significant digits a positive value lies, and notes them with
    /// what stands before and behind.
    pub(super) fn note(
        &mut self,
        d: &mut Derivation,
        (words, value, unit): (&str, &Ball, &str),
        digits: usize,
    ) -> Result<(), Undecided> {
        let rounded = Rounded::from_ball(value, digits)
            .ok_or_else(|| Undecided::new(format!("{words}: no digits")))?;
        let near = |decimal: &Decimal| Ball::enclosing(&decimal.to_rational(), value.prec());
        let (below, above) = (&rounded.lower, &rounded.upper);
        let inside = near(below).is_less_than(value).and(value.is_less_than(&near(above)));
        let found = format!("{words} is between {below}{unit} and {above}{unit}");
        d.certain(Support::Balls, found, inside)?;
        self.above.push(format!("{words}: {above}{unit}"));
        self.below.push(format!("{words}: {below}{unit}"));
        Ok(())
    }

    /// The values as bounds that hold, next to such as do not.
    pub(super) fn finding(self) -> Finding {
        let fails_with = Some(self.below.join("; "));
        Finding::Measured { holds_with: self.above.join("; "), fails_with }
    }
}
