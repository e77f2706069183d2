//! `couplet audit`.

use super::output::OutputFile;
use crate::certify::{CertifiedLandmark, Enclosed, Undecided};
use crate::judge::{audit_of, compare_weights_of, enclosed};
use crate::problem::Landmark;
use crate::report::{Audit, Format, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
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
    let weights = arguments.weight.all();
    let points: Result<Vec<Enclosed>, Undecided> = landmarks
        .flat_map(|landmark| weights.iter().map(move |&weight| (landmark, weight)))
        .map(|(landmark, weight)| enclosed(&CertifiedLandmark::new(landmark, weight)?))
        .collect();
    let points = points?;
    let (printed, comparisons) = (audit_of(&points)?, compare_weights_of(&points)?);
    let report = Audit { printed, comparisons };
    output.write(|out| report.write(format, out))
}
