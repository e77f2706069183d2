//! `couplet voussoirs`.

use super::arch::{ArchArguments, Needs};
use super::notes;
use super::output::OutputFile;
use super::tilt::acceleration;
use crate::certify::state::{Answer, Balls, Figure};
use crate::certify::{
    Error, MOST_TILTED_STONES, VoussoirStanding, Voussoirs, assess_voussoirs, tilted_stones,
    voussoir_loss, voussoirs,
};
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::problem::stones::{MOST_STONES, Stones, StonesError};
use crate::report::{
    Content, Format, GivenThickness, Report, TiltedArch, TiltedArches, VoussoirArch, VoussoirArches,
};
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

    /// Stones of the whole arch, all of the same angle; an odd number has a keystone. A range, 2..200, tells how the thickness comes near that
    /// of many, as a table or, with -o convergence.svg, a figure.
    #[arg(long, value_name = "N", conflicts_with = "joints", value_parser = numbers, allow_hyphen_values = true)]
    stones: Option<Numbers>,

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

    /// A uniform horizontal acceleration over that of gravity (0.1), or the angle by which the ground is tilted (5deg): whether an arch of this
    /// thickness and of at most 2001 stones has an admissible state left, and the largest one with which it has.
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
    let missing =
        (given.is_none() && arguments.stones.is_none()).then_some("--stones (or --joints)");
    let needs = Needs { missing: missing.into_iter().collect(), example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, given.as_ref().map(Stones::half_opening))?;
    let is_range = matches!(arguments.stones, Some(Numbers { is_range: true, .. }));
    let stones = match (given, arguments.stones, arches.first()) {
        (Some(given), ..) => vec![given],
        (None, Some(Numbers { first, last, .. }), Some(arch)) => {
            let equal = |stones| Stones::equal(stones, arch.half_opening().clone());
            let all: Result<Vec<Stones>, StonesError> = (first..=last).map(equal).collect();
            all.map_err(|error| Failure::Input(error.to_string()))?
        }
        _ => return Err(Failure::Input(format!("for example: {EXAMPLE}"))),
    };
    let eta = arguments.thickness.as_deref().map(thickness).transpose().map_err(Failure::Input)?;
    if is_range && eta.is_some() {
        return Err(Failure::Input(ONE_NUMBER.to_owned()));
    }
    if let (Some(tilt), Some(eta), [stones]) = (&arguments.tilt, &eta, &stones[..]) {
        return tilted(arguments, &arches, (stones, eta), tilt);
    }
    let format = arguments.file.format(arguments.format, Content::Voussoirs, "table")?;
    if format.is_picture && !is_range {
        return Err(Failure::Input(RANGE.to_owned()));
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
        return Err(Failure::Input(message.to_owned()));
    }
    let open = answers.arches.iter().find_map(VoussoirArch::first_open).cloned();
    file.write(|out| Report::Voussoirs(answers).write(format, out))?;
    open.map_or(Ok(()), |open| Err(Failure::Undecided(open.to_string())))
}

/// The arches under an acceleration.
fn tilted(
    arguments: &Arguments,
    arches: &[Arch],
    (stones, eta): (&Stones, &ExactNumber),
    tilt: &str,
) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Content::Tilted, "table")?;
    if format.tilt.is_none() {
        let names = Format::names(Content::Tilted);
        let message = format!("--tilt is not written as {}; the formats are {names}", format.name);
        return Err(Failure::Input(message));
    }
    if stones.count() > MOST_TILTED_STONES / 2 + 1 {
        let message =
            format!("--tilt looks at every joint: give at most {MOST_TILTED_STONES} stones");
        return Err(Failure::Input(message));
    }
    let tilt = acceleration(tilt, arches)?;
    let file = arguments.file.open_for(format)?;
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    notes::tilt(&tilt);
    let digits = arguments.arch.digits;
    let answer = |arch: &Arch| {
        let (weight, friction) = (arch.weight(), arch.friction());
        let standing = assess_voussoirs(stones, weight, friction, eta, digits)?;
        let found = match standing.standing {
            Ok(VoussoirStanding::Stands(_)) => {
                Ok(Some(tilted_stones(arch, stones, eta, &tilt, digits)?))
            }
            Ok(VoussoirStanding::Falls(_)) => Ok(None),
            Err(undecided) => Err(undecided),
        };
        let given = [
            arch.half_opening().to_string(),
            friction.to_string(),
            eta.to_string(),
            tilt.to_string(),
        ];
        let (stones, is_limited) = (Some(stones.clone()), arch.is_limited());
        Ok(TiltedArch { weight, given, stones, is_limited, found })
    };
    let answers = TiltedArches(arches.iter().map(answer).collect::<Result<_, Failure>>()?);
    let open = answers.0.iter().find_map(TiltedArch::first_open).cloned();
    file.write(|out| Report::Tilted(answers).write(format, out))?;
    open.map_or(Ok(()), |open| Err(Failure::Undecided(open.to_string())))
}

/// What is proved of one arch.
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
struct Numbers {
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
fn numbers(text: &str) -> Result<Numbers, String> {
    let wrong = || {
        format!(
            "stones are a whole number from 2 to {MOST_STONES}, or a range of at most {MOST_NUMBERS}, as in 2..200"
        )
    };
    let number = |text: &str| {
        text.trim()
            .parse()
            .ok()
            .filter(|number| (2..=MOST_STONES).contains(number))
            .ok_or_else(wrong)
    };
    let numbers = match text.split_once("..") {
        Some((first, last)) => {
            Numbers { first: number(first)?, last: number(last)?, is_range: true }
        }
        None => {
            let first = number(text)?;
            Numbers { first, last: first, is_range: false }
        }
    };
    let count = (numbers.last + 1).checked_sub(numbers.first).filter(|count| *count > 0);
    count.filter(|count| *count <= MOST_NUMBERS).map(|_| numbers).ok_or_else(wrong)
}

/// Angles with commas between them.
fn joints(text: &str) -> Result<Stones, Failure> {
    let angles: Result<Vec<ExactNumber>, _> =
        text.split(',').map(|angle| angle.trim().parse()).collect();
    let angles = angles.map_err(|error| Failure::Input(error.to_string()))?;
    Stones::joints(angles).map_err(|error| Failure::Input(error.to_string()))
}
