//! What can be asked of a landmark.

use crate::arch::Unknown;

/// A quantity of an arch state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// `eta = t/r`, thickness over centreline radius.
    Thickness,
    /// `mu`, the friction coefficient.
    Friction,
    /// `phi = atan(mu)`, rad.
    FrictionAngle,
    /// The same in degrees.
    FrictionAngleDegrees,
    /// `alpha`, the half-angle of embrace, rad.
    HalfOpening,
    /// The same in degrees.
    HalfOpeningDegrees,
    /// `h = H/(w r)`, the horizontal thrust.
    Thrust,
    /// `eta h = H/(gamma d r²)`, the intrinsic thrust.
    IntrinsicThrust,
    /// `beta_r`, the inner rotational joint, rad from the crown.
    RotationJoint,
    /// The same in degrees.
    RotationJointDegrees,
    /// `beta_s`, the inner sliding joint, rad from the crown.
    SlidingJoint,
    /// The same in degrees.
    SlidingJointDegrees,
    /// `A = alpha cot(alpha/2)`.
    OpeningVariable,
}

impl Quantity {
    /// All quantities in the order in which they are shown.
    pub const ALL: [Self; 13] = [
        Self::Thickness,
        Self::Friction,
        Self::FrictionAngle,
        Self::FrictionAngleDegrees,
        Self::HalfOpening,
        Self::HalfOpeningDegrees,
        Self::Thrust,
        Self::IntrinsicThrust,
        Self::RotationJoint,
        Self::RotationJointDegrees,
        Self::SlidingJoint,
        Self::SlidingJointDegrees,
        Self::OpeningVariable,
    ];

    /// The name used in files and on the command line; stable.
    pub fn name(self) -> &'static str {
        match self {
            Self::Thickness => "thickness",
            Self::Friction => "friction",
            Self::FrictionAngle => "friction_angle",
            Self::FrictionAngleDegrees => "friction_angle_degrees",
            Self::HalfOpening => "half_opening",
            Self::HalfOpeningDegrees => "half_opening_degrees",
            Self::Thrust => "thrust",
            Self::IntrinsicThrust => "intrinsic_thrust",
            Self::RotationJoint => "rotation_joint",
            Self::RotationJointDegrees => "rotation_joint_degrees",
            Self::SlidingJoint => "sliding_joint",
            Self::SlidingJointDegrees => "sliding_joint_degrees",
            Self::OpeningVariable => "A",
        }
    }

    /// The symbol of the paper and the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Thickness => "eta = t/r",
            Self::Friction => "mu",
            Self::FrictionAngle => "phi, rad",
            Self::FrictionAngleDegrees => "phi, deg",
            Self::HalfOpening => "alpha, rad",
            Self::HalfOpeningDegrees => "alpha, deg",
            Self::Thrust => "h = H/(w r)",
            Self::IntrinsicThrust => "eta h",
            Self::RotationJoint => "beta_r, rad",
            Self::RotationJointDegrees => "beta_r, deg",
            Self::SlidingJoint => "beta_s, rad",
            Self::SlidingJointDegrees => "beta_s, deg",
            Self::OpeningVariable => "alpha cot(alpha/2)",
        }
    }

    /// The quantity in radians of which this is the value in degrees.
    pub fn in_radians(self) -> Option<Self> {
        match self {
            Self::FrictionAngleDegrees => Some(Self::FrictionAngle),
            Self::HalfOpeningDegrees => Some(Self::HalfOpening),
            Self::RotationJointDegrees => Some(Self::RotationJoint),
            Self::SlidingJointDegrees => Some(Self::SlidingJoint),
            _ => None,
        }
    }

    /// The variable that a system has to know for the quantity to exist.
    pub fn variable(self) -> Unknown {
        match self {
            Self::Thickness => Unknown::Thickness,
            Self::Friction | Self::FrictionAngle | Self::FrictionAngleDegrees => Unknown::Friction,
            Self::HalfOpening | Self::HalfOpeningDegrees | Self::OpeningVariable => {
                Unknown::HalfOpening
            }
            Self::Thrust | Self::IntrinsicThrust => Unknown::Thrust,
            Self::RotationJoint | Self::RotationJointDegrees => Unknown::RotationJoint,
            Self::SlidingJoint | Self::SlidingJointDegrees => Unknown::SlidingJoint,
        }
    }
}
