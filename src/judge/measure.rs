//! The numbers of a state that can be claimed.

use super::printed::Known;
use crate::certify::state::State;
use crate::number::Ball;
use rug::Rational;

/// A number of the state of an arch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measure {
    /// `eta = t/r`, the least thickness over the radius.
    Thickness,
    /// `h = H/(w r)`.
    Thrust,
    /// `eta h`.
    IntrinsicThrust,
    /// `beta_r`, an angle.
    RotationJoint,
    /// `beta_s`, an angle; there is none in a mode without an inner sliding joint.
    SlidingJoint,
    /// The friction below which nothing stands at this half opening.
    SlidingFriction,
    /// The friction from which collapse is purely rotational; unbounded if none is enough.
    RotationalFriction,
}

/// What is certain of a number of a state.
#[derive(Clone, Debug)]
pub(super) enum Truth {
    Finite(Known),
    Infinite,
    /// The state has no such number.
    Missing,
}

impl Measure {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 7] = [
        Self::Thickness,
        Self::Thrust,
        Self::IntrinsicThrust,
        Self::RotationJoint,
        Self::SlidingJoint,
        Self::SlidingFriction,
        Self::RotationalFriction,
    ];

    /// The name used in files; that of the columns of `couplet states`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Thickness => "thickness",
            Self::Thrust => "thrust",
            Self::IntrinsicThrust => "intrinsic_thrust",
            Self::RotationJoint => "rotation_joint",
            Self::SlidingJoint => "sliding_joint",
            Self::SlidingFriction => "sliding_friction",
            Self::RotationalFriction => "rotational_friction",
        }
    }

    /// Whether it is an angle, which may be claimed in degrees.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::RotationJoint | Self::SlidingJoint)
    }

    /// Whether it is a friction at which the mode changes, which a state leaves out unless it is asked.
    pub(super) fn is_friction(self) -> bool {
        matches!(self, Self::SlidingFriction | Self::RotationalFriction)
    }

    /// What a proved state says of it.
    pub(super) fn of(self, state: &State) -> Truth {
        let known = |x: &Ball| {
            let zero = x.mid().is_zero() && x.rad().is_zero();
            Truth::Finite(match zero {
                true => Known::Exact(Rational::new()),
                false => Known::Enclosed(x.clone()),
            })
        };
        match self {
            Self::Thickness => known(&state.thickness),
            Self::Thrust => known(&state.thrust),
            Self::IntrinsicThrust => known(&(state.thickness.clone() * &state.thrust)),
            Self::RotationJoint => known(&state.rotation_joint),
            Self::SlidingJoint => state.sliding_joint.as_ref().map_or(Truth::Missing, known),
            Self::SlidingFriction => {
                state.frictions.as_ref().map_or(Truth::Missing, |all| known(&all.sliding))
            }
            Self::RotationalFriction => state.frictions.as_ref().map_or(Truth::Missing, |all| {
                all.rotational.as_ref().map_or(Truth::Infinite, known)
            }),
        }
    }
}
