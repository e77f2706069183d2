//! `couplet assess`.

use super::Failure;
use super::arch::{ArchArguments, thickness};
use super::output::Destination;
use crate::certify::state::Certify;
use crate::report::AssessReport;
use clap::Args;

/// Print whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Thickness-to-radius ratio, between 0 and 2 (0.12, 3/25).
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: String,

    #[command(flatten)]
    destination: Destination,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (arch, friction) = arguments.arch.arch()?;
    let eta = thickness(&arguments.thickness).map_err(Failure::Input)?;
    let output = arguments.destination.open()?;
    let outcome = arch.certify_thickness(&eta, arguments.arch.digits);
    let report = AssessReport {
        weight: arch.weight(),
        half_opening: arch.half_opening().to_string(),
        friction,
        thickness: arguments.thickness.clone(),
        doubles: arguments.arch.digits == 17,
        outcome: &outcome,
    };
    output.write(|out| report.write(arguments.destination.format, out))?;
    match outcome {
        Ok(_) => Ok(()),
        Err(doubt) => Err(Failure::Undecided(doubt.to_string())),
    }
}
