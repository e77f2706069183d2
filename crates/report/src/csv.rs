//! CSV: a row for each constant, or for each arch, with a header.

use super::answer::{Answer, Status};
use super::answers::{Answers, Scope};
use super::columns::{self, Asked};
use super::find;
use super::paper::PaperTable;
use super::record::Record;
use super::rows::Rows;
use super::tabular::Tabular;
use super::value::Value;
use super::words::{hexadecimal, labels};
use crate::problem::Quantity;
use rayon::prelude::*;
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
            let rows = report.list.iter().map(|answer| Own::WHOLE.row(report, answer));
            Tabular { header: Own::WHOLE.header(report), rows: rows.collect() }
        }
    }
}

/// Writer of a table.
type Writer<T> = fn(&T, &mut dyn io::Write) -> io::Result<()>;

/// Arches as they come, each with the line of its query, as CSV or as that of a spreadsheet with decimal commas.
pub(super) fn rows(
    report: Answers,
    beside: Beside,
    write: Writer<Tabular>,
) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(CsvRows { report, own: Own { with_lines: true, beside }, write }))
}

/// Arches of which a table for a paper is made at the end.
pub(super) fn rows_at_once(
    report: Answers,
    beside: Beside,
    write: Writer<PaperTable>,
) -> io::Result<Box<dyn Rows>> {
    let own = Own { with_lines: true, beside };
    Ok(Box::new(RowsAtOnce { report, own, rows: Vec::new(), has_errors: false, write }))
}

/// Columns of numbers that a table of arches has beside what is asked and what is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beside {
    /// The nearest doubles of what is given and of each value.
    pub doubles: bool,
    /// The nearest doubles of each value in hexadecimal.
    pub hex: bool,
}

impl Beside {
    /// All that there are.
    pub const ALL: Self = Self { doubles: true, hex: true };

    /// Adds the columns of a name; answers whether it is one.
    pub fn add(&mut self, name: &str) -> bool {
        match name {
            "doubles" => self.doubles = true,
            "hex" => self.hex = true,
            "all" => *self = Self::ALL,
            _ => return false,
        }
        true
    }
}

/// Columns of a table of arches behind what is handed on.
#[derive(Clone, Copy)]
struct Own {
    /// True if a row has the line of its query, and its error.
    with_lines: bool,
    beside: Beside,
}

/// A row for each value that is proved.
fn constants(report: &Answers) -> Vec<Record> {
    let row = |answer: &Answer, quantity: Quantity, value: &Value| {
        let mut row = Record::default();
        row.add("weight", answer.subject.weight().map(|weight| weight.name()));
        row.add("landmark", answer.subject.landmark().map(|landmark| landmark.symbol()));
        row.add("modes", labels(&answer.modes).join(" "));
        row.add("quantity", quantity.name());
        row.append(Record::named(
            "value lower upper",
            value.texts().map(|text| text.to_string().into()),
        ));
        row.add("exact", value.exact.as_deref());
        row
    };
    let rows = |answer: &Answer| -> Vec<Record> {
        answer.values.iter().map(|(quantity, value)| row(answer, *quantity, value)).collect()
    };
    report.list.iter().flat_map(rows).collect()
}

impl Own {
    /// Columns of arches that are all there.
    const WHOLE: Self = Self { with_lines: false, beside: Beside::ALL };

    fn header(self, report: &Answers) -> Vec<String> {
        let header = columns::header(|answer| self.cells(report, answer));
        [columns::kept_names(&report.kept, &header), header].concat()
    }

    fn row(self, report: &Answers, answer: &Answer) -> Vec<String> {
        let kept = columns::kept_cells(&report.kept, &answer.kept);
        kept.chain(self.cells(report, answer).texts()).collect()
    }

    fn cells(self, report: &Answers, answer: &Answer) -> Record {
        let Self { with_lines, beside } = self;
        let mut row = columns::row(report, answer);
        if with_lines {
            let error = match &answer.status {
                Status::Refused(error) => Some(error.as_str()),
                _ => None,
            };
            row.add("line", answer.subject.line());
            row.add("error", error);
        }
        if beside.doubles {
            row.append(columns::doubles(answer, Asked::in_table(report)));
        }
        let are_many = matches!(report.scope, Scope::Arches | Scope::Mixed);
        if are_many && (with_lines || report.have_doubles()) {
            for quantity in &report.quantities {
                let double = answer.value(*quantity).map(|value| value.double);
                if beside.doubles {
                    row.add_double(format!("{}_double", quantity.name()), double);
                }
                if beside.hex {
                    row.add(format!("{}_hex", quantity.name()), double.map(hexadecimal));
                }
            }
        }
        row
    }
}

/// Cells of what is given and what is found, in the same columns.
fn finding(answer: &Answer) -> Record {
    find::fields(answer, labels(&answer.modes).join(" "), |fields, quantity| {
        fields.add(quantity.name(), answer.value(quantity).map(|value| value.text()));
    })
}

struct CsvRows {
    report: Answers,
    own: Own,
    write: Writer<Tabular>,
}

struct RowsAtOnce {
    report: Answers,
    own: Own,
    rows: Vec<Vec<String>>,
    has_errors: bool,
    write: Writer<PaperTable>,
}

impl Rows for RowsAtOnce {
    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        self.has_errors |= answers.iter().any(|answer| matches!(answer.status, Status::Refused(_)));
        self.rows.par_extend(answers.par_iter().map(|answer| self.own.row(&self.report, answer)));
        Ok(Vec::new())
    }

    fn end(self: Box<Self>) -> io::Result<Vec<u8>> {
        let mut table = Tabular { header: self.own.header(&self.report), rows: self.rows };
        // Lines of the input tell where an error is.
        if !self.has_errors {
            let line = table.header.iter().rposition(|name| name == "line");
            line.into_iter().for_each(|k| table.rows.iter_mut().for_each(|row| row[k].clear()));
        }
        let mut bytes = Vec::new();
        (self.write)(&PaperTable::from(&table.without_empty()), &mut bytes)?;
        Ok(bytes)
    }
}

/// Rows that are written at a time.
const PIECE: usize = 64;

impl Rows for CsvRows {
    fn begin(&mut self) -> io::Result<Vec<u8>> {
        let header = Tabular { header: self.own.header(&self.report), rows: Vec::new() };
        let mut bytes = Vec::new();
        (self.write)(&header, &mut bytes)?;
        Ok(bytes)
    }

    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        let written = |answers: &[Answer]| {
            let rows = answers.iter().map(|answer| self.own.row(&self.report, answer));
            lines(rows, self.write)
        };
        Ok(answers.par_chunks(PIECE).map(written).collect::<io::Result<Vec<_>>>()?.concat())
    }
}

/// One line.
pub(super) fn line(cells: Vec<String>) -> io::Result<Vec<u8>> {
    lines([cells], Tabular::csv)
}

/// Lines without a header.
fn lines(
    rows: impl IntoIterator<Item = Vec<String>>,
    write: Writer<Tabular>,
) -> io::Result<Vec<u8>> {
    let (mut bytes, mut rows) = (Vec::new(), rows.into_iter());
    if let Some(header) = rows.next() {
        write(&Tabular { header, rows: rows.collect() }, &mut bytes)?;
    }
    Ok(bytes)
}
