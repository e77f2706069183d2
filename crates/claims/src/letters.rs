//! The arch as letters, for the claims that speak of all of it.

use crate::arch::whole::Forces;
use crate::arch::{Configuration, Ring};
use crate::number::Field;
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

/// A fraction with one value in place of some letters.
pub(super) fn with(fraction: &Fraction, letters: &[Symbol], value: &Fraction) -> Fraction {
    let put = |x: Symbol| if letters.contains(&x) { value.clone() } else { x.number() };
    fraction.evaluate(value, put)
}

/// `n/m` times a power of the half opening.
pub(super) fn term(n: i32, m: i32, power: usize) -> Fraction {
    let alpha = Symbol::HalfOpening;
    Fraction::from(alpha.polynomial().power(power)) * alpha.number().ratio(n, m)
}

/// The forces as letters.
pub(super) fn forces() -> Forces<Fraction> {
    let [thrust, moment, vertical] =
        [Symbol::Thrust, Symbol::CrownMoment, Symbol::CrownShear].map(Symbol::number);
    Forces { thrust, moment, vertical }
}
