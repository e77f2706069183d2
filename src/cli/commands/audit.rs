//! `couplet audit`.

use super::output::OutputFile;
use super::parse;
use crate::cli::failure::Failure;
use crate::judge::{audit, compare_weights};
use crate::report::{Audit, Content, Format, Report};
use clap::Args;

/// Compare every number the paper prints, and its claims on the two weights, with certified values.
///
/// The exit code tells whether everything was decided, not whether the paper is right. CSV has the
/// printed numbers only.
#[derive(Args)]
pub(crate) struct Arguments {
    #[arg(long, default_value = "table", value_parser = parse::format(Content::Audit), help = parse::format_help(Content::Audit))]
    format: &'static Format,

    #[command(flatten)]
    file: OutputFile,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let output = arguments.file.open()?;
    let undecided =
        |undecided: crate::certify::Undecided| Failure::Undecided(undecided.to_string());
    let report = Report::Audit(Audit {
        printed: audit().map_err(undecided)?,
        comparisons: compare_weights().map_err(undecided)?,
    });
    output.write(|out| report.write(arguments.format, out))
}
