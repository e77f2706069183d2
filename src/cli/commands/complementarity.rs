//! `couplet complementarity`.

use super::arch::{ArchArguments, Needs};
use super::output::OutputFile;
use super::parse;
use crate::certify::state::Inquiry;
use crate::certify::{MOST_JOINTED_STONES, asymmetric, programme};
use crate::cli::failure::Failure;
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::report::{
    AtThickness, ComplementarityArch, ComplementarityArches, Content, Format, Report,
};
use clap::Args;

/// Print the thicknesses at which the complementarity problem (19) of the whole arch has a solution, each proved.
///
/// A solution is an admissible state with a motion of the joints that are at their limits, without dilatancy. Among
/// symmetric ones there is one thickness, the least; some horseshoes have asymmetric ones at a larger thickness. What is
/// printed is proved; that there are no others is not.
#[derive(Args)]
#[command(
    override_usage = "couplet complementarity --half-opening <ANGLE> --friction <MU> [--thickness <ETA> --stones <N>] [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Enclose the least value of the programme (20) at this thickness-to-radius ratio (0.55, 11/20) too, between equal stones.
    #[arg(long, visible_alias = "eta", value_name = "ETA", requires = "stones", value_parser = parse::thickness, allow_hyphen_values = true)]
    thickness: Option<ExactNumber>,

    /// Stones of the whole arch for the programme (20), 2 to 100; its conditions hold at the joints between them.
    #[arg(long, value_name = "N", requires = "thickness", value_parser = stones, allow_negative_numbers = true)]
    stones: Option<u64>,

    #[arg(long, value_parser = parse::format(Content::Complementarity), help = parse::format_help(Content::Complementarity))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

/// A number of stones.
fn stones(text: &str) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (2..=MOST_JOINTED_STONES).contains(number));
    number.ok_or_else(|| format!("stones are a whole number from 2 to {MOST_JOINTED_STONES}"))
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet complementarity --half-opening 2.3 --friction 1.05";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let needs = Needs { missing: Vec::new(), example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, None)?;
    let format = arguments.file.format(arguments.format, Content::Complementarity, "table")?;
    let file = arguments.file.open_for(format)?;
    let digits = arguments.arch.digits;
    let asked = arguments.thickness.as_ref().zip(arguments.stones);
    if asked.is_some() && arches.iter().any(|arch| !arch.is_limited()) {
        let words = "the programme (20) needs a limited friction: give --friction a number";
        return Err(Failure::Input(words.to_owned()));
    }
    let answer = |arch: Arch| ComplementarityArch {
        programme: asked.map(|(thickness, stones)| AtThickness {
            thickness: thickness.to_string(),
            stones,
            found: programme(&arch, thickness, stones),
        }),
        symmetric: Inquiry::new(&arch, digits, false).state(digits, false),
        asymmetric: asymmetric(&arch, digits),
        arch,
    };
    let answers = ComplementarityArches(arches.into_iter().map(answer).collect());
    let open = answers.0.iter().find_map(|answer| answer.first_open().cloned());
    file.write(|out| Report::Complementarity(answers).write(format, out))?;
    open.map_or(Ok(()), |open| Err(Failure::Undecided(open.to_string())))
}
