//! `couplet voussoirs`.

use super::arch::ArchArguments;
use super::draw;
use super::look::{ArchLook, LookArguments};
use super::notes;
use super::output::{AnswerOutput, OutputFile, Printed, is_written};
use super::survey;
use super::tilt;
use crate::ask::{ArchGiven, ArchQuestion, Field, StonesAsked};
use crate::certify::state::{Answer, Certify, Figure};
use crate::certify::{
    Error, Voussoirs, assess_voussoirs, enumerate, measured_voussoirs, voussoir_loss, voussoirs,
};
use crate::cli::line::typed;
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::stones::Stones;
use crate::problem::{Arch, Extent};
use crate::report::{
    Content, Format, GivenThickness, Reported, Sizes, Understood, VoussoirArch, VoussoirArches,
};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;

/// Tell how thin an arch of given stones can be.
///
/// The conditions hold at the joints between the stones and nowhere else, so that such an arch needs a little less
/// than one that can open and slide at every angle. The cost does not depend on the number of stones. A range of them,
/// --stones 2..200, tells how the thickness comes near that of many, as a table or, with -o convergence.svg, a figure;
/// one number, with -o arch.svg, is drawn as couplet draw does.
/// With --thickness: whether the arch stands then, its safety factors, and the thrusts it can bear. With --tilt, of at
/// most 2001 stones, also the largest acceleration.
///
/// Friction and thickness may be ranges, as of `assess`: then it is told of every arch inside. A range of the half
/// opening, the span or the rise would move the joints.
#[derive(Args)]
#[command(
    override_usage = "couplet voussoirs --half-opening <ANGLE> --friction <MU> --stones <N> [OPTIONS]\n       \
                            couplet voussoirs --joints <ANGLES> --friction <MU> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    #[arg(long, value_parser = parse::format(VoussoirArches::content()), help = parse::format_help(VoussoirArches::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    look: LookArguments,
}

/// Question about an arch of stones.
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[],
    needs: &[Field::Stones],
    unlimited: false,
    example: "couplet voussoirs --half-opening pi/2 --friction 0.6 --stones 11",
};

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, VoussoirArches::content(), "table")?;
    let has_range = arguments.arch.asked.has_range();
    let look = |is_drawn| arguments.look.of(format, is_drawn && format.is_drawing());
    if has_range {
        look(false)?;
        return survey::print_of_stones(&QUESTION, &arguments.arch, (&arguments.file, format));
    }
    let (given, arches) = arguments.arch.read(&QUESTION)?;
    let look = look(!given.stones.as_ref().is_some_and(StonesAsked::is_range))?;
    answers(&arguments.arch, &given, &arches, (&arguments.file, format, look))
}

/// Answers for an arch of stones, where the question was one of any arch.
pub(super) fn print(
    arguments: &ArchArguments,
    given: &ArchGiven,
    arches: &[Arch],
    output: &AnswerOutput,
) -> Result<(), Failure> {
    output.tells_all("--stones")?;
    answers(arguments, given, arches, (output.file(), output.format()?, ArchLook::default()))
}

fn answers(
    arguments: &ArchArguments,
    given: &ArchGiven,
    arches: &[Arch],
    (file, format, look): Printed<'_>,
) -> Result<(), Failure> {
    let (asked, digits) = (arguments.understood(given), arguments.digits_of(given, format));
    let stones = divisions(given)?;
    if let Some(tilt) = &given.tilt {
        let (Some(eta), [stones]) = (&given.thickness, &stones[..]) else {
            return Err(TILTED.into());
        };
        if format.is_drawing() {
            let printed = (file, format, look);
            return match tilt::draw(given, (&asked, arches), Some(stones), &printed, digits)? {
                true => Ok(()),
                false => draw::arch(given, arguments.one_weight()?, printed),
            };
        }
        let measures = arguments.measures(given);
        let of = (eta, tilt, Some(stones));
        return tilt::write((file, format), (&asked, arches), of, (digits, measures));
    }
    is_written("an arch of stones", VoussoirArches::content(), format)?;
    match given.stones.as_ref().is_some_and(StonesAsked::is_range) {
        true if format.is_drawing() => {
            is_written("a figure of many numbers of stones", Content::FIGURE, format)?;
        }
        false if format.is_drawing() => {
            return draw::arch(given, arguments.one_weight()?, (file, format, look));
        }
        _ => {}
    }
    let file = file.open_for(format)?;
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    let sized = arguments.measures(given).map_or(digits, |(_, sized)| sized);
    let answers = of_stones((asked, given), arches, (digits, sized))?;
    if format.is_picture && answers.arches.iter().all(|arch| arch.loss.is_none()) {
        let message =
            "there is nothing to draw: of none of these numbers of stones a loss is proved";
        return Err(message.into());
    }
    let open = answers.arches.iter().find_map(VoussoirArch::first_open).cloned();
    file.printed((&answers, format, &look.print), open)
}

/// Divisions into stones that are asked about.
pub fn divisions(given: &ArchGiven) -> Result<Vec<Stones>, Failure> {
    let stones = given.divisions()?;
    if given.stones.as_ref().is_some_and(StonesAsked::is_range) && given.thickness.is_some() {
        return Err(ONE_NUMBER.into());
    }
    Ok(stones)
}

/// Arches of stones, one for each self-weight and division, with what is proved of them; sizes have their own digits.
pub fn of_stones(
    (asked, given): (Understood, &ArchGiven),
    arches: &[Arch],
    (digits, sized): (usize, usize),
) -> Result<VoussoirArches, Failure> {
    let (stones, eta) = (divisions(given)?, given.thickness.as_ref());
    let measures = given.measures.as_ref().map(|measures| (measures, sized));
    let is_range = given.stones.as_ref().is_some_and(StonesAsked::is_range);
    let of_weight = |arch: &Arch| {
        let continuous = match arch.certify_alone(digits) {
            Ok(Answer::Stands(state)) => Some(state.thickness),
            _ => None,
        };
        let (stones, arch) = (stones.clone(), arch.clone());
        stones.into_iter().map(move |stones| -> Result<VoussoirArch, Failure> {
            let found = answer(&arch, stones, continuous.as_ref(), eta, (digits, measures))?;
            let is_still = found.may_move() && is_still(&arch, &found.stones);
            Ok(VoussoirArch { is_still, ..found })
        })
    };
    let arches = arches.iter().flat_map(of_weight).collect::<Result<_, Failure>>()?;
    Ok(VoussoirArches { asked, arches, is_range, command: typed() })
}

/// Tells whether it is proved, of few stones, that (19) has no solution above the least thickness.
fn is_still(arch: &Arch, stones: &Stones) -> bool {
    match stones {
        Stones::Equal { stones, .. } if *stones <= FEW => {
            let all = enumerate(arch, *stones, Extent::Whole, 6);
            all.is_ok_and(|all| all.ends_at_the_least())
        }
        _ => false,
    }
}

/// Answer that is proved of one arch.
fn answer(
    arch: &Arch,
    stones: Stones,
    continuous: Option<&Figure>,
    eta: Option<&ExactNumber>,
    (digits, measures): (usize, Option<(&Measures, usize)>),
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
    let sizes = |(measures, digits): (&Measures, usize)| -> Result<Sizes, Failure> {
        let of = (arch.weight(), arch.friction());
        let found = Error::apart(measured_voussoirs(&stones, of, eta, measures, digits))?;
        Ok(Sizes { measured_at: measures.circle(), found })
    };
    let sizes = measures.map(sizes).transpose()?;
    let (weight, friction) = (arch.weight(), arch.friction().to_string());
    let continuous = continuous.cloned();
    Ok(VoussoirArch {
        weight,
        friction,
        stones,
        found,
        continuous,
        loss,
        given,
        is_still: false,
        sizes,
    })
}

/// The most stones of which all solutions of (19) are found for every answer: the cost grows with their cube.
const FEW: u64 = 12;

const ONE_NUMBER: &str =
    "a given thickness asks for one number of stones: leave out --thickness, or give one";
const TILTED: &str = "--tilt asks of an arch of a thickness: give --thickness";
