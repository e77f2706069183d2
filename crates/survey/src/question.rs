//! The question about every arch of a survey.

use super::answer::{ENCLOSED_DIGITS, QuantityRange, SurveyAnswer, SurveyedArch};
use super::corners::{self, Corner};
use super::modes::modes;
use crate::problem::Quantity;
use crate::problem::measures::{Measures, of_span_and_rise};
use crate::problem::survey::{Side, Survey};
use crate::prover::{Error, Undecided};

/// Proves what holds for every arch of a survey, to `digits` digits: the verdict on all, the ranges of what is asked of
/// one, and the modes that occur. Digits beyond [`MAX_DIGITS`](crate::certify::MAX_DIGITS) are refused; undecided if a
/// value stays open on which all depends.
///
/// ```
/// use couplet_check::problem::survey::{Shape, Survey};
/// use couplet_survey::{SurveyVerdict, survey};
/// use couplet_prove::prelude::*;
/// let shape = Shape::Free {
///     half_opening: ["78deg".parse()?, "82deg".parse()?],
///     thickness: Some(["0.08".parse()?, "0.1".parse()?]),
/// };
/// let arches = Survey::new(SelfWeight::Milankovitch, ["0.55".parse()?, "inf".parse()?], shape)?;
/// let found = survey(&arches, 6)?;
/// assert_eq!(found.verdict, Some(Ok(SurveyVerdict::AllStand)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn survey(survey: &Survey, digits: usize) -> Result<SurveyAnswer, Error> {
    let [worst, best] = [Side::Unsafe, Side::Safe].map(|side| corner(survey, side, digits));
    let modes = modes(survey.weight(), &survey.half_opening(), survey.friction());
    let mut found = corners::answer(worst?, best?, Some(modes));
    found.ranges.extend(thrusts(survey, digits).into_iter().flatten());
    Ok(found)
}

/// The arch that decides on a side.
fn corner(survey: &Survey, side: Side, digits: usize) -> Result<Corner, Error> {
    let at = SurveyedArch::decisive(survey, side).ok_or_else(Undecided::no_solution)?;
    let measured = survey.thickness_at(side).zip(at.measured.clone());
    let corner = Corner::new(at, digits)?;
    let Some(((circle, _), [span, rise, _])) = measured else { return Ok(corner) };
    let measures = Measures::new(circle, of_span_and_rise(&span, &rise).1, None);
    Ok(corner.in_metres(&measures, digits)?)
}

/// Enclosures of the least and of the largest thrust of measured arches, if they all stand: those of two arches with
/// the half opening of one end of the survey and the thickness of another.
fn thrusts(survey: &Survey, digits: usize) -> Option<[QuantityRange; 2]> {
    let digits = digits.min(ENCLOSED_DIGITS);
    let found = |side| {
        let outermost = survey.beyond(side)?;
        corners::enclosed_thrusts(&outermost.arch, outermost.thickness.as_ref()?, digits)
    };
    let [worst_least, worst_largest] = found(Side::Unsafe)?;
    let [best_least, best_largest] = found(Side::Safe)?;
    Some([
        QuantityRange::enclosed(Quantity::LeastThrust, [best_least.0, worst_least.1]),
        QuantityRange::enclosed(Quantity::LargestThrust, [worst_largest.0, best_largest.1]),
    ])
}
