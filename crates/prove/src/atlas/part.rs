//! The part of a line of one half opening, thickness or friction in the domain of one mode: a chain of proved pieces
//! between the points in which it meets the lines to the next modes, or straight.

use super::crossing::{BITS, Crossing};
use super::form::{Form, Joint, Thrust};
use super::law::Law;
use super::place::Place;
use super::section::Section;
use super::trace::{Piece, Point};
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
    course: Course,
}

/// How a part runs between its ends.
#[derive(Clone, Debug)]
enum Course {
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
        Ok(Self { mode, course: Course::Curved(section) })
    }

    /// The line of pure sliding: from where it begins up to the physical limit.
    pub(super) fn upright(foot: &Crossing) -> Self {
        let from = foot.place();
        let thickness = Some(Ball::integer(2, BITS));
        let to = Place { thickness, rotation_joint: None, ..from.clone() };
        Self { mode: Mode::Sliding, course: Course::Straight([from, to]) }
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
        Self { mode: Mode::Rotational, course: Course::Straight([from, to]) }
    }

    /// The quantities at a friction angle, of a part that is traced by it or that is the same for all of them; `None`
    /// elsewhere.
    fn at_friction_angle(&self, phi: &Ball) -> Option<Place> {
        match &self.course {
            Course::Straight([end, _]) => {
                let from = end.friction_angle.as_ref()?;
                let is_here = self.mode == Mode::Rotational && !phi.is_less_than(from).is_proved();
                is_here.then(|| end.clone())
            }
            Course::Curved(section) if section.form.parameter == Variable::FrictionAngle => {
                let piece = section.pieces().find(|piece| {
                    let [low, high] = piece.range();
                    phi.lower() >= low && phi.upper() <= high
                })?;
                Some(Crossing::in_tube(&section.form, piece.tube()?, phi)?.place())
            }
            Course::Curved(_) => None,
        }
    }

    /// The quantities at a friction angle on one of some parts that follow each other.
    pub(super) fn among(parts: &[Self], phi: &Ball) -> Option<Place> {
        parts.iter().find_map(|part| part.at_friction_angle(phi))
    }

    /// The quantities of its two ends.
    pub fn ends(&self) -> &[Place; 2] {
        match &self.course {
            Course::Straight(ends) => ends,
            Course::Curved(section) => section.ends(),
        }
    }

    /// The nodes; of a straight part its two ends.
    pub fn points(&self) -> Vec<Point> {
        let end = |place: &Place| Point { parameter: f64::NAN, end: None, place: place.clone() };
        match &self.course {
            Course::Straight(ends) => ends.iter().map(end).collect(),
            Course::Curved(section) => section.points(),
        }
    }

    /// What it is traced by; nothing where it is straight.
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
            Course::Straight(_) => None,
            Course::Curved(section) => Some(section),
        }
    }
}

/// The equations of a mode with what is given.
fn form(mode: Mode, weight: SelfWeight, (fixed, value): (Variable, &Ball)) -> Form {
    use {Law as L, Variable as V};
    let turns = matches!(mode, Mode::RotationalSliding | Mode::RotationalSlidingRotational);
    let (laws, thrust): (&[L], Thrust) = match mode {
        Mode::SlidingRotational => (&[L::Tangency, L::Touching], Thrust::Shoulder),
        _ if turns => (&[L::Cycloid, L::Tangency, L::Upper], Thrust::Sliding),
        _ => (&[L::Cycloid, L::Upper], Thrust::Sliding),
    };
    let (parameter, unknowns): (V, &[V]) = match (mode, fixed) {
        (Mode::SlidingRotational, V::HalfOpening) => {
            (V::FrictionAngle, &[V::JointSquare, V::Thickness])
        }
        (Mode::SlidingRotational, V::Thickness) => {
            (V::FrictionAngle, &[V::JointSquare, V::HalfOpening])
        }
        (Mode::SlidingRotational, _) => (V::HalfOpening, &[V::JointSquare, V::Thickness]),
        (_, V::HalfOpening) if turns => {
            (V::Inclination, &[V::FrictionAngle, V::JointSquare, V::Thickness])
        }
        (_, V::HalfOpening) => (V::Inclination, &[V::FrictionAngle, V::Thickness]),
        (_, V::Thickness) if turns => {
            (V::Inclination, &[V::FrictionAngle, V::JointSquare, V::HalfOpening])
        }
        (_, V::Thickness) => (V::Inclination, &[V::FrictionAngle, V::HalfOpening]),
        _ if turns => (V::Thickness, &[V::Inclination, V::JointSquare, V::HalfOpening]),
        _ => (V::Thickness, &[V::Inclination, V::HalfOpening]),
    };
    let given = Some((fixed, value.clone()));
    Form { weight, parameter, unknowns, laws, thrust, joint: Joint::Crown, given }
}
