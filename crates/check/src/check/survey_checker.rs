//! The checker of surveys: from certificates of single arches to a verdict on all arches between measured ends.
//!
//! Which arches decide follows from the survey alone ([`problem::survey`](crate::problem::survey)): what a certificate
//! adds is where to cut a course into steps. Each arch in it has to be the one that decides there, number by number,
//! and its own certificate is checked as any other.

use super::checker::check_certificate;
use super::refusal::Refusal;
use super::survey_cover::{Claimed, Deciding, deciding};
use super::survey_file::{PartFile, SurveyCertificate};
use super::survey_refusal::SurveyRefusal;
use crate::number::Engine;
use crate::problem::survey::{Bounding, Survey, SurveyVerdict, is_one_friction, is_one_number};
use crate::problem::{Problem, Verdict};

/// The verdict on a survey, of a successful check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AcceptedSurvey {
    /// Survey that was claimed about.
    pub survey: Survey,
    /// The verdict on its arches.
    pub verdict: SurveyVerdict,
    /// Number of arches whose certificates decide it.
    pub parts: usize,
}

/// Checks a certificate of a survey in the arithmetic `E`, each arch in it up to `max_digits` digits and never more
/// than [`MAX_DIGITS`](super::MAX_DIGITS).
///
/// Guaranteed if it is accepted: the verdict holds for every arch of the survey, its ends among them. A [`Refusal`]
/// names the place and says nothing about the truth.
///
/// ```
/// use couplet_check::check::{ASTRO_DIGITS, SurveyCertificate, check_survey};
/// use couplet_check::problem::survey::SurveyVerdict;
/// use couplet_number::number::AstroInterval;
/// let file = include_bytes!("../../../../proofs/surveys/all-stand-free.json");
/// let accepted = check_survey::<AstroInterval>(&SurveyCertificate::read(file)?, ASTRO_DIGITS)?;
/// assert_eq!(accepted.verdict, SurveyVerdict::AllStand);
/// # Ok::<(), couplet_check::check::Refusal>(())
/// ```
///
/// See also: [`check_file`](super::check_file), which takes a certificate of either kind.
pub fn check_survey<E: Engine>(
    certificate: &SurveyCertificate,
    max_digits: usize,
) -> Result<AcceptedSurvey, Refusal> {
    let survey = certificate.survey.resolve()?;
    let verdict = certificate.verdict()?;
    let parts = &certificate.parts.0;
    let claimed = |part: &PartFile| -> Result<Claimed, SurveyRefusal> {
        let step = part.step.as_ref().map(|step| step.places()).transpose()?;
        Ok((part.side()?, step))
    };
    let claimed: Vec<Claimed> = parts.iter().map(claimed).collect::<Result<_, _>>()?;
    let all = deciding(&survey, verdict, &claimed)?;
    // What is cheap to refuse is looked at first.
    for (index, (part, deciding)) in parts.iter().zip(&all).enumerate() {
        part.certificate.of_this_schema().map_err(|refusal| within(index, refusal))?;
        let problem = part.certificate.claim.resolve().map_err(|refusal| within(index, refusal))?;
        claims(index + 1, &problem, deciding, verdict)?;
    }
    for (index, part) in parts.iter().enumerate() {
        check_certificate::<E>(&part.certificate, max_digits)
            .map_err(|refusal| within(index, refusal))?;
    }
    Ok(AcceptedSurvey { survey, verdict, parts: parts.len() })
}

/// Refusal of the certificate of a part. One that is not checked leaves the whole unchecked.
fn within(index: usize, refusal: Refusal) -> Refusal {
    match refusal {
        Refusal::Limit(..) => refusal,
        _ => Refusal::Part(index + 1, Box::new(refusal)),
    }
}

/// Checks that a problem is that of an arch that decides, with the verdict on it that is needed.
fn claims(
    part: usize,
    problem: &Problem,
    deciding: &Deciding,
    of: SurveyVerdict,
) -> Result<(), SurveyRefusal> {
    let needed = SurveyRefusal::Claim { part, stands: deciding.stands, verdict: of };
    let Problem::Verdict { verdict, arch } = problem else { return Err(needed) };
    if matches!(verdict, Verdict::Stands(_)) != deciding.stands {
        return Err(needed);
    }
    let Bounding { arch: expected, thickness: expected_thickness } = &deciding.bounding;
    // An arch that stands at no thickness has none in its claim.
    let thickness = match verdict {
        Verdict::Slides | Verdict::TooWide => None,
        Verdict::TooThin { thickness, .. } => Some(thickness),
        Verdict::Stands(standing) => Some(&standing.thickness),
    };
    let is_thickness = thickness.is_none_or(|found| {
        expected_thickness.as_ref().is_some_and(|expected| is_one_number(found, expected))
    });
    let same = [
        ("weight", arch.weight() == expected.weight()),
        ("half_opening", is_one_number(arch.half_opening(), expected.half_opening())),
        ("friction", is_one_friction(arch.friction(), expected.friction())),
        ("thickness", is_thickness),
    ];
    match same.into_iter().find(|(_, is_same)| !is_same) {
        Some((place, _)) => Err(SurveyRefusal::Arch { part, place }),
        None => Ok(()),
    }
}
