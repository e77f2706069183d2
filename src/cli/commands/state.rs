//! `couplet state`.

use super::Failure;
use super::arch::ArchArguments;
use super::output::Destination;
use crate::certify::state::Answer;
use crate::certify::{CertifiedLandmark, Value};
use crate::problem::{Landmark, Mode};
use crate::report::{StateAt, StateOf, StateReport};
use clap::Args;

/// Print whether an arch can stand, how thin it can be, and how it collapses there, with a proof.
///
/// The proof: the equations of the mode have one solution in a box; that state is admissible on the
/// whole half arch; no thinner arch has an admissible state; every comparison is decided.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// A landmark instead of an arch: T, S, J, B, l, L or sb, with all modes that meet there.
    #[arg(long, value_name = "LANDMARK", value_parser = super::landmark, conflicts_with_all = ["half_opening", "friction", "friction_angle"])]
    at: Option<Landmark>,

    #[command(flatten)]
    destination: Destination,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(landmark) = arguments.at {
        return at_landmark(landmark, arguments);
    }
    let (arch, friction) = arguments.arch.arch()?;
    let output = arguments.destination.open()?;
    let answer = arch.certify(arguments.arch.digits);
    let outcome = match &answer {
        Ok(Answer::Stands(digits)) => StateOf::Stands(digits),
        Ok(Answer::Falls(fall)) => StateOf::Falls(*fall),
        Err(doubt) => StateOf::Undecided(doubt),
    };
    let report = StateReport {
        weight: arch.weight(),
        half_opening: arch.half_opening().to_string(),
        friction,
        doubles: arguments.arch.digits == 17,
        outcome,
    };
    output.write(|out| report.write(arguments.destination.format, out))?;
    match answer {
        Ok(_) => Ok(()),
        Err(doubt) => Err(Failure::Undecided(format!("undecided: {}", doubt.question))),
    }
}

fn at_landmark(landmark: Landmark, arguments: &Arguments) -> Result<(), Failure> {
    let output = arguments.destination.open()?;
    let undecided = |error: crate::certify::Undecided| Failure::Undecided(error.to_string());
    let point = CertifiedLandmark::new(landmark, arguments.arch.weight).map_err(undecided)?;
    let constants = point.constants(arguments.arch.digits, &|| ()).map_err(undecided)?;
    let modes: Vec<Mode> = landmark.modes().to_vec();
    let values =
        constants.iter().filter(|c| !matches!(c.value, Value::Infinite) || c.exact.is_some());
    let report =
        StateAt { landmark, weight: point.weight(), modes, constants: values.cloned().collect() };
    output.write(|out| report.write(arguments.destination.format, out))
}
