//! Ends of curves, by values that are proved.

use super::variable::Variable;
use crate::arch::{SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::{Ball, Field, Magnitude, Real};
use crate::problem::Landmark;
use rug::Float;
use std::fmt;

/// An end of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CurveEnd {
    /// The arch of no half opening, no thickness and no friction.
    Origin,
    /// A landmark.
    Landmark(Landmark),
    /// The full circle, `alpha = pi`, at unlimited friction, where purely sliding states end.
    Circle,
}

impl CurveEnd {
    /// Tells whether the end's friction is unlimited.
    pub fn is_unlimited(self) -> bool {
        use Landmark::{OverturningEnd, RotationEnd};
        matches!(self, Self::Circle | Self::Landmark(RotationEnd | OverturningEnd))
    }
}

impl fmt::Display for CurveEnd {
    /// The symbol of the landmark, `0` or `pi`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Origin => "0",
            Self::Landmark(landmark) => landmark.symbol(),
            Self::Circle => "pi",
        })
    }
}

/// Enclosures of the variables at an end.
#[derive(Clone, Debug)]
pub(super) struct EndValues {
    half_opening: Ball,
    friction_angle: Ball,
    inclination: Ball,
    joint_square: Ball,
    thickness: Ball,
}

/// Bits in which the landmarks are enclosed: far more than a tube can tell.
const BITS: u32 = 128;

impl EndValues {
    /// The values at both ends of a curve.
    pub(super) fn both(
        [first, last]: [CurveEnd; 2],
        weight: SelfWeight,
    ) -> Result<[Self; 2], Undecided> {
        Ok([Self::of(first, weight)?, Self::of(last, weight)?])
    }

    /// The values at an end; those of a landmark are refined from its proof.
    pub(super) fn of(end: CurveEnd, weight: SelfWeight) -> Result<Self, Undecided> {
        let zero = Ball::integer(0, BITS);
        let quarter_turn = zero.pi() / zero.int(2);
        let flat = |half_opening: &Ball, angle: &Ball| Self {
            half_opening: half_opening.clone(),
            friction_angle: angle.clone(),
            inclination: angle.clone(),
            joint_square: zero.clone(),
            thickness: zero.clone(),
        };
        let landmark = match end {
            CurveEnd::Origin => return Ok(flat(&zero, &zero)),
            CurveEnd::Circle => return Ok(flat(&zero.pi(), &quarter_turn)),
            CurveEnd::Landmark(landmark) => landmark,
        };
        let refined = CertifiedLandmark::new(landmark, weight)?.enclosure(BITS)?;
        let value = |unknown| refined.value(unknown).unwrap_or_else(|| zero.clone());
        let (friction_angle, inclination) = match refined.friction_angle() {
            Some(phi) => {
                let inclination = phi.clone() + value(Unknown::SlidingJoint);
                (phi, inclination)
            }
            None => (quarter_turn.clone(), quarter_turn),
        };
        Ok(Self {
            half_opening: value(Unknown::HalfOpening),
            friction_angle,
            inclination,
            joint_square: value(Unknown::RotationJoint).square(),
            thickness: value(Unknown::Thickness),
        })
    }

    /// The value of a variable; of a ratio its limit at the origin, and nothing elsewhere: `q = 2`, `p³ = 4`, `s =
    /// p²/2`.
    pub(super) fn value(&self, variable: Variable) -> Ball {
        match variable {
            Variable::HalfOpening => self.half_opening.clone(),
            Variable::FrictionAngle => self.friction_angle.clone(),
            Variable::Inclination => self.inclination.clone(),
            Variable::JointSquare => self.joint_square.clone(),
            Variable::Thickness => self.thickness.clone(),
            Variable::Ratio => Ball::integer(2, BITS),
            Variable::OpeningRatio => cube_root_of_four(),
            Variable::JointRatio => cube_root_of_four().square() / Ball::integer(2, BITS),
            // Of symmetric states.
            Variable::VerticalForce | Variable::CrownHinge => Ball::integer(0, BITS),
            Variable::CrownMoment => Ball::whole(BITS),
        }
    }
}

/// Cube root of four, between 1 and 2, rounded to the nearest.
fn cube_root_of_four() -> Ball {
    let last = Magnitude::power_of_two(-i64::from(BITS) + 1);
    Ball::new(Float::with_val(BITS, 4).cbrt(), last, BITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_of_the_cube_root_is_four() {
        let root = cube_root_of_four();
        let cube = root.square() * &root;
        assert!(cube.contains(&4.into()) && cube.rad().to_float() < 1e-30);
        assert!(!cube.contains(&rug::Rational::from((400_001, 100_000))), "false twin");
    }
}
