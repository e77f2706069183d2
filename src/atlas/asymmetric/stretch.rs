//! A part of a branch, of one kind, proved between two points.

use super::super::form::Form;
use super::super::part::chained;
use super::super::place::Place;
use super::super::trace::{Piece, Point, pieces_of, points_of};
use super::super::walk::Walk;
use super::admissible::is_admissible;
use super::kind::over_vertical_force;
use super::meeting::Meeting;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::Undecided;
use crate::number::Ball;

/// A part of a branch, of one kind.
///
/// Guaranteed, where [`is_admissible`](Self::is_admissible) and no piece is a gap: for **each** vertical force between those of the two
/// ends there is exactly one solution of the equations in the tube, and it is admissible at every joint of the
/// whole arch, with a motion of its kind whose rates are not negative: a solution of Eq. (19).
#[derive(Clone, Debug)]
pub struct Stretch {
    /// The kind.
    pub kind: AsymmetricMode,
    /// From the smaller vertical force to the larger one.
    form: Form,
    walk: Walk,
    ends: [Place; 2],
    /// Whether the branch runs to smaller vertical forces.
    falls: bool,
    admissible: Result<(), Undecided>,
}

impl Stretch {
    /// The part between two meetings, in the direction of the branch, whose vertical forces grow or fall.
    pub(super) fn between(
        kind: AsymmetricMode,
        half_opening: &Ball,
        [from, to]: [&Meeting; 2],
        falls: bool,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let form = over_vertical_force(kind, from.crossing.form.weight, half_opening);
        let [low, high] = if falls { [to, from] } else { [from, to] };
        let about = |undecided: Undecided| undecided.about(kind.name());
        let walk = chained(&form, &low.crossing, Some(&high.crossing), tolerance).map_err(about)?;
        let admissible = is_admissible(kind, &form, &walk, [low, high]).map_err(about);
        let ends = [low.place(), high.place()];
        Ok(Self { kind, form, walk, ends, falls, admissible })
    }

    /// The pieces over the vertical force, from the smaller to the larger one, gaps among them.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        pieces_of(&self.form, &self.walk)
    }

    /// The nodes in the same order; those at the ends are the ends themselves.
    pub fn points(&self) -> Vec<Point> {
        let mut points = points_of(&self.form, &self.walk);
        for (point, place) in [(0, &self.ends[0]), (points.len() - 1, &self.ends[1])] {
            points[point].place = place.clone();
        }
        points
    }

    /// The quantities of its ends, the smaller vertical force first.
    pub fn ends(&self) -> &[Place; 2] {
        &self.ends
    }

    /// Whether the branch runs from the larger vertical force to the smaller one.
    pub fn falls(&self) -> bool {
        self.falls
    }

    /// Whether every state of it is proved to be admissible; else where that failed.
    pub fn is_admissible(&self) -> Result<(), &Undecided> {
        self.admissible.as_ref().copied()
    }

    /// Whether nothing is left open.
    pub fn is_proved(&self) -> bool {
        self.admissible.is_ok() && self.pieces().all(|piece| piece.is_proved())
    }
}
