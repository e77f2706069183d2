//! The variables of the problem, and a value for each.

use crate::number::{Angle, Field, Real, worded};

worded! {
    /// A variable of the problem.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Unknown {
        /// `alpha`, in `(0, pi)`.
        HalfOpening = "half_opening",
        /// `beta_r`, in `[0, alpha]`.
        RotationJoint = "rotation_joint",
        /// `beta_s`, in `[0, 1/2]`.
        SlidingJoint = "sliding_joint",
        /// `eta`, in `(0, 2]`.
        Thickness = "thickness",
        /// `h`, in `[0, 1)`.
        Thrust = "thrust",
        /// `mu`, in `[0, inf]`.
        Friction = "friction",
        /// `b0`, the hinge right of the crown of an asymmetric state, in `(-alpha, alpha)`.
        CrownHinge = "crown_hinge",
        /// `p`, the moment of the forces in the crown about the centre.
        CrownMoment = "crown_moment",
        /// `v`, the vertical force in the crown.
        VerticalForce = "vertical_force",
    }
    /// All of them, in order.
    pub const ALL;
    /// The name used in files.
    pub fn name -> &'static str;
}

impl Unknown {
    /// Tells whether the sine and cosine of the unknown are needed.
    pub fn is_angle(self) -> bool {
        matches!(
            self,
            Self::HalfOpening | Self::RotationJoint | Self::SlidingJoint | Self::CrownHinge
        )
    }
}

/// Values of all variables. One that a system neither solves for nor fixes is zero and is read by
/// none of its equations.
#[derive(Clone, Debug)]
pub struct Configuration<T> {
    /// `alpha`.
    pub half_opening: Angle<T>,
    /// `beta_r`.
    pub rotation_joint: Angle<T>,
    /// `beta_s`.
    pub sliding_joint: Angle<T>,
    /// `eta`.
    pub thickness: T,
    /// `h`.
    pub thrust: T,
    /// `mu`.
    pub friction: T,
    /// `b0`, at which the crown turns; like what follows zero in a symmetric state, but for a keystone's joint.
    pub crown_hinge: Angle<T>,
    /// `p`.
    pub crown_moment: T,
    /// `v`.
    pub vertical_force: T,
}

impl<T: Real> Configuration<T> {
    /// The configuration with one variable given another value.
    pub fn with(mut self, unknown: Unknown, value: T) -> Self {
        match unknown {
            Unknown::HalfOpening => self.half_opening = Angle::new(value),
            Unknown::RotationJoint => self.rotation_joint = Angle::new(value),
            Unknown::SlidingJoint => self.sliding_joint = Angle::new(value),
            Unknown::Thickness => self.thickness = value,
            Unknown::Thrust => self.thrust = value,
            Unknown::Friction => self.friction = value,
            Unknown::CrownHinge => self.crown_hinge = Angle::new(value),
            Unknown::CrownMoment => self.crown_moment = value,
            Unknown::VerticalForce => self.vertical_force = value,
        }
        self
    }
}

impl<T: Field> Configuration<T> {
    /// All variables zero, "like" `like`.
    #[inline(always)]
    pub fn zero(like: &T) -> Self {
        let (angle, zero) = (Angle::zero(like), like.int(0));
        Self {
            half_opening: angle.clone(),
            rotation_joint: angle.clone(),
            sliding_joint: angle.clone(),
            thickness: zero.clone(),
            thrust: zero.clone(),
            friction: zero.clone(),
            crown_hinge: angle,
            crown_moment: zero.clone(),
            vertical_force: zero,
        }
    }
}

#[cfg(test)]
impl Configuration<rug::Rational> {
    /// Configuration with rational sines and cosines, for identities: of no state.
    pub(crate) fn rational() -> Self {
        let angle = |rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)| Angle {
            rad: rad.into(),
            sin: sin.into(),
            cos: cos.into(),
        };
        Self {
            half_opening: angle((9, 4), (4, 5), (-3, 5)),
            rotation_joint: angle((1, 1), (20, 29), (21, 29)),
            sliding_joint: angle((1, 3), (5, 13), (12, 13)),
            thickness: (1, 3).into(),
            thrust: (1, 7).into(),
            friction: (5, 4).into(),
            ..Self::zero(&rug::Rational::new())
        }
    }
}

impl<T> Configuration<T> {
    /// The value of a variable, rad for an angle.
    pub fn value(&self, unknown: Unknown) -> &T {
        match unknown {
            Unknown::HalfOpening => &self.half_opening.rad,
            Unknown::RotationJoint => &self.rotation_joint.rad,
            Unknown::SlidingJoint => &self.sliding_joint.rad,
            Unknown::Thickness => &self.thickness,
            Unknown::Thrust => &self.thrust,
            Unknown::Friction => &self.friction,
            Unknown::CrownHinge => &self.crown_hinge.rad,
            Unknown::CrownMoment => &self.crown_moment,
            Unknown::VerticalForce => &self.vertical_force,
        }
    }

    /// A variable that is an angle, with its sine and cosine.
    pub fn angle(&self, unknown: Unknown) -> Option<&Angle<T>> {
        match unknown {
            Unknown::HalfOpening => Some(&self.half_opening),
            Unknown::RotationJoint => Some(&self.rotation_joint),
            Unknown::SlidingJoint => Some(&self.sliding_joint),
            Unknown::CrownHinge => Some(&self.crown_hinge),
            Unknown::Thickness
            | Unknown::Thrust
            | Unknown::Friction
            | Unknown::CrownMoment
            | Unknown::VerticalForce => None,
        }
    }

    /// The configuration with its values in another number.
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Configuration<U> {
        self.map_each(|_, angle| angle.map(&f), |_, value| f(value))
    }

    /// Maps the variables from references.
    pub fn map_ref<U>(&self, f: impl Fn(&T) -> U) -> Configuration<U> {
        self.mapped(&f)
    }

    /// Maps by any function, as a copy for each would be as long as this.
    fn mapped<U>(&self, f: &dyn Fn(&T) -> U) -> Configuration<U> {
        let angle = |x: &Angle<T>| Angle { rad: f(&x.rad), sin: f(&x.sin), cos: f(&x.cos) };
        Configuration {
            half_opening: angle(&self.half_opening),
            rotation_joint: angle(&self.rotation_joint),
            sliding_joint: angle(&self.sliding_joint),
            thickness: f(&self.thickness),
            thrust: f(&self.thrust),
            friction: f(&self.friction),
            crown_hinge: angle(&self.crown_hinge),
            crown_moment: f(&self.crown_moment),
            vertical_force: f(&self.vertical_force),
        }
    }

    /// Maps each variable in its own way.
    pub fn map_each<U>(
        self,
        angle: impl Fn(Unknown, Angle<T>) -> Angle<U>,
        number: impl Fn(Unknown, T) -> U,
    ) -> Configuration<U> {
        Configuration {
            half_opening: angle(Unknown::HalfOpening, self.half_opening),
            rotation_joint: angle(Unknown::RotationJoint, self.rotation_joint),
            sliding_joint: angle(Unknown::SlidingJoint, self.sliding_joint),
            thickness: number(Unknown::Thickness, self.thickness),
            thrust: number(Unknown::Thrust, self.thrust),
            friction: number(Unknown::Friction, self.friction),
            crown_hinge: angle(Unknown::CrownHinge, self.crown_hinge),
            crown_moment: number(Unknown::CrownMoment, self.crown_moment),
            vertical_force: number(Unknown::VerticalForce, self.vertical_force),
        }
    }
}
