//! A proved line from one point to another: nodes and tubes of one form.

use super::crossing::Crossing;
use super::form::CurveForm;
use super::place::Place;
use super::trace::{Piece, TracePoint, pieces_of, points_of};
use super::walk::{Walk, walk};
use crate::certify::Undecided;
use crate::number::{Ball, Field, Real};
use rug::float::Round;

/// A proved line from one point to another.
#[derive(Clone, Debug)]
pub struct Section {
    pub(super) form: CurveForm,
    pub(super) walk: Walk,
    pub(super) ends: [Place; 2],
}

impl Section {
    /// The line from one point to another; both are proved to be on it.
    pub(super) fn between(
        form: CurveForm,
        [from, to]: [&Crossing; 2],
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let walk = chained(&form, from, Some(to), tolerance)?;
        Ok(Self { form, walk, ends: [from.place(), to.place()] })
    }

    /// The line from a point to unlimited friction, whose parameter is the friction angle; the point is proved to
    /// be on it.
    pub(super) fn to_unlimited_friction(
        form: CurveForm,
        from: &Crossing,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let walk = chained(&form, from, None, tolerance)?;
        let end = right_angle(from, &form);
        let at_end = match walk.tubes.last() {
            Some(Some(tube)) => {
                let place = Place::new(&form, &end, &tube.enclosure(&end));
                Place { is_unlimited: true, ..place }
            }
            _ => Place::default(),
        };
        Ok(Self { form, walk, ends: [from.place(), at_end] })
    }

    /// The pieces over the parameter, gaps among them.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        pieces_of(&self.form, &self.walk)
    }

    /// The nodes; those at the ends are the ends themselves.
    pub fn points(&self) -> Vec<TracePoint> {
        let mut points = points_of(&self.form, &self.walk);
        for (point, place) in [(0, &self.ends[0]), (points.len() - 1, &self.ends[1])] {
            points[point].place = place.clone();
        }
        points
    }

    /// The quantities of its two ends, in the order of the parameter.
    pub fn ends(&self) -> &[Place; 2] {
        &self.ends
    }

    /// The largest half-width of a tube.
    pub fn width(&self) -> f64 {
        self.pieces().filter_map(|piece| piece.width()).fold(0.0, f64::max)
    }

    /// Tells whether a piece is not proved.
    pub fn has_gap(&self) -> bool {
        self.pieces().any(|piece| !piece.is_proved())
    }
}

fn right_angle(from: &Crossing, form: &CurveForm) -> Ball {
    let start = from.value(form.parameter);
    start.pi() / start.int(2)
}

/// Nodes and tubes of a form from one point to another, or to the right angle of unlimited friction: both points are
/// proved to be on it.
fn chained(
    form: &CurveForm,
    from: &Crossing,
    to: Option<&Crossing>,
    tolerance: f64,
) -> Result<Walk, Undecided> {
    let start = from.value(form.parameter);
    let end = to.map_or_else(|| right_angle(from, form), |to| to.value(form.parameter));
    let guess = form.unknowns.iter().map(|u| from.value(*u).mid().to_f64()).collect();
    // Rounding downward makes a zero negative.
    let [low, high] =
        [start.lower().to_f64_round(Round::Down) + 0.0, end.upper().to_f64_round(Round::Up)];
    let walk = walk(form, low, guess, (high, high), tolerance)
        .ok_or_else(|| Undecided::new("a node cannot be proved"))?;
    let meets = |crossing: &Crossing, is_first| {
        walk.reaches(form, |variable| crossing.value(variable), is_first)
    };
    match meets(from, true) && to.is_none_or(|to| meets(to, false)) {
        true => Ok(walk),
        false => Err(Undecided::new("it is not proved to meet the next line")),
    }
}
