//! The answer about every arch of a question with ranges: for every door.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, SurveyGiven};
use crate::certify::Error;
use crate::certify::survey::{SurveyAnswer, survey, survey_of_stones};
use crate::failure::Failure;
use crate::problem::Quantity;
use crate::problem::survey::Survey;
use crate::report::{SurveyedArches, Understood};

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

/// Quantities of which ranges are told.
pub fn quantities(asked: &ArchAsked) -> &'static [Quantity] {
    told(asked.thickness.is_some())
}

/// Quantities of which ranges are told, of arches with a thickness or without.
pub fn told(have_thickness: bool) -> &'static [Quantity] {
    if have_thickness { &ASSESSED } else { &STATED }
}

/// Quantities of which ranges are told in a table, whose arches may have a thickness and may be measured.
pub fn of_rows(have_thickness: bool, are_measured: bool) -> Vec<Quantity> {
    let assessed = if have_thickness { &ASSESSED[..] } else { &[Quantity::LeastThickness] };
    let is_told = |of: &Quantity| are_measured || !of.is_measured();
    assessed.iter().copied().filter(is_told).chain([Quantity::Thrust]).collect()
}

/// All arches of a question and of a self-weight, with what is proved of them.
pub fn surveyed(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (quantities, digits): (&[Quantity], usize),
) -> Result<SurveyedArches, Failure> {
    let answer = proved((asked, given), weight, |arches| match &given.stones {
        Some(stones) => survey_of_stones(arches, stones, digits),
        None => survey(arches, digits),
    })?;
    Ok(SurveyedArches { quantities: quantities.to_vec(), ..answer })
}

/// All arches of a question and of a self-weight, with what a proof finds of them.
pub fn proved(
    (asked, given): (&ArchAsked, &SurveyGiven),
    weight: SelfWeight,
    proof: impl Fn(&Survey) -> Result<SurveyAnswer, Error>,
) -> Result<SurveyedArches, Failure> {
    let found = Error::apart(proof(&arches(given, weight)?)).map_err(Error::from)?;
    let (asked, given) = (Understood::of_ranges(asked, given), given.clone());
    let (sought, quantities) = (None, Vec::new());
    Ok(SurveyedArches { asked, given, weight, sought, quantities, found })
}

/// The arches of a question, of a self-weight.
pub fn arches(given: &SurveyGiven, weight: SelfWeight) -> Result<Survey, Failure> {
    Ok(given.survey(weight).map_err(|error| error.to_string())?)
}
