//! CSV: a row for each constant, or for each arch, with a header.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::column::NamedColumn;
use super::columns::{self, Asked};
use super::fields::Fields;
use super::find;
use super::rows::{Rows, in_parallel};
use super::value::Value;
use super::words::{hexadecimal, labels, printable};
use crate::problem::Quantity;
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    match report.scope {
        Scope::Constants => {
            table("weight landmark quantity value lower upper exact", constants(report), out)
        }
        Scope::Point => {
            table("weight landmark modes quantity value lower upper", constants(report), out)
        }
        Scope::Found => {
            let all: Vec<Fields> = report.list.iter().map(finding).collect();
            let header = all.iter().take(1).map(|row| row.names().map(str::to_owned).collect());
            write(header.chain(all.iter().map(|row| row.texts().collect())), out)
        }
        Scope::Arch | Scope::Arches | Scope::Mixed => {
            let rows = report.list.iter().map(|answer| record(report, answer, false));
            write(std::iter::once(header(report, false)).chain(rows), out)
        }
    }
}

/// Arches as they come, each with the line of its query.
pub(super) fn rows(report: Answers) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(CsvRows(report)))
}

/// Writes records, the header among them.
pub(super) fn write(
    records: impl IntoIterator<Item = Vec<String>>,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    let cell = |cell: String| printable(cell, |c| c.escape_debug().to_string()).into_bytes();
    let mut records = records.into_iter().map(|record| record.into_iter().map(cell));
    records.try_for_each(|record| csv.write_record(record)).map_err(io_error)?;
    csv.flush()
}

/// Writes records in some columns, whose names are given in one text.
pub(super) fn table(
    columns: &str,
    rows: impl IntoIterator<Item = Fields>,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let cells = |row: Fields| columns.split(' ').map(|name| row.text(name)).collect();
    let header = columns.split(' ').map(str::to_owned).collect();
    write(std::iter::once(header).chain(rows.into_iter().map(cells)), out)
}

/// Writes rows in the cells of some columns.
pub(super) fn columns<'a, R: 'a>(
    columns: impl Iterator<Item = &'a NamedColumn<R>> + Clone,
    rows: impl IntoIterator<Item = R>,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let header = columns.clone().map(|(name, _)| (*name).to_owned()).collect();
    let cells = |row| columns.clone().map(|(_, column)| column.text(&row)).collect();
    write(std::iter::once(header).chain(rows.into_iter().map(cells)), out)
}

/// A row for each value that is proved.
fn constants(report: &Answers) -> Vec<Fields> {
    let row = |answer: &Answer, quantity: Quantity, value: &Value| {
        let mut row = Fields::default();
        row.add("weight", answer.subject.weight().map(|weight| weight.name()));
        row.add("landmark", answer.subject.landmark().map(|landmark| landmark.symbol()));
        row.add("modes", labels(&answer.modes).join(" "));
        row.add("quantity", quantity.name());
        row.append(Fields::named("value lower upper", value.texts().map(Into::into)));
        row.add("exact", value.exact.as_deref());
        row
    };
    let rows = |answer: &Answer| -> Vec<Fields> {
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
fn own(report: &Answers, answer: &Answer, with_lines: bool) -> Fields {
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

/// Fields of what is given and what is found, in the same columns.
fn finding(answer: &Answer) -> Fields {
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
pub(super) fn line(record: Vec<String>) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    write([record], &mut bytes)?;
    Ok(bytes)
}

/// The error of the stream itself: its kind tells a closed pipe from a full disk.
fn io_error(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
