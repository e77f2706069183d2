//! Questions with ranges on the command line.

use super::arch::ArchArguments;
use super::notes;
use super::output::{AnswerOutput, is_written};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchQuestion, Spelling, SurveyGiven};
use crate::certify::Error;
use crate::certify::survey::{share as survey_share, survey};
use crate::problem::Quantity;
use crate::report::{Reported, SurveyedArches, Understood};
use crate::sweep::failure::Failure;

/// Quantities of which ranges are told, of arches of a thickness.
const ASSESSED: [Quantity; 7] = [
    Quantity::LeastThickness,
    Quantity::GeometricSafety,
    Quantity::RequiredFriction,
    Quantity::FrictionSafety,
    Quantity::LeastThrust,
    Quantity::LargestThrust,
    Quantity::ThicknessInMetres,
];

/// Quantities of which they are told of arches at their least thickness.
const STATED: [Quantity; 3] = [Quantity::Thickness, Quantity::LeastThickness, Quantity::Thrust];

/// Proves and prints what holds for every arch of a question.
pub(super) fn print(
    question: &ArchQuestion,
    arguments: &ArchArguments,
    output: &AnswerOutput,
    share: bool,
) -> Result<(), Failure> {
    let given = SurveyGiven::read(question, &arguments.asked, Spelling::Option)?;
    if output.drawing()?.is_some() {
        return Err("a picture shows one arch: give one value in place of each range".into());
    }
    let format = output.format()?;
    is_written("the answer of a range", SurveyedArches::content(), format)?;
    let mut quantities = output.quantities(quantities(&arguments.asked))?;
    // The thickness of a state is the least.
    if quantities.contains(&Quantity::Thickness) {
        quantities.push(Quantity::LeastThickness);
    }
    let file = output.file().open_for(format)?;
    notes::frictions(&given.friction);
    let answer = |weight| {
        surveyed(&arguments.asked, &given, weight, (&quantities, arguments.range_digits(), share))
    };
    let answers: Result<Vec<_>, _> = arguments.weight.all().into_iter().map(answer).collect();
    let answers = answers?;
    let open = answers.iter().find_map(SurveyedArches::first_open).cloned();
    file.report((&answers, format), open)
}

/// Quantities of which ranges are told.
pub fn quantities(asked: &ArchAsked) -> &'static [Quantity] {
    if asked.thickness.is_some() { &ASSESSED } else { &STATED }
}

/// All arches of a question and of a self-weight, with what is proved of them.
pub fn surveyed(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (quantities, digits, share): (&[Quantity], usize, bool),
) -> Result<SurveyedArches, Failure> {
    let arches = given.survey(weight).map_err(|error| error.to_string())?;
    let found = match survey(&arches, digits) {
        Ok(found) => Ok(found),
        Err(Error::Undecided(undecided)) => Err(undecided),
        Err(refused @ Error::Refused(_)) => return Err(refused.into()),
    };
    let asked = Understood::of_ranges(asked, given);
    let (given, quantities) = (given.clone(), quantities.to_vec());
    let share = share.then(|| survey_share(&arches));
    Ok(SurveyedArches { asked, given, weight, quantities, found, share })
}
