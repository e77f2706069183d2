//! A part of a branch, of one kind, proved between two points.

use super::super::section::Section;
use super::admissible::is_admissible;
use super::kind::over_vertical_force;
use super::meeting::Meeting;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::Undecided;
use crate::number::Ball;

/// A part of a branch, of one kind.
///
/// Guaranteed, where [`is_admissible`](Self::is_admissible) and no piece is a gap: for **each** vertical force
/// between those of the two ends there is exactly one solution of the equations in the tube, and it is admissible
/// at every joint of the whole arch, with a motion of its kind whose rates are not negative: a solution of Eq.
/// (19).
#[derive(Clone, Debug)]
pub struct Stretch {
    /// The kind.
    pub kind: AsymmetricMode,
    /// Section of the curve, from the smaller vertical force to the larger one.
    pub section: Section,
    /// True if the branch runs to smaller vertical forces.
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
        let ends = [&low.crossing, &high.crossing];
        let section = Section::between(form, ends, tolerance).map_err(about)?;
        let admissible =
            is_admissible(kind, &section.form, &section.walk, [low, high]).map_err(about);
        Ok(Self { kind, section, falls, admissible })
    }

    /// Tells whether the branch runs from the larger vertical force to the smaller one.
    pub fn falls(&self) -> bool {
        self.falls
    }

    /// Checks that every state of it is proved to be admissible, and says where that failed.
    pub fn is_admissible(&self) -> Result<(), &Undecided> {
        self.admissible.as_ref().copied()
    }

    /// Tells whether nothing is left open.
    pub fn is_proved(&self) -> bool {
        self.admissible.is_ok() && self.section.pieces().all(|piece| piece.is_proved())
    }
}
