//! Boundaries where one mode becomes another: a point of a line of the map, or a proof that it has none.
//!
//! A line is one curve without a gap between two landmarks, on which each half opening is there once at most, and each
//! friction: both are monotone along it. So beyond the values at its ends it has no point.

use super::widest::in_range;
use crate::arch::{Configuration, Unknown};
use crate::certify::CertifiedLandmark;
use crate::certify::state::query::Query;
use crate::number::{Ball, Enclosure, Field, Rounded};
use crate::problem::{Condition, Examined, Landmark, Line, Mode, Quantity, Sought};
use crate::prover::Undecided;
use crate::prover::decide::{in_few_bits, require, require_condition};
use crate::solve::start;
use rug::Float;

/// The point of a line where `query` has the half opening or the friction, and the other is `sought`: the
/// equations of both modes hold, each condition that is not zero by them is positive, and so the state is that
/// of the arch from either side.
pub(super) fn point_on(
    query: &Query,
    line: Line,
    sought: Sought,
) -> Result<Configuration<Ball>, Undecided> {
    let given = Float::with_val(query.bits, given(query, sought).mid());
    let system = line.system(query.weight, sought);
    let start = start::on_line(query.weight, line, sought, &given);
    let at = query.root(system, &system.values(&start)).map_err(|open| none(line, &open))?;
    in_few_bits(&at, query.bits, |at, bits| {
        let query = Query { bits, given: at.clone(), ..*query };
        is_on_line(&query, line, sought)
    })?;
    Ok(at)
}

/// Value of the half opening or the friction, the one of the two that is not sought.
fn given(query: &Query, sought: Sought) -> &Ball {
    match sought {
        Sought::HalfOpening => &query.given.friction,
        Sought::Friction => &query.given.half_opening.rad,
    }
}

/// Proves that the root in `query` is the point of the line.
fn is_on_line(query: &Query, line: Line, sought: Sought) -> Result<(), Undecided> {
    let at = &query.given;
    in_range(at)?;
    require(&at.friction, "a positive friction")?;
    // No state of the half opening has a larger thrust: then beta_s grows with it along all of them.
    if (line, sought) == (Line::Joints, Sought::Friction) {
        let slides = Mode::Sliding.system(query.weight);
        let slides = query.root(slides, &start::sliding(&query.alpha()))?;
        require(&slides.friction, "a positive purely sliding friction")?;
        let rest = slides.thrust.int(1) - slides.thrust.int(2) * &slides.thrust;
        require(&rest, "whether it is the only such friction")?;
    }
    for (mode, tie) in line.modes().into_iter().zip(line.ties()) {
        if mode == Mode::Sliding {
            let margin = at.half_opening.rad.clone() - &at.sliding_joint.rad;
            require(&margin, Condition::Below(Unknown::SlidingJoint).label())?;
            continue;
        }
        let state = Examined::new(query.weight, mode, at);
        for condition in Condition::of(mode, true).filter(|condition| Some(*condition) != tie) {
            let proved = require_condition(condition, &state.margin(condition), mode);
            proved.map_err(|open| none(line, &open))?;
        }
    }
    Ok(())
}

/// Digits of the values at the ends of a line.
const DIGITS: usize = 10;

/// The ends of a line in words, if the half opening or the friction of `query` is proved to be beyond them; the other
/// of the two is sought.
pub(super) fn beyond(
    query: &Query,
    line: Line,
    sought: Sought,
) -> Result<Option<String>, Undecided> {
    let value = given(query, sought);
    let quantity = match sought {
        Sought::HalfOpening => Quantity::Friction,
        Sought::Friction => Quantity::HalfOpening,
    };
    // At the end of rotation the friction is infinite.
    let end = |landmark: Option<Landmark>| match landmark {
        None => Ok(Some(value.int(0))),
        Some(landmark) => {
            let of = CertifiedLandmark::new(landmark, query.weight)?.enclosure(0)?;
            Ok::<_, Undecided>(of.quantity(quantity))
        }
    };
    let [from, to] = line.ends();
    let ends = [end(from)?, end(to)?];
    let is_below =
        |end: &Option<Ball>| end.as_ref().is_none_or(|end| value.is_less_than(end).is_proved());
    let is_above =
        |end: &Option<Ball>| end.as_ref().is_some_and(|end| end.is_less_than(value).is_proved());
    let is_beyond = ends.iter().all(is_below) || ends.iter().all(is_above);
    let name = quantity.name().replace('_', " ");
    let words = |landmark: Option<Landmark>, end: &Option<Ball>| match (landmark, end) {
        (None, _) => "a half opening of zero".to_owned(),
        (Some(landmark), end) => {
            let rounded = end.as_ref().and_then(|end| Rounded::from_ball(end, DIGITS));
            let value = rounded.map_or("inf".to_owned(), |x| x.value.to_string());
            format!("{} (at the {name} {value})", landmark.symbol())
        }
    };
    let [first, last] = &ends;
    Ok(is_beyond.then(|| format!("{} to {}", words(from, first), words(to, last))))
}

/// Undecided answer where no point of the line is found.
fn none(line: Line, open: &Undecided) -> Undecided {
    let ends = line.ends().map(|end| end.map_or("a half opening of zero", Landmark::symbol));
    let [from, to] = ends;
    let reason = format!(
        "no point of the line {line} is found there (it runs from {from} to {to}): {}",
        open.reason
    );
    Undecided { reason: reason.into(), ..open.clone() }
}
