//! The curves' equations in forms that are regular on the whole curve, ends included.
//!
//! A form is a system with one unknown more than equations, one of which is taken as its parameter. The
//! printed equations have roots and vanishing quotients at the origin, at the crown and at unlimited friction;
//! the square of the rotational joint, the friction angle and the inclination of the force do not
//! ([`cycloid`](crate::arch::cycloid), [`haunch`](crate::arch::haunch)).

use crate::arch::flat::Flat;
use crate::arch::haunch::{Haunch, opening_variable_at_half, touching_root};
use crate::arch::{Ring, SelfWeight, cycloid, thrust};
use crate::number::{Angle, Ball, Real, Stumpff};

/// A variable of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// `alpha`, the half opening, rad.
    HalfOpening,
    /// `phi`, the friction angle, rad.
    FrictionAngle,
    /// `chi`, the inclination of the force on the joint that slides, rad.
    Inclination,
    /// `b = beta_r²`, rad².
    JointSquare,
    /// `eta`, the thickness.
    Thickness,
    /// `q = (alpha - phi)/chi`, of a flat arch that slides.
    Ratio,
    /// `p = alpha/chi`, of a flat arch that turns at the haunch.
    OpeningRatio,
    /// `s = beta_r²/chi²`, of the same.
    JointRatio,
}

impl Variable {
    /// The variables in which a map is drawn: a tube is as narrow in these as was asked.
    pub const PLANE: [Self; 3] = [Self::HalfOpening, Self::FrictionAngle, Self::Thickness];

    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::HalfOpening => "half_opening",
            Self::FrictionAngle => "friction_angle",
            Self::Inclination => "inclination",
            Self::JointSquare => "rotation_joint_squared",
            Self::Thickness => "thickness",
            Self::Ratio => "inclination_ratio",
            Self::OpeningRatio => "opening_ratio",
            Self::JointRatio => "joint_ratio",
        }
    }
}

/// An equation of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    /// (18), the friction angle.
    Cycloid,
    /// (17).
    Shoulder,
    /// (17) of a flat arch, in `q`.
    FlatShoulder,
    /// `alpha = phi + q chi`.
    Ratio,
    /// (17) of a flat arch that turns at the haunch, in `p` and `s`.
    FlatTurningShoulder,
    /// (4) less (5) of the same.
    FlatTurning,
    /// `alpha = p chi`.
    OpeningRatio,
    /// `beta_r² = s chi²`.
    JointRatio,
    /// (5).
    Tangency,
    /// The thrust that (2) and (5) have in common.
    Touching,
    /// The square root of that, regular where the thrust vanishes.
    TouchingRoot,
    /// The same put into (5): what (2) and (5) leave of the thickness and the joint.
    Rotation,
    /// (4).
    Whole,
    /// (4) less (5): the half opening of the rotational states.
    WholeTangency,
    /// (3).
    Upper,
}

/// Where the thrust comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thrust {
    /// There is none.
    Zero,
    /// An inner joint slides: (18).
    Sliding,
    /// The line of thrust touches the intrados: (5).
    Tangent,
    /// The shoulder slides: (17).
    Shoulder,
}

/// Where the rotational joint is, if it is no unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    /// At the crown.
    Crown,
    /// Where an inner joint slides.
    Sliding,
}

/// A system with one unknown more than equations.
#[derive(Clone, Debug)]
pub(super) struct Form {
    pub weight: SelfWeight,
    pub parameter: Variable,
    pub unknowns: &'static [Variable],
    pub laws: &'static [Law],
    pub thrust: Thrust,
    pub joint: Joint,
    /// The variable that is the same throughout, with its value.
    pub given: Option<(Variable, Ball)>,
}

/// A value for each variable; one that a form does not know is zero and is read by none of its laws.
#[derive(Clone, Debug)]
pub(super) struct Spot<T> {
    pub half_opening: T,
    pub friction_angle: T,
    pub inclination: Angle<T>,
    pub joint_square: T,
    pub haunch: Haunch<T>,
    pub thickness: T,
    pub ratio: T,
    pub opening_ratio: T,
    pub joint_ratio: T,
    pub thrust: T,
}

impl Form {
    /// Whether it is the parameter, an unknown or given.
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
    ) -> Spot<T> {
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
            (None, Joint::Crown) => zero.clone(),
            (None, Joint::Sliding) => cycloid::joint(&inclination).square(),
        };
        let at_crown = !self.knows(Variable::JointSquare) && self.joint == Joint::Crown;
        let haunch = if at_crown { Haunch::crown(s) } else { Haunch::at_square(&joint_square) };
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
        Spot {
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
        }
    }

    /// Whether the rotational joint is a joint of its own, not the crown or without meaning.
    pub(super) fn has_haunch(&self) -> bool {
        self.knows(Variable::JointSquare) || self.joint == Joint::Sliding
    }

    /// Whether the thickness is the physical limit, 2: a form that turns about the shoulder and knows no thickness.
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

    /// What the equations have cleared and what has to be positive for them to be the printed ones: the lever
    /// arm of (3), the normal force on a shoulder that slides, `2 - eta` in (5).
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

impl Law {
    fn residual<T: Real + Stumpff>(self, weight: SelfWeight, at: &Spot<T>) -> T {
        let ring = || Ring::new(weight, &at.thickness);
        let tangency = || thrust::tangency(&at.haunch.times_cotangent, &ring());
        let touching = || thrust::touching(&at.haunch.versine, &at.haunch.excess, &ring());
        let whole = || {
            let quarter = at.half_opening.square() / at.thrust.int(4);
            thrust::whole_through(&opening_variable_at_half(&quarter.stumpff(2)), &ring())
        };
        match self {
            Self::Cycloid => cycloid::friction_angle(&at.inclination) - &at.friction_angle,
            Self::Shoulder => {
                cycloid::shoulder(&at.half_opening, &at.shoulder_inclination(), &at.thrust)
            }
            Self::FlatShoulder => cycloid::flat_shoulder(&at.ratio, &at.inclination.rad),
            Self::Ratio => {
                at.half_opening.clone()
                    - &at.friction_angle
                    - at.ratio.clone() * &at.inclination.rad
            }
            Self::FlatTurningShoulder => at.flat().shoulder(weight, &at.inclination.rad),
            Self::FlatTurning => at.flat().turning(weight, &at.half_opening),
            Self::OpeningRatio => {
                at.half_opening.clone() - at.opening_ratio.clone() * &at.inclination.rad
            }
            Self::JointRatio => {
                at.joint_square.clone() - at.inclination.rad.square() * &at.joint_ratio
            }
            Self::Tangency => tangency().residual(&at.thrust),
            Self::Touching => touching().residual(&at.thrust),
            Self::TouchingRoot => touching_root(&at.inclination.cos, &at.joint_square, &ring()),
            Self::Rotation => tangency().difference(&touching()),
            Self::Whole => whole().residual(&at.thrust),
            Self::WholeTangency => whole().difference(&tangency()),
            Self::Upper => at.upper(weight).residual(&at.thrust),
        }
    }

    fn divisor<T: Real + Stumpff>(self, weight: SelfWeight, at: &Spot<T>) -> Option<T> {
        match self {
            Self::Upper => Some(at.upper(weight).denominator),
            Self::Shoulder => {
                let Angle { sin, cos, .. } = at.shoulder_inclination();
                // The force on the shoulder less its part along the joint: N over cos(phi).
                Some(at.thrust.clone() * cos + at.half_opening.clone() * sin)
            }
            Self::Tangency | Self::Rotation | Self::WholeTangency => {
                Some(Ring::new(weight, &at.thickness).intrados())
            }
            _ => None,
        }
    }
}

impl<T: Real + Stumpff> Spot<T> {
    /// As a flat arch that turns at the haunch.
    fn flat(&self) -> Flat<T> {
        Flat {
            opening: self.opening_ratio.clone(),
            joint: self.joint_ratio.clone(),
            square: self.joint_square.clone(),
            functions: self.joint_square.stumpff(4),
            thickness: self.thickness.clone(),
        }
    }
}

impl<T: Real> Spot<T> {
    /// The inclination of the force on a shoulder that slides.
    fn shoulder_inclination(&self) -> Angle<T> {
        Angle::new(self.half_opening.clone() - &self.friction_angle)
    }

    fn upper(&self, weight: SelfWeight) -> crate::arch::Quotient<T> {
        let ring = Ring::new(weight, &self.thickness);
        let moment = ring.intrados() * &self.haunch.times_sine;
        let half_opening = Angle::new(self.half_opening.clone());
        thrust::upper_about(&half_opening, moment, &self.haunch.cosine, &ring)
    }
}
