//! Quantities that are the same along a level.

use super::variable::Variable;
use crate::number::{Ball, ExactNumber, arctangent};
use crate::problem::Friction;
use std::fmt;

/// The quantity of a level, with its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contour {
    /// `alpha`, rad.
    HalfOpening(ExactNumber),
    /// `eta`.
    Thickness(ExactNumber),
    /// `mu`.
    Friction(Friction),
}

impl Contour {
    /// The variable of the curves' equations that it fixes.
    pub fn variable(&self) -> Variable {
        match self {
            Self::HalfOpening(_) => Variable::HalfOpening,
            Self::Thickness(_) => Variable::Thickness,
            Self::Friction(_) => Variable::FrictionAngle,
        }
    }

    /// The name of the quantity.
    pub fn name(&self) -> &'static str {
        match self {
            Self::HalfOpening(_) => "half opening",
            Self::Thickness(_) => "thickness",
            Self::Friction(_) => "friction",
        }
    }

    /// The value, as it was given.
    pub fn given(&self) -> String {
        match self {
            Self::HalfOpening(x) | Self::Thickness(x) => x.to_string(),
            Self::Friction(friction) => friction.to_string(),
        }
    }

    /// The value of the variable; `None` where it is unlimited.
    pub(super) fn value(&self, bits: u32) -> Option<Ball> {
        match self {
            Self::HalfOpening(x) | Self::Thickness(x) | Self::Friction(Friction::Angle(x)) => {
                Some(x.enclosure(bits))
            }
            Self::Friction(Friction::Coefficient(mu)) => Some(arctangent(&mu.enclosure(bits))),
            Self::Friction(Friction::Infinite) => None,
        }
    }
}

impl fmt::Display for Contour {
    /// `half opening 80deg`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name(), self.given())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    #[test]
    fn a_friction_is_a_coefficient_or_an_angle() {
        let friction = |text: &str| Contour::Friction(text.parse().unwrap());
        let [one, other] = ["1", "45deg"].map(|text| friction(text).value(100).unwrap());
        assert!(one.overlaps(&other));
        assert!(!one.overlaps(&friction("1.000001").value(100).unwrap()), "false twin");
        assert!(friction("inf").value(100).is_none());
        assert_eq!(friction("0.6").to_string(), "friction 0.6");
    }
}
