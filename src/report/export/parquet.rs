//! Parquet: one row for each value, in one schema for landmarks and for arches.
//!
//! A subject without values (an arch that does not stand, an answer that is undecided) has one row without
//! a quantity. What made the file, and how its certificates are made again, is in the key-value metadata.

use super::names::head;
use super::{Certificate, Export, Exported, Of, Subject, TOOL};
use ::parquet::basic::Compression;
use ::parquet::column::writer::ColumnWriter;
use ::parquet::data_type::ByteArray;
use ::parquet::errors::Result;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::parser::parse_message_type;
use Column::*;
use std::io;
use std::sync::Arc;

/// How the cells of a column are found; each may be null.
enum Column {
    Text(for<'a> fn(&'a Row<'a>) -> Option<&'a str>),
    Double(fn(&Row) -> Option<f64>),
    Integer(fn(&Row) -> Option<u64>),
    Truth(fn(&Row) -> Option<bool>),
}

/// The columns. `double` is the nearest to the true value, the doubles after it bound that value and its
/// error; `half_opening`, `friction` and `thickness` are the texts of the query in `line`.
const COLUMNS: [(&str, Column); 20] = [
    ("line", Integer(|row| row.query().map(|query| query.line))),
    ("weight", Text(|row| row.weight())),
    ("landmark", Text(|row| row.landmark())),
    ("half_opening", Text(|row| row.query()?.half_opening)),
    ("friction", Text(|row| row.query()?.friction)),
    ("thickness", Text(|row| row.query()?.thickness)),
    ("mode", Text(|row| row.query()?.mode)),
    ("stands", Truth(|row| row.query()?.stands)),
    ("status", Text(|row| Some(row.subject.status.words().0))),
    ("reason", Text(|row| row.subject.status.words().1)),
    ("quantity", Text(|row| row.value.map(|value| value.label.name))),
    ("value", Text(|row| row.value.map(|_| row.texts[0].as_str()))),
    ("lower", Text(|row| row.value.map(|_| row.texts[1].as_str()))),
    ("upper", Text(|row| row.value.map(|_| row.texts[2].as_str()))),
    ("exact", Text(|row| row.value?.exact.as_deref())),
    ("double", Double(|row| row.value.map(|value| value.double))),
    ("double_lower", Double(|row| row.value.map(|value| value.binary.lower))),
    ("double_upper", Double(|row| row.value.map(|value| value.binary.upper))),
    ("double_error", Double(|row| row.value.map(|value| value.binary.error))),
    ("certificate_sha256", Text(|row| row.certificate())),
];

/// A Parquet file that is written group by group.
pub struct ParquetRows {
    writer: SerializedFileWriter<Vec<u8>>,
}

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    let mut rows = ParquetRows::new(export)?;
    out.write_all(&rows.group(&export.subjects)?)?;
    out.write_all(&rows.end()?)
}

impl ParquetRows {
    /// A file about what `export` says of itself; its subjects are not written yet.
    pub fn new(export: &Export) -> io::Result<Self> {
        let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let certificate = "couplet certify LANDMARK --weight WEIGHT --digits DIGITS | sha256sum";
        let mut notes = vec![
            note("couplet.schema", export.schema.to_owned()),
            note("couplet.tool", TOOL.to_owned()),
            note("couplet.digits", export.digits.to_string()),
            note("couplet.about", head(export).join("\n")),
        ];
        if export.subjects.iter().any(|subject| matches!(subject.of, Of::Landmark { .. })) {
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
        let schema = parse_message_type(&schema).map_err(io::Error::other)?;
        let writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties));
        Ok(Self { writer: writer.map_err(io::Error::other)? })
    }

    /// The next bytes of the file: a group with these subjects.
    pub fn group(&mut self, subjects: &[Subject]) -> io::Result<Vec<u8>> {
        let rows: Vec<Row> = subjects.iter().flat_map(Row::all).collect();
        if !rows.is_empty() {
            self.columns(&rows).map_err(io::Error::other)?;
        }
        self.writer.flush()?;
        // The writer counts what it has written by itself.
        Ok(std::mem::take(self.writer.inner_mut()))
    }

    /// The last bytes, without which the file cannot be read.
    pub fn end(self) -> io::Result<Vec<u8>> {
        self.writer.into_inner().map_err(io::Error::other)
    }

    fn columns(&mut self, rows: &[Row]) -> Result<()> {
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
        group.close()?;
        Ok(())
    }
}

/// The cells that are not null, and for each row whether it has one.
fn present<'a, T>(
    rows: &'a [Row<'a>],
    cell: impl Fn(&'a Row<'a>) -> Option<T>,
) -> (Vec<T>, Vec<i16>) {
    let (mut values, mut there) = (Vec::new(), Vec::new());
    for cell in rows.iter().map(cell) {
        there.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    (values, there)
}

/// A value with what it belongs to.
struct Row<'a> {
    subject: &'a Subject,
    value: Option<&'a Exported>,
    texts: [String; 3],
}

/// What was asked of an arch, and what became of it.
#[derive(Default)]
struct Query<'a> {
    line: u64,
    half_opening: Option<&'a str>,
    friction: Option<&'a str>,
    thickness: Option<&'a str>,
    mode: Option<&'static str>,
    stands: Option<bool>,
}

impl<'a> Row<'a> {
    fn all(subject: &'a Subject) -> Vec<Self> {
        if subject.values.is_empty() {
            return vec![Self { subject, value: None, texts: Default::default() }];
        }
        let row = |value: &'a Exported| Self { subject, value: Some(value), texts: value.texts() };
        subject.values.iter().map(row).collect()
    }

    fn weight(&self) -> Option<&'static str> {
        match &self.subject.of {
            Of::Landmark { weight, .. } | Of::Arch { weight, .. } => Some(weight.name()),
            Of::Query { .. } => None,
        }
    }

    fn landmark(&self) -> Option<&'static str> {
        match &self.subject.of {
            Of::Landmark { landmark, .. } => Some(landmark.symbol()),
            Of::Arch { .. } | Of::Query { .. } => None,
        }
    }

    fn query(&self) -> Option<Query<'_>> {
        match &self.subject.of {
            Of::Landmark { .. } => None,
            Of::Arch { number, half_opening, friction, thickness, stands, mode, .. } => {
                Some(Query {
                    line: *number,
                    half_opening: Some(half_opening),
                    friction: Some(friction),
                    thickness: thickness.as_deref(),
                    mode: mode.map(|mode| mode.label()),
                    stands: *stands,
                })
            }
            Of::Query { number } => Some(Query { line: *number, ..Query::default() }),
        }
    }

    fn certificate(&self) -> Option<&str> {
        match &self.subject.certificate {
            Certificate::Hash { sha256, .. } => Some(sha256),
            Certificate::None(_) => None,
        }
    }
}
