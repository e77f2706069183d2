//! States by another quantity than the half opening: all arches whose state has a given joint, thrust, thickness or
//! opening variable.
//!
//! Everything comes down to thicknesses: at a friction each is the least one of at most one half opening, which
//! [`widest`] finds and proves.
//!
//! **A joint.** A state without sliding inside lies on the purely rotational curve, (2) = (5), at its joint: the
//! thicknesses there are the roots of (7) between 0 and 2, all of them isolated. A state that slides inside has the
//! thrust of (18), and (5), which grows with the thickness, gives one thickness.
//!
//! **A thrust.** Along the purely rotational curve it falls from 1 to 0 (the claim `curve-order`), so that one
//! thickness has it. A state that slides inside has the thrust of (18) whatever its half opening; a given one is
//! proved to be another.
//!
//! **An opening variable.** `A` falls with the half opening, from 2 to 0.

mod exact;
mod form;
mod found;
mod search;

pub use found::{OtherState, StateOfValue, StatesOfValue};

use self::search::Search;
use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction, Quantity};
use crate::prover::{Error, Refused};
use rug::Rational;

/// Question for the states with a value.
///
/// ```
/// use couplet_prove::certify::state::find::StatesByValue;
/// use couplet_prove::prelude::*;
/// let joint = (Quantity::RotationJoint, "1.0".parse()?);
/// let found = StatesByValue::new(joint, Friction::Infinite)?.find(SelfWeight::Milankovitch, 8)?;
/// let openings: Vec<String> =
///     found.states.iter().map(|of| of.as_ref().unwrap().value(Quantity::HalfOpening)).collect();
/// assert_eq!(openings, ["1.6920722", "2.4677392"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StatesByValue {
    quantity: Quantity,
    value: ExactNumber,
    friction: Friction,
}

impl StatesByValue {
    /// Quantities by which a state can be given.
    pub const GIVEN: [Quantity; 4] =
        [Quantity::RotationJoint, Quantity::Thrust, Quantity::Thickness, Quantity::OpeningVariable];

    /// Quantities of the states that are found, those that a state has.
    pub const VALUES: [Quantity; 8] = StateOfValue::VALUES;

    /// Question for the states with an exact value: a joint between 0 and pi, a thrust between 0 and 1, a thickness up
    /// to 2, an opening variable between 0 and 2.
    pub fn new(
        (quantity, value): (Quantity, ExactNumber),
        friction: Friction,
    ) -> Result<Self, Refused> {
        Refused::quantity(quantity, &Self::GIVEN)?;
        Refused::value_of(quantity, &value)?;
        let asked = Self { quantity, value, friction };
        asked.arch(SelfWeight::Heyman)?;
        Ok(asked)
    }

    /// Quantity that is given, and its value.
    pub fn given(&self) -> (Quantity, &ExactNumber) {
        (self.quantity, &self.value)
    }

    /// Friction that is given.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// Arch of the friction, with something in place of the half opening.
    fn arch(&self, weight: SelfWeight) -> Result<Arch, Refused> {
        let one = ExactNumber::from(&Rational::from(1));
        Ok(Arch::new(weight, one, self.friction.clone())?)
    }

    /// Finds all states with the value, every figure correctly rounded to `digits` significant digits.
    pub fn find(&self, weight: SelfWeight, digits: usize) -> Result<StatesOfValue, Error> {
        Refused::digits(digits)?;
        let (quantity, value, arch) = (self.quantity, &self.value, self.arch(weight)?);
        Search { quantity, value, arch, digits }.all()
    }
}

#[cfg(test)]
mod tests;
