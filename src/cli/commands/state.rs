//! `couplet state`.

use super::arch::ArchArguments;
use super::by_value::{self, ValueArguments};
use super::draw;
use super::look::LookArguments;
use super::notes;
use super::output::AnswerOutput;
use super::survey;
use super::voussoirs;
use crate::ask::{ArchQuestion, Field};
use crate::certify::{Error, quantities as quantities_of};
use crate::problem::{Arch, Landmark, Quantity};
use crate::report::{Answer, Answers, Reported, Scope, Understood};
use crate::sweep::answer;
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;

/// Tell how thin an arch can be, and how it collapses then.
///
/// With the rotational joint, the thrust, the least thickness or A in place of the half opening: all states that have
/// it, at the friction given or, without one, at unlimited friction.
///
/// A number may be a range, as of `assess`: then it is told of every arch inside.
///
/// The proof: the equations of the mode have one solution in a box; that state is admissible on the
/// whole half arch; no thinner arch has an admissible state; every comparison is decided.
#[derive(Args)]
#[command(mut_arg("thickness", |arg| {
    arg.help("Least thickness eta = t/r instead of the half opening, up to 2").long_help(None)
}))]
#[command(mut_arg("tilt", |arg| arg.hide(true)))]
#[command(
    override_usage = "couplet state --half-opening <ANGLE> --friction <MU> [OPTIONS]\n       \
                            couplet state --rotation-joint <ANGLE> | --thrust <H> | --thickness <ETA> | \
                            --opening-variable <A> [--friction <MU>] [OPTIONS]\n       \
                            couplet state --at <LANDMARK> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    #[command(flatten)]
    value: ValueArguments,

    /// A landmark instead of an arch, by symbol or name (T, triple), with all modes that meet there.
    #[arg(
        long, value_name = "LANDMARK", value_parser = parse::landmark,
        conflicts_with_all = [
            "half_opening", "friction", "friction_angle", "stones", "joints", "span", "radius", "density",
            "thickness", "rotation_joint", "thrust", "opening_variable"
        ]
    )]
    at: Option<Landmark>,

    #[command(flatten)]
    output: AnswerOutput,

    #[command(flatten)]
    look: LookArguments,
}

/// Question about an arch at its least thickness.
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Thickness, "`couplet assess` tells of an arch of a thickness"),
        (Field::Tilt, "`couplet assess` tells of an arch of a thickness that is tilted"),
    ],
    needs: &[],
    unlimited: false,
    example: "couplet state --half-opening 80deg --friction 0.6",
};

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(landmark) = arguments.at {
        return at_landmark(landmark, arguments);
    }
    if let Some(asked) = arguments.value.question(&arguments.arch.asked)? {
        return by_value::print(&asked, &arguments.arch, &arguments.output);
    }
    if arguments.arch.asked.has_range() {
        return survey::print(&QUESTION, &arguments.arch, (&arguments.output, &arguments.look));
    }
    let (given, arches) = arguments.arch.read(&QUESTION)?;
    if let Some(printed) = arguments.output.drawing(&arguments.look)? {
        return draw::arch(&given, arguments.arch.one_weight()?, printed);
    }
    if given.stones.is_some() {
        return voussoirs::print(&arguments.arch, &given, &arches, &arguments.output);
    }
    let asked = arguments.arch.understood(&given);
    let quantities = arguments.output.quantities(&given.quantities())?;
    let format = arguments.output.format()?;
    let digits = arguments.arch.digits_of(&given, format);
    let (proved, balls) = (format.proved_digits(digits), format.balls());
    let frictions = quantities.iter().any(|quantity| quantity.is_friction());
    let answer = |line, arch: &Arch| {
        let found = balls.state(arch, proved, frictions);
        answer::state(line, (arch, arguments.arch.measures(&given)), proved, &found)
    };
    print(&arguments.output, (digits, quantities), (&asked, &arches), answer)
}

/// Computes and prints the answers for one arch, or for several.
pub(super) fn print(
    output: &AnswerOutput,
    (digits, quantities): (usize, Vec<Quantity>),
    (asked, arches): (&Understood, &[Arch]),
    answer: impl Fn(u64, &Arch) -> Answer,
) -> Result<(), Failure> {
    notes::frictions(arches.iter().take(1).map(Arch::friction));
    let (file, format) = output.open()?;
    let answer = |(line, arch)| Answer {
        asked: Some(Box::new(asked.clone())),
        ..answer(line, arch).only(&quantities)
    };
    let answers: Vec<Answer> = (1..).zip(arches).map(answer).collect();
    let open = answers.iter().find_map(Answer::first_open);
    let scope = if answers.len() == 1 { Scope::Arch } else { Scope::Arches };
    let answers = Answers::of(scope, digits, quantities, answers);
    file.report((&answers, format), open)
}

fn at_landmark(landmark: Landmark, arguments: &Arguments) -> Result<(), Failure> {
    let quantities = arguments.output.quantities(&Quantity::LANDMARK)?;
    let (output, format) = arguments.output.open()?;
    let digits = arguments.arch.digits();
    let asked: Vec<(Quantity, usize)> = quantities_of(landmark)
        .filter(|quantity| quantities.contains(quantity))
        .map(|quantity| (quantity, digits))
        .collect();
    let answer = |weight| {
        let answer = answer::landmark((landmark, weight), &asked)?;
        Ok(Answer { modes: landmark.modes().to_vec(), ..answer })
    };
    let list: Result<_, Error> = arguments.arch.weight.iter().copied().map(answer).collect();
    let report = Answers::of(Scope::Point, digits, quantities, list?);
    output.write(|out| report.write(format, out))
}
