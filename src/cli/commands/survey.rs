//! Questions with ranges on the command line.

use super::arch::{ArchArguments, RANGE_DIGITS};
use super::look::LookArguments;
use super::notes;
use super::output::{AnswerOutput, OutputFile, Printed, is_written};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchQuestion, Spelling, SurveyGiven};
use crate::atlas::BandedArch;
use crate::certify::survey::sought as survey_sought;
use crate::cli::line::typed;
use crate::problem::survey::Survey;
use crate::problem::{Quantity, Sought};
use crate::report::{BandedArches, Format, Reported, SurveyedArches};
use crate::sweep::failure::Failure;
use crate::sweep::surveyed::{arches, proved, quantities, ranges, surveyed};

/// Proves and prints what holds for every arch of a question.
pub(super) fn print(
    question: &ArchQuestion,
    arguments: &ArchArguments,
    (output, look): (&AnswerOutput, &LookArguments),
) -> Result<(), Failure> {
    let given = SurveyGiven::read(question, &arguments.asked, Spelling::Option)?;
    if let Some(printed) = output.drawing(look)? {
        return draw(&arguments.asked, &given, arguments.one_weight()?, &printed);
    }
    let mut quantities = output.quantities(&quantities(&arguments.asked))?;
    // The thickness of a state is the least.
    if quantities.contains(&Quantity::Thickness) {
        quantities.push(Quantity::LeastThickness);
    }
    let digits = arguments.range_digits();
    write((output.file(), output.format()?), (arguments, &given), |weight| {
        surveyed(&arguments.asked, &given, weight, (&quantities, digits))
    })
}

/// Draws the bands in which the lines of thrust of every arch of a question lie.
pub(super) fn draw(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (file, format, look): &Printed<'_>,
) -> Result<(), Failure> {
    look.refuse_motion("a range", false)?;
    is_written("the picture of a range", BandedArches::content(), format)?;
    if given.stones.is_some() {
        return Err("a picture of a range has a joint at every angle: leave out the stones".into());
    }
    let bands = BandedArch::of(&arches(given, weight)?)?;
    let bands = bands.ok_or(
        "a picture of a range is of arches of a thickness: `couplet draw` with --thickness",
    )?;
    let file = file.open_for(format)?;
    notes::frictions(&given.friction);
    let (command, digits) = (typed(), RANGE_DIGITS);
    let arches = ranges(asked, given, weight, (&quantities(asked), digits))?;
    let open = arches.first_open().cloned();
    file.printed((&BandedArches { arches, bands, command }, format, &look.print), open)
}

/// Proves and prints what holds for every arch of given stones.
pub(super) fn print_of_stones(
    question: &ArchQuestion,
    arguments: &ArchArguments,
    (file, format): (&OutputFile, &'static Format),
) -> Result<(), Failure> {
    let given = SurveyGiven::read(question, &arguments.asked, Spelling::Option)?;
    let (quantities, digits) = (quantities(&arguments.asked), arguments.range_digits());
    write((file, format), (arguments, &given), |weight| {
        surveyed(&arguments.asked, &given, weight, (&quantities, digits))
    })
}

/// Proves and prints the range of what is sought over every arch of a question.
pub(super) fn print_sought(
    sought: Sought,
    given: &SurveyGiven,
    arguments: &ArchArguments,
    output: &AnswerOutput,
) -> Result<(), Failure> {
    let quantities = output.quantities(sought.quantities())?;
    let digits = arguments.range_digits();
    write((output.file(), output.format()?), (arguments, given), |weight| {
        let found = |arches: &Survey| survey_sought(arches, sought, digits);
        let answer = proved((&arguments.asked, given), weight, found)?;
        Ok(SurveyedArches { sought: Some(sought), quantities: quantities.clone(), ..answer })
    })
}

/// Writes the answer of each self-weight.
fn write(
    (file, format): (&OutputFile, &'static Format),
    (arguments, given): (&ArchArguments, &SurveyGiven),
    answer: impl Fn(SelfWeight) -> Result<SurveyedArches, Failure>,
) -> Result<(), Failure> {
    is_written("the answer of a range", SurveyedArches::content(), format)?;
    let file = file.open_for(format)?;
    notes::frictions(&given.friction);
    let answers: Result<Vec<_>, _> = arguments.weight.iter().copied().map(answer).collect();
    let answers = answers?;
    let open = answers.iter().find_map(SurveyedArches::first_open).cloned();
    file.report((&answers, format), open)
}
