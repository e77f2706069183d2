//! The quantities of a claim over enclosures, and their comparison with a bound.

use super::claim::{Claim, Subject};
use crate::arch::{Configuration, Unknown, thrust};
use crate::number::{Enclosure, Ternary};
use crate::problem::{Fixed, Mode, Quantity};

/// What is known of a quantity.
pub enum Known<E> {
    /// An enclosure.
    Enclosed(E),
    /// The angle whose tangent is enclosed, between 0 and a right angle.
    AngleOfTangent(E),
    /// Without bound.
    Infinite,
}

impl Claim {
    /// Whether the claim has a quantity that can be stated: an unknown of its subject or something
    /// made from unknowns and fixed variables.
    pub fn has(&self, quantity: Quantity) -> bool {
        let known = |unknown| self.unknowns().contains(&unknown) || self.fixed(unknown).is_some();
        match (&self.subject, quantity) {
            (Subject::State(_), Quantity::OpeningVariable) => false,
            // The joint of a mode whose inner joint does not slide is no part of the state.
            (Subject::State(state), _) if quantity.variable() == Unknown::SlidingJoint => {
                !matches!(
                    state.mode,
                    Mode::Rotational | Mode::SlidingRotational | Mode::Overturning
                )
            }
            (_, Quantity::IntrinsicThrust) => known(Unknown::Thickness) && known(Unknown::Thrust),
            _ => known(quantity.variable()),
        }
    }

    /// The quantity where the variables lie in the configuration given.
    pub fn known<E: Enclosure>(&self, quantity: Quantity, at: &Configuration<E>) -> Known<E> {
        let infinite = self.fixed(Unknown::Friction) == Some(Fixed::Infinite);
        let value = match quantity.in_radians().unwrap_or(quantity) {
            Quantity::Thickness => at.thickness.clone(),
            Quantity::Friction if infinite => return Known::Infinite,
            Quantity::Friction => at.friction.clone(),
            Quantity::FrictionAngle if infinite => at.thrust.pi() / at.thrust.int(2),
            Quantity::FrictionAngle => return Known::AngleOfTangent(at.friction.clone()),
            Quantity::HalfOpening => at.half_opening.rad.clone(),
            Quantity::Thrust => at.thrust.clone(),
            Quantity::IntrinsicThrust => at.thickness.clone() * &at.thrust,
            Quantity::RotationJoint => at.rotation_joint.rad.clone(),
            Quantity::SlidingJoint => at.sliding_joint.rad.clone(),
            _ => thrust::opening_variable(&at.half_opening).value(),
        };
        Known::Enclosed(value)
    }
}

impl<E: Enclosure> Known<E> {
    /// Whether the quantity, in degrees if `degrees`, lies between two bounds. `True` is a proof.
    pub fn lies_between(&self, [low, high]: &[E; 2], degrees: bool) -> Ternary {
        let in_radians = |bound: &E| {
            if degrees { bound.clone() * bound.pi() / bound.int(180) } else { bound.clone() }
        };
        let (low, high) = (in_radians(low), in_radians(high));
        match self {
            Self::Enclosed(x) => low.is_less_than(x).and(x.is_less_than(&high)),
            // For angles between 0 and a right angle the tangent grows: no arctangent is needed.
            Self::AngleOfTangent(tangent) => {
                let ((sin, cos), (other_sin, other_cos)) = (low.sin_cos(), high.sin_cos());
                let in_quadrant =
                    low.is_positive().and(high.is_less_than(&(high.pi() / high.int(2))));
                in_quadrant
                    .and(cos.is_positive())
                    .and(other_cos.is_positive())
                    .and(sin.is_less_than(&(cos * tangent)))
                    .and((other_cos * tangent).is_less_than(&other_sin))
            }
            Self::Infinite => Ternary::False,
        }
    }

    /// Whether the quantity is exactly zero: nothing above it, nothing below.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Enclosed(x) => {
                x.is_positive() == Ternary::False && (-x.clone()).is_positive() == Ternary::False
            }
            _ => false,
        }
    }

    /// Whether it is infinite.
    pub fn is_infinite(&self) -> bool {
        matches!(self, Self::Infinite)
    }
}
