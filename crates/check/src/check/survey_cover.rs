//! Arches that have to be decided for a verdict on a survey: the corners, or those of steps that cover a course.

use super::survey_refusal::SurveyRefusal;
use crate::problem::survey::{
    Bounding, Shape, Side, SpanAndRise, Survey, SurveyVerdict, is_one_place,
};

/// Claim of a part: its side, and the ends of its step.
pub(super) type Claimed = (Side, Option<[SpanAndRise; 2]>);

/// An arch that has to be decided.
pub(super) struct Deciding {
    pub bounding: Bounding,
    /// True if it has to stand, false if not to stand.
    pub stands: bool,
}

/// The arches of some parts, if these are what a verdict on a survey takes.
pub(super) fn deciding(
    survey: &Survey,
    verdict: SurveyVerdict,
    parts: &[Claimed],
) -> Result<Vec<Deciding>, SurveyRefusal> {
    // Both occur where an arch of the side on which they stand least easily does not, and one of the other side does.
    let needed: &[(Side, bool)] = match verdict {
        SurveyVerdict::AllStand => &[(Side::Unsafe, true)],
        SurveyVerdict::NoneStands => &[(Side::Safe, false)],
        SurveyVerdict::BothOccur => &[(Side::Unsafe, false), (Side::Safe, true)],
    };
    match (survey.shape(), needed) {
        (Shape::Spanned { .. }, [(side, stands)]) => cover(survey, *side, *stands, parts),
        _ => singles(survey, needed, parts),
    }
}

/// The arches of steps that cover the course on a side without a gap, in its order.
fn cover(
    survey: &Survey,
    side: Side,
    stands: bool,
    parts: &[Claimed],
) -> Result<Vec<Deciding>, SurveyRefusal> {
    let [start, .., end] = survey.course(side).ok_or(SurveyRefusal::Step(1))?;
    let (mut at, mut all) = (&start, Vec::new());
    for (index, claimed) in parts.iter().enumerate() {
        let (part, [first, last]) = (index + 1, step(survey, side, claimed, index + 1)?);
        if !is_one_place(at, first) {
            return Err(SurveyRefusal::Gap(part));
        }
        let bounding = survey.bounding(side, [first, last]).ok_or(SurveyRefusal::Step(part))?;
        all.push(Deciding { bounding, stands });
        at = last;
    }
    match is_one_place(at, &end) && !parts.is_empty() {
        true => Ok(all),
        false => Err(SurveyRefusal::End),
    }
}

/// One arch of the survey for each of these sides: a corner, or one of a single place on a course.
fn singles(
    survey: &Survey,
    needed: &[(Side, bool)],
    parts: &[Claimed],
) -> Result<Vec<Deciding>, SurveyRefusal> {
    if parts.len() != needed.len() {
        return Err(SurveyRefusal::Parts { found: parts.len(), expected: needed.len() });
    }
    let single = |(index, (claimed, (side, stands))): (usize, (&Claimed, &(Side, bool)))| {
        let part = index + 1;
        let bounding = match survey.corner(*side) {
            Some(corner) => match claimed {
                (found, None) if found == side => corner,
                (_, None) => return Err(SurveyRefusal::Side(part, *side)),
                _ => return Err(SurveyRefusal::Step(part)),
            },
            None => {
                let [first, last] = step(survey, *side, claimed, part)?;
                if !is_one_place(first, last) {
                    return Err(SurveyRefusal::Wide(part));
                }
                survey.bounding(*side, [first, last]).ok_or(SurveyRefusal::Step(part))?
            }
        };
        Ok(Deciding { bounding, stands: *stands })
    };
    parts.iter().zip(needed).enumerate().map(single).collect()
}

/// The step of a part, if it is one of the course on a side.
fn step<'a>(
    survey: &Survey,
    side: Side,
    (found, step): &'a Claimed,
    part: usize,
) -> Result<[&'a SpanAndRise; 2], SurveyRefusal> {
    if *found != side {
        return Err(SurveyRefusal::Side(part, side));
    }
    let step = step.as_ref().ok_or(SurveyRefusal::Step(part))?.each_ref();
    match survey.has_step(side, step) {
        true => Ok(step),
        false => Err(SurveyRefusal::Beside(part)),
    }
}
