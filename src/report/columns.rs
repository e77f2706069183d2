//! The fields of an arch that JSON and tables of columns share.

use super::answer::{Answer, Subject};
use super::answers::Answers;
use super::fields::Fields;

/// The fields before the values: the arch, the verdict, the mode.
pub(super) fn front(report: &Answers, answer: &Answer) -> Fields {
    let mut fields = Fields::default();
    let (mut alpha, mut mu, mut eta) = (None, None, None);
    if let Subject::Arch { half_opening, friction, thickness, .. } = &answer.subject {
        (alpha, mu, eta) =
            (Some(half_opening.as_str()), Some(friction.as_str()), thickness.as_deref());
    }
    fields.add("weight", answer.subject.weight().map(|weight| weight.name()));
    fields.add("half_opening", alpha);
    fields.add("friction", mu);
    if report.are_assessed() {
        fields.add("thickness", eta);
    }
    fields.add("verdict", answer.status.name());
    fields.add("stands", answer.stands);
    if !report.are_assessed() {
        fields.add("mode", answer.modes.first().map(|mode| mode.label()));
    }
    fields
}

/// The names of the columns of arches.
pub(super) fn names(report: &Answers) -> Vec<&'static str> {
    row(report, &Answer::refused(0, String::new())).names().collect()
}

/// The cells of an arch, all empty for a query that could not be read.
pub(super) fn cells(report: &Answers, answer: &Answer) -> Vec<String> {
    match answer.subject {
        Subject::Query { .. } => vec![String::new(); names(report).len()],
        _ => row(report, answer).texts().collect(),
    }
}

fn row(report: &Answers, answer: &Answer) -> Fields {
    let mut fields = front(report, answer);
    for &quantity in &report.quantities {
        fields.add(quantity.name(), answer.value(quantity).map(|value| value.text()));
    }
    if report.quantities.iter().any(|quantity| quantity.joint().is_some()) {
        let limits: Vec<&str> = answer.values.iter().filter_map(|(_, x)| x.limited_by).collect();
        fields.add("limited_by", limits.join("; "));
    }
    fields.add("reason", answer.status.reason());
    fields
}
