//! CSV: a row for each constant, or for each arch, with a header.

use super::answer::Answer;
use super::answers::{Answers, Scope};
use super::columns::{Beside, TableColumn, kept_cell, kept_cells, kept_names};
use super::find;
use super::paper::PaperTable;
use super::record::Record;
use super::rows::Rows;
use super::tabular::{Separated, Tabular};
use super::value_row::ValueRow;
use super::words::labels;
use rayon::prelude::*;
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers) -> Tabular {
    match report.scope {
        Scope::Constants => constants(report, "weight landmark quantity value lower upper exact"),
        Scope::Point => constants(report, "weight landmark modes quantity value lower upper"),
        Scope::Found => Tabular::of_all(report.list.iter().map(finding)),
        Scope::Arch | Scope::Arches | Scope::Mixed => {
            let columns = TableColumn::all(report, false, Beside::ALL);
            let rows = report.list.iter().map(|answer| cells(report, &columns, answer));
            Tabular { header: header(report, &columns), rows: rows.collect() }
        }
    }
}

/// A row for each value that is proved.
fn constants(report: &Answers, names: &str) -> Tabular {
    let rows = report.list.iter().flat_map(ValueRow::all).filter(|row| row.value.is_some());
    Tabular::of_columns(ValueRow::named(names).iter(), rows)
}

/// The names of what is handed on and of the columns.
fn header(report: &Answers, columns: &[TableColumn]) -> Vec<String> {
    let own = TableColumn::names(columns);
    [kept_names(&report.kept, &own), own].concat()
}

/// The cells of what is handed on and of the columns.
fn cells<'a>(report: &Answers, columns: &[TableColumn<'a>], answer: &'a Answer) -> Vec<String> {
    kept_cells(&report.kept, &answer.kept).chain(TableColumn::texts(columns, answer)).collect()
}

/// Cells of what is given and what is found, in the same columns.
fn finding(answer: &Answer) -> Record {
    find::fields(answer, labels(&answer.modes).join(" "), |fields, quantity| {
        fields.add(quantity.name(), answer.value(quantity).map(|value| value.text()));
    })
}

/// Arches as they come, each with the line of its query.
pub(super) struct CsvRows {
    pub report: Answers,
    pub beside: Beside,
    pub separated: Separated,
}

/// Arches of which a table for a paper is made at the end.
pub(super) struct RowsAtOnce {
    pub report: Answers,
    pub beside: Beside,
    pub rows: Vec<Vec<String>>,
    pub write: fn(&PaperTable, &mut dyn io::Write) -> io::Result<()>,
}

impl Rows for RowsAtOnce {
    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        let columns = TableColumn::all(&self.report, true, self.beside);
        self.rows.par_extend(answers.par_iter().map(|of| cells(&self.report, &columns, of)));
        Ok(Vec::new())
    }

    fn end(self: Box<Self>) -> io::Result<Vec<u8>> {
        let header = header(&self.report, &TableColumn::all(&self.report, true, self.beside));
        let mut table = Tabular { header, rows: self.rows };
        // Lines of the input tell where an error is.
        let place = |of: &str| table.header.iter().rposition(|name| name == of);
        if let [Some(line), Some(error)] = ["line", "error"].map(place)
            && table.rows.iter().all(|row| row[error].is_empty())
        {
            table.rows.iter_mut().for_each(|row| row[line].clear());
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
        let columns = TableColumn::all(&self.report, true, self.beside);
        self.separated.lines(|lines| lines.all(header(&self.report, &columns)))
    }

    fn group(&mut self, answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        let Self { report, beside, separated } = self;
        let written = |answers: &[Answer]| {
            let (columns, mut text) = (TableColumn::all(report, true, *beside), String::new());
            separated.lines(|lines| {
                answers.iter().try_for_each(|answer| {
                    for name in &report.kept {
                        lines.cell(kept_cell(&answer.kept, name))?;
                    }
                    for column in &columns {
                        text.clear();
                        column.write(answer, &mut text);
                        lines.cell(&text)?;
                    }
                    lines.end()
                })
            })
        };
        Ok(answers.par_chunks(PIECE).map(written).collect::<io::Result<Vec<_>>>()?.concat())
    }
}

/// One line.
pub(super) fn line(cells: impl IntoIterator<Item: AsRef<str>>) -> io::Result<Vec<u8>> {
    Separated::Comma.lines(|lines| lines.all(cells))
}

/// The line of a record in columns, whose names are given in one text.
pub(super) fn row(names: &str, record: &Record) -> io::Result<Vec<u8>> {
    line(names.split(' ').map(|name| record.text(name)))
}
