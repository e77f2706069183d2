//! `couplet complementarity`.

use super::arch::ArchArguments;
use super::map::tolerance;
use super::notes;
use super::output::{OutputFile, is_written};
use super::print::PrintArguments;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling, StonesAsked};
use crate::atlas::{Branch, Contour, Level, NoBranch, NoLevel};
use crate::certify::state::Certify;
use crate::certify::{
    Error, LeastSolution, MOST_ENUMERATED_STONES, MOST_JOINTED_STONES, Programme, Refused,
    Undecided, asymmetric, enumerate, least_solution, programme,
};
use crate::cli::line::typed;
use crate::number::ExactNumber;
use crate::problem::{Arch, Extent};
use crate::report::{
    AtThickness, BranchArch, BranchArches, ComplementarityArch, Format, ProgrammeFound, Reported,
    SolutionsFound,
};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;

/// Solve the complementarity problem (19) of the whole arch.
///
/// Tell the thicknesses at which it has a solution, each proved.
///
/// A solution is an admissible state with a motion of the joints that are at their limits, without dilatancy. Among
/// symmetric ones there is one thickness, the least; some horseshoes have asymmetric ones at a larger thickness.
/// What is printed is proved, and that asymmetric ones are one at the most with Milankovitch's weight and two with
/// Heyman's; where as many are found as there can be, that there are no others is proved too. With --stones there are
/// joints between so many equal stones only, 2 to 60: then all solutions are found, at any thickness up to 2, and that
/// there are no others is proved; thicknesses at which it is not are listed. With --thickness too, and up to 100
/// stones, the least value of the programme (20) at that thickness is enclosed instead; at the `least` thickness of the
/// stones it is zero.
#[derive(Args)]
#[command(mut_arg("joints", |arg| arg.hide(true)))]
#[command(mut_arg("tilt", |arg| arg.hide(true)))]
#[command(mut_arg("density", |arg| arg.hide(true)))]
#[command(mut_arg("depth", |arg| arg.hide(true)))]
#[command(
    override_usage = "couplet complementarity --half-opening <ANGLE> --friction <MU> [--stones <N> [--half] \
                      [--thickness <ETA>]] [OPTIONS]\n       couplet complementarity --half-opening <ANGLE> --branch \
                      [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Between the stones look at the half arch, whose states are symmetric, instead of the whole.
    #[arg(long, requires = "stones")]
    half: bool,

    /// Instead, the asymmetric solutions of the half opening over friction, as curves beside the least thickness.
    #[arg(long, conflicts_with_all = ["friction", "friction_angle", "thickness", "stones", "half"])]
    branch: bool,

    /// With --branch, largest half-width of a tube, in rad and in thicknesses, from 1e-12 to 1; 1e-4 if not given.
    #[arg(long, value_name = "WIDTH", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: Option<f64>,

    #[arg(long, value_parser = parse::format(BranchArches::content()), help = parse::format_help(BranchArches::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    print: PrintArguments,
}

/// Numbers of stones that are enumerated, and of the programme (20).
const STONES: &str = "stones are a whole number from 2 to 60, or to 100 with --thickness";
const _: () = assert!(MOST_ENUMERATED_STONES == 60 && MOST_JOINTED_STONES == 100);

/// A thickness, or the least one.
enum At {
    Given(ExactNumber),
    Least,
}

/// Question about the solutions of (19).
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Joints, "stones are of one angle here, --stones"),
        (Field::Tilt, "the conditions (19) have no acceleration"),
        (Field::Density, "no forces are told"),
    ],
    needs: &[],
    unlimited: false,
    example: "couplet complementarity --half-opening 2.3 --friction 1.05",
};

/// Thickness that is asked for, beside what is given of the arch.
fn read(asked: &ArchAsked) -> Result<(Option<At>, ArchGiven), Failure> {
    let is_least = asked.thickness.as_deref().is_some_and(|text| text.trim() == "least");
    let thickness = asked.thickness.clone().filter(|_| !is_least);
    let given =
        ArchGiven::read(&QUESTION, &ArchAsked { thickness, ..asked.clone() }, Spelling::Option);
    let given = given.map_err(|misfit| match misfit.field {
        Some(Field::Thickness) => {
            Failure::Input(format!("{misfit}; or `least`, that of the stones"))
        }
        Some(Field::Stones) => STONES.into(),
        _ => misfit.into(),
    })?;
    if asked.thickness.is_some() && asked.stones.is_none() {
        return Err(
            "--thickness needs --stones here: the programme (20) has joints between them".into()
        );
    }
    let at = is_least.then_some(At::Least).or_else(|| given.thickness.clone().map(At::Given));
    Ok((at, given))
}

/// Number of stones that is asked for.
fn stones(given: &ArchGiven) -> Result<Option<u64>, Failure> {
    match given.stones {
        None => Ok(None),
        Some(StonesAsked::Numbers { first, is_range: false, .. })
            if first <= MOST_JOINTED_STONES =>
        {
            Ok(Some(first))
        }
        Some(_) => Err(STONES.into()),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.branch {
        return branches(arguments);
    }
    if arguments.tolerance.is_some() {
        return Err("--tolerance is for --branch".into());
    }
    let (at, given) = read(&arguments.arch.asked)?;
    let asked = arguments.arch.understood(&given);
    let stones = stones(&given)?;
    let weights = arguments.arch.weight.iter().copied();
    let arches: Vec<Arch> = weights.map(|weight| given.arch(weight)).collect::<Result<_, _>>()?;
    let format =
        arguments.file.format(arguments.format, ComplementarityArch::content(), "table")?;
    is_written("without --branch a solution", ComplementarityArch::content(), format)?;
    arguments.print.of(format)?;
    let file = arguments.file.open_for(format)?;
    let digits = arguments.arch.digits();
    let extent = if arguments.half { Extent::Half } else { Extent::Whole };
    let too_many = stones.filter(|n| *n > MOST_ENUMERATED_STONES);
    if let (Some(stones), None) = (too_many, &at) {
        return Err(format!(
            "all solutions are found between at most {MOST_ENUMERATED_STONES} stones, not {stones}: with --thickness \
             {MOST_JOINTED_STONES} are allowed"
        )
        .into());
    }
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    let answer = |arch: Arch| {
        let found = match (stones, &at) {
            (Some(stones), None) => SolutionsFound::Stones {
                stones,
                extent,
                all: Error::apart(enumerate(&arch, stones, extent, digits))?,
            },
            (Some(stones), Some(at)) => {
                SolutionsFound::Programme(at_thickness(&arch, at, (stones, extent), digits)?)
            }
            (None, _) => SolutionsFound::Continuous {
                symmetric: Error::apart(arch.certify_alone(digits))?,
                asymmetric: asymmetric(&arch, digits)?,
            },
        };
        Ok(ComplementarityArch { found, asked: asked.clone(), arch })
    };
    let answers: Vec<ComplementarityArch> =
        arches.into_iter().map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(ComplementarityArch::first_open);
    file.report((&answers, format), open)
}

/// The programme (20) of an arch.
fn at_thickness(
    arch: &Arch,
    at: &At,
    (stones, extent): (u64, Extent),
    digits: usize,
) -> Result<AtThickness, Refused> {
    let (thickness, named, found) = match at {
        At::Given(thickness) => {
            let found = Error::apart(programme(arch, thickness, (stones, extent)))?;
            (thickness.to_string(), None, found.map(ProgrammeFound::At))
        }
        At::Least => {
            let least = Error::apart(least_solution(arch, stones, extent, digits))?;
            let (named, found) = match least {
                Ok(LeastSolution::From(solution)) => {
                    (Some(solution.thickness), Ok(ProgrammeFound::At(Programme::Zero)))
                }
                Ok(LeastSolution::Always) => (None, Ok(ProgrammeFound::EveryThicknessStands)),
                Ok(LeastSolution::Never) => (None, Ok(ProgrammeFound::NoThicknessStands)),
                Err(undecided) => (None, Err(undecided)),
            };
            ("least".to_owned(), named, found)
        }
    };
    Ok(AtThickness { thickness, named, stones, extent, found })
}

/// Solutions over all frictions.
const BRANCH: ArchQuestion = ArchQuestion {
    unlimited: true,
    example: "couplet complementarity --half-opening 2.3 --branch",
    ..QUESTION
};
/// The half-width of a tube that is asked for if none is given.
const TOLERANCE: f64 = 1e-4;
/// Digits of the points of a branch, at most.
const DIGITS: usize = 30;

fn branches(arguments: &Arguments) -> Result<(), Failure> {
    let (_, arches) = arguments.arch.read(&BRANCH)?;
    let Some(half_opening) = arches.first().map(Arch::half_opening) else { return Ok(()) };
    let digits = arguments.arch.digits();
    if digits > DIGITS {
        return Err(format!("with --branch digits are 1 to {DIGITS}").into());
    }
    let format = arguments.file.format(arguments.format, BranchArches::content(), "table")?;
    let print = arguments.print.of(format)?;
    let file = arguments.file.open_for(format)?;
    let tolerance = arguments.tolerance.unwrap_or(TOLERANCE);
    let found = |weight| -> Result<(Branch, Level), NoBranch> {
        let branch = Branch::new(weight, half_opening, tolerance)?;
        let contour = Contour::HalfOpening(half_opening.clone());
        let least = Level::new(weight, &contour, tolerance).map_err(|none| match none {
            NoLevel::Undecided(_, open) => NoBranch::from(open),
            outside => Undecided::new(outside.to_string()).into(),
        })?;
        Ok((branch, least))
    };
    let arch =
        |weight| BranchArch { weight, half_opening: half_opening.clone(), found: found(weight) };
    let arches: Vec<BranchArch> = arguments.arch.weight.iter().copied().map(arch).collect();
    let open: Vec<String> = arches.iter().flat_map(BranchArch::open).collect();
    let is_empty = arches.iter().all(|arch| arch.found.is_err());
    if let (true, true, Some(Err(why))) =
        (format.is_picture, is_empty, arches.first().map(|arch| &arch.found))
    {
        return Err(Failure::Undecided(format!("there is nothing to draw: {why}")));
    }
    let report = BranchArches { tolerance, digits, arches, command: typed() };
    file.printed((&report, format, &print), open)
}
