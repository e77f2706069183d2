//! `couplet state`.

use super::arch::ArchArguments;
use super::output::AnswerOutput;
use super::parse;
use crate::certify::CertifiedLandmark;
use crate::certify::state::Certify;
use crate::cli::failure::Failure;
use crate::problem::Landmark;
use crate::report::{Answer, Answers, Report, Status};
use clap::Args;

/// Print whether an arch can stand, how thin it can be, and how it collapses there, with a proof.
///
/// The proof: the equations of the mode have one solution in a box; that state is admissible on the
/// whole half arch; no thinner arch has an admissible state; every comparison is decided.
#[derive(Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// A landmark instead of an arch: T, S, J, B, l, L or sb, with all modes that meet there.
    #[arg(long, value_name = "LANDMARK", value_parser = parse::landmark, conflicts_with_all = ["half_opening", "friction", "friction_angle"])]
    at: Option<Landmark>,

    #[command(flatten)]
    output: AnswerOutput,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(landmark) = arguments.at {
        return at_landmark(landmark, arguments);
    }
    let (arch, digits) = (arguments.arch.arch()?, arguments.arch.digits);
    print(&arguments.output, digits, || Answer::state(1, &arch, &arch.certify(digits)))
}

/// Computes and prints the answer for one arch.
pub(super) fn print(
    output: &AnswerOutput,
    digits: usize,
    answer: impl FnOnce() -> Answer,
) -> Result<(), Failure> {
    let file = output.open()?;
    let answer = answer();
    let undecided = match &answer.status {
        Status::Undecided(undecided) => Err(Failure::Undecided(undecided.to_string())),
        _ => Ok(()),
    };
    let report = Report::Answers(Answers::arch(digits, answer));
    file.write(|out| report.write(output.format, out))?;
    undecided
}

fn at_landmark(landmark: Landmark, arguments: &Arguments) -> Result<(), Failure> {
    let output = arguments.output.open()?;
    let (weight, digits) = (arguments.arch.weight, arguments.arch.digits);
    let undecided = |error: crate::certify::Undecided| Failure::Undecided(error.to_string());
    let point = CertifiedLandmark::new(landmark, weight).map_err(undecided)?;
    let constants = point.constants(digits).map_err(undecided)?;
    let answer = Answer::landmark((landmark, weight), Ok((&point, constants)));
    let answer = Answer { modes: landmark.modes().to_vec(), ..answer };
    let report = Report::Answers(Answers::point(digits, answer));
    output.write(|out| report.write(arguments.output.format, out))
}
