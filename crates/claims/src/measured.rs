//! Numbers where a sentence has none: proved bounds in few digits.

use super::{Checked, Derivation, Support};
use crate::certify::Undecided;
use crate::number::{Ball, Decimal, Enclosure, Rounded};

/// A value with its words and its unit.
type MeasuredValue<'a> = (&'a str, &'a Ball, &'a str);

/// Checks between which neighbours of few significant digits a positive value lies; the upper one is noted as a
/// bound that holds.
pub(super) fn at_most(d: &mut Derivation, value: MeasuredValue<'_>, digits: usize) -> Checked {
    let [below, above] = neighbours(d, value, digits)?;
    note(d, value, "at most", [above, below])
}

/// Checks the same, and notes the lower one as the bound that holds.
pub(super) fn at_least(d: &mut Derivation, value: MeasuredValue<'_>, digits: usize) -> Checked {
    let ends = neighbours(d, value, digits)?;
    note(d, value, "at least", ends)
}

fn note(
    d: &mut Derivation,
    (words, _, unit): MeasuredValue<'_>,
    is: &str,
    ends: [Decimal; 2],
) -> Checked {
    let [holds, fails] = ends.map(|end| format!("{words}: {is} {end}{unit}"));
    d.holds(holds)?;
    d.fails(fails)
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
