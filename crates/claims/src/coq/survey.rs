//! The certificate of a survey: its ranges, the verdict, and the certificates of the arches that decide it.

use super::value::{capital, coefficient, number, rows};
use crate::check::{Certificate, PartFile, SurveyCertificate, SurveyFile};

/// Term of Coq; `single` is that of the certificate of one arch.
pub(super) fn term(certificate: &SurveyCertificate, single: fn(&Certificate) -> String) -> String {
    let parts = rows(certificate.parts.0.iter().map(|of| part(of, single)));
    let survey = survey(&certificate.survey);
    format!("SurveyCertificate {survey} {}\n    {parts}", verdict(certificate))
}

/// `AllStand` for `all_stand`.
pub(super) fn verdict(certificate: &SurveyCertificate) -> String {
    certificate.verdict.split('_').map(capital).collect()
}

fn survey(survey: &SurveyFile) -> String {
    let shape = match (&survey.free, &survey.spanned) {
        (Some(free), _) => {
            let [alphas, etas] =
                [&free.half_opening, &free.thickness].map(|ends| pair(ends, number));
            format!("(Free {alphas} {etas})")
        }
        (_, Some(spanned)) => {
            let [spans, rises, thicknesses] =
                [&spanned.span, &spanned.rise, &spanned.thickness].map(|ends| pair(ends, length));
            format!("(Spanned At{} {spans} {rises} {thicknesses})", capital(&spanned.circle))
        }
        _ => String::new(),
    };
    let frictions = pair(&survey.friction, coefficient);
    format!("(Survey {} {frictions} {shape})", capital(&survey.weight))
}

fn part(part: &PartFile, single: fn(&Certificate) -> String) -> String {
    let step = part.step.as_ref().map_or("None".to_owned(), |step| {
        let [spans, rises] = [&step.span, &step.rise].map(|ends| ends.iter().map(|x| length(x)));
        let places: Vec<String> = spans.zip(rises).map(|(s, f)| format!("({s}, {f})")).collect();
        format!("(Some ({}))", places.join(", "))
    });
    format!("Part {step}\n    ({})", single(&part.certificate))
}

fn pair(ends: &[String], write: fn(&str) -> String) -> String {
    format!("({})", ends.iter().map(|end| write(end)).collect::<Vec<_>>().join(", "))
}

/// A length in metres: `49/5`.
fn length(text: &str) -> String {
    format!("(Qmake {})", text.replace('/', " "))
}
