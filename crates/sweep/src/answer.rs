//! An answer about one arch, with the asymmetric solutions that are known of it and, in metres, its sizes, or about all
//! arches of a question with ranges: for every door.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, SurveyGiven};
use crate::certify::state::{Answer as Outcome, AssessmentDigits};
use crate::certify::state::{measured_assessment, measured_state};
use crate::certify::survey::{share as survey_share, survey};
use crate::certify::{Error, Refused, asymmetric_thicknesses};
use crate::failure::Failure;
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Quantity};
use crate::report::{Answer, SurveyedArches, Understood};

/// State of an arch at its least thickness, as it was found to so many digits; sizes have a number of their own. The
/// line tells arches apart.
pub fn state(
    line: u64,
    (arch, measures): (&Arch, Option<(&Measures, usize)>),
    digits: usize,
    found: &Result<Outcome, Error>,
) -> Answer {
    let answer =
        Answer::state(line, arch, found).with_asymmetric(|| asymmetric_thicknesses(arch, digits));
    match measures {
        Some((of, digits)) => answer.measured(of.circle(), measured_state(arch, of, digits)),
        None => answer,
    }
}

/// Arch of a given thickness, as it was found to so many digits.
pub fn assessment(
    line: u64,
    (arch, thickness, measures): (&Arch, &ExactNumber, Option<(&Measures, usize)>),
    digits: usize,
    found: &Result<AssessmentDigits, Refused>,
) -> Answer {
    let answer = Answer::assessment(line, (arch, thickness), found)
        .with_asymmetric(|| asymmetric_thicknesses(arch, digits));
    match measures {
        Some((of, digits)) => {
            answer.measured(of.circle(), measured_assessment((arch, thickness), of, digits))
        }
        None => answer,
    }
}

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

/// Quantities of which the ranges of a question are told.
pub fn survey_quantities(asked: &ArchAsked) -> &'static [Quantity] {
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
