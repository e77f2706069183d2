//! The document that lists each value: JSON and TOML are two ways to write it. Fields may be added, none
//! changes its meaning.
//!
//! Where JSON has `null`, TOML has nothing; where a double is infinite, JSON has `null` and TOML `inf`.

use super::answer::Answer;
use super::answers::{Answers, TOOL};
use super::record::Record;
use super::subject::Subject;
use super::value_row::ValueRow;
use super::words::hexadecimal;

/// Document of landmarks or arches.
pub(super) fn document(report: &Answers) -> Record {
    let mut file = Record::of(report.schema());
    file.add("tool", TOOL);
    file.add("digits", report.digits);
    let values = report.list.iter().flat_map(ValueRow::all).filter(|row| row.value.is_some());
    file.add_list("constants", values.map(|row| constant(&row)));
    file.add_list("proofs", report.list.iter().map(proof));
    file
}

/// Whose value it is.
fn owner(subject: &Subject) -> Record {
    let mut fields = Record::default();
    fields.add("weight", subject.weight().map(|weight| weight.name()));
    if let Some(landmark) = subject.landmark() {
        fields.add("landmark", landmark.symbol());
    }
    if let Some(line) = subject.line() {
        fields.add("line", line);
    }
    fields
}

/// A proved value. `double` is the nearest to the true value, the doubles after it its bounds and a bound
/// of its error.
fn constant(row: &ValueRow) -> Record {
    let mut fields = owner(&row.answer.subject);
    fields.add_found(&ValueRow::named("quantity value lower upper exact double"), row);
    let double = row.value.map(|value| value.double).filter(|double| double.is_finite());
    fields.add("hex", double.map(hexadecimal));
    fields.add_found(&ValueRow::named("double_lower double_upper double_error"), row);
    fields
}

fn proof(answer: &Answer) -> Record {
    let mut fields = owner(&answer.subject);
    if matches!(answer.subject, Subject::Arch { .. } | Subject::Sought { .. }) {
        let names = "half_opening friction thickness half_opening_rad half_opening_deg \
                     friction_double thickness_double can_stand stands mode";
        fields.add_found(&ValueRow::named(names), &ValueRow::at(answer, None));
    }
    fields.add("verdict", answer.status.name());
    fields.add("reason", answer.status.reason());
    let proof = answer.proof.as_ref();
    fields.add("equations", proof.map_or(&[][..], |proof| &proof.equations));
    // Radius of the box of uniqueness for each unknown, relative to its value.
    let mut radii = proof.map_or(Vec::new(), |proof| proof.radii.clone());
    radii.sort_by_key(|(unknown, _)| *unknown);
    let mut relative = Record::default();
    radii.into_iter().for_each(|(unknown, radius)| relative.add_double(unknown, radius));
    fields.add_record("box_relative_radius", Some(relative));
    // The command that writes the certificate and the SHA-256 of its output; or why there is none.
    let certificate = match &answer.certificate {
        Ok(of) => [of.command.as_str().into(), of.sha256.as_str().into(), None],
        Err(reason) => [None, None, Some(reason.as_str())],
    };
    let certificate = Record::named("command sha256 reason", certificate.map(Into::into));
    fields.add_record("certificate", Some(certificate));
    fields
}
