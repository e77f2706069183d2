//! A quantity of a landmark with all its digits proved.

use crate::arch::SelfWeight;
use crate::number::{Ball, Binary, Rounded};
use crate::problem::{Landmark, Quantity};
use std::fmt;

/// A quantity of a landmark with its digits.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Constant {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The landmark.
    pub landmark: Landmark,
    /// The quantity.
    pub quantity: Quantity,
    /// The correctly rounded value with its bounds.
    pub value: Value,
    /// The exact value, where there is one.
    pub exact: Option<String>,
    /// The nearest double of the true value, not of its digits; infinite where the value is.
    pub double: f64,
    /// Bounds of what that double leaves open.
    pub binary: Binary,
}

/// A finite value with bounds, or infinity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// Correctly rounded, with outward bounds.
    Finite(Rounded),
    /// Exactly infinite.
    Infinite,
}

impl Constant {
    /// The correctly rounded value with its bounds; `None` for infinity.
    pub fn rounded(&self) -> Option<&Rounded> {
        match &self.value {
            Value::Finite(rounded) => Some(rounded),
            Value::Infinite => None,
        }
    }

    /// Doubles between which the true value lies.
    ///
    /// ```
    /// use couplet_prove::prelude::*;
    /// let triple = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman)?;
    /// let friction = triple.constant(Quantity::Friction, 30)?;
    /// let ([lower, upper], ball) = (friction.bounds(), friction.enclosure(200).unwrap());
    /// assert!(lower.next_up() == upper && lower <= ball.lower() && ball.upper() <= upper);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn bounds(&self) -> [f64; 2] {
        self.binary.bounds()
    }

    /// Ball of `bits` bits about the decimal bounds; `None` for infinity.
    pub fn enclosure(&self, bits: u32) -> Option<Ball> {
        self.rounded().map(|rounded| rounded.enclosure(bits))
    }
}

impl fmt::Display for Constant {
    /// The digits, or `inf`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

impl fmt::Display for Value {
    /// The digits, or `inf`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite(rounded) => f.pad(&rounded.value.to_string()),
            Self::Infinite => f.pad("inf"),
        }
    }
}

/// The quantities that exist at a landmark, in the order of [`Quantity::LANDMARK`].
pub fn quantities(landmark: Landmark) -> impl Iterator<Item = Quantity> {
    // Which variables a landmark has does not depend on the weight.
    let system = landmark.system(SelfWeight::Heyman);
    Quantity::LANDMARK
        .into_iter()
        .filter(move |quantity| quantity.variable().is_some_and(|unknown| system.knows(unknown)))
}
