//! Parquet: one row for each value, in one schema for landmarks and for arches; of a map one for each node.
//!
//! A subject without values (an arch that does not stand, an answer that is undecided) has one row without
//! a quantity. What made the file, and how its certificates are made again, is in the key-value metadata.

use super::answer::Answer;
use super::answers::{Answers, Scope};
use super::column::Column::{Double, Integer, Made, Shown, Text, Truth};
use super::column::NamedColumn;
use super::columns::{kept_cell, kept_names};
use super::names::head;
use super::parquet_file::{ParquetColumn, ParquetFile, ParquetTable, Texts};
use super::rows::Rows;
use super::value_row::ValueRow;
use std::io;
use std::mem;

/// Answers that are written group by group, about what a report says of itself.
struct ParquetRows {
    file: ParquetFile,
    report: Answers,
    /// Answers that are not written yet, and how many make a group.
    held: Vec<Answer>,
    most: usize,
}

/// Digits of the arches of a group, each of which has some values: small groups are mostly their own descriptions.
const GROUP: usize = 1 << 17;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let (quantities, kept) = (report.quantities.clone(), report.kept.clone());
    let mut rows = ParquetRows::new(Answers { quantities, kept, list: Vec::new(), ..*report });
    out.write_all(&rows.write(&report.list)?)?;
    out.write_all(&Box::new(rows).end()?)
}

/// Arches as they come.
pub(super) fn rows(report: Answers) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(ParquetRows::new(report)))
}

/// Rows in one group, with notes on what they are.
pub fn parquet_rows<R>(
    columns: &[NamedColumn<R>],
    rows: &[R],
    notes: impl IntoIterator<Item = (&'static str, String)>,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let mut file = ParquetFile::default();
    out.write_all(&group(&mut file, (columns, &[]), rows, &[])?)?;
    out.write_all(&file.end(notes)?)
}

/// Writes some rows as a group, with texts that are handed on, each under its name, behind the columns.
fn group<R>(
    file: &mut ParquetFile,
    (columns, once): (&[NamedColumn<R>], &'static [&'static str]),
    rows: &[R],
    kept: &[(String, Texts)],
) -> io::Result<Vec<u8>> {
    let texts = |(_, column): &NamedColumn<R>| match column {
        Text(cell) => rows.iter().map(cell).collect(),
        Made(cell) => rows.iter().map(cell).collect(),
        Shown(cell) => rows.iter().map(cell).collect(),
        Double(_) | Integer(_) | Truth(_) => Texts::default(),
    };
    let texts: Vec<Texts> = columns.iter().map(texts).collect();
    let column = |((name, column), texts): (&NamedColumn<R>, _)| {
        let column = match *column {
            Text(_) | Made(_) | Shown(_) => ParquetColumn::Text(Box::new(Texts::cells(texts))),
            Double(cell) => ParquetColumn::Double(Box::new(move |row| cell(&rows[row]))),
            Integer(cell) => ParquetColumn::whole(move |row| cell(&rows[row])),
            Truth(cell) => ParquetColumn::Truth(Box::new(move |row| cell(&rows[row]))),
        };
        ((*name).to_owned(), column)
    };
    let own = columns.iter().zip(&texts).map(column);
    let kept = kept
        .iter()
        .map(|(name, texts)| (name.clone(), ParquetColumn::Text(Box::new(texts.cells()))));
    let columns = own.chain(kept).collect();
    file.group(&ParquetTable { rows: rows.len(), again: &[], once, columns })
}

impl ParquetRows {
    fn new(report: Answers) -> Self {
        let most = GROUP / report.digits.clamp(1, GROUP);
        Self { file: ParquetFile::default(), report, held: Vec::new(), most }
    }

    /// Writes some answers as a group.
    fn write(&mut self, answers: &[Answer]) -> io::Result<Vec<u8>> {
        let rows: Vec<ValueRow> = answers.iter().flat_map(ValueRow::all).collect();
        let own = ValueRow::COLUMNS.map(|(name, _)| name.to_owned());
        let texts = |name: &String| {
            rows.iter().map(|row| Some(kept_cell(&row.answer.kept, name))).collect()
        };
        let kept = self.report.kept.iter().map(texts);
        let kept: Vec<_> = kept_names(&self.report.kept, &own).into_iter().zip(kept).collect();
        group(&mut self.file, (&ValueRow::COLUMNS, &VALUES), &rows, &kept)
    }
}

impl Rows for ParquetRows {
    fn group(&mut self, mut answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        self.held.append(&mut answers);
        if self.held.len() < self.most {
            return Ok(Vec::new());
        }
        let held = mem::take(&mut self.held);
        self.write(&held)
    }

    fn end(mut self: Box<Self>) -> io::Result<Vec<u8>> {
        let held = mem::take(&mut self.held);
        let mut bytes = self.write(&held)?;
        let report = &self.report;
        let certificate = "couplet certify LANDMARK --weight WEIGHT --digits DIGITS | sha256sum";
        let certificate =
            (report.scope == Scope::Constants).then(|| ("certificate", certificate.into()));
        let notes = [
            ("schema", report.schema().to_owned()),
            ("digits", report.digits.to_string()),
            ("about", head(report).join("\n")),
        ];
        bytes.extend(self.file.end(notes.into_iter().chain(certificate))?);
        Ok(bytes)
    }
}

/// Columns of values: hardly any comes again.
const VALUES: [&str; 7] =
    ["value", "lower", "upper", "double", "double_lower", "double_upper", "double_error"];
