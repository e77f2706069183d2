//! The answer about every arch of a question with ranges: for every door.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, SurveyGiven};
use crate::certify::Error;
use crate::failure::Failure;
use crate::problem::Quantity;
use crate::problem::survey::Survey;
use crate::report::{SurveyedArches, Understood};
use couplet_survey::{SurveyAnswer, survey, survey_of_stones};

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::{ArchQuestion, Spelling};
    use crate::certify::Undecided;
    use crate::report::{Format, Reported};

    const QUESTION: ArchQuestion =
        ArchQuestion { refuses: &[], needs: &[], unlimited: false, example: "" };

    /// A verdict that is proved comes first, whatever stays open beside it.
    #[test]
    fn what_stays_open_is_told_behind_the_verdict() {
        let text = |words: &str| Some(words.to_owned());
        let asked = ArchAsked {
            joints: text("2.00789,2.6309"),
            friction: text("0.691032..0.74143"),
            thickness: text("0.8498609..0.8517507"),
            ..ArchAsked::default()
        };
        let given = SurveyGiven::read(&QUESTION, &asked, Spelling::Option).unwrap();
        let of = (told(true), 6);
        let mut all = surveyed(&asked, &given, SelfWeight::Milankovitch, of).unwrap();
        assert!(all.first_open().is_none());
        let found = all.found.as_mut().unwrap();
        found.open = Some(Undecided::new("whether it is so").about("required_friction"));
        let mut written = Vec::new();
        let table = Format::named(SurveyedArches::content(), "table").unwrap();
        all.write(table, &mut written).unwrap();
        let written = String::from_utf8(written).unwrap();
        let place = |words: &str| written.lines().position(|line| line.trim() == words).unwrap();
        let [verdict, open] =
            ["every arch stands, proved", "undecided: required_friction: whether it is so"]
                .map(place);
        assert!(verdict == 2 && open > verdict, "{written}");
    }
}
