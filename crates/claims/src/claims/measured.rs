//! Numbers where a sentence has none: proved bounds in few digits.

use super::{Derivation, Finding, Proof, Support};
use crate::certify::Undecided;
use crate::number::{Ball, Decimal, Enclosure, Field, Real, Rounded};

/// Bounds of values: decimals next to each, between which it is proved to lie.
#[derive(Default)]
pub(super) struct MeasuredBounds {
    hold: Vec<String>,
    fail: Vec<String>,
}

impl MeasuredBounds {
    /// Checks between which neighbours of few significant digits a positive value lies; the upper one is
    /// noted as a bound that holds.
    pub(super) fn at_most(
        &mut self,
        d: &mut Derivation,
        (words, value, unit): (&str, &Ball, &str),
        digits: usize,
    ) -> Proof {
        let (below, above) = neighbours(d, (words, value, unit), digits)?;
        self.hold.push(format!("{words}: at most {above}{unit}"));
        self.fail.push(format!("{words}: at most {below}{unit}"));
        Ok(())
    }

    /// Adds a bound of which the lower end is the one that holds.
    pub(super) fn at_least(
        &mut self,
        d: &mut Derivation,
        (words, value, unit): (&str, &Ball, &str),
        digits: usize,
    ) -> Proof {
        let (below, above) = neighbours(d, (words, value, unit), digits)?;
        self.hold.push(format!("{words}: at least {below}{unit}"));
        self.fail.push(format!("{words}: at least {above}{unit}"));
        Ok(())
    }

    /// Notes a number with which the sentence holds besides.
    pub(super) fn holds(&mut self, words: &str) {
        self.hold.push(words.to_owned());
    }

    /// Notes where the sentence fails besides.
    pub(super) fn fails(&mut self, words: &str) {
        self.fail.push(words.to_owned());
    }

    /// The values as bounds that hold, next to such as do not.
    pub(super) fn finding(self) -> Finding {
        Finding::Measured {
            holds_with: self.hold.join("; "),
            fails_with: Some(self.fail.join("; ")),
        }
    }
}

/// An angle in degrees.
pub(super) fn in_degrees(angle: &Ball) -> Ball {
    angle.clone() * angle.int(180) / angle.pi()
}

/// The decimals of few significant digits between which a value is proved to lie.
fn neighbours(
    d: &mut Derivation,
    (words, value, unit): (&str, &Ball, &str),
    digits: usize,
) -> Proof<(String, String)> {
    let rounded = Rounded::from_ball(value, digits)
        .ok_or_else(|| Undecided::new(format!("{words}: no digits")))?;
    let near = |decimal: &Decimal| Ball::enclosing(&decimal.to_rational(), value.prec());
    let (below, above) = (&rounded.lower, &rounded.upper);
    let found = format!("{words} is between {below}{unit} and {above}{unit}");
    let further = value.clone() + near(above) - near(below);
    d.certain(Support::Balls, found, [value, &further], |value| {
        Ok(near(below).is_less_than(value).and(value.is_less_than(&near(above))))
    })?;
    Ok((below.to_string(), above.to_string()))
}
