//! Horizontal accelerations on the command line.

use super::notes;
use super::output::Output;
use crate::certify::{TiltDigits, Undecided};
use crate::number::ExactNumber;
use crate::problem::stones::Stones;
use crate::problem::{Arch, Slope};
use crate::report::{Format, Report, TiltedArch, Understood};
use crate::sweep::failure::Failure;

/// Proves and writes the answers for arches under an acceleration.
pub(super) fn write(
    (output, format): (Output, &Format),
    (asked, arches): (&Understood, &[Arch]),
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
        let asked = asked.clone();
        Ok(TiltedArch { asked, weight, given, stones, is_limited, found })
    };
    let answers: Vec<TiltedArch> = arches.iter().map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(TiltedArch::first_open).cloned();
    output.report((&Report::Tilted(answers), format), open)
}
