//! The question about every arch of a survey.

use super::answer::{QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
use super::corners::{self, Corner};
use super::course::extreme;
use super::modes::modes;
use crate::problem::Quantity;
use crate::problem::survey::{Side, Survey};
use crate::prover::{Error, Refused, Undecided};

/// Proves what holds for every arch of a survey, to `digits` digits (of measured spans and rises to
/// [`MEASURED_DIGITS`](super::MEASURED_DIGITS) at most): the verdict on all, the ranges of what is asked of one, and the
/// modes that occur. Digits beyond [`MAX_DIGITS`](crate::certify::MAX_DIGITS) are refused; undecided if a value stays
/// open on which all depends.
///
/// ```
/// use couplet_prove::certify::survey::{SurveyVerdict, survey};
/// use couplet_prove::prelude::*;
/// use couplet_prove::problem::survey::{Shape, Survey};
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
        let (worst, best) = (worst?, best?);
        return Ok(SurveyAnswer {
            verdict: corners::verdict(&worst, &best),
            ranges: corners::ranges(&worst, &best),
            worst: worst.at,
            best: best.at,
            modes: modes(),
        });
    }
    Refused::digits(digits)?;
    let at = |side, of| {
        let found = extreme(survey, side, of, digits)?;
        let bounding = survey.bounding(side, [&found.place, &found.place]);
        let arch = bounding.ok_or_else(Undecided::no_solution)?;
        let arch = SurveyedArch::new(arch, survey.measured(side, &found.place));
        Ok::<_, Undecided>((found, arch))
    };
    let (unsafest, worst) = at(Side::Unsafe, Quantity::GeometricSafety)?;
    let (safest, best) = at(Side::Safe, Quantity::GeometricSafety)?;
    let open = || Undecided::new("whether the thickness is enough");
    let verdict =
        corners::together(unsafest.stands.ok_or_else(open), safest.stands.ok_or_else(open));
    let mut ranges = vec![least_thickness(survey, digits)?];
    ranges.push(QuantityRange {
        of: Quantity::GeometricSafety,
        lower: unsafest.end(&worst),
        upper: safest.end(&best),
    });
    for of in [Quantity::RequiredFriction, Quantity::FrictionSafety, Quantity::ThicknessInMetres] {
        let is_safety = of == Quantity::FrictionSafety;
        if is_safety && !worst.arch.is_limited() {
            continue;
        }
        // What stays open of one quantity leaves the others as they are.
        let Ok((unsafest, at_unsafest)) = at(Side::Unsafe, of) else { continue };
        let unsafe_end = unsafest.end(&at_unsafest);
        let safe_end = match is_safety && !best.arch.is_limited() {
            true => RangeEnd::unbounded(&best),
            false => {
                let Ok((safest, at_safest)) = at(Side::Safe, of) else { continue };
                safest.end(&at_safest)
            }
        };
        let [lower, upper] =
            if is_safety { [unsafe_end, safe_end] } else { [safe_end, unsafe_end] };
        ranges.push(QuantityRange { of, lower, upper });
    }
    Ok(SurveyAnswer { verdict, worst, best, ranges, modes: modes() })
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
    let ranges = corners::ranges(&worst, &best);
    let found = ranges.into_iter().find(|range| range.of == Quantity::LeastThickness);
    Ok(found.ok_or_else(|| Undecided::rounding("the rounding of a least thickness"))?)
}
