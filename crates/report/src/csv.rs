//! CSV: a row for each constant, or for each arch, with a header.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns::{self, Asked};
use super::find;
use super::record::Record;
use super::rows::{Rows, in_parallel};
use super::tabular::Tabular;
use super::value::Value;
use super::words::{hexadecimal, labels};
use crate::problem::Quantity;
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers) -> Tabular {
    match report.scope {
        Scope::Constants => {
            Tabular::of("weight landmark quantity value lower upper exact", constants(report))
        }
        Scope::Point => {
            Tabular::of("weight landmark modes quantity value lower upper", constants(report))
        }
        Scope::Found => Tabular::of_all(report.list.iter().map(finding)),
        Scope::Arch | Scope::Arches | Scope::Mixed => {
            let rows = report.list.iter().map(|answer| record(report, answer, false));
            Tabular { header: header(report, false), rows: rows.collect() }
        }
    }
}

/// Arches as they come, each with the line of its query.
pub(super) fn rows(report: Answers) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(CsvRows(report)))
}

/// A row for each value that is proved.
fn constants(report: &Answers) -> Vec<Record> {
    let row = |answer: &Answer, quantity: Quantity, value: &Value| {
        let mut row = Record::default();
        row.add("weight", answer.subject.weight().map(|weight| weight.name()));
        row.add("landmark", answer.subject.landmark().map(|landmark| landmark.symbol()));
        row.add("modes", labels(&answer.modes).join(" "));
        row.add("quantity", quantity.name());
        row.append(Record::named("value lower upper", value.texts().map(Into::into)));
        row.add("exact", value.exact.as_deref());
        row
    };
    let rows = |answer: &Answer| -> Vec<Record> {
        answer.values.iter().map(|(quantity, value)| row(answer, *quantity, value)).collect()
    };
    report.list.iter().flat_map(rows).collect()
}

fn header(report: &Answers, with_lines: bool) -> Vec<String> {
    let header = columns::header(|answer| own(report, answer, with_lines));
    [columns::kept_names(&report.kept, &header), header].concat()
}

fn record(report: &Answers, answer: &Answer, with_lines: bool) -> Vec<String> {
    let kept = columns::kept_cells(&report.kept, &answer.kept);
    kept.chain(own(report, answer, with_lines).texts()).collect()
}

/// The cells of an arch behind what is handed on.
fn own(report: &Answers, answer: &Answer, with_lines: bool) -> Record {
    let mut row = columns::row(report, answer);
    if with_lines {
        let error = match &answer.status {
            Status::Refused(error) => Some(error.as_str()),
            _ => None,
        };
        row.add("line", answer.subject.line());
        row.add("error", error);
    }
    row.append(columns::doubles(answer, Asked::in_table(report)));
    if matches!(report.scope, Scope::Arches | Scope::Mixed) && report.have_doubles() {
        for quantity in &report.quantities {
            let double = answer.value(*quantity).map(|value| value.double);
            row.add_double(format!("{}_double", quantity.name()), double);
            row.add(format!("{}_hex", quantity.name()), double.map(hexadecimal));
        }
    }
    row
}

/// Cells of what is given and what is found, in the same columns.
fn finding(answer: &Answer) -> Record {
    find::fields(answer, labels(&answer.modes).join(" "), |fields, quantity| {
        fields.add(quantity.name(), answer.value(quantity).map(|value| value.text()));
    })
}

struct CsvRows(Answers);

impl Rows for CsvRows {
    fn begin(&mut self) -> io::Result<Vec<u8>> {
        line(header(&self.0, true))
    }

    fn group(&mut self, answers: &[Answer]) -> io::Result<Vec<u8>> {
        in_parallel(answers, |answer| line(record(&self.0, answer, true)))
    }
}

/// One line.
pub(super) fn line(header: Vec<String>) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    Tabular { header, rows: Vec::new() }.csv(&mut bytes)?;
    Ok(bytes)
}
