//! `couplet audit`.

use super::Failure;
use super::output::Destination;
use crate::judge::{audit, compare_weights};
use crate::report::Audit;
use clap::Args;

/// Compare every number the paper prints, and its claims on the two weights, with certified values.
///
/// The exit code says whether everything could be decided, not whether the paper is right. The
/// format csv has the printed numbers only.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    destination: Destination,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let output = arguments.destination.open()?;
    let undecided =
        |undecided: crate::certify::Undecided| Failure::Undecided(undecided.to_string());
    let report = Audit {
        printed: audit().map_err(undecided)?,
        comparisons: compare_weights().map_err(undecided)?,
    };
    output.write(|out| report.write(arguments.destination.format, out))
}
