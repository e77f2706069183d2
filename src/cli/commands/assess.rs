//! `couplet assess`.

use super::arch::{ArchArguments, thickness};
use super::output::AnswerOutput;
use super::state::print;
use crate::certify::state::Certify;
use crate::cli::failure::Failure;
use crate::report::Answer;
use clap::Args;

/// Print whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear.
#[derive(Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Thickness-to-radius ratio, between 0 and 2 (0.12, 3/25).
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: String,

    #[command(flatten)]
    output: AnswerOutput,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let arch = arguments.arch.arch()?;
    let eta = thickness(&arguments.thickness).map_err(Failure::Input)?;
    let digits = arguments.arch.digits;
    print(&arguments.output, digits, || {
        Answer::assessment(1, (&arch, &eta), &arch.certify_thickness(&eta, digits))
    })
}
