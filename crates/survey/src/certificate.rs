//! Makes the certificate of a survey: the arches that decide the verdict on all of its arches, each with its own.
//!
//! Where half opening and thickness are free of each other two corners decide. Where spans and rises are measured a
//! course is covered by steps, at first its legs. An arch that is at least as unsafe as all of a step, or as safe, may
//! be none of the survey, and tell nothing of those that are: then the step is halved, and the arch in its middle may
//! be one for which the verdict does not hold.

use crate::certify::certify_arch;
use crate::certify::state::{Outcome, bits_lost, state_enclosed};
use crate::check::{
    MAX_PARTS, PartFile, Parts, SURVEY_SCHEMA, StepFile, SurveyCertificate, SurveyFile,
};
use crate::number::Ball;
use crate::problem::survey::{Bounding, Shape, Side, SpanAndRise, Survey, SurveyVerdict};
use crate::prover::decide::decide;
use crate::prover::{Error, Refused, Undecided, raise};
use num_bigint::BigInt;
use rayon::prelude::*;

/// Bits in which an arch is looked at first.
const BITS: u32 = 100;

/// Number of times that a step is halved: what is nearer to its limit than this tells stays open.
const HALVINGS: usize = 64;

/// A certificate of the verdict on all arches of a survey, with `digits` significant digits of each value in it, 1 to
/// [`MAX_DIGITS`](crate::certify::MAX_DIGITS). A survey without a thickness has no verdict, and is refused; undecided
/// if a comparison stays open, or more than [`MAX_PARTS`] steps are needed.
pub fn certify_survey(survey: &Survey, digits: usize) -> Result<SurveyCertificate, Error> {
    Refused::digits(digits)?;
    Refused::certifiable(&survey.half_opening(), survey.friction())?;
    if matches!(survey.shape(), Shape::Free { thickness: None, .. }) {
        return Err(Refused::SurveyWithoutThickness.into());
    }
    let file = SurveyFile::new(survey).ok_or(Refused::LongLengths)?;
    let (verdict, parts) = match survey.shape() {
        Shape::Free { .. } => at_corners(survey)?,
        Shape::Spanned { .. } => on_courses(survey)?,
    };
    let certified = |part: &DecidingArch| part.certified(survey, digits);
    Ok(SurveyCertificate {
        schema: SURVEY_SCHEMA.to_owned(),
        tool: concat!("couplet ", env!("CARGO_PKG_VERSION")).to_owned(),
        survey: file,
        verdict: verdict.name().to_owned(),
        parts: Parts(parts.par_iter().map(certified).collect::<Result<_, _>>()?),
    })
}

/// Arch that decides something: a corner, or one of a step.
struct DecidingArch {
    side: Side,
    step: Option<[SpanAndRise; 2]>,
}

impl DecidingArch {
    fn step(side: Side, step: [SpanAndRise; 2]) -> Self {
        Self { side, step: Some(step) }
    }

    fn bounding(&self, survey: &Survey) -> Result<Bounding, Undecided> {
        let found = match &self.step {
            Some(step) => survey.bounding(self.side, step.each_ref()),
            None => survey.corner(self.side),
        };
        found.ok_or_else(|| Undecided::new("which arch decides"))
    }

    /// Tells whether its arch stands.
    fn stands(&self, survey: &Survey) -> Result<bool, Undecided> {
        let Bounding { arch, thickness } = self.bounding(survey)?;
        let thickness = thickness.ok_or_else(|| Undecided::new("how thick the arch is"))?;
        raise(BITS + bits_lost(&arch), |bits| {
            let Outcome::Stands(state) = state_enclosed(&arch, bits, false)? else {
                return Ok(Some(false));
            };
            let margin = thickness.enclosure::<Ball>(bits) - &state.thickness;
            decide(&margin, "whether the thickness is enough", &[]).map(Some)
        })
    }

    fn certified(&self, survey: &Survey, digits: usize) -> Result<PartFile, Error> {
        let Bounding { arch, thickness } = self.bounding(survey)?;
        let step = self.step.as_ref().map(|step| {
            StepFile::new(step.each_ref()).ok_or_else(|| Undecided::new("a step in so many digits"))
        });
        Ok(PartFile {
            side: self.side.name().to_owned(),
            step: step.transpose()?,
            certificate: certify_arch(&arch, thickness.as_ref(), digits)?,
        })
    }
}

/// The verdict by one corner, or by both.
fn at_corners(survey: &Survey) -> Result<(SurveyVerdict, Vec<DecidingArch>), Undecided> {
    let [worst, best] = [Side::Unsafe, Side::Safe].map(|side| DecidingArch { side, step: None });
    Ok(match (worst.stands(survey)?, best.stands(survey)?) {
        (true, _) => (SurveyVerdict::AllStand, vec![worst]),
        (false, true) => (SurveyVerdict::BothOccur, vec![worst, best]),
        (false, false) => (SurveyVerdict::NoneStands, vec![best]),
    })
}

/// The verdict by steps that cover one course, or by an arch of each.
fn on_courses(survey: &Survey) -> Result<(SurveyVerdict, Vec<DecidingArch>), Undecided> {
    let falls = match along(survey, Side::Unsafe)? {
        CourseOutcome::Covered(parts) => return Ok((SurveyVerdict::AllStand, parts)),
        CourseOutcome::Found(falls) => falls,
    };
    Ok(match along(survey, Side::Safe)? {
        CourseOutcome::Covered(parts) => (SurveyVerdict::NoneStands, parts),
        CourseOutcome::Found(stands) => (SurveyVerdict::BothOccur, vec![falls, stands]),
    })
}

/// Outcome along a course.
#[allow(clippy::large_enum_variant, reason = "there are two for each survey")]
enum CourseOutcome {
    /// Steps of which all arches stand, on the unsafe side, or none, on the safe side.
    Covered(Vec<DecidingArch>),
    /// An arch that does not, or does.
    Found(DecidingArch),
}

/// Covers the course on a side by steps, or finds an arch that is not as the others would have to be.
fn along(survey: &Survey, side: Side) -> Result<CourseOutcome, Undecided> {
    let open = |reason: &'static str| {
        Undecided::new(reason).about(match side {
            Side::Unsafe => "whether all arches stand",
            Side::Safe => "whether any arch stands",
        })
    };
    let course = survey.course(side).ok_or_else(|| open("which arches decide"))?;
    let single = |place: &SpanAndRise| DecidingArch::step(side, [place.clone(), place.clone()]);
    let shows = |part: &DecidingArch, stands: bool| part.stands(survey) == Ok(stands);
    let is_found = |part: &DecidingArch| shows(part, side == Side::Safe);
    if let Some(found) = course.iter().map(single).find(is_found) {
        return Ok(CourseOutcome::Found(found));
    }
    let legs = course.windows(2).filter(|leg| leg[0] != leg[1]);
    let mut steps: Vec<(DecidingArch, bool)> = legs
        .map(|leg| (DecidingArch::step(side, [leg[0].clone(), leg[1].clone()]), false))
        .collect();
    if steps.is_empty() {
        steps.push((single(&course[0]), false));
    }
    for _ in 0..HALVINGS {
        let mut next = Vec::new();
        for (part, is_known) in steps {
            let [first, last] = match &part.step {
                Some(step) if !is_known && !shows(&part, side == Side::Unsafe) => step.clone(),
                _ => {
                    next.push((part, true));
                    continue;
                }
            };
            if first == last {
                return Err(open("the only arch is too near its limit"));
            }
            let middle = [0, 1].map(|i| (&first[i] + &last[i]) / BigInt::from(2));
            let found = single(&middle);
            if is_found(&found) {
                return Ok(CourseOutcome::Found(found));
            }
            let halves = [[first, middle.clone()], [middle, last]];
            next.extend(halves.map(|half| (DecidingArch::step(side, half), false)));
        }
        if next.iter().all(|(_, is_known)| *is_known) {
            return Ok(CourseOutcome::Covered(next.into_iter().map(|(part, _)| part).collect()));
        }
        if next.len() > MAX_PARTS {
            break;
        }
        steps = next;
    }
    Err(open("some arches are too near their limit for the steps that a certificate may have"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::check::{AcceptedFile, Refusal, check_file};
    use crate::number::AstroInterval;
    use crate::problem::Friction;
    use crate::problem::measures::{Circle, Length};
    use std::fmt::Debug;
    use std::str::FromStr;

    fn ends<T: FromStr<Err: Debug>>(range: [&str; 2]) -> [T; 2] {
        range.map(|text| text.parse().unwrap())
    }

    fn free(half_opening: [&str; 2], friction: [&str; 2], thickness: [&str; 2]) -> Survey {
        let thickness = Some(ends(thickness));
        let shape = Shape::Free { half_opening: ends(half_opening), thickness };
        Survey::new(SelfWeight::Milankovitch, ends::<Friction>(friction), shape).unwrap()
    }

    fn spanned(span: [&str; 2], rise: [&str; 2], t: [&str; 2], friction: [&str; 2]) -> Survey {
        let [span, rise, thickness]: [[Length; 2]; 3] = [span, rise, t].map(ends);
        let shape = Shape::Spanned { circle: Circle::Intrados, span, rise, thickness };
        Survey::new(SelfWeight::Heyman, ends::<Friction>(friction), shape).unwrap()
    }

    /// Verdict and number of parts, which both arithmetics accept.
    fn accepted(survey: &Survey) -> (SurveyVerdict, usize) {
        let made = certify_survey(survey, 5).unwrap();
        let bytes = serde_json::to_vec(&made).unwrap();
        let by_mpfr: Result<AcceptedFile, Refusal> = check_file::<Ball>(&bytes, 5);
        assert_eq!(by_mpfr, check_file::<AstroInterval>(&bytes, 5));
        let AcceptedFile::Survey(accepted) = by_mpfr.unwrap() else { panic!("{made:?}") };
        assert_eq!(accepted.parts, made.parts.0.len());
        (accepted.verdict, accepted.parts)
    }

    #[test]
    fn corners_decide_where_half_opening_and_thickness_are_free() {
        use SurveyVerdict::{AllStand, BothOccur, NoneStands};
        for (half_opening, friction, thickness, expected) in [
            (["70deg", "80deg"], ["0.5", "0.6"], ["0.1", "0.2"], (AllStand, 1)),
            (["70deg", "80deg"], ["0.5", "0.6"], ["0.06", "0.2"], (BothOccur, 2)),
            (["80deg", "90deg"], ["0.5", "inf"], ["0.01", "0.05"], (NoneStands, 1)),
            (["80deg", "90deg"], ["0.1", "tan(10deg)"], ["0.01", "2"], (NoneStands, 1)),
            (["2.8", "2.9"], ["4", "4"], ["1", "2"], (NoneStands, 1)),
            (["1", "2.9"], ["0.1", "inf"], ["1", "2"], (BothOccur, 2)),
            (["pi/2", "90deg"], ["1/2", "0.5"], ["1/5", "0.2"], (AllStand, 1)),
        ] {
            let survey = free(half_opening, friction, thickness);
            assert_eq!(accepted(&survey), expected, "{survey:?}");
        }
    }

    #[test]
    fn courses_are_covered_or_show_an_arch_of_each_kind() {
        let made = |span, rise, t, friction| accepted(&spanned(span, rise, t, friction));
        let (verdict, parts) =
            made(["9.9m", "10.1m"], ["2.95m", "3.05m"], ["45cm", "50cm"], ["0.5", "0.6"]);
        assert_eq!((verdict, parts), (SurveyVerdict::AllStand, 2));
        let (verdict, _) =
            made(["9.9m", "10.1m"], ["2.95m", "3.05m"], ["10cm", "50cm"], ["0.5", "0.6"]);
        assert_eq!(verdict, SurveyVerdict::BothOccur);
        let (verdict, _) = made(["9m", "11m"], ["4.5m", "5.5m"], ["5cm", "10cm"], ["0.5", "inf"]);
        assert_eq!(verdict, SurveyVerdict::NoneStands);
        // One arch.
        let (verdict, parts) = made(["10m", "10m"], ["3m", "3m"], ["45cm", "45cm"], ["1", "1"]);
        assert_eq!((verdict, parts), (SurveyVerdict::AllStand, 1));
        let (verdict, parts) = made(["10m", "10m"], ["3m", "3m"], ["5cm", "5cm"], ["1", "1"]);
        assert_eq!((verdict, parts), (SurveyVerdict::NoneStands, 1));
    }

    #[test]
    fn next_to_a_limit_steps_are_halved() {
        use SurveyVerdict::{AllStand, BothOccur};
        for (thickness, expected) in [
            ("25cm", (AllStand, 2)),
            ("22cm", (AllStand, 3)),
            ("19cm", (AllStand, 5)),
            ("12cm", (BothOccur, 2)),
        ] {
            let survey = spanned(["9m", "11m"], ["2m", "3m"], [thickness, "50cm"], ["0.7", "0.8"]);
            assert_eq!(accepted(&survey), expected, "{thickness}");
        }
    }

    #[test]
    fn what_has_no_verdict_is_refused() {
        let shape = Shape::Free { half_opening: ends(["1", "1.1"]), thickness: None };
        let survey = Survey::new(SelfWeight::Heyman, ends(["1", "2"]), shape).unwrap();
        let refused = |survey: &Survey, digits| match certify_survey(survey, digits) {
            Err(Error::Refused(refused)) => refused.to_string(),
            other => panic!("{other:?}"),
        };
        assert!(refused(&survey, 5).contains("needs a thickness"));
        let long = format!("1.{}1m", "0".repeat(300));
        let survey = spanned([&long, "2m"], ["1m", "1m"], ["1m", "1m"], ["1", "2"]);
        assert!(refused(&survey, 5).contains("300 digits"));
        assert!(refused(&free(["1", "1"], ["1", "1"], ["1", "1"]), 0).contains("digits"));
    }
}
