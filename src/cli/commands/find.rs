//! `couplet find`.

use super::arch::ArchArguments;
use super::notes;
use super::output::AnswerOutput;
use super::survey;
use crate::ask::Spelling;
use crate::certify::state::find::Question;
use crate::door::find::{self, FindTarget};
use crate::problem::{Line, Quantity};
use crate::report::{Answer, Answers, Scope};
use crate::sweep::answer;
use crate::sweep::failure::Failure;
use clap::Args;

/// Find the widest opening, the least friction, where modes meet.
///
/// Find the widest half opening that stands, the least friction, or where one mode becomes another, with a proof.
///
/// Without --thickness an arch counts if it stands at any. The least thickness of an arch is what `couplet state`
/// finds.
///
/// Of half-opening and friction a number that is given may be a range, as of `assess`: then it is told between which
/// ends the answer is for every arch inside.
#[derive(Args)]
#[command(mut_arg("stones", |arg| arg.hide(true)))]
#[command(mut_arg("joints", |arg| arg.hide(true)))]
#[command(mut_arg("tilt", |arg| arg.hide(true)))]
#[command(mut_arg("density", |arg| arg.hide(true)))]
#[command(mut_arg("depth", |arg| arg.hide(true)))]
#[command(
    override_usage = "couplet find half-opening --friction <MU> [--thickness <ETA>] [OPTIONS]\n       \
                            couplet find friction --half-opening <ANGLE> [--thickness <ETA>] [OPTIONS]\n       \
                            couplet find boundary <MODES> --friction <MU> | --half-opening <ANGLE> [OPTIONS]"
)]
pub(crate) struct Arguments {
    /// What to find: half-opening, friction or boundary.
    #[arg(value_name = "WHAT", value_parser = find::what)]
    what: FindTarget,

    /// The two modes of a boundary (rrs/rsr, [r,s,r]/[r,s]).
    #[arg(value_name = "MODES", value_parser = find::line)]
    modes: Option<Line>,

    #[command(flatten)]
    arch: ArchArguments,

    #[command(flatten)]
    output: AnswerOutput,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let target = (arguments.what, arguments.modes);
    if arguments.arch.asked.has_range() {
        let (sought, given) = find::of_ranges(target, &arguments.arch.asked, Spelling::Option)?;
        return survey::print_sought(sought, &given, &arguments.arch, &arguments.output);
    }
    let question = find::question(target, &arguments.arch.asked, Spelling::Option)?;
    let asked = find::understood(&arguments.arch.asked, Spelling::Option)?;
    let quantities = arguments.output.quantities(&found_by(&question))?;
    let (file, format) = arguments.output.open()?;
    notes::frictions(question.friction());
    let digits = arguments.arch.digits();
    let answer = |(line, weight)| {
        let answer = answer::finding(line, (weight, &question), digits)?.only(&quantities);
        Ok(Answer { asked: Some(Box::new(asked.clone())), ..answer })
    };
    let weights = (1..).zip(arguments.arch.weight.to_vec());
    let answers: Vec<Answer> = weights.map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(Answer::first_open);
    let report = Answers::of(Scope::Found, digits, quantities, answers);
    file.report((&report, format), open)
}

/// The quantities that an answer can have: not what is given.
fn found_by(question: &Question) -> Vec<Quantity> {
    use Quantity as Q;
    let others: &[Q] = match question {
        Question::HalfOpening { .. } => &[Q::Thrust, Q::RotationJoint, Q::SlidingJoint],
        Question::Friction { .. } => &[],
        Question::Boundary { .. } => &[Q::Thickness, Q::Thrust, Q::RotationJoint, Q::SlidingJoint],
    };
    [question.sought().quantities(), others].concat()
}
