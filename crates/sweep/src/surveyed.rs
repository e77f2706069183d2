//! The answer about every arch of a question with ranges: for every door.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, SurveyGiven};
use crate::certify::Error;
use crate::certify::survey::{share as survey_share, survey};
use crate::failure::Failure;
use crate::problem::Quantity;
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
