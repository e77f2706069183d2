//! The arch as letters, for the claims that speak of all of it.

use crate::arch::{Configuration, Ring};
use crate::symbolic::{Fraction, Letters, Symbol};

/// The ring with symbolic thickness and `delta_M`.
pub(super) fn ring() -> Ring<Fraction> {
    Ring::with_flag(&Symbol::Flag.number(), &Symbol::Thickness.number())
}

/// All variables; the sliding joint is the joint.
pub(super) fn variables() -> Configuration<Fraction> {
    Configuration {
        half_opening: Symbol::half_opening(),
        rotation_joint: Symbol::joint(),
        sliding_joint: Symbol::joint(),
        thickness: Symbol::Thickness.number(),
        thrust: Symbol::Thrust.number(),
        friction: Symbol::Friction.number(),
        ..Configuration::zero(&Symbol::Thrust.number())
    }
}
