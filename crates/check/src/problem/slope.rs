//! A slope, as it is given: a ratio or an angle.

use super::{ArchError, Friction};
use crate::number::says;
use std::ops::Deref;
use std::str::FromStr;

/// A ratio of at least 0, by itself or as the tangent of an angle below a right one: that of a horizontal
/// acceleration to gravity. A friction that is limited is written, shown and computed with in the same way.
///
/// ```
/// use couplet_check::problem::{Slope, SlopeError};
/// assert_eq!("5deg".parse::<Slope>().unwrap().to_string(), "tan(5deg)");
/// assert_eq!("inf".parse::<Slope>(), Err(SlopeError::Unreadable));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Slope(Friction);

/// Why a slope is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SlopeError {
    /// A text is neither a ratio nor an angle.
    Unreadable,
    /// The ratio is negative.
    Negative,
    /// The angle is not between 0 and a right one.
    Angle,
}

says!(SlopeError {
    Self::Unreadable => "neither a number (0.1) nor an angle (5deg)";
    Self::Negative => "negative";
    Self::Angle => "not an angle from 0 to below 90deg";
});

impl FromStr for Slope {
    type Err = SlopeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.parse::<Friction>() {
            Err(_) | Ok(Friction::Infinite) => Err(SlopeError::Unreadable),
            Ok(given) => match given.checked(true) {
                Err(ArchError::Friction(_)) => Err(SlopeError::Negative),
                Err(_) | Ok(Friction::Infinite) => Err(SlopeError::Angle),
                Ok(slope) => Ok(Self(slope)),
            },
        }
    }
}

impl Deref for Slope {
    type Target = Friction;

    fn deref(&self) -> &Friction {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_is_not_negative_and_below_a_right_angle() {
        let refused = |text: &str| text.parse::<Slope>().unwrap_err();
        assert_eq!(["inf", "steep"].map(refused), [SlopeError::Unreadable; 2]);
        assert_eq!(["-0.1", "-1e-30"].map(refused), [SlopeError::Negative; 2]);
        assert_eq!(["-1deg", "90deg", "tan(2)"].map(refused), [SlopeError::Angle; 3]);
        for text in ["0", "7.5", "tan(0deg)", "tan(89.9deg)", "tan(pi/4)"] {
            assert_eq!(text.parse::<Slope>().unwrap().to_string(), text);
        }
    }
}
