//! The quantities of a point of a curve.

use super::form::{CurveForm, Thrust};
use super::law::Law;
use super::variable::Variable;
use crate::arch::cycloid;
use crate::number::{Ball, Field, Real, Stumpff};

/// Enclosures of the quantities of a point of a curve. One that the curve leaves open is not there: the friction of
/// purely rotational states, the thickness of purely sliding ones.
#[derive(Clone, Debug, Default)]
pub struct Place {
    /// `alpha`, rad.
    pub half_opening: Option<Ball>,
    /// `phi`, rad.
    pub friction_angle: Option<Ball>,
    /// `mu = tan phi`; the whole line where the friction angle may be a right one.
    pub friction: Option<Ball>,
    /// True if the friction is unlimited, exactly.
    pub is_unlimited: bool,
    /// `eta`.
    pub thickness: Option<Ball>,
    /// `h`.
    pub thrust: Option<Ball>,
    /// `beta_r`, rad.
    pub rotation_joint: Option<Ball>,
    /// `beta_s`, rad.
    pub sliding_joint: Option<Ball>,
    /// `v`, of an asymmetric state.
    pub vertical_force: Option<Ball>,
    /// `b0`, rad, of an asymmetric state, whose haunch is the rotational joint.
    pub crown_hinge: Option<Ball>,
}

impl Place {
    /// The quantities where the parameter and the unknowns lie in these sets.
    pub(super) fn new(form: &CurveForm, s: &Ball, x: &[Ball]) -> Self {
        Self::by(form, s, x, Ball::clone, |x| x)
    }

    /// The quantities by way of other numbers, which perhaps know some sines.
    pub(super) fn by<T: Real + Stumpff>(
        form: &CurveForm,
        s: &Ball,
        x: &[Ball],
        number: impl Fn(&Ball) -> T,
        ball: impl Fn(T) -> Ball,
    ) -> Self {
        let x: Vec<T> = x.iter().map(&number).collect();
        let at = form.spot(&number, &number(s), &x);
        let is_overturning = form.thrust == Thrust::Zero;
        let slides_purely = !form.knows(Variable::Thickness) && !form.fixes_limit();
        let friction_angle = match form.knows(Variable::FrictionAngle) {
            true => Some(at.friction_angle.clone()),
            false => is_overturning.then(|| number(&(s.pi() / s.int(2)))),
        };
        let friction = friction_angle.as_ref().map(|phi| {
            let (sin, cos) = phi.sin_cos();
            ball(sin / cos)
        });
        let slides = |law| matches!(law, &Law::Cycloid | &Law::InnerSlides);
        let slides_inside = form.thrust == Thrust::Sliding && form.laws.iter().any(slides);
        Self {
            half_opening: Some(ball(at.half_opening)),
            friction_angle: friction_angle.map(&ball),
            friction,
            is_unlimited: is_overturning,
            thickness: (!slides_purely).then(|| ball(at.thickness)),
            thrust: Some(ball(at.thrust)),
            rotation_joint: match form.has_haunch() {
                true => Some(root_of_square(&ball(at.joint_square))),
                false => (!slides_purely).then(|| s.int(0)),
            },
            sliding_joint: slides_inside
                .then(|| ball(cycloid::joint(&at.inclination) - &at.vertical_force)),
            vertical_force: form.knows(Variable::VerticalForce).then(|| ball(at.vertical_force)),
            crown_hinge: form.knows(Variable::CrownHinge).then(|| ball(at.crown_hinge)),
        }
    }

    /// The coordinate of a plane.
    pub fn coordinate(&self, variable: Variable) -> Option<&Ball> {
        match variable {
            Variable::HalfOpening => self.half_opening.as_ref(),
            Variable::FrictionAngle => self.friction_angle.as_ref(),
            Variable::Thickness => self.thickness.as_ref(),
            _ => None,
        }
    }
}

/// The root of what is known not to be negative, though its enclosure may reach below zero.
pub(super) fn root_of_square(square: &Ball) -> Ball {
    if square.lower() >= 0 {
        return square.sqrt();
    }
    let upper = Ball::exact(square.upper(), square.prec());
    let zero = square.int(0);
    if upper.mid() <= &0 { zero } else { upper.sqrt().hull(&zero) }
}
