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
use super::value::Value;
use crate::problem::Quantity;
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
            Text(_) | Made(_) | Shown(_) => ParquetColumn::text(Texts::cells(texts)),
            Double(cell) => ParquetColumn::double(move |row| cell(&rows[row])),
            Integer(cell) => ParquetColumn::whole(move |row| cell(&rows[row])),
            Truth(cell) => ParquetColumn::truth(move |row| cell(&rows[row])),
        };
        ((*name).to_owned(), column)
    };
    let own = columns.iter().zip(&texts).map(column);
    let kept = kept.iter().map(|(name, texts)| (name.clone(), ParquetColumn::text(texts.cells())));
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
        let texts = |name: &String| rows.iter().map(|row| Some(row.kept(name))).collect();
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
        let certificate = (report.scope == Scope::Constants).then_some(certificate.to_owned());
        let notes = [
            ("schema", report.schema().to_owned()),
            ("digits", report.digits.to_string()),
            ("about", head(report).join("\n")),
        ];
        let certificate = certificate.map(|how| ("certificate", how));
        bytes.extend(self.file.end(notes.into_iter().chain(certificate))?);
        Ok(bytes)
    }
}

/// Columns of values: hardly any comes again.
const VALUES: [&str; 7] =
    ["value", "lower", "upper", "double", "double_lower", "double_upper", "double_error"];

/// A value and its answer.
struct ValueRow<'a> {
    answer: &'a Answer,
    quantity: Option<Quantity>,
    value: Option<&'a Value>,
}

impl<'a> ValueRow<'a> {
    /// The columns. `double` is the nearest to the true value, the doubles after it bound that value and its
    /// error; `half_opening`, `friction` and `thickness` are the texts of the query in `line`, with the doubles
    /// nearest to them.
    const COLUMNS: [NamedColumn<Self>; 26] = [
        ("line", Integer(|row| row.answer.subject.line())),
        ("weight", Text(|row| row.answer.subject.weight().map(|weight| weight.name()))),
        ("landmark", Text(|row| row.answer.subject.landmark().map(|landmark| landmark.symbol()))),
        ("half_opening", Text(|row| row.answer.subject.given()[0])),
        ("half_opening_rad", Double(|row| row.answer.subject.doubles().half_opening_rad)),
        ("half_opening_deg", Double(|row| row.answer.subject.doubles().half_opening_deg)),
        ("friction", Text(|row| row.answer.subject.given()[1])),
        ("friction_double", Double(|row| row.answer.subject.doubles().friction)),
        ("thickness", Text(|row| row.answer.subject.given()[2])),
        ("thickness_double", Double(|row| row.answer.subject.doubles().thickness)),
        ("mode", Text(|row| row.mode())),
        ("can_stand", Truth(|row| row.answer.can_stand)),
        ("stands", Truth(|row| row.answer.stands)),
        ("status", Text(|row| Some(row.answer.status.name()))),
        ("reason", Text(|row| row.answer.status.reason())),
        ("note", Text(|row| row.answer.note.as_deref())),
        ("quantity", Text(|row| row.quantity.map(Quantity::name))),
        ("value", Shown(|row| Some(row.value?.texts()[0]))),
        ("lower", Shown(|row| Some(row.value?.texts()[1]))),
        ("upper", Shown(|row| Some(row.value?.texts()[2]))),
        ("exact", Text(|row| row.value?.exact.as_deref())),
        ("double", Double(|row| row.value.map(|value| value.double))),
        ("double_lower", Double(|row| row.value.map(|value| value.binary.lower))),
        ("double_upper", Double(|row| row.value.map(|value| value.binary.upper))),
        ("double_error", Double(|row| row.value.map(|value| value.binary.error))),
        ("certificate_sha256", Text(|row| Some(&row.answer.certificate.as_ref().ok()?.sha256))),
    ];

    fn all(answer: &'a Answer) -> Vec<Self> {
        if answer.values.is_empty() {
            return vec![Self { answer, quantity: None, value: None }];
        }
        let row = |(quantity, value): &'a (Quantity, Value)| Self {
            answer,
            quantity: Some(*quantity),
            value: Some(value),
        };
        answer.values.iter().map(row).collect()
    }

    fn kept(&self, name: &str) -> &'a str {
        kept_cell(&self.answer.kept, name)
    }

    /// The mode of an arch; at a landmark several meet.
    fn mode(&self) -> Option<&'static str> {
        let mode = self.answer.modes.first().map(|mode| mode.label());
        mode.filter(|_| self.answer.subject.landmark().is_none())
    }
}
