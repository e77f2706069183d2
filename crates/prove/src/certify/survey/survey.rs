//! The question about every arch of a survey.

use super::answer::{QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
use super::corners::{self, Corner};
use super::course::placed;
use super::modes::modes;
use crate::problem::Quantity;
use crate::problem::survey::{Side, Survey};
use crate::prover::{Error, Refused, Undecided};

/// Proves what holds for every arch of a survey, to `digits` digits (of measured spans and rises to
/// [`MEASURED_DIGITS`](super::MEASURED_DIGITS) at most): the verdict on all, the ranges of what is asked of one, and
/// the modes that occur. Digits beyond [`MAX_DIGITS`](crate::certify::MAX_DIGITS) are refused; undecided if a value
/// stays open on which all depends.
///
/// ```
/// use couplet_check::problem::survey::{Shape, Survey};
/// use couplet_prove::certify::survey::{SurveyVerdict, survey};
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
    let modes = || modes(survey.weight(), &survey.half_opening(), survey.friction());
    let [worst, best] = [Side::Unsafe, Side::Safe].map(|side| {
        let at = SurveyedArch::new(survey.corner(side)?, None);
        Some(Corner::new(side, at, digits))
    });
    if let (Some(worst), Some(best)) = (worst, best) {
        return Ok(corners::answer(worst?, best?, Some(modes())));
    }
    Refused::digits(digits)?;
    let at = |side, of| placed(survey, side, of, digits);
    let (unsafest, worst) = at(Side::Unsafe, Quantity::GeometricSafety)?;
    let (safest, best) = at(Side::Safe, Quantity::GeometricSafety)?;
    let open = || Undecided::new("whether the thickness is enough");
    let verdict =
        corners::together(unsafest.stands.ok_or_else(open), safest.stands.ok_or_else(open));
    let (mut ranges, mut left_open) = (vec![least_thickness(survey, digits)?], None);
    let safety = unsafest.end(&worst).and_then(|lower| Ok((lower, safest.end(&best)?)));
    let end = |side, of| at(side, of).and_then(|(found, arch)| found.end(&arch));
    let both = |of| Ok::<_, Undecided>((end(Side::Safe, of)?, end(Side::Unsafe, of)?));
    let friction_safety = || {
        let lower = end(Side::Unsafe, Quantity::FrictionSafety)?;
        let upper = match best.arch.is_limited() {
            true => end(Side::Safe, Quantity::FrictionSafety)?,
            false => RangeEnd::unbounded(&best),
        };
        Ok((lower, upper))
    };
    let mut all = vec![
        (Quantity::GeometricSafety, safety),
        (Quantity::RequiredFriction, both(Quantity::RequiredFriction)),
        (Quantity::ThicknessInMetres, both(Quantity::ThicknessInMetres)),
    ];
    if worst.arch.is_limited() {
        all.insert(2, (Quantity::FrictionSafety, friction_safety()));
    }
    // What stays open of one quantity leaves the others as they are.
    for (of, ends) in all {
        match ends {
            Ok((lower, upper)) => ranges.push(QuantityRange { of, lower, upper }),
            Err(why) => left_open = left_open.or_else(|| Some(why.about(of.name()))),
        }
    }
    ranges.extend(thrusts(survey, digits).into_iter().flatten());
    let verdict = Some(verdict);
    Ok(SurveyAnswer { verdict, worst, best, ranges, open: left_open, modes: Some(modes()) })
}

/// Enclosures of the least and of the largest thrust of measured arches, if they all stand: those of two arches with
/// the half opening of one end of the survey and the thickness of another.
fn thrusts(survey: &Survey, digits: usize) -> Option<[QuantityRange; 2]> {
    let digits = digits.min(corners::ENCLOSED_DIGITS);
    let found = |side| {
        let outermost = survey.beyond(side)?;
        corners::enclosed_thrusts(&outermost.arch, outermost.thickness.as_ref()?, digits)
    };
    let [worst_least, worst_largest] = found(Side::Unsafe)?;
    let [best_least, best_largest] = found(Side::Safe)?;
    let range = |of, lower, upper| {
        let [lower, upper] = [lower, upper].map(|value| RangeEnd { value, at: None });
        QuantityRange { of, lower, upper }
    };
    Some([
        range(Quantity::LeastThrust, best_least.0, worst_least.1),
        range(Quantity::LargestThrust, worst_largest.0, best_largest.1),
    ])
}

/// Range of the least thickness, which half opening and friction decide: its ends belong to ends of the course.
fn least_thickness(survey: &Survey, digits: usize) -> Result<QuantityRange, Error> {
    let corner = |side| {
        let course = survey.course(side).ok_or_else(Undecided::no_solution)?;
        let [first, _, last] = course;
        let place = if side == Side::Unsafe { last } else { first };
        let at = survey.bounding(side, [&place, &place]).ok_or_else(Undecided::no_solution)?;
        let at = SurveyedArch::new(at, survey.measured(side, &place));
        Ok::<_, Error>(Corner::new(side, at, digits)?)
    };
    let (worst, best) = (corner(Side::Unsafe)?, corner(Side::Safe)?);
    let (ranges, open) = corners::ranges(&worst, &best);
    let found = ranges.into_iter().find(|range| range.of == Quantity::LeastThickness);
    Ok(found.ok_or_else(|| open.unwrap_or_else(Undecided::no_solution))?)
}
