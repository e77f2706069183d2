//! All arches of a question with ranges.

use crate::answer::Answer;
use crate::failure::{Failure, wrong};
use crate::question::{ARCH, certified};
use crate::threads::on_threads;
use couplet::arch::SelfWeight;
use couplet::ask::{ArchAsked, ArchQuestion, Field, Spelling, SurveyGiven};
use couplet::certify;
use couplet::check::SurveyCertificate;
use couplet::sweep::failure::Failure as Failed;
use couplet::sweep::surveyed::{quantities, surveyed as found};

/// Question about a verdict on all arches, which need a thickness.
const CERTIFIED: ArchQuestion = ArchQuestion { needs: &[Field::Thickness], ..ARCH };

/// Answer about every arch inside.
pub(crate) fn surveyed(
    asked: &ArchAsked,
    weight: SelfWeight,
    digits: usize,
) -> Result<Answer, Failure> {
    let given = SurveyGiven::read(&ARCH, asked, Spelling::Key).map_err(wrong)?;
    match found(asked, &given, weight, (&quantities(asked), digits)) {
        Ok(found) => Ok(Answer::surveyed(&found)),
        Err(Failed::Undecided(open)) => Ok(Answer::undecided(open)),
        Err(failed) => Err(wrong(failed)),
    }
}

/// Certificate of the verdict on all of them.
pub(crate) fn survey_certified(
    asked: &ArchAsked,
    weight: SelfWeight,
    digits: usize,
) -> Result<Answer, Failure> {
    let given = SurveyGiven::read(&CERTIFIED, asked, Spelling::Key).map_err(wrong)?;
    let survey = given.survey(weight).map_err(wrong)?;
    // Its parts are shared among threads, which are to be of this call.
    let made = on_threads(1, || certify::certify_survey(&survey, digits))?;
    certified(made, SurveyCertificate::write)
}
