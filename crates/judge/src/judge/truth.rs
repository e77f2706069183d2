//! Truth of a quantity that somebody claims.

use super::comparable::Comparable;
use super::possible::Possible;
use super::printed::KnownValue;
use crate::certify::Answered;
use crate::certify::state::{Assessment, Outcome};
use crate::number::Ball;
use crate::problem::Quantity;
use rug::Rational;

/// Certain knowledge of a quantity of an arch.
pub(super) type Truth<E = Ball> = Possible<KnownValue<E>>;

/// Proof about an arch.
pub(super) struct ProvedArch<E> {
    /// Outcome at its least thickness.
    pub outcome: Outcome<E>,
    /// Assessment at the thickness that it has, if it has one.
    pub assessment: Option<Assessment<E>>,
    /// The friction below which nothing stands, of an arch that falls.
    pub sliding_friction: Option<E>,
}

impl<E: Comparable> ProvedArch<E> {
    /// Certain knowledge of one of [`Quantity::STATE`] or [`Quantity::ASSESSMENT`].
    pub(super) fn truth(&self, quantity: Quantity) -> Truth<E> {
        let state = match &self.outcome {
            Outcome::Stands(state) => Some(state),
            Outcome::Falls(_) => None,
        };
        let frictions = state.and_then(|state| state.frictions.as_ref());
        let assessed = self.assessment.as_ref();
        let thrust = |end: usize| match assessed.map(|found| &found.thrust[end]) {
            Some(Ok(Some(limit))) => limit.thrust.as_ref().map_or(Truth::Infinite, Truth::known),
            _ => Truth::Missing,
        };
        let number = |of: fn(&Assessment<E>) -> &Answered<E>| {
            assessed.and_then(|found| of(found).as_ref().ok()?.as_ref())
        };
        let value = match quantity {
            Quantity::Thickness | Quantity::LeastThickness => state.map(|state| &state.thickness),
            Quantity::Thrust => state.map(|state| &state.thrust),
            Quantity::IntrinsicThrust => {
                let product = state.map(|state| state.thickness.clone() * &state.thrust);
                return product.as_ref().map_or(Truth::Missing, Truth::known);
            }
            Quantity::RotationJoint => state.map(|state| &state.rotation_joint),
            Quantity::SlidingJoint => state.and_then(|state| state.sliding_joint.as_ref()),
            Quantity::SlidingFriction => {
                frictions.map(|both| &both.sliding).or(self.sliding_friction.as_ref())
            }
            Quantity::RotationalFriction => match frictions {
                Some(both) if both.rotational.is_none() => return Truth::Infinite,
                both => both.and_then(|both| both.rotational.as_ref()),
            },
            Quantity::GeometricSafety => number(|found| &found.geometric_safety),
            Quantity::RequiredFriction => number(|found| &found.required_friction),
            Quantity::FrictionSafety => number(|found| &found.friction_safety),
            Quantity::LeastThrust => return thrust(0),
            Quantity::LargestThrust => return thrust(1),
            _ => None,
        };
        value.map_or(Truth::Missing, Truth::known)
    }
}

impl<E: Comparable> Truth<E> {
    fn known(x: &E) -> Self {
        Self::Finite(match x.is_zero() {
            true => KnownValue::Exact(Rational::new()),
            false => KnownValue::Enclosed(x.clone()),
        })
    }
}
