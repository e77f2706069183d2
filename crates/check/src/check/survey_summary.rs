//! Summary of a survey that was accepted: what is said of which arches.

use super::given::{friction_text, given_text};
use super::summary::shortened_fraction;
use super::survey_checker::AcceptedSurvey;
use crate::number::ExactNumber;
use crate::problem::Friction;
use crate::problem::asymmetric_region::STANDS;
use crate::problem::measures::Length;
use crate::problem::survey::{Shape, SurveyVerdict};

/// Summary of what was accepted of a survey, in a few words.
pub(super) fn survey_summary(accepted: &AcceptedSurvey) -> String {
    let survey = &accepted.survey;
    let verdict = match accepted.verdict {
        SurveyVerdict::AllStand => format!("all arches stand ({STANDS})"),
        SurveyVerdict::NoneStands => "no arch stands".to_owned(),
        SurveyVerdict::BothOccur => format!("one arch stands ({STANDS}) and one does not"),
    };
    let shape = match survey.shape() {
        Shape::Free { half_opening, thickness } => {
            let thickness = thickness.as_ref().map(|eta| numbers("thickness", eta));
            [Some(numbers("half_opening", half_opening)), thickness].into_iter().flatten().collect()
        }
        Shape::Spanned { circle, span, rise, thickness } => {
            let [span, rise, thickness] =
                [("span", span), ("rise", rise), ("thickness", thickness)].map(lengths);
            vec![format!("{} {span}", circle.name()), rise, thickness]
        }
    };
    let by = match accepted.parts {
        1 => "1 arch".to_owned(),
        parts => format!("{parts} arches"),
    };
    let (friction, weight) = (frictions(survey.friction()), survey.weight().name());
    format!("{verdict}: {} {friction} {weight}  by {by}", shape.join(" "))
}

fn numbers(name: &str, range: &[ExactNumber; 2]) -> String {
    between(name, range.each_ref().map(given_text))
}

fn frictions(range: &[Friction; 2]) -> String {
    between("friction", range.each_ref().map(friction_text))
}

fn lengths((name, range): (&str, &[Length; 2])) -> String {
    let text = |length: &Length| given_text(&ExactNumber::rational(length.metres().clone())) + " m";
    between(name, range.each_ref().map(text))
}

/// `span 49/5 m..51/5 m`, or one end if both are the same.
fn between(name: &str, ends: [String; 2]) -> String {
    let [first, last] = ends.map(|end| shortened_fraction(&end));
    if first == last { format!("{name} {first}") } else { format!("{name} {first}..{last}") }
}
