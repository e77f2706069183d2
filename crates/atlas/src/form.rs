//! The curves' equations in forms that are regular on the whole curve, ends included.
//!
//! A form is a system with one unknown more than equations, one of which is taken as its parameter. The
//! printed equations have roots and vanishing quotients at the origin, at the crown and at unlimited friction;
//! the square of the rotational joint, the friction angle and the inclination of the force do not
//! ([`cycloid`](crate::arch::cycloid), [`haunch`](crate::arch::haunch)).

use super::law::Law;
use super::spot::{VariableValues, WholeState};
use super::variable::Variable;
use crate::arch::haunch::Haunch;
use crate::arch::{Ring, SelfWeight, cycloid, thrust};
use crate::number::{Angle, Ball, Real, Stumpff};

/// Source of the thrust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thrust {
    /// There is no thrust.
    Zero,
    /// An inner joint slides: (18).
    Sliding,
    /// The line of thrust touches the intrados: (5).
    Tangent,
    /// The shoulder slides: (17).
    Shoulder,
}

/// Place of the rotational joint, if it is no unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FixedJoint {
    /// The joint is at the crown.
    Crown,
    /// The joint is where an inner joint slides.
    Sliding,
}

/// A system with one unknown more than equations.
#[derive(Clone, Debug)]
pub(super) struct CurveForm {
    pub weight: SelfWeight,
    pub parameter: Variable,
    pub unknowns: Vec<Variable>,
    pub laws: Vec<Law>,
    pub thrust: Thrust,
    pub joint: FixedJoint,
    /// The variable that is the same throughout, with its value.
    pub given: Option<(Variable, Ball)>,
}

impl CurveForm {
    /// A system in which an inner joint slides and the rotational joint, if it is no unknown, is the crown.
    pub(super) fn new(
        weight: SelfWeight,
        parameter: Variable,
        unknowns: &[Variable],
        laws: &[Law],
    ) -> Self {
        let (thrust, joint) = (Thrust::Sliding, FixedJoint::Crown);
        let (unknowns, laws) = (unknowns.to_vec(), laws.to_vec());
        Self { weight, parameter, unknowns, laws, thrust, joint, given: None }
    }

    /// The parameter and the unknowns.
    pub(super) fn variables(&self) -> impl Iterator<Item = &Variable> {
        [&self.parameter].into_iter().chain(&self.unknowns)
    }

    /// A point of the curve by the values of its variables: the parameter and the unknowns.
    pub(super) fn point(&self, value: impl Fn(Variable) -> Ball) -> (Ball, Vec<Ball>) {
        (value(self.parameter), self.unknowns.iter().map(|unknown| value(*unknown)).collect())
    }

    /// Tells whether the variable is the parameter, an unknown or given.
    pub(super) fn knows(&self, variable: Variable) -> bool {
        self.parameter == variable || self.unknowns.contains(&variable) || self.gives(variable)
    }

    fn gives(&self, variable: Variable) -> bool {
        self.given.as_ref().is_some_and(|(given, _)| *given == variable)
    }

    /// The value of a variable among the parameter and the unknowns.
    pub(super) fn value<'a, T>(&self, variable: Variable, s: &'a T, x: &'a [T]) -> Option<&'a T> {
        match self.unknowns.iter().position(|unknown| *unknown == variable) {
            Some(index) => x.get(index),
            None => (self.parameter == variable).then_some(s),
        }
    }

    /// All variables at a parameter and values of the unknowns; `number` makes a number like these of what is
    /// given.
    pub(super) fn spot<T: Real + Stumpff>(
        &self,
        number: &impl Fn(&Ball) -> T,
        s: &T,
        x: &[T],
    ) -> VariableValues<T> {
        let given = |variable| {
            let given = self.given.as_ref().filter(|(given, _)| *given == variable);
            given.map(|(_, value)| number(value))
        };
        let known = |variable| self.value(variable, s, x).cloned().or_else(|| given(variable));
        let zero = s.int(0);
        let value = |variable| known(variable).unwrap_or_else(|| zero.clone());
        let inclination = match known(Variable::Inclination) {
            Some(chi) => Angle::new(chi),
            None => Angle::zero(s),
        };
        let joint_square = match (known(Variable::JointSquare), self.joint) {
            (Some(square), _) => square,
            (None, FixedJoint::Crown) => zero.clone(),
            (None, FixedJoint::Sliding) => cycloid::joint(&inclination).square(),
        };
        let haunch = self.haunch(s, &joint_square);
        let thickness = match self.fixes_limit() {
            true => s.int(2),
            false => value(Variable::Thickness),
        };
        let half_opening = value(Variable::HalfOpening);
        let friction_angle = value(Variable::FrictionAngle);
        let thrust = match self.thrust {
            Thrust::Zero => zero.clone(),
            Thrust::Sliding => cycloid::thrust(&inclination),
            Thrust::Shoulder => cycloid::shoulder_thrust(&half_opening, &friction_angle),
            Thrust::Tangent => {
                let ring = Ring::new(self.weight, &thickness);
                thrust::tangency(&haunch.times_cotangent, &ring).value()
            }
        };
        VariableValues {
            half_opening,
            friction_angle,
            inclination,
            joint_square,
            haunch,
            thickness,
            ratio: value(Variable::Ratio),
            opening_ratio: value(Variable::OpeningRatio),
            joint_ratio: value(Variable::JointRatio),
            thrust,
            vertical_force: value(Variable::VerticalForce),
            crown_moment: value(Variable::CrownMoment),
            crown_hinge: value(Variable::CrownHinge),
            whole: WholeState::default(),
        }
    }

    /// Terms of the rotational joint by the square of its angle, those of the crown where no law asks for them: the
    /// laws of the whole arch read the square itself.
    fn haunch<T: Real + Stumpff>(&self, like: &T, square: &T) -> Haunch<T> {
        match self.has_haunch() && !self.laws.contains(&Law::OnHaunch) {
            true => Haunch::at_square(square),
            false => Haunch::crown(like),
        }
    }

    /// Tells whether the rotational joint is a joint of its own, not the crown or without meaning.
    pub(super) fn has_haunch(&self) -> bool {
        self.knows(Variable::JointSquare) || self.joint == FixedJoint::Sliding
    }

    /// Tells whether the thickness is the physical limit, 2: a form that turns about the shoulder and knows
    /// no thickness.
    pub(super) fn fixes_limit(&self) -> bool {
        !self.knows(Variable::Thickness) && self.laws.contains(&Law::Upper)
    }

    /// The left sides of the equations, zero on the curve.
    pub(super) fn residuals<T: Real + Stumpff>(
        &self,
        number: &impl Fn(&Ball) -> T,
        s: &T,
        x: &[T],
    ) -> Vec<T> {
        let at = self.spot(number, s, x);
        self.laws.iter().map(|law| law.residual(self.weight, &at)).collect()
    }

    /// The left side of another equation at the same place.
    pub(super) fn residual<T: Real + Stumpff>(
        &self,
        law: Law,
        number: &impl Fn(&Ball) -> T,
        s: &T,
        x: &[T],
    ) -> T {
        law.residual(self.weight, &self.spot(number, s, x))
    }

    /// Divisors that the equations have cleared and what has to be positive for them to be the printed ones:
    /// the lever arm of (3), the normal force on a shoulder that slides, `2 - eta` in (5).
    pub(super) fn divisors<T: Real + Stumpff>(
        &self,
        number: &impl Fn(&Ball) -> T,
        s: &T,
        x: &[T],
    ) -> Vec<T> {
        let at = self.spot(number, s, x);
        self.laws.iter().filter_map(|law| law.divisor(self.weight, &at)).collect()
    }
}
