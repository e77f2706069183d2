//! Questions with ranges on the command line.

use super::arch::ArchArguments;
use super::notes;
use super::output::{AnswerOutput, is_written};
use crate::ask::{ArchQuestion, Spelling, SurveyGiven};
use crate::problem::Quantity;
use crate::report::{Reported, SurveyedArches};
use crate::sweep::failure::Failure;
use crate::sweep::surveyed::{quantities, surveyed};

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
