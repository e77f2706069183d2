//! Questions with ranges on the command line.

use super::arch::{ArchArguments, RANGE_DIGITS};
use super::notes;
use super::output::{AnswerOutput, OutputFile, is_written};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchQuestion, Spelling, SurveyGiven};
use crate::atlas::BandedArch;
use crate::certify::Error;
use crate::certify::survey::{
    SurveyAnswer, share as survey_share, sought as survey_sought, survey, survey_of_stones,
};
use crate::cli::line::typed;
use crate::picture::Print;
use crate::problem::survey::Survey;
use crate::problem::{Quantity, Sought};
use crate::report::{BandedArches, Format, Reported, SurveyedArches, Understood};
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
    if let Some((format, file)) = output.drawing()? {
        if share {
            return Err("--share is told in words, not in a picture: leave out one of them".into());
        }
        let weight = arguments.one_weight()?;
        return draw(&arguments.asked, &given, weight, (file, format, &Print::default()));
    }
    let mut quantities = output.quantities(quantities(&arguments.asked))?;
    // The thickness of a state is the least.
    if quantities.contains(&Quantity::Thickness) {
        quantities.push(Quantity::LeastThickness);
    }
    let digits = arguments.range_digits();
    write((output.file(), output.format()?), (arguments, &given), |weight| {
        surveyed(&arguments.asked, &given, weight, (&quantities, digits, share))
    })
}

/// Draws the bands in which the lines of thrust of every arch of a question lie.
pub(super) fn draw(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (file, format, print): (&OutputFile, &'static Format, &Print),
) -> Result<(), Failure> {
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
    let arches = surveyed(asked, given, weight, (&ASSESSED, digits, false))?;
    let open = arches.first_open().cloned();
    file.printed((&BandedArches { arches, bands, command }, format, print), open)
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
        surveyed(&arguments.asked, &given, weight, (quantities, digits, false))
    })
}

/// Proves and prints the range of what is sought over every arch of a question.
pub(super) fn print_sought(
    sought: Sought,
    given: &SurveyGiven,
    arguments: &ArchArguments,
    output: &AnswerOutput,
) -> Result<(), Failure> {
    let all: &[Quantity] = match sought {
        Sought::HalfOpening => &[Quantity::HalfOpening, Quantity::HalfOpeningDegrees],
        Sought::Friction => &[Quantity::Friction],
    };
    let quantities = output.quantities(all)?;
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
    let of_stones = given.stones.as_ref();
    if share && of_stones.is_some() {
        return Err("--share is of arches with a joint at every angle: leave out the stones".into());
    }
    let answer = proved((asked, given), weight, |arches| match of_stones {
        Some(stones) => survey_of_stones(arches, stones, digits),
        None => survey(arches, digits),
    })?;
    let share = match share {
        true => Some(survey_share(&arches(given, weight)?)),
        false => None,
    };
    Ok(SurveyedArches { quantities: quantities.to_vec(), share, ..answer })
}

/// All arches of a question and of a self-weight, with what a proof finds of them.
fn proved(
    (asked, given): (&ArchAsked, &SurveyGiven),
    weight: SelfWeight,
    proof: impl Fn(&Survey) -> Result<SurveyAnswer, Error>,
) -> Result<SurveyedArches, Failure> {
    let found = Error::apart(proof(&arches(given, weight)?)).map_err(Error::from)?;
    let (asked, given) = (Understood::of_ranges(asked, given), given.clone());
    let (sought, quantities, share) = (None, Vec::new(), None);
    Ok(SurveyedArches { asked, given, weight, sought, quantities, found, share })
}

fn arches(given: &SurveyGiven, weight: SelfWeight) -> Result<Survey, Failure> {
    Ok(given.survey(weight).map_err(|error| error.to_string())?)
}
