//! Answers about arches, landmarks and what is found, with asymmetric solutions and sizes: for every door.

use crate::arch::SelfWeight;
use crate::certify::state::find::{Question, find};
use crate::certify::state::{Answer as Outcome, AssessmentDigits, SomeDigits};
use crate::certify::state::{measured_assessment, measured_state};
use crate::certify::{CertifiedLandmark, Error, Refused, asymmetric_thicknesses};
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Landmark, Quantity};
use crate::report::{Answer, Extent};

/// Constants of a landmark, each to its digits.
pub fn landmark(
    (landmark, weight): (Landmark, SelfWeight),
    asked: &[(Quantity, usize)],
) -> Result<Answer, Error> {
    let point = CertifiedLandmark::new(landmark, weight)?;
    let constants = point.constants_of(asked)?;
    Ok(Answer::landmark((landmark, weight), Ok((&point, constants))))
}

/// Answer to a question asked the other way round, to so many digits. The line tells questions apart.
pub fn finding(
    line: u64,
    (weight, question): (SelfWeight, &Question),
    digits: usize,
) -> Result<Answer, Refused> {
    let found = Error::apart(find(weight, question, digits))?;
    Ok(Answer::finding(line, (weight, question), found))
}

/// State of an arch at its least thickness, as it was found to so many digits; sizes have a number of their own. The
/// line tells arches apart.
pub fn state(
    line: u64,
    of: (&Arch, Option<(&Measures, usize)>),
    digits: usize,
    found: &Result<Outcome, Error>,
) -> Answer {
    let all = |found: Outcome| found.map(|digits| digits.only(|_| true));
    state_to(Extent::ALL, line, of, digits, found.clone().map(all))
}

/// State of an arch, as far as it is shown.
pub fn state_to(
    extent: Extent,
    line: u64,
    (arch, measures): (&Arch, Option<(&Measures, usize)>),
    digits: usize,
    found: Result<Outcome<SomeDigits>, Error>,
) -> Answer {
    let answer = Answer::state_to(extent, line, arch, found)
        .with_asymmetric(|| asymmetric_thicknesses(arch, digits));
    match measures {
        Some((of, digits)) => answer.measured(of.circle(), measured_state(arch, of, digits)),
        None => answer,
    }
}

/// Arch of a given thickness, as it was found to so many digits and as far as it is shown.
pub fn assessment(
    extent: Extent,
    line: u64,
    (arch, thickness, measures): (&Arch, &ExactNumber, Option<(&Measures, usize)>),
    digits: usize,
    found: &Result<AssessmentDigits, Refused>,
) -> Answer {
    let answer = Answer::assessment(extent, line, (arch, thickness), found)
        .with_asymmetric(|| asymmetric_thicknesses(arch, digits));
    match measures {
        Some((of, digits)) => {
            answer.measured(of.circle(), measured_assessment((arch, thickness), of, digits))
        }
        None => answer,
    }
}
