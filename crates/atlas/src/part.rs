//! The part of a line of one half opening, thickness or friction in the domain of one mode: a chain of proved pieces
//! between the points in which it meets the lines to the next modes, or straight.

use super::crossing::{BITS, Crossing, in_tube};
use super::form::{CurveForm, Thrust};
use super::law::Law;
use super::place::Place;
use super::section::Section;
use super::trace::{Piece, TracePoint};
use super::variable::Variable;
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, Field, Real};
use crate::problem::Mode;

/// The part of a line in the domain of one mode.
#[derive(Clone, Debug)]
pub struct Part {
    /// The mode.
    pub mode: Mode,
    course: PartShape,
}

/// Shape of a part between its ends.
#[derive(Clone, Debug)]
enum PartShape {
    Straight([Place; 2]),
    Curved(Section),
}

impl Part {
    /// The line of a mode from one crossing to another, or to unlimited friction.
    pub(super) fn between(
        mode: Mode,
        given: (Variable, &Ball),
        from: &Crossing,
        to: Option<&Crossing>,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let form = form(mode, from.form.weight, given);
        let section = match to {
            Some(to) => Section::between(form, [from, to], tolerance),
            None => Section::to_unlimited_friction(form, from, tolerance),
        };
        let section = section.map_err(|undecided| undecided.about(&mode.to_string()))?;
        Ok(Self { mode, course: PartShape::Curved(section) })
    }

    /// The line of pure sliding: from where it begins up to the physical limit.
    pub(super) fn upright(foot: &Crossing) -> Self {
        let from = foot.place();
        let thickness = Some(Ball::integer(2, BITS));
        let to = Place { thickness, rotation_joint: None, ..from.clone() };
        Self { mode: Mode::Sliding, course: PartShape::Straight([from, to]) }
    }

    /// The line of pure rotation: from where it begins to unlimited friction.
    pub(super) fn level(begin: &Crossing) -> Self {
        let from = Place { sliding_joint: None, ..begin.place() };
        let alpha = begin.value(Variable::HalfOpening);
        let right_angle = alpha.pi() / alpha.int(2);
        let to = Place {
            friction_angle: Some(right_angle),
            friction: Some(Ball::whole(BITS)),
            is_unlimited: true,
            ..from.clone()
        };
        Self { mode: Mode::Rotational, course: PartShape::Straight([from, to]) }
    }

    /// The quantities at a friction angle, of a part that is traced by it or that is the same for all of them; `None`
    /// elsewhere.
    fn at_friction_angle(&self, phi: &Ball) -> Option<Place> {
        match &self.course {
            PartShape::Straight([end, _]) => {
                let from = end.friction_angle.as_ref()?;
                let is_here = self.mode == Mode::Rotational && !phi.is_less_than(from).is_proved();
                is_here.then(|| end.clone())
            }
            PartShape::Curved(section) if section.form.parameter == Variable::FrictionAngle => {
                let piece = section.pieces().find(|piece| {
                    let [low, high] = piece.range();
                    phi.lower() >= low && phi.upper() <= high
                })?;
                in_tube(&section.form, piece.tube?, phi, BITS).ok()
            }
            PartShape::Curved(_) => None,
        }
    }

    /// The quantities at a friction angle on one of some parts that follow each other.
    pub(super) fn among(parts: &[Self], phi: &Ball) -> Option<Place> {
        parts.iter().find_map(|part| part.at_friction_angle(phi))
    }

    /// The quantities of its two ends.
    pub fn ends(&self) -> &[Place; 2] {
        match &self.course {
            PartShape::Straight(ends) => ends,
            PartShape::Curved(section) => section.ends(),
        }
    }

    /// The nodes; of a straight part its two ends.
    pub fn points(&self) -> Vec<TracePoint> {
        let end =
            |place: &Place| TracePoint { parameter: f64::NAN, end: None, place: place.clone() };
        match &self.course {
            PartShape::Straight(ends) => ends.iter().map(end).collect(),
            PartShape::Curved(section) => section.points(),
        }
    }

    /// Variable by which it is traced; nothing where it is straight.
    pub fn parameter(&self) -> Option<Variable> {
        self.section().map(|section| section.form.parameter)
    }

    /// The pieces, gaps among them; a straight part has none.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        self.section().into_iter().flat_map(Section::pieces)
    }

    /// The line, unless it is straight.
    fn section(&self) -> Option<&Section> {
        match &self.course {
            PartShape::Straight(_) => None,
            PartShape::Curved(section) => Some(section),
        }
    }
}

/// The equations with what is given of a mode in which a joint slides.
fn form(mode: Mode, weight: SelfWeight, (fixed, value): (Variable, &Ball)) -> CurveForm {
    use {Law as L, Variable as V};
    let (slides, has_haunch) = (mode.slides_inside(), mode.has_haunch());
    let (laws, thrust): (&[L], Thrust) = match (slides, has_haunch) {
        (false, _) => (&[L::Tangency, L::Touching], Thrust::Shoulder),
        (true, true) => (&[L::Cycloid, L::Tangency, L::Upper], Thrust::Sliding),
        (true, false) => (&[L::Cycloid, L::Upper], Thrust::Sliding),
    };
    let (parameter, force, last) = match (slides, fixed) {
        (false, V::HalfOpening) => (V::FrictionAngle, None, V::Thickness),
        (false, V::Thickness) => (V::FrictionAngle, None, V::HalfOpening),
        (false, _) => (V::HalfOpening, None, V::Thickness),
        (true, V::HalfOpening) => (V::Inclination, Some(V::FrictionAngle), V::Thickness),
        (true, V::Thickness) => (V::Inclination, Some(V::FrictionAngle), V::HalfOpening),
        (true, _) => (V::Thickness, Some(V::Inclination), V::HalfOpening),
    };
    let joint = (has_haunch || !slides).then_some(V::JointSquare);
    let unknowns: Vec<V> = force.into_iter().chain(joint).chain([last]).collect();
    let given = Some((fixed, value.clone()));
    CurveForm { thrust, given, ..CurveForm::new(weight, parameter, &unknowns, laws) }
}
