//! Horizontal accelerations on the command line.

use crate::number::shown;
use crate::problem::{Arch, Friction, Slope, SlopeError};
use crate::sweep::failure::Failure;

/// Whether there is none.
fn is_zero(friction: &Friction) -> bool {
    match friction {
        Friction::Coefficient(x) | Friction::Angle(x) => x.to_rational() == 0,
        Friction::Infinite => false,
    }
}

/// A horizontal acceleration of arches: a ratio to that of gravity, or an angle of the ground.
pub(super) fn acceleration(text: &str, arches: &[Arch]) -> Result<Slope, Failure> {
    let why = |error: SlopeError| match error {
        SlopeError::Negative => {
            "is negative: give its size, for to the other side the arch is its mirror image"
        }
        SlopeError::Angle => "is not an angle from 0 to below 90deg",
        _ => "is no acceleration: give a number (0.1) or an angle (5deg)",
    };
    let wrong = |error| Failure::Input(format!("the tilt '{}' {}", shown(text), why(error)));
    let tilt = text.parse().map_err(wrong)?;
    if arches.iter().any(|arch| is_zero(arch.friction())) {
        return Err(Failure::Input(
            "without friction nothing stands: --tilt asks for a friction above 0".to_owned(),
        ));
    }
    Ok(tilt)
}
