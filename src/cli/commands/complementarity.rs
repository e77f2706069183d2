//! `couplet complementarity`.

use super::arch::{ArchArguments, Needs};
use super::output::OutputFile;
use super::parse;
use crate::certify::asymmetric;
use crate::certify::state::Inquiry;
use crate::cli::failure::Failure;
use crate::problem::Arch;
use crate::report::{ComplementarityArch, ComplementarityArches, Content, Format, Report};
use clap::Args;

/// Print the thicknesses at which the complementarity problem (19) of the whole arch has a solution, each proved.
///
/// A solution is an admissible state with a motion of the joints that are at their limits, without dilatancy. Among
/// symmetric ones there is one thickness, the least; some horseshoes have asymmetric ones at a larger thickness. What is
/// printed is proved; that there are no others is not.
#[derive(Args)]
#[command(
    override_usage = "couplet complementarity --half-opening <ANGLE> --friction <MU> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    #[arg(long, value_parser = parse::format(Content::Complementarity), help = parse::format_help(Content::Complementarity))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet complementarity --half-opening 2.3 --friction 1.05";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let needs = Needs { missing: Vec::new(), example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, None)?;
    let format = arguments.file.format(arguments.format, Content::Complementarity, "table")?;
    let file = arguments.file.open_for(format)?;
    let digits = arguments.arch.digits;
    let answer = |arch: Arch| ComplementarityArch {
        symmetric: Inquiry::new(&arch, digits, false).state(digits, false),
        asymmetric: asymmetric(&arch, digits),
        arch,
    };
    let answers = ComplementarityArches(arches.into_iter().map(answer).collect());
    let open = answers.0.iter().find_map(|answer| answer.first_open().cloned());
    file.write(|out| Report::Complementarity(answers).write(format, out))?;
    open.map_or(Ok(()), |open| Err(Failure::Undecided(open.to_string())))
}
