//! `couplet audit`.

use super::Failure;
use super::output::Output;
use crate::certify::{audit, compare_weights};
use crate::report::{Audit, Format};
use clap::Args;
use std::path::PathBuf;

/// Compare every number the paper prints, and its claims on the two weights, with certified values.
///
/// The exit code says whether everything could be decided, not whether the paper is right.
#[derive(Args)]
pub struct Arguments {
    /// Output format: table, json or csv (csv has the printed numbers only).
    #[arg(long, default_value = "table", value_parser = super::format)]
    format: Format,

    /// Write to a file instead of standard output; it appears whole or not at all.
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let output = Output::open(arguments.output.as_deref())?;
    let undecided =
        |undecided: crate::certify::Undecided| Failure::Undecided(undecided.to_string());
    let report = Audit {
        printed: audit().map_err(undecided)?,
        comparisons: compare_weights().map_err(undecided)?,
    };
    output.write(|out| report.write(arguments.format, out))
}
