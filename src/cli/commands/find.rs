//! `couplet find`.

use super::arch::ArchArguments;
use super::notes;
use super::output::AnswerOutput;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling};
use crate::certify::state::find::{Given, Question, find};
use crate::certify::{Error, Refused};
use crate::problem::{Friction, Line, Quantity, Sought};
use crate::report::words::list;
use crate::report::{Answer, Answers, Report, Scope};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;

/// Find the widest half opening that stands, the least friction, or where one mode becomes another, with a proof.
///
/// Without --thickness an arch counts if it stands at any. The least thickness of an arch is what `couplet state`
/// finds.
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
    #[arg(value_name = "WHAT", value_parser = what)]
    what: FindTarget,

    /// The two modes of a boundary (rrs/rsr, [r,s,r]/[r,s]).
    #[arg(value_name = "MODES", value_parser = line)]
    modes: Option<Line>,

    #[command(flatten)]
    arch: ArchArguments,

    #[command(flatten)]
    output: AnswerOutput,
}

/// Target of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FindTarget {
    /// The widest half opening that stands.
    HalfOpening,
    /// The least friction with which an arch stands.
    Friction,
    /// The place where one mode becomes another.
    Boundary,
}

/// Target of a name.
pub fn what(text: &str) -> Result<FindTarget, String> {
    match &text.replace('_', "-").to_lowercase()[..] {
        "half-opening" | "alpha" => Ok(FindTarget::HalfOpening),
        "friction" | "mu" => Ok(FindTarget::Friction),
        "boundary" => Ok(FindTarget::Boundary),
        "thickness" | "eta" => Err("the least thickness is what `couplet state` finds".into()),
        _ => Err(parse::unknown("what is found", text, &["half-opening", "friction", "boundary"])),
    }
}

/// Pair of modes.
pub fn line(text: &str) -> Result<Line, String> {
    text.parse().map_err(|error: crate::problem::NoLine| error.to_string())
}

const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Stones, "what is found is of an arch with a joint at every angle"),
        (Field::Joints, "what is found is of an arch with a joint at every angle"),
        (Field::Tilt, "what is found is of an arch without acceleration"),
        (Field::Density, "no forces are found"),
    ],
    needs: &[],
    unlimited: false,
    example: "",
};

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let asked = &arguments.arch.asked;
    let question = question((arguments.what, arguments.modes), asked, Spelling::Option)?;
    let quantities = arguments.output.quantities(&found_by(&question))?;
    let (file, format) = arguments.output.open()?;
    notes::frictions(given_friction(&question));
    let digits = arguments.arch.digits;
    let answer = |(line, weight)| {
        let found = find(weight, &question, digits);
        if let Err(Error::Refused(refused)) = found {
            return Err(refused.into());
        }
        Ok(Answer::finding(line, (weight, &question), &found).only(&quantities))
    };
    let weights = (1..).zip(arguments.arch.weight.all());
    let answers: Vec<Answer> = weights.map(answer).collect::<Result<_, Failure>>()?;
    let open = answers.iter().find_map(Answer::first_open);
    let kept = Vec::new();
    let report = Answers { scope: Scope::Found, digits, quantities, kept, list: answers };
    file.report((&Report::Answers(report), format), open)
}

/// The friction that is given.
fn given_friction(question: &Question) -> Option<&Friction> {
    match question {
        Question::HalfOpening { friction, .. }
        | Question::Boundary { given: Given::Friction(friction), .. } => Some(friction),
        _ => None,
    }
}

/// The quantities that an answer can have: not what is given.
fn found_by(question: &Question) -> Vec<Quantity> {
    use Quantity as Q;
    let sought: &[Q] = match question.sought() {
        Sought::HalfOpening => &[Q::HalfOpening, Q::HalfOpeningDegrees],
        Sought::Friction => &[Q::Friction],
    };
    let others: &[Q] = match question {
        Question::HalfOpening { .. } => &[Q::Thrust, Q::RotationJoint, Q::SlidingJoint],
        Question::Friction { .. } => &[],
        Question::Boundary { .. } => &[Q::Thickness, Q::Thrust, Q::RotationJoint, Q::SlidingJoint],
    };
    [sought, others].concat()
}

/// The question asked, if what is given fits it.
pub fn question(
    (what, modes): (FindTarget, Option<Line>),
    asked: &ArchAsked,
    spelling: Spelling,
) -> Result<Question, Failure> {
    QUESTION.fits(asked, spelling)?;
    let given = ArchGiven::new(asked, spelling)?;
    let ArchGiven { half_opening, friction, thickness: eta, .. } = given;
    let given = [half_opening.is_some(), friction.is_some(), eta.is_some()];
    let name = |field| spelling.of(field);
    let too_much = |wrong: &[(bool, String)]| {
        let wrong: Vec<&str> = wrong.iter().filter(|(given, _)| *given).map(|x| &x.1[..]).collect();
        match wrong.is_empty() {
            true => Ok(()),
            false => Err(Failure::Input(format!("{} does not belong here", list(wrong)))),
        }
    };
    let missing = |what: &str, example: &str| {
        let example = match spelling {
            Spelling::Option => format!("; for example: couplet find {example}"),
            Spelling::Key => String::new(),
        };
        Failure::Input(format!("{what} is missing{example}"))
    };
    let pair = (modes.is_some(), "a pair of modes".to_owned());
    let [alpha, mu, angle] = [Field::HalfOpening, Field::Friction, Field::FrictionAngle].map(name);
    let [has_alpha, has_mu, is_thick] = given;
    Ok(match what {
        FindTarget::HalfOpening => {
            too_much(&[pair, (has_alpha, alpha)])?;
            let example = "half-opening --thickness 0.15 --friction 0.6";
            let friction =
                friction.ok_or_else(|| missing(&format!("{mu} (or {angle})"), example))?;
            Question::HalfOpening { friction, thickness: eta }
        }
        FindTarget::Friction => {
            too_much(&[pair, (has_mu, mu)])?;
            let example = "friction --half-opening 80deg --thickness 0.1";
            let half_opening = half_opening.ok_or_else(|| missing(&alpha, example))?;
            Question::Friction { half_opening, thickness: eta }
        }
        FindTarget::Boundary => {
            too_much(&[(is_thick, name(Field::Thickness))])?;
            let example = "boundary rrs/rsr --friction 1.6";
            let line = modes.ok_or_else(|| missing("the pair of modes", example))?;
            let given = match (half_opening, friction) {
                (Some(alpha), None) => Given::HalfOpening(alpha),
                (None, Some(Friction::Infinite)) => return Err(Refused::UnlimitedFriction.into()),
                (None, Some(mu)) => Given::Friction(mu),
                (None, None) => return Err(missing(&format!("{mu} or {alpha}"), example)),
                (Some(_), Some(_)) => {
                    let message = format!("give {mu} or {alpha}; the other one is found");
                    return Err(message.into());
                }
            };
            Question::Boundary { line, given }
        }
    })
}
