//! Numbers where a sentence has none: proved bounds in few digits.

use super::{Checked, Derivation, Support};
use crate::certify::Undecided;
use crate::number::{Ball, Decimal, Enclosure, Rounded};

/// A value with its words and its unit.
type MeasuredValue<'a> = (&'a str, &'a Ball, &'a str);

/// Bounds of values in a derivation: decimals next to each, between which it is proved to lie.
pub(super) struct MeasuredBounds<'a> {
    pub(super) d: &'a mut Derivation,
    hold: Vec<String>,
    fail: Vec<String>,
}

impl<'a> MeasuredBounds<'a> {
    /// No bounds yet.
    pub(super) fn new(d: &'a mut Derivation) -> Self {
        Self { d, hold: Vec::new(), fail: Vec::new() }
    }

    /// Checks between which neighbours of few significant digits a positive value lies; the upper one is
    /// noted as a bound that holds.
    pub(super) fn at_most(&mut self, value: MeasuredValue<'_>, digits: usize) -> Checked {
        let [below, above] = neighbours(self.d, value, digits)?;
        self.note(value, "at most", [above, below])
    }

    /// Adds a bound of which the lower end is the one that holds.
    pub(super) fn at_least(&mut self, value: MeasuredValue<'_>, digits: usize) -> Checked {
        let ends = neighbours(self.d, value, digits)?;
        self.note(value, "at least", ends)
    }

    fn note(
        &mut self,
        (words, _, unit): MeasuredValue<'_>,
        is: &str,
        ends: [Decimal; 2],
    ) -> Checked {
        let [holds, fails] = ends.map(|end| format!("{words}: {is} {end}{unit}"));
        self.hold.push(holds);
        self.fail.push(fails);
        Ok(())
    }

    /// Notes a number with which the sentence holds besides. It may end a proof, as a conclusion does.
    pub(super) fn holds(&mut self, words: &str) -> Checked {
        self.hold.push(words.to_owned());
        Ok(())
    }

    /// Notes where the sentence fails besides.
    pub(super) fn fails(&mut self, words: &str) -> Checked {
        self.fail.push(words.to_owned());
        Ok(())
    }

    /// The bounds that hold, and those next to them that do not.
    pub(super) fn texts(self) -> [String; 2] {
        [self.hold, self.fail].map(|bounds| bounds.join("; "))
    }
}

/// A value to some significant digits.
pub(super) fn shown(value: &Ball, digits: usize) -> Checked<String> {
    let rounded = Rounded::from_ball(value, digits);
    rounded.map_or_else(|| Err(Undecided::new("no digits")), |r| Ok(r.value.to_string()))
}

/// The decimals of few significant digits between which a value is proved to lie.
fn neighbours(
    d: &mut Derivation,
    (words, value, unit): MeasuredValue<'_>,
    digits: usize,
) -> Checked<[Decimal; 2]> {
    let rounded = Rounded::from_ball(value, digits)
        .ok_or_else(|| Undecided::new(format!("{words}: no digits")))?;
    let near = |decimal: &Decimal| Ball::enclosing(&decimal.to_rational(), value.prec());
    let ends @ [below, above] = &[rounded.lower, rounded.upper];
    let found = format!("{words} is between {below}{unit} and {above}{unit}");
    let further = value.clone() + near(above) - near(below);
    d.certain(Support::Balls, found, [value, &further], |value| {
        Ok(near(below).is_less_than(value).and(value.is_less_than(&near(above))))
    })?;
    Ok(ends.clone())
}
