//! What a proved state says of a quantity that somebody claims.

use super::printed::Known;
use crate::certify::state::State;
use crate::number::Ball;
use crate::problem::Quantity;
use rug::Rational;

/// What is certain of a quantity of a state.
#[derive(Clone, Debug)]
pub(super) enum Truth {
    Finite(Known),
    Infinite,
    /// The state has no such number.
    Missing,
}

impl Truth {
    /// What a proved state says of one of [`Quantity::STATE`].
    pub(super) fn new(quantity: Quantity, state: &State) -> Self {
        let known = |x: &Ball| {
            let zero = x.mid().is_zero() && x.rad().is_zero();
            Self::Finite(match zero {
                true => Known::Exact(Rational::new()),
                false => Known::Enclosed(x.clone()),
            })
        };
        let frictions = state.frictions.as_ref();
        match quantity {
            Quantity::Thickness => known(&state.thickness),
            Quantity::Thrust => known(&state.thrust),
            Quantity::IntrinsicThrust => known(&(state.thickness.clone() * &state.thrust)),
            Quantity::RotationJoint => known(&state.rotation_joint),
            Quantity::SlidingJoint => state.sliding_joint.as_ref().map_or(Self::Missing, known),
            Quantity::SlidingFriction => frictions.map_or(Self::Missing, |all| known(&all.sliding)),
            Quantity::RotationalFriction => frictions
                .map_or(Self::Missing, |all| all.rotational.as_ref().map_or(Self::Infinite, known)),
            _ => Self::Missing,
        }
    }
}
