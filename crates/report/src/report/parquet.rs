//! Parquet: one row for each value, in one schema for landmarks and for arches.
//!
//! A subject without values (an arch that does not stand, an answer that is undecided) has one row without
//! a quantity. What made the file, and how its certificates are made again, is in the key-value metadata.

use super::answer::Answer;
use super::answers::{Answers, Scope, TOOL};
use super::columns::kept_names;
use super::given::GivenDoubles;
use super::names::head;
use super::rows::Rows;
use super::subject::Subject;
use super::value::Value;
use crate::problem::Quantity;
use ::parquet::basic::{Compression, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::column::writer::ColumnWriter;
use ::parquet::data_type::ByteArray;
use ::parquet::errors::Result;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::parser::parse_message_type;
use ::parquet::schema::types::Type;
use AnswerColumn::*;
use std::io;
use std::sync::Arc;

/// Way to find the cells of a column; each may be null.
enum AnswerColumn {
    Text(for<'a> fn(&'a ValueRow<'a>) -> Option<&'a str>),
    Double(fn(&ValueRow) -> Option<f64>),
    Integer(fn(&ValueRow) -> Option<u64>),
    Truth(fn(&ValueRow) -> Option<bool>),
}

/// The columns. `double` is the nearest to the true value, the doubles after it bound that value and its
/// error; `half_opening`, `friction` and `thickness` are the texts of the query in `line`, with the doubles
/// nearest to them.
const COLUMNS: [(&str, AnswerColumn); 25] = [
    ("line", Integer(|row| row.answer.subject.line())),
    ("weight", Text(|row| row.answer.subject.weight().map(|weight| weight.name()))),
    ("landmark", Text(|row| row.answer.subject.landmark().map(|landmark| landmark.symbol()))),
    ("half_opening", Text(|row| row.query()?.half_opening)),
    ("half_opening_rad", Double(|row| row.query()?.doubles.half_opening_rad)),
    ("half_opening_deg", Double(|row| row.query()?.doubles.half_opening_deg)),
    ("friction", Text(|row| row.query()?.friction)),
    ("friction_double", Double(|row| row.query()?.doubles.friction)),
    ("thickness", Text(|row| row.query()?.thickness)),
    ("thickness_double", Double(|row| row.query()?.doubles.thickness)),
    ("mode", Text(|row| row.query().and(row.answer.modes.first()).map(|mode| mode.label()))),
    ("can_stand", Truth(|row| row.answer.can_stand)),
    ("stands", Truth(|row| row.answer.stands)),
    ("status", Text(|row| Some(row.answer.status.name()))),
    ("reason", Text(|row| row.answer.status.reason())),
    ("quantity", Text(|row| row.quantity.map(Quantity::name))),
    ("value", Text(|row| row.value.map(|_| row.texts[0].as_str()))),
    ("lower", Text(|row| row.value.map(|_| row.texts[1].as_str()))),
    ("upper", Text(|row| row.value.map(|_| row.texts[2].as_str()))),
    ("exact", Text(|row| row.value?.exact.as_deref())),
    ("double", Double(|row| row.value.map(|value| value.double))),
    ("double_lower", Double(|row| row.value.map(|value| value.binary.lower))),
    ("double_upper", Double(|row| row.value.map(|value| value.binary.upper))),
    ("double_error", Double(|row| row.value.map(|value| value.binary.error))),
    ("certificate_sha256", Text(|row| Some(&row.answer.certificate.as_ref().ok()?.sha256))),
];

/// A Parquet file that is written group by group.
struct ParquetRows {
    writer: SerializedFileWriter<Vec<u8>>,
    /// Names of what is handed on from queries, a column each, behind the others.
    kept: Vec<String>,
}

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let mut rows = ParquetRows::new(report)?;
    out.write_all(&rows.group(&report.list)?)?;
    out.write_all(&Box::new(rows).end()?)
}

/// Arches as they come.
pub(super) fn rows(report: Answers) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(ParquetRows::new(&report)?))
}

impl ParquetRows {
    /// A file about what a report says of itself; its answers are not written yet.
    fn new(report: &Answers) -> io::Result<Self> {
        let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let certificate = "couplet certify LANDMARK --weight WEIGHT --digits DIGITS | sha256sum";
        let mut notes = vec![
            note("couplet.schema", report.schema().to_owned()),
            note("couplet.tool", TOOL.to_owned()),
            note("couplet.digits", report.digits.to_string()),
            note("couplet.about", head(report).join("\n")),
        ];
        if report.scope == Scope::Constants {
            notes.push(note("couplet.certificate", certificate.to_owned()));
        }
        let properties = WriterProperties::builder()
            .set_compression(Compression::UNCOMPRESSED)
            .set_created_by(TOOL.to_owned())
            .set_key_value_metadata(Some(notes))
            .build();
        let columns = COLUMNS.iter().map(|(name, column)| match column {
            Text(_) => format!("optional binary {name} (STRING);"),
            Double(_) => format!("optional double {name};"),
            Integer(_) => format!("optional int64 {name};"),
            Truth(_) => format!("optional boolean {name};"),
        });
        let schema = format!("message couplet {{ {} }}", columns.collect::<String>());
        let schema = with_kept(&schema, &report.kept).map_err(io::Error::other)?;
        let writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties));
        Ok(Self { writer: writer.map_err(io::Error::other)?, kept: report.kept.clone() })
    }

    fn columns(&mut self, rows: &[ValueRow]) -> Result<()> {
        let mut group = self.writer.next_row_group()?;
        for (_, column) in &COLUMNS {
            let Some(mut written) = group.next_column()? else { break };
            match (column, written.untyped()) {
                (Text(cell), ColumnWriter::ByteArrayColumnWriter(writer)) => {
                    let (values, there) = present(rows, |row| cell(row).map(ByteArray::from));
                    writer.write_batch(&values, Some(&there), None)?
                }
                (Double(cell), ColumnWriter::DoubleColumnWriter(writer)) => {
                    let (values, there) = present(rows, cell);
                    writer.write_batch(&values, Some(&there), None)?
                }
                (Integer(cell), ColumnWriter::Int64ColumnWriter(writer)) => {
                    let (values, there) = present(rows, |row| i64::try_from(cell(row)?).ok());
                    writer.write_batch(&values, Some(&there), None)?
                }
                (Truth(cell), ColumnWriter::BoolColumnWriter(writer)) => {
                    let (values, there) = present(rows, cell);
                    writer.write_batch(&values, Some(&there), None)?
                }
                // The schema is made of the same list.
                _ => unreachable!(),
            };
            written.close()?;
        }
        for name in &self.kept {
            let Some(mut written) = group.next_column()? else { break };
            if let ColumnWriter::ByteArrayColumnWriter(writer) = written.untyped() {
                let (values, there) = present(rows, |row| row.kept(name).map(ByteArray::from));
                writer.write_batch(&values, Some(&there), None)?;
            }
            written.close()?;
        }
        group.close()?;
        Ok(())
    }
}

/// The schema with a text for each name from outside, which may be any text.
fn with_kept(schema: &str, kept: &[String]) -> Result<Type> {
    let own = parse_message_type(schema)?;
    let mut fields = own.get_fields().to_vec();
    let names = COLUMNS.map(|(name, _)| name.to_owned());
    for name in kept_names(kept, &names) {
        let text = Type::primitive_type_builder(&name, PhysicalType::BYTE_ARRAY)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(Some(LogicalType::String));
        fields.push(Arc::new(text.build()?));
    }
    Type::group_type_builder(own.name()).with_fields(fields).build()
}

impl Rows for ParquetRows {
    fn group(&mut self, answers: &[Answer]) -> io::Result<Vec<u8>> {
        let rows: Vec<ValueRow> = answers.iter().flat_map(ValueRow::all).collect();
        if !rows.is_empty() {
            self.columns(&rows).map_err(io::Error::other)?;
        }
        self.writer.flush()?;
        // The writer keeps its own count of the bytes.
        Ok(std::mem::take(self.writer.inner_mut()))
    }

    /// Without these bytes the file cannot be read.
    fn end(self: Box<Self>) -> io::Result<Vec<u8>> {
        self.writer.into_inner().map_err(io::Error::other)
    }
}

/// The cells that are not null, and for each row whether it has one.
fn present<'a, T>(
    rows: &'a [ValueRow<'a>],
    cell: impl Fn(&'a ValueRow<'a>) -> Option<T>,
) -> (Vec<T>, Vec<i16>) {
    let (mut values, mut there) = (Vec::new(), Vec::new());
    for cell in rows.iter().map(cell) {
        there.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    (values, there)
}

/// A value and its answer.
struct ValueRow<'a> {
    answer: &'a Answer,
    quantity: Option<Quantity>,
    value: Option<&'a Value>,
    texts: [String; 3],
}

/// An arch as it was asked about.
struct AskedArch<'a> {
    half_opening: Option<&'a str>,
    friction: Option<&'a str>,
    thickness: Option<&'a str>,
    doubles: GivenDoubles,
}

impl<'a> ValueRow<'a> {
    fn all(answer: &'a Answer) -> Vec<Self> {
        if answer.values.is_empty() {
            return vec![Self { answer, quantity: None, value: None, texts: Default::default() }];
        }
        let row = |(quantity, value): &'a (Quantity, Value)| Self {
            answer,
            quantity: Some(*quantity),
            value: Some(value),
            texts: value.texts(),
        };
        answer.values.iter().map(row).collect()
    }

    fn kept(&self, name: &str) -> Option<&'a str> {
        self.answer.kept.iter().find(|(of, _)| of == name).map(|(_, kept)| kept.text())
    }

    fn query(&self) -> Option<AskedArch<'_>> {
        match &self.answer.subject {
            Subject::Arch { half_opening, friction, thickness, doubles, .. } => {
                let (half_opening, friction) = (Some(&half_opening[..]), Some(&friction[..]));
                let (thickness, doubles) = (thickness.as_deref(), *doubles);
                Some(AskedArch { half_opening, friction, thickness, doubles })
            }
            Subject::Sought { half_opening, friction, thickness, .. } => {
                let given = [half_opening, friction, thickness].map(|text| text.as_deref());
                let ([half_opening, friction, thickness], doubles) =
                    (given, GivenDoubles::default());
                Some(AskedArch { half_opening, friction, thickness, doubles })
            }
            Subject::Landmark { .. } | Subject::Query { .. } => None,
        }
    }
}
