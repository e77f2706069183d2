//! The answer about every arch of a question with ranges: for every door.

use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchQuestion, Field, Spelling, SurveyGiven};
use crate::certify::Error;
use crate::failure::Failure;
use crate::number::list;
use crate::problem::Quantity;
use crate::problem::survey::Survey;
use crate::report::words::distinct;
use crate::report::{MeasureAlone, SurveyedArches, Understood};
use couplet_survey::{SurveyAnswer, survey, survey_of_stones};

/// Quantities of which ranges are told, of arches of a thickness.
const ASSESSED: [Quantity; 10] = list![
    Quantity: LeastThickness GeometricSafety RequiredFriction FrictionSafety LeastThrust LargestThrust
    ThicknessInMetres Weight LeastForce LargestForce
];

/// Quantities of which they are told of arches at their least thickness.
const STATED: [Quantity; 5] = list![Quantity: Thickness LeastThickness Thrust Weight Force];

/// Quantities of which ranges are told.
pub fn quantities(asked: &ArchAsked) -> Vec<Quantity> {
    told(|field| asked.get(field).is_some())
}

/// Quantities of which ranges are told, of arches that have these fields.
pub fn told(has: impl Fn(Field) -> bool) -> Vec<Quantity> {
    let all = if has(Field::Thickness) { &ASSESSED[..] } else { &STATED };
    let has_forces = has(Field::Density);
    all.iter().copied().filter(|of| has_forces || !of.is_force()).collect()
}

/// Quantities of which ranges are told in a table with these fields, in whose rows a thickness may be missing.
pub fn of_rows(has: impl Fn(Field) -> bool) -> Vec<Quantity> {
    let least = told(|of| of != Field::Thickness && has(of));
    let is_told = |of: &Quantity| match of {
        Quantity::Thickness => false,
        Quantity::ThicknessInMetres => has(Field::Span),
        _ => true,
    };
    distinct(told(&has).into_iter().chain(least).filter(is_told))
}

/// All arches of a question and of a self-weight, with what is proved of them; where their geometric safety is told and
/// more than one measure has a tolerance, also with what each of these does to it alone.
pub fn surveyed(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (quantities, digits): (&[Quantity], usize),
) -> Result<SurveyedArches, Failure> {
    let all = ranges(asked, given, weight, (quantities, digits))?;
    let (measures, safety) = (asked.tolerances(), [Quantity::GeometricSafety]);
    let is_told = asked.thickness.is_some() && quantities.contains(&safety[0]);
    if measures.len() < 2 || !is_told {
        return Ok(all);
    }
    let alone = |measure: Field| -> Result<SurveyedArches, Failure> {
        let asked = asked.alone(measure).map_err(|misfit| misfit.message)?;
        let given = SurveyGiven::read(&ArchQuestion::ANY, &asked, Spelling::Key);
        ranges(&asked, &given.map_err(|misfit| misfit.message)?, weight, (&safety, digits))
    };
    let alone = |measure| {
        let found = alone(measure).map_err(|error| error.to_string());
        MeasureAlone { measure, found }
    };
    Ok(all.with_each_alone(measures.into_iter().map(alone).collect()))
}

/// All arches of a question and of a self-weight, with what is proved of all together.
pub fn ranges(
    asked: &ArchAsked,
    given: &SurveyGiven,
    weight: SelfWeight,
    (quantities, digits): (&[Quantity], usize),
) -> Result<SurveyedArches, Failure> {
    let answer = proved((asked, given), weight, |arches| {
        let mut found = match &given.stones {
            Some(stones) => survey_of_stones(arches, stones, digits),
            None => survey(arches, digits),
        }?;
        if quantities.iter().any(|of| of.is_force())
            && let Some(force) = given.forces(found.numbers(Quantity::LeastThickness))
        {
            found.add_forces(&given.half_opening(), &force, digits);
        }
        Ok(found)
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
    Ok(SurveyedArches { asked, given, weight, sought, quantities, found, alone: Vec::new() })
}

/// The arches of a question, of a self-weight.
pub fn arches(given: &SurveyGiven, weight: SelfWeight) -> Result<Survey, Failure> {
    Ok(given.survey(weight).map_err(|error| error.to_string())?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::Undecided;
    use crate::report::{Format, Reported};

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
        let given = SurveyGiven::read(&ArchQuestion::ANY, &asked, Spelling::Option).unwrap();
        let told = quantities(&asked);
        let of = (&told[..], 6);
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
