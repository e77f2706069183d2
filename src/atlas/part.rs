//! The part of a line of one half opening, thickness or friction in the domain of one mode: a chain of proved pieces
//! between the points in which it meets the lines to the next modes, or straight.

use super::crossing::{BITS, Crossing};
use super::form::{Form, Joint, Thrust};
use super::law::Law;
use super::place::Place;
use super::trace::{Piece, Point, pieces_of, points_of};
use super::variable::Variable;
use super::walk::{Walk, walk};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, Field, Real};
use crate::problem::Mode;
use rug::float::Round;

/// The part of a line in the domain of one mode.
#[derive(Clone, Debug)]
pub struct Part {
    /// The mode.
    pub mode: Mode,
    ends: [Place; 2],
    /// Nothing where the part is straight.
    chain: Option<(Form, Walk)>,
}

impl Part {
    /// The chain of a mode from one crossing to another, or to unlimited friction.
    pub(super) fn between(
        mode: Mode,
        given: (Variable, &Ball),
        from: &Crossing,
        to: Option<&Crossing>,
        tolerance: f64,
    ) -> Result<Self, Undecided> {
        let form = form(mode, from.form.weight, given);
        let failed = |undecided: Undecided| undecided.about(&mode.to_string());
        let walk = chained(&form, from, to, tolerance).map_err(failed)?;
        let end = given.1.pi() / given.1.int(2);
        let at_end = match (to, walk.tubes.last()) {
            (Some(to), _) => to.place(),
            (None, Some(Some(tube))) => {
                let place = Place::new(&form, &end, &tube.enclosure(&end));
                Place { is_unlimited: true, ..place }
            }
            (None, _) => Place::default(),
        };
        Ok(Self { mode, ends: [from.place(), at_end], chain: Some((form, walk)) })
    }

    /// The line of pure sliding: from where it begins up to the physical limit.
    pub(super) fn upright(foot: &Crossing) -> Self {
        let from = foot.place();
        let thickness = Some(Ball::integer(2, BITS));
        let to = Place { thickness, rotation_joint: None, ..from.clone() };
        Self { mode: Mode::Sliding, ends: [from, to], chain: None }
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
        Self { mode: Mode::Rotational, ends: [from, to], chain: None }
    }

    /// The quantities at a friction angle, of a part that is traced by it or that is the same for all of them; `None`
    /// elsewhere.
    fn at_friction_angle(&self, phi: &Ball) -> Option<Place> {
        let Some((form, walk)) = &self.chain else {
            let from = self.ends[0].friction_angle.as_ref()?;
            let is_here = self.mode == Mode::Rotational && !phi.is_less_than(from).is_proved();
            return is_here.then(|| self.ends[0].clone());
        };
        if form.parameter != Variable::FrictionAngle {
            return None;
        }
        let mut pieces = pieces_of(form, walk);
        let piece = pieces.find(|piece| {
            let [low, high] = piece.range();
            phi.lower() >= low && phi.upper() <= high
        })?;
        Some(Crossing::in_tube(form, piece.tube()?, phi)?.place())
    }

    /// The quantities at a friction angle on one of some parts that follow each other.
    pub(super) fn among(parts: &[Self], phi: &Ball) -> Option<Place> {
        parts.iter().find_map(|part| part.at_friction_angle(phi))
    }

    /// The quantities of its two ends.
    pub fn ends(&self) -> &[Place; 2] {
        &self.ends
    }

    /// The nodes; of a straight part its two ends.
    pub fn points(&self) -> Vec<Point> {
        let end = |place: &Place| Point { parameter: f64::NAN, end: None, place: place.clone() };
        let Some((form, walk)) = &self.chain else { return self.ends.iter().map(end).collect() };
        let mut points = points_of(form, walk);
        for (point, place) in [(0, &self.ends[0]), (points.len() - 1, &self.ends[1])] {
            points[point].place = place.clone();
        }
        points
    }

    /// What it is traced by; nothing where it is straight.
    pub fn parameter(&self) -> Option<Variable> {
        self.chain.as_ref().map(|(form, _)| form.parameter)
    }

    /// The pieces, gaps among them; a straight part has none.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        self.chain.iter().flat_map(|(form, walk)| pieces_of(form, walk))
    }
}

/// Nodes and tubes of a form from one point to another, or to the right angle of unlimited friction: both points are
/// proved to be on it.
pub(super) fn chained(
    form: &Form,
    from: &Crossing,
    to: Option<&Crossing>,
    tolerance: f64,
) -> Result<Walk, Undecided> {
    let start = from.value(form.parameter);
    let quarter_turn = start.pi() / start.int(2);
    let end = to.map_or(quarter_turn, |to| to.value(form.parameter));
    let guess = form.unknowns.iter().map(|u| from.value(*u).mid().to_f64()).collect();
    // Rounding downward makes a zero negative.
    let [low, high] =
        [start.lower().to_f64_round(Round::Down) + 0.0, end.upper().to_f64_round(Round::Up)];
    let walk = walk(form, low, guess, high, tolerance)
        .ok_or_else(|| Undecided::new("a node cannot be proved"))?;
    let meets = |crossing: &Crossing, is_first: bool| {
        let tube = if is_first { walk.tubes.first() } else { walk.tubes.last() };
        let root: Vec<Ball> = form.unknowns.iter().map(|u| crossing.value(*u)).collect();
        let s = crossing.value(form.parameter);
        tube.and_then(Option::as_ref).is_some_and(|tube| tube.holds(&s, &root))
    };
    match meets(from, true) && to.is_none_or(|to| meets(to, false)) {
        true => Ok(walk),
        false => Err(Undecided::new("it is not proved to meet the next line")),
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
