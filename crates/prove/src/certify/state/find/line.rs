//! Boundaries where one mode becomes another: a point of a line of the map.

use super::widest::in_range;
use crate::arch::{Configuration, Unknown};
use crate::certify::state::query::Query;
use crate::number::{Ball, Field};
use crate::problem::{Condition, Examined, Landmark, Line, Mode, Sought};
use crate::prover::Undecided;
use crate::prover::decide::{require, require_condition};
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
    let given = match sought {
        Sought::HalfOpening => &query.given.friction,
        Sought::Friction => &query.given.half_opening.rad,
    };
    let given = Float::with_val(query.bits, given.mid());
    let system = line.system(query.weight, sought);
    let start = start::on_line(query.weight, line, sought, &given);
    let at = query.root(system, &system.values(&start)).map_err(|open| none(line, &open))?;
    in_range(&at)?;
    require(&at.friction, "a positive friction")?;
    // No state of the half opening has a larger thrust: then beta_s grows with it along all of them.
    if (line, sought) == (Line::Joints, Sought::Friction) {
        let slides = Mode::Sliding.system(query.weight);
        let slides = query.root(slides, &start::sliding(&query.alpha()))?;
        require(&slides.friction, "a positive purely sliding friction")?;
        let rest = slides.thrust.int(1) - slides.thrust.int(2) * &slides.thrust;
        require(&rest, "a thrust below one half")?;
    }
    for (mode, tie) in line.modes().into_iter().zip(line.ties()) {
        if mode == Mode::Sliding {
            let margin = at.half_opening.rad.clone() - &at.sliding_joint.rad;
            require(&margin, Condition::Below(Unknown::SlidingJoint).label())?;
            continue;
        }
        let state = Examined::new(query.weight, mode, &at);
        for condition in Condition::of(mode, true).filter(|condition| Some(*condition) != tie) {
            let proved = require_condition(condition, &state.margin(condition), mode);
            proved.map_err(|open| none(line, &open))?;
        }
    }
    Ok(at)
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
