//! Statement that an accepted file proves, in one whole sentence: each number as it is given, each value with all its
//! digits. `proofs/check_with_arb.py` writes it a second time, from the page of the format, and
//! `proofs/verified/statement.ml` a third, from what Coq has proved. Each clause is a part of `claim_of` in
//! `proofs/coq/verified/Certificate.v`; where a checker has to look is not said.

use super::checker::Accepted;
use super::given::{friction_text, given_text};
use super::survey_checker::AcceptedSurvey;
use crate::number::ExactNumber;
use crate::problem::asymmetric_region::STANDS;
use crate::problem::survey::{Shape, SurveyVerdict};
use crate::problem::{Arch, Landmark, Mode, Problem, Verdict};

/// Statement on a landmark or an arch.
pub(super) fn statement(accepted: &Accepted) -> String {
    let problem = &accepted.problem;
    let (subject, says) = match problem {
        Problem::Landmark { landmark, .. } => {
            (format!("landmark {}", landmark.symbol()), of_landmark(*landmark))
        }
        Problem::State { mode, arch } => (described(arch), of_state(*mode)),
        Problem::Asymmetric { mode, arch } => (
            described(arch),
            format!(
                "the complementarity problem (19) of the whole arch has an asymmetric solution, {mode}, admissible at \
                 every joint"
            ),
        ),
        Problem::Verdict { verdict, arch } => of_verdict(verdict, arch),
    };
    let values = accepted.values.iter();
    let values: Vec<String> =
        values.map(|(quantity, value)| format!("{} = {value}", quantity.name())).collect();
    let values = match (values.join(", "), accepted.digits) {
        (values, _) if values.is_empty() => values,
        (values, digits) => {
            let plural = if digits == 1 { "" } else { "s" };
            format!(
                "; there {values}, each correctly rounded to {digits} significant digit{plural}"
            )
        }
    };
    format!("{subject}, {} weight: {says}{values}", problem.weight().name())
}

fn of_landmark(landmark: Landmark) -> String {
    let labels: Vec<&str> = landmark.modes().iter().map(|mode| mode.label()).collect();
    let rougher = match landmark.modes().contains(&Mode::Sliding) {
        true => ", and none of its half opening with less friction",
        false => "",
    };
    format!(
        "its equations have a solution, the only one in the large box, that is a state of {}, admissible at every joint, \
         and no thinner arch of its half opening and friction stands{rougher}",
        labels.join(", ")
    )
}

fn of_state(mode: Mode) -> String {
    format!(
        "the arch stands ({STANDS}) exactly from a least thickness on, up to 2, and at the least one it has a state of \
         {mode}, the only solution of its equations in the large box"
    )
}

fn of_verdict(verdict: &Verdict, arch: &Arch) -> (String, String) {
    let with = |eta: &ExactNumber| format!("{}, thickness {}", described(arch), given_text(eta));
    match verdict {
        Verdict::Slides => (
            described(arch),
            "the arch stands at no thickness, as its friction is below that of pure sliding".into(),
        ),
        Verdict::TooWide => (
            described(arch),
            "the arch stands at no thickness up to 2, as its half opening is beyond a bound for its friction".into(),
        ),
        Verdict::TooThin { mode, thickness } => (
            with(thickness),
            format!("the arch does not stand, as its least thickness, of {mode}, is larger"),
        ),
        Verdict::Stands(standing) => (
            with(&standing.thickness),
            format!("the arch stands ({STANDS})"),
        ),
    }
}

fn described(arch: &Arch) -> String {
    let [half_opening, friction] =
        [given_text(arch.half_opening()), friction_text(arch.friction())];
    format!("half opening {half_opening}, friction {friction}")
}

/// Statement on a survey.
pub(super) fn survey_statement(accepted: &AcceptedSurvey) -> String {
    let survey = &accepted.survey;
    let says = match accepted.verdict {
        SurveyVerdict::AllStand => "every arch stands",
        SurveyVerdict::NoneStands => "no arch stands",
        SurveyVerdict::BothOccur => "one arch stands and one does not",
    };
    let numbers = |range: &[ExactNumber; 2]| range.each_ref().map(given_text).join(" to ");
    let shape = match survey.shape() {
        Shape::Free { half_opening, thickness } => {
            let thick = thickness.as_ref().map(|eta| format!("thickness {}, ", numbers(eta)));
            format!("half opening {}, {}", numbers(half_opening), thick.unwrap_or_default())
        }
        Shape::Spanned { circle, span, rise, thickness } => {
            let [span, rise, thickness] = [span, rise, thickness].map(|range| {
                numbers(&range.each_ref().map(|x| ExactNumber::rational(x.metres().clone()))) + " m"
            });
            format!("span {span} and rise {rise} at the {}, thickness {thickness}, ", circle.name())
        }
    };
    let friction = survey.friction().each_ref().map(friction_text).join(" to ");
    let weight = survey.weight().name();
    format!("all arches with {shape}friction {friction}, {weight} weight: {says} ({STANDS})")
}
