//! JSON: `couplet.constants/1` of landmarks, `couplet.state_at/1` of one with its modes, `couplet.state/2` or
//! `couplet.assess/2` of an arch, `couplet.arches/2` of many, `couplet.refused/1` of a query that could not be
//! read, `couplet.find/1` of what was found, a list of several. Fields may be added, none changes its meaning.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns::{Asked, DOUBLES, GIVEN, VERDICT};
use super::document::document;
use super::find;
use super::record::Record;
use super::rows::{Rows, in_parallel};
use super::value::Value;
use super::value_row::ValueRow;
use super::words::{hexadecimal, labels, printable};
use crate::problem::Quantity;
use serde::Serialize;
use std::borrow::Cow;
use std::io;

/// Records of landmarks or arches; of many arches one, in which each quantity that was not asked for is null.
pub(super) fn records(report: &Answers) -> Vec<Record> {
    let all = report.list.iter();
    match report.scope {
        Scope::Constants => vec![document(report)],
        Scope::Point => all.map(point).collect(),
        Scope::Arch => all.map(|answer| entry(report, answer, false)).collect(),
        Scope::Found => all.map(|answer| finding(report, answer)).collect(),
        Scope::Arches | Scope::Mixed => {
            let mut file = Record::of("couplet.arches/2");
            file.add("digits", report.digits);
            let names = report.quantities.iter().map(|quantity| quantity.name());
            file.add("quantities", names.collect::<Vec<_>>());
            file.add_list("arches", all.map(|answer| entry(report, answer, false)));
            vec![file]
        }
    }
}

/// Writes a document for a program, which a person can read too; texts may be those of other people.
pub(super) fn write(document: &impl Serialize, out: &mut dyn io::Write) -> io::Result<()> {
    out.write_all(&escaped(serde_json::to_string_pretty(document)?))
}

/// A document on one line.
pub(super) fn line(document: &impl Serialize) -> io::Result<Vec<u8>> {
    Ok(escaped(serde_json::to_string(document)?))
}

/// A line of JSON with what is no text as escapes, which are the same to a reader.
fn escaped(json: String) -> Vec<u8> {
    let json = json + "\n";
    let escaped = match printable(&json, |c| format!("\\u{:04x}", u32::from(c))) {
        Cow::Owned(escaped) => Some(escaped),
        Cow::Borrowed(_) => None,
    };
    escaped.unwrap_or(json).into_bytes()
}

/// Arches as they come, each on one line.
pub(super) struct JsonLines(pub Answers);

impl Rows for JsonLines {
    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        in_parallel(&answers, |answer| line(&entry(&self.0, answer, true)))
    }
}

/// An arch: a missing value is null, an unbounded one the text `inf`. Each has the fields of what was asked
/// of it, whatever the others were asked.
fn entry(report: &Answers, answer: &Answer, with_line: bool) -> Record {
    let mut fields = Record::default();
    let asked = Asked::of(answer);
    let schema = if asked.assessment { "couplet.assess/2" } else { "couplet.state/2" };
    fields.add("schema", if answer.is_read() { schema } else { "couplet.refused/1" });
    if with_line {
        fields.add("line", answer.subject.line());
    }
    fields.keep(&answer.kept);
    if !answer.is_read() {
        fields.add("error", answer.fault());
        return fields;
    }
    if let Some(asked) = &answer.asked {
        fields.add_record("asked", Some(asked.fields()));
    }
    let circle = report.are_measured().then_some("measured_at");
    for names in [GIVEN].into_iter().chain(circle).chain([DOUBLES, VERDICT]) {
        fields.add_found(&asked.columns(names), &ValueRow::at(answer, None));
    }
    let figure = |value: Option<&Value>| Some(figure(value?, report.have_doubles()));
    let asymmetric = Quantity::AsymmetricThickness;
    fields.add_record(asymmetric.name(), figure(answer.value(asymmetric)));
    let quantities =
        if asked.assessment { &Quantity::ASSESSMENT[..] } else { &Quantity::STATE[..] };
    for &quantity in quantities {
        let value = answer.value(quantity);
        let value = match quantity.joint() {
            Some(joint) => value.map(|thrust| limit(thrust, answer.value(joint), figure)),
            None => figure(value),
        };
        let open = answer.why_open(quantity);
        let open = open.map(|why| Record::named("undecided", [why.reason.as_ref().into()]));
        fields.add_record(quantity.name(), value.or(open).filter(|_| report.shows(quantity)));
    }
    // Those of an arch that is measured are there if they are asked for; of rows, each has its own.
    let is_of = |of: &&Quantity| match (report.scope, asked.assessment) {
        (Scope::Mixed, true) => answer.measured_at.is_some(),
        (Scope::Mixed, false) => {
            answer.measured_at.is_some() && Quantity::MEASURED_STATE.contains(of)
        }
        _ => true,
    };
    for quantity in report.quantities.iter().filter(|of| of.is_measured()).filter(is_of) {
        fields.add_record(quantity.name(), figure(answer.value(*quantity)));
    }
    fields.add("reason", answer.reason());
    fields.note(answer.note.as_deref());
    if asked.state {
        let (between, gap) = match &answer.status {
            Status::Undecided(undecided) => (&undecided.between[..], undecided.gap),
            _ => (&[][..], None),
        };
        fields.add("between", labels(between));
        fields.add("gap", gap);
        let [friction, half_opening] = &answer.enough;
        let enough = (friction.is_some() || half_opening.is_some()).then(|| {
            let mut enough = Record::default();
            enough.add_record(Quantity::Friction.name(), figure(friction.as_ref()));
            enough.add_record(Quantity::HalfOpening.name(), figure(half_opening.as_ref()));
            enough
        });
        fields.add_record("enough", enough);
    }
    fields
}

/// `couplet.find/1`: what is given is text, what is found has bounds.
fn finding(report: &Answers, answer: &Answer) -> Record {
    let mut fields = Record::of("couplet.find/1");
    if let Some(asked) = &answer.asked {
        fields.add_record("asked", Some(asked.fields()));
    }
    fields.append(find::fields(answer, labels(&answer.modes), |fields, quantity| {
        let value = answer.value(quantity);
        let figure = value.map(|value| figure(value, report.have_doubles()));
        fields.add_record(quantity.name(), figure);
    }));
    fields
}

/// A value with its bounds, and with its nearest double if that is shown.
fn figure(value: &Value, with_double: bool) -> Record {
    let mut fields =
        Record::named("value lower upper", value.texts().map(|text| text.to_string().into()));
    if with_double && value.decimal.is_some() {
        fields.add("double", value.double);
        fields.add("hex", hexadecimal(value.double));
    }
    fields
}

/// An end of the range of thrusts; a thrust of null has no bound.
fn limit(
    thrust: &Value,
    joint: Option<&Value>,
    figure: impl Fn(Option<&Value>) -> Option<Record>,
) -> Record {
    let mut fields = Record::default();
    fields.add_record("thrust", figure(Some(thrust).filter(|thrust| thrust.decimal.is_some())));
    fields.add("limited_by", thrust.limited_by);
    fields.add_record("joint", figure(joint));
    fields
}

/// A landmark with the modes that meet there; its values in the order of their names.
fn point(answer: &Answer) -> Record {
    let mut fields = Record::of("couplet.state_at/1");
    fields.add("weight", answer.subject.weight().map(|weight| weight.name()));
    fields.add("landmark", answer.subject.landmark().map(|landmark| landmark.symbol()));
    fields.add("verdict", answer.status.name());
    fields.add("modes", labels(&answer.modes));
    let values = answer.values.iter().map(|(of, value)| (of.name(), figure(value, false)));
    fields.add_sorted("values", values);
    fields
}
