//! `couplet voussoirs`.

use super::arch::{ArchArguments, Missing};
use super::notes;
use super::output::OutputFile;
use super::tilt::{acceleration, tilted_as, write};
use crate::certify::state::{Answer, Balls, Figure};
use crate::certify::{
    Error, MOST_TILTED_STONES, VoussoirStanding, Voussoirs, assess_voussoirs, tilted_stones,
    voussoir_loss, voussoirs,
};
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::Arch;
use crate::problem::stones::{MOST_STONES, Stones, StonesError};
use crate::report::{Content, Format, GivenThickness, Report, VoussoirArch, VoussoirArches};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, thickness};
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

    /// Stones of the whole arch, all of the same angle; an odd number has a keystone. A range, 2..200, tells how
    /// the thickness comes near that of many, as a table or, with -o convergence.svg, a figure.
    #[arg(long, value_name = "N", conflicts_with = "joints", value_parser = numbers, allow_hyphen_values = true)]
    stones: Option<StoneNumbers>,

    /// Angles of the joints of the half arch instead, with commas between them, from the crown (0, or half a
    /// keystone) to the shoulder.
    #[arg(
        long,
        value_name = "ANGLES",
        conflicts_with = "half_opening",
        allow_hyphen_values = true
    )]
    joints: Option<String>,

    /// Thickness-to-radius ratio, between 0 and 2: whether the arch stands then, its safety factors, and the
    /// thrusts it can bear.
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: Option<String>,

    /// A uniform horizontal acceleration over that of gravity (0.1), or the angle by which the ground is tilted
    /// (5deg): whether an arch of this thickness and of at most 2001 stones has an admissible state left, and the
    /// largest one with which it has.
    #[arg(long, value_name = "K", requires = "thickness", allow_hyphen_values = true)]
    tilt: Option<String>,

    #[arg(long, value_parser = parse::format(Content::Voussoirs), help = parse::format_help(Content::Voussoirs))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet voussoirs --half-opening pi/2 --friction 0.6 --stones 11";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let given = arguments.joints.as_deref().map(joints).transpose()?;
    let option =
        (given.is_none() && arguments.stones.is_none()).then_some("--stones (or --joints)");
    let needs = Missing { option, example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, given.as_ref().map(Stones::half_opening))?;
    let is_range = matches!(arguments.stones, Some(StoneNumbers { is_range: true, .. }));
    let stones = match (given, arguments.stones, arches.first()) {
        (Some(given), ..) => vec![given],
        (None, Some(StoneNumbers { first, last, .. }), Some(arch)) => {
            let equal = |stones| Stones::equal(stones, arch.half_opening().clone());
            (first..=last).map(equal).collect::<Result<_, StonesError>>()?
        }
        _ => return Err(format!("for example: {EXAMPLE}").into()),
    };
    let eta = arguments.thickness.as_deref().map(thickness).transpose()?;
    if is_range && eta.is_some() {
        return Err(ONE_NUMBER.into());
    }
    if let (Some(tilt), Some(eta), [stones]) = (&arguments.tilt, &eta, &stones[..]) {
        return tilted(arguments, &arches, (stones, eta), tilt);
    }
    let format = arguments.file.format(arguments.format, Content::Voussoirs, "table")?;
    if format.is_picture && !is_range {
        return Err(RANGE.into());
    }
    let file = arguments.file.open_for(format)?;
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    let digits = arguments.arch.digits;
    let of_weight = |arch: &Arch| {
        let continuous = match Balls::Mpfr.state(arch, digits, false) {
            Ok(Answer::Stands(state)) => Some(state.thickness),
            _ => None,
        };
        let (stones, arch, eta) = (stones.clone(), arch.clone(), eta.clone());
        stones
            .into_iter()
            .map(move |stones| answer(&arch, stones, continuous.as_ref(), eta.as_ref(), digits))
    };
    let arches = arches.iter().flat_map(of_weight).collect::<Result<_, Failure>>()?;
    let answers = VoussoirArches { arches, is_range };
    if format.is_picture && answers.arches.iter().all(|arch| arch.loss.is_none()) {
        let message =
            "there is nothing to draw: of none of these numbers of stones a loss is proved";
        return Err(message.into());
    }
    let open = answers.arches.iter().find_map(VoussoirArch::first_open).cloned();
    file.report((&Report::Voussoirs(answers), format), open)
}

/// The arches under an acceleration.
fn tilted(
    arguments: &Arguments,
    arches: &[Arch],
    (stones, eta): (&Stones, &ExactNumber),
    tilt: &str,
) -> Result<(), Failure> {
    let format = tilted_as(arguments.file.format(arguments.format, Content::Tilted, "table")?)?;
    if stones.count() > MOST_TILTED_STONES / 2 + 1 {
        let most = MOST_TILTED_STONES;
        return Err(format!("--tilt looks at every joint: give at most {most} stones").into());
    }
    let tilt = acceleration(tilt, arches)?;
    let file = arguments.file.open_for(format)?;
    let digits = arguments.arch.digits;
    write((file, format), arches, (eta, &tilt), Some(stones), |arch| {
        let standing = assess_voussoirs(stones, arch.weight(), arch.friction(), eta, digits)?;
        Ok(match standing.standing {
            Ok(VoussoirStanding::Stands(_)) => {
                Ok(Some(tilted_stones(arch, stones, eta, &tilt, digits)?))
            }
            Ok(VoussoirStanding::Falls(_)) => Ok(None),
            Err(undecided) => Err(undecided),
        })
    })
}

/// Answer that is proved of one arch.
fn answer(
    arch: &Arch,
    stones: Stones,
    continuous: Option<&Figure>,
    eta: Option<&ExactNumber>,
    digits: usize,
) -> Result<VoussoirArch, Failure> {
    let found = Error::apart(voussoirs(&stones, arch.weight(), arch.friction(), digits))?;
    let loss = match (&found, continuous) {
        (Ok(Voussoirs::Stands(state)), Some(continuous)) => {
            voussoir_loss(continuous, &state.thickness)
        }
        _ => None,
    };
    let given = |eta: &ExactNumber| -> Result<GivenThickness, Failure> {
        let found = assess_voussoirs(&stones, arch.weight(), arch.friction(), eta, digits)?;
        Ok(GivenThickness { thickness: eta.clone(), found })
    };
    let given = eta.map(given).transpose()?;
    let (weight, friction) = (arch.weight(), arch.friction().to_string());
    let continuous = continuous.cloned();
    Ok(VoussoirArch { weight, friction, stones, found, continuous, loss, given })
}

/// Numbers of stones, all from the first to the last.
#[derive(Clone, Copy, Debug)]
struct StoneNumbers {
    first: u64,
    last: u64,
    is_range: bool,
}

/// Numbers in a range at most.
const MOST_NUMBERS: u64 = 10_000;
const ONE_NUMBER: &str =
    "a given thickness asks for one number of stones: leave out --thickness, or give one";
const RANGE: &str = "a picture shows how the thickness comes near that of many stones: give a range, --stones 2..200";

/// A number of stones, or a range.
fn numbers(text: &str) -> Result<StoneNumbers, String> {
    let wrong = || {
        format!(
            "stones are a whole number from 2 to {MOST_STONES}, or a range of at most {MOST_NUMBERS}, as in 2..200"
        )
    };
    let number = |text: &str| {
        let number = text.trim().parse().ok();
        number.filter(|number| (2..=MOST_STONES).contains(number)).ok_or_else(wrong)
    };
    let is_range = text.contains("..");
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let numbers = StoneNumbers { first: number(first)?, last: number(last)?, is_range };
    let count = (numbers.last + 1).checked_sub(numbers.first).filter(|count| *count > 0);
    count.filter(|count| *count <= MOST_NUMBERS).map(|_| numbers).ok_or_else(wrong)
}

/// Angles with commas between them.
fn joints(text: &str) -> Result<Stones, Failure> {
    let angles = text.split(',').map(|angle| angle.trim().parse());
    Ok(Stones::joints(angles.collect::<Result<_, ParseExactError>>()?)?)
}
