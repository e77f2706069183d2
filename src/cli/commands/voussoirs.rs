//! `couplet voussoirs`.

use super::arch::{ArchArguments, Needs, thickness};
use super::output::OutputFile;
use super::parse;
use crate::certify::state::{Answer, Inquiry};
use crate::certify::{assess_voussoirs, voussoirs};
use crate::cli::failure::Failure;
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::problem::stones::{MOST_STONES, Stones};
use crate::report::{Content, Format, GivenThickness, Report, VoussoirArch, VoussoirArches};
use clap::Args;

/// Print the least thickness of an arch of given stones, and how it collapses there, with a proof.
///
/// The conditions hold at the joints between the stones and nowhere else, so that such an arch needs a little less
/// than one that can open and slide at every angle. The cost does not depend on the number of stones.
#[derive(Args)]
#[command(
    override_usage = "couplet voussoirs --half-opening <ANGLE> --friction <MU> --stones <N> [OPTIONS]\n       \
                            couplet voussoirs --joints <ANGLES> --friction <MU> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Stones of the whole arch, all of the same angle; an odd number has a keystone.
    #[arg(long, value_name = "N", conflicts_with = "joints", value_parser = number, allow_negative_numbers = true)]
    stones: Option<u64>,

    /// Angles of the joints of the half arch instead, with commas between them, from the crown (0, or half a keystone) to the
    /// shoulder.
    #[arg(
        long,
        value_name = "ANGLES",
        conflicts_with = "half_opening",
        allow_hyphen_values = true
    )]
    joints: Option<String>,

    /// Thickness-to-radius ratio, between 0 and 2: whether the arch stands then, its safety factors, and the thrusts it can bear.
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: Option<String>,

    #[arg(long, value_parser = parse::format(Content::Voussoirs), help = parse::format_help(Content::Voussoirs))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet voussoirs --half-opening pi/2 --friction 0.6 --stones 11";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let given = arguments.joints.as_deref().map(joints).transpose()?;
    let missing =
        (given.is_none() && arguments.stones.is_none()).then_some("--stones (or --joints)");
    let needs = Needs { missing: missing.into_iter().collect(), example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, given.as_ref().map(Stones::half_opening))?;
    let stones = match (given, arguments.stones, arches.first()) {
        (Some(given), ..) => given,
        (None, Some(stones), Some(arch)) => {
            let equal = Stones::equal(stones, arch.half_opening().clone());
            equal.map_err(|error| Failure::Input(error.to_string()))?
        }
        _ => return Err(Failure::Input(format!("for example: {EXAMPLE}"))),
    };
    let eta = arguments.thickness.as_deref().map(thickness).transpose().map_err(Failure::Input)?;
    let format = arguments.file.format(arguments.format, Content::Voussoirs, "table")?;
    let file = arguments.file.open_for(format)?;
    let digits = arguments.arch.digits;
    let answer = |arch: &Arch| VoussoirArch {
        weight: arch.weight(),
        friction: arch.friction().to_string(),
        stones: stones.clone(),
        found: voussoirs(&stones, arch.weight(), arch.friction(), digits),
        continuous: match Inquiry::new(arch, digits, false).state(digits, false) {
            Ok(Answer::Stands(state)) => Some(state.thickness),
            _ => None,
        },
        given: eta.as_ref().map(|eta| GivenThickness {
            thickness: eta.clone(),
            found: assess_voussoirs(&stones, arch.weight(), arch.friction(), eta, digits),
        }),
    };
    let answers = VoussoirArches(arches.iter().map(answer).collect());
    let open = answers.0.iter().find_map(VoussoirArch::first_open).cloned();
    file.write(|out| Report::Voussoirs(answers).write(format, out))?;
    open.map_or(Ok(()), |open| Err(Failure::Undecided(open.to_string())))
}

/// A number of stones.
fn number(text: &str) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (2..=MOST_STONES).contains(number));
    number.ok_or_else(|| format!("stones are a whole number from 2 to {MOST_STONES}"))
}

/// Angles with commas between them.
fn joints(text: &str) -> Result<Stones, Failure> {
    let angles: Result<Vec<ExactNumber>, _> =
        text.split(',').map(|angle| angle.trim().parse()).collect();
    let angles = angles.map_err(|error| Failure::Input(error.to_string()))?;
    Stones::joints(angles).map_err(|error| Failure::Input(error.to_string()))
}
