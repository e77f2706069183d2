//! Parquet: one row for each value, in one schema for landmarks and for arches; of a map one for each node.
//!
//! A subject without values (an arch that does not stand, an answer that is undecided) has one row without
//! a quantity. What made the file, and how its certificates are made again, is in the key-value metadata.

use super::answer::Answer;
use super::answers::{Answers, Scope, TOOL};
use super::column::Column::{Double, Integer, Text, Truth};
use super::column::NamedColumn;
use super::columns::kept_names;
use super::map::{Map, MapRow};
use super::names::head;
use super::rows::Rows;
use super::value::Value;
use crate::problem::Quantity;
use ::parquet::basic::{Compression, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use ::parquet::errors::Result;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use ::parquet::schema::parser::parse_message_type;
use ::parquet::schema::types::{ColumnPath, Type};
use std::io;
use std::mem;
use std::sync::Arc;

/// A Parquet file that is written group by group.
struct ParquetRows {
    writer: SerializedFileWriter<Vec<u8>>,
    /// Names of what is handed on from queries, a column each, behind the others.
    kept: Vec<String>,
    /// Answers that are not written yet, and how many make a group.
    held: Vec<Answer>,
    most: usize,
}

/// Digits of the arches of a group, each of which has some values: small groups are mostly their own descriptions.
const GROUP: usize = 1 << 17;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let mut rows = ParquetRows::new(report)?;
    rows.write(&report.list)?;
    out.write_all(&Box::new(rows).end()?)
}

/// Arches as they come.
pub(super) fn rows(report: Answers) -> io::Result<Box<dyn Rows>> {
    Ok(Box::new(ParquetRows::new(&report)?))
}

/// The nodes of a map, in one group.
pub(super) fn map(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let notes = [("schema", "couplet.map/1".to_owned()), ("tool", TOOL.to_owned())];
    let tolerance = ("tolerance", format!("{:?}", report.tolerance));
    let mut file = file(&MapRow::COLUMNS, &[], notes.into_iter().chain([tolerance]))?;
    group(&mut file, &MapRow::COLUMNS, &MapRow::of_map(report), &[])?;
    out.write_all(&with_common_order(file.into_inner()?))
}

/// The last bytes of a file, with the order that every reader knows for its doubles. The writer notes the total order
/// of IEEE 754, and a reader that does not know it leaves the least and the largest values unread. Both orders are one
/// where every cell is a number, as here.
pub fn with_common_order(mut bytes: Vec<u8>) -> Vec<u8> {
    // One field, without content, and the end of both.
    const TOTAL: [u8; 3] = [0x2C, 0, 0];
    const COMMON: [u8; 3] = [0x1C, 0, 0];
    // The footer ends with the orders of the columns and a zero, before its length and the four letters of the format.
    let mut end = bytes.len().saturating_sub(9);
    while let Some(order) = end.checked_sub(3).and_then(|start| bytes.get_mut(start..end)) {
        match order {
            _ if *order == TOTAL => order.copy_from_slice(&COMMON),
            _ if *order == COMMON => {}
            _ => break,
        }
        end -= 3;
    }
    bytes
}

/// An empty file of some columns, and behind them a text for each name from outside, which may be any text; with
/// notes on it.
fn file<R>(
    columns: &[NamedColumn<R>],
    kept: &[String],
    notes: impl Iterator<Item = (&'static str, String)>,
) -> Result<SerializedFileWriter<Vec<u8>>> {
    let notes = notes.map(|(key, value)| KeyValue::new(format!("couplet.{key}"), value));
    let properties = WriterProperties::builder()
        .set_compression(Compression::UNCOMPRESSED)
        .set_created_by(TOOL.to_owned())
        .set_key_value_metadata(Some(notes.collect()));
    // Of values hardly any comes again.
    let properties = VALUES.iter().fold(properties, |properties, name| {
        properties.set_column_dictionary_enabled(ColumnPath::from(*name), false)
    });
    let properties = properties.build();
    let own = columns.iter().map(|(name, column)| match column {
        Text(_) => format!("optional binary {name} (STRING);"),
        Double(_) => format!("optional double {name};"),
        Integer(_) => format!("optional int64 {name};"),
        Truth(_) => format!("optional boolean {name};"),
    });
    let own = parse_message_type(&format!("message couplet {{ {} }}", own.collect::<String>()))?;
    let mut fields = own.get_fields().to_vec();
    let names: Vec<String> = columns.iter().map(|(name, _)| (*name).to_owned()).collect();
    for name in kept_names(kept, &names) {
        let text = Type::primitive_type_builder(&name, PhysicalType::BYTE_ARRAY)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(Some(LogicalType::String));
        fields.push(Arc::new(text.build()?));
    }
    let schema = Type::group_type_builder(own.name()).with_fields(fields).build()?;
    SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))
}

/// Writes some rows as a group, with the texts of each column that is handed on.
fn group<R>(
    file: &mut SerializedFileWriter<Vec<u8>>,
    columns: &[NamedColumn<R>],
    rows: &[R],
    kept: &[Vec<Option<&str>>],
) -> Result<()> {
    let mut group = file.next_row_group()?;
    for (_, column) in columns {
        let Some(written) = group.next_column()? else { break };
        match column {
            Text(cell) => put::<ByteArrayType>(written, texts(rows.iter().map(cell))),
            Double(cell) => put::<DoubleType>(written, rows.iter().map(cell)),
            Integer(cell) => {
                let number = |row: &R| i64::try_from(cell(row)?).ok();
                put::<Int64Type>(written, rows.iter().map(number))
            }
            Truth(cell) => put::<BoolType>(written, rows.iter().map(cell)),
        }?;
    }
    for kept in kept {
        let Some(written) = group.next_column()? else { break };
        put::<ByteArrayType>(written, texts(kept.iter().copied()))?;
    }
    group.close()?;
    Ok(())
}

/// Texts as cells. The rows of an arch follow each other, and share what they have of it.
fn texts<'a>(
    texts: impl Iterator<Item = Option<&'a str>>,
) -> impl Iterator<Item = Option<ByteArray>> {
    let mut last = ("", ByteArray::from(""));
    texts.map(move |text| {
        let text = text?;
        if last.0 != text {
            last = (text, ByteArray::from(text));
        }
        Some(last.1.clone())
    })
}

/// Writes the cells of a column, each of which may be null.
fn put<T: DataType>(
    mut column: SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = Option<T::T>>,
) -> Result<()> {
    let (mut values, mut there) = (Vec::new(), Vec::new());
    for cell in cells {
        there.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    column.typed::<T>().write_batch(&values, Some(&there), None)?;
    column.close()
}

impl ParquetRows {
    /// A file about what a report says of itself; its answers are not written yet.
    fn new(report: &Answers) -> io::Result<Self> {
        let certificate = "couplet certify LANDMARK --weight WEIGHT --digits DIGITS | sha256sum";
        let notes = [
            ("schema", report.schema().to_owned()),
            ("tool", TOOL.to_owned()),
            ("digits", report.digits.to_string()),
            ("about", head(report).join("\n")),
        ];
        let is_hashed = report.scope == Scope::Constants;
        let certificate = is_hashed.then(|| ("certificate", certificate.to_owned()));
        let notes = notes.into_iter().chain(certificate);
        let kept = report.kept.clone();
        let writer = file(&ValueRow::COLUMNS, &kept, notes)?;
        Ok(Self { writer, kept, held: Vec::new(), most: GROUP / report.digits.clamp(1, GROUP) })
    }

    /// Writes some answers as a group.
    fn write(&mut self, answers: &[Answer]) -> io::Result<()> {
        let rows: Vec<ValueRow> = answers.iter().flat_map(ValueRow::all).collect();
        let texts = |name: &String| rows.iter().map(|row| row.kept(name)).collect();
        let kept: Vec<Vec<Option<&str>>> = self.kept.iter().map(texts).collect();
        if !rows.is_empty() {
            group(&mut self.writer, &ValueRow::COLUMNS, &rows, &kept)?;
        }
        Ok(())
    }
}

impl Rows for ParquetRows {
    fn group(&mut self, mut answers: Vec<Answer>) -> io::Result<Vec<u8>> {
        self.held.append(&mut answers);
        if self.held.len() >= self.most {
            let held = mem::take(&mut self.held);
            self.write(&held)?;
        }
        self.writer.flush()?;
        // The writer keeps its own count of the bytes.
        Ok(mem::take(self.writer.inner_mut()))
    }

    /// Without these bytes the file cannot be read.
    fn end(mut self: Box<Self>) -> io::Result<Vec<u8>> {
        let held = mem::take(&mut self.held);
        self.write(&held)?;
        Ok(with_common_order(self.writer.into_inner()?))
    }
}

/// Columns of values.
const VALUES: [&str; 7] =
    ["value", "lower", "upper", "double", "double_lower", "double_upper", "double_error"];

/// A value and its answer.
struct ValueRow<'a> {
    answer: &'a Answer,
    quantity: Option<Quantity>,
    value: Option<&'a Value>,
    texts: [String; 3],
}

impl<'a> ValueRow<'a> {
    /// The columns. `double` is the nearest to the true value, the doubles after it bound that value and its
    /// error; `half_opening`, `friction` and `thickness` are the texts of the query in `line`, with the doubles
    /// nearest to them.
    const COLUMNS: [NamedColumn<Self>; 25] = [
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

    /// The mode of an arch; at a landmark several meet.
    fn mode(&self) -> Option<&'static str> {
        let mode = self.answer.modes.first().map(|mode| mode.label());
        mode.filter(|_| self.answer.subject.landmark().is_none())
    }
}
