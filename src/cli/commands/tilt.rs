//! Horizontal accelerations on the command line.

use super::notes;
use super::output::Output;
use crate::certify::{TiltDigits, Undecided};
use crate::number::{ExactNumber, shown};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Friction, Slope, SlopeError};
use crate::report::{Content, Format, Report, TiltedArch};
use crate::sweep::failure::Failure;

/// Tells whether a friction is zero.
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
        return Err("without friction nothing stands: --tilt asks for a friction above 0".into());
    }
    Ok(tilt)
}

/// A format that tilted arches are written in.
pub(super) fn tilted_as(format: &'static Format) -> Result<&'static Format, Failure> {
    let names = Format::names(Content::Tilted);
    let message = || format!("--tilt is not written as {}; the formats are {names}", format.name);
    Ok(Content::Tilted.is_written_as(format).then_some(format).ok_or_else(message)?)
}

/// Proves and writes the answers for arches under an acceleration.
pub(super) fn write(
    (output, format): (Output, &Format),
    arches: &[Arch],
    (eta, tilt): (&ExactNumber, &Slope),
    stones: Option<&Stones>,
    found: impl Fn(&Arch) -> Result<Result<Option<TiltDigits>, Undecided>, Failure>,
) -> Result<(), Failure> {
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    notes::tilt(tilt);
    let answer = |arch: &Arch| {
        let found = found(arch)?;
        let (weight, is_limited, stones) = (arch.weight(), arch.is_limited(), stones.cloned());
        let (alpha, mu) = (arch.half_opening().to_string(), arch.friction().to_string());
        let given = [alpha, mu, eta.to_string(), tilt.to_string()];
        Ok(TiltedArch { weight, given, stones, is_limited, found })
    };
    let answers: Vec<TiltedArch> = arches.iter().map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(TiltedArch::first_open).cloned();
    output.report((&Report::Tilted(answers), format), open)
}
