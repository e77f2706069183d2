//! CSV: a row for each constant, or for each arch, with a header.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns;
use super::fields::Fields;
use super::find;
use super::rows::{Rows, in_parallel};
use super::subject::Subject;
use super::words::{hexadecimal, printable};
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    match report.scope {
        Scope::Constants | Scope::Point => write(constants(report), out),
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

/// A row for each value that is proved.
fn constants(report: &Answers) -> Vec<Vec<String>> {
    let with_modes = report.scope == Scope::Point;
    let record =
        |modes: &str, exact: &str, [weight, landmark, quantity]: [&str; 3], value: [String; 3]| {
            let mut record = vec![weight.to_owned(), landmark.to_owned()];
            record.extend(with_modes.then(|| modes.to_owned()));
            record.push(quantity.to_owned());
            record.extend(value);
            record.extend((!with_modes).then(|| exact.to_owned()));
            record
        };
    let bounds = ["value", "lower", "upper"].map(str::to_owned);
    let mut records = vec![record("modes", "exact", ["weight", "landmark", "quantity"], bounds)];
    for answer in &report.list {
        let Subject::Landmark { landmark, weight } = &answer.subject else { continue };
        let modes: Vec<&str> = answer.modes.iter().map(|mode| mode.label()).collect();
        records.extend(answer.values.iter().map(|(quantity, value)| {
            let names = [weight.name(), landmark.symbol(), quantity.name()];
            let exact = value.exact.as_deref().unwrap_or_default();
            record(&modes.join(" "), exact, names, value.texts())
        }));
    }
    records
}

/// Tells whether the doubles of the values have columns.
fn has_doubles(report: &Answers) -> bool {
    matches!(report.scope, Scope::Arches | Scope::Mixed) && report.have_doubles()
}

fn header(report: &Answers, with_lines: bool) -> Vec<String> {
    let mut header = columns::names(report);
    header.extend(["line", "error"].into_iter().filter(|_| with_lines).map(str::to_owned));
    header.extend(columns::double_names(report));
    if has_doubles(report) {
        let names = report.quantities.iter().map(|quantity| quantity.name());
        header.extend(names.flat_map(|name| [format!("{name}_double"), format!("{name}_hex")]));
    }
    let mut all = columns::kept_names(&report.kept, &header);
    all.append(&mut header);
    all
}

fn record(report: &Answers, answer: &Answer, with_lines: bool) -> Vec<String> {
    let mut record: Vec<String> = columns::kept_cells(&report.kept, &answer.kept).collect();
    record.extend(columns::cells(report, answer));
    if with_lines {
        let error = match &answer.status {
            Status::Refused(error) => error.as_str(),
            _ => "",
        };
        let line = answer.subject.line().map_or(String::new(), |line| line.to_string());
        record.extend([line, error.to_owned()]);
    }
    record.extend(columns::double_cells(report, answer));
    if has_doubles(report) {
        record.extend(report.quantities.iter().flat_map(
            |&quantity| match answer.value(quantity) {
                Some(value) => [format!("{:?}", value.double), hexadecimal(value.double)],
                None => [const { String::new() }; 2],
            },
        ));
    }
    record
}

/// Fields of what is given and what is found, in the same columns.
fn finding(answer: &Answer) -> Fields {
    let modes: Vec<&str> = answer.modes.iter().map(|mode| mode.label()).collect();
    find::fields(answer, modes.join(" "), |fields, quantity| {
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
