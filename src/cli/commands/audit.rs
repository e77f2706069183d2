//! `couplet audit`.

use super::output::OutputFile;
use crate::picture::Print;
use crate::problem::Landmark;
use crate::report::{Audit, Format, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use crate::sweep::scene::{ItemKind, Request, answered};
use clap::Args;

/// Compare every number the paper prints with certified ones.
///
/// Its claims on the two weights too.
///
/// The exit code tells whether everything was decided, not whether the paper is right. CSV has the
/// printed numbers only.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Only the numbers of these landmarks (T, triple), with commas between several.
    #[arg(long, value_name = "LANDMARK", value_delimiter = ',', value_parser = parse::landmark)]
    only: Vec<Landmark>,

    /// Only those of a self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "both", value_parser = parse::weights)]
    weight: Weights,

    #[arg(long, value_parser = parse::format(Audit::content()), help = parse::usual_format_help(Audit::content(), "table"))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Audit::content(), "table")?;
    let output = arguments.file.open()?;
    let is_asked =
        |landmark: &Landmark| arguments.only.is_empty() || arguments.only.contains(landmark);
    let landmarks = Landmark::ALL.into_iter().filter(is_asked);
    let weights = arguments.weight.to_vec();
    let points = landmarks.flat_map(|of| weights.iter().map(move |&weight| (of, weight))).collect();
    let what = Request::Audit { points };
    let answer = answered(ItemKind::Audit, what, (format, &Print::default()));
    output.write(|out| answer.write(out))?;
    Failure::of_open(answer.undecided)
}
