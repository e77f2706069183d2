//! Horizontal accelerations on the command line.

use crate::arch::SelfWeight;
use crate::number::{ExactNumber, shown};
use crate::problem::{Arch, Friction};
use crate::sweep::failure::Failure;
use rug::Rational;

/// Whether there is none.
fn is_zero(friction: &Friction) -> bool {
    match friction {
        Friction::Coefficient(x) | Friction::Angle(x) => x.to_rational() == 0,
        Friction::Infinite => false,
    }
}

/// A horizontal acceleration of arches: a ratio to that of gravity, or an angle of the ground.
pub(super) fn acceleration(text: &str, arches: &[Arch]) -> Result<Friction, Failure> {
    let tilt = parsed(text)?;
    if arches.iter().any(|arch| is_zero(arch.friction())) {
        return Err(Failure::Input(
            "without friction nothing stands: --tilt asks for a friction above 0".to_owned(),
        ));
    }
    Ok(tilt)
}

fn parsed(text: &str) -> Result<Friction, Failure> {
    let wrong = |why: &str| Err(Failure::Input(format!("the tilt '{}' {why}", shown(text))));
    let tilt: Friction = match text.parse() {
        Ok(tilt) => tilt,
        Err(_) => return wrong("is no acceleration: give a number (0.1) or an angle (5deg)"),
    };
    // What a friction may be, an acceleration may.
    let allowed =
        Arch::new(SelfWeight::Heyman, ExactNumber::from(&Rational::from(1)), tilt.clone());
    match (&tilt, allowed.map(|arch| arch.is_limited())) {
        (Friction::Coefficient(_), Err(_)) => {
            wrong("is negative: give its size, for to the other side the arch is its mirror image")
        }
        (Friction::Angle(_), Err(_) | Ok(false)) => wrong("is not an angle from 0 to below 90deg"),
        (_, Ok(true)) => Ok(tilt),
        _ => wrong("is no acceleration: give a number (0.1) or an angle (5deg)"),
    }
}
