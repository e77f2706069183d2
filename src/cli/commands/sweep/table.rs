//! The rows of a part as a Parquet file, `couplet.sweep/1`: the same rows are the same bytes.

use super::answers::{Found, Verdict, Wanted};
use super::query::Query;
use super::record::{Arches, Record};
use crate::problem::Mode;
use crate::scene::SWEEP_SCHEMA;
use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use ::parquet::column::writer::{ColumnWriter, ColumnWriterImpl};
use ::parquet::data_type::{ByteArray, DataType};
use ::parquet::errors::{ParquetError, Result};
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties};
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{ColumnPath, Type};
use std::collections::BTreeMap;
use std::fs::File;
use std::ops::Range;
use std::sync::Arc;

/// What writes.
const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// A column, whose cells may be null.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cells {
    Text(Vec<Option<ByteArray>>),
    Double(Vec<Option<f64>>),
    Whole(Vec<Option<i64>>),
    /// A whole number of one byte.
    Short(Vec<Option<i32>>),
}

/// The rows of a part by columns, with the names of these.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table(pub Vec<(String, Cells)>);

/// What a part says of itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Notes {
    /// The hash of the record of its sweep.
    pub plan: String,
    /// Its rows.
    pub rows: Range<u64>,
    /// How many of them have which verdict, in the order of [`Verdict::ALL`].
    pub counts: [u64; 4],
}

/// The rows of a part, as they are asked and as they are answered.
pub(super) type Rows<'a> = (&'a [Query], &'a [Arc<Found>]);

impl Table {
    /// The columns that are asked: row, file and line of a data set, texts and doubles.
    pub(super) fn asked(record: &Record, queries: &[Query]) -> Self {
        fn text(queries: &[Query], place: usize) -> Cells {
            let text =
                |query: &Query| Some(query.texts[place].clone()).filter(|text| !text.is_empty());
            Cells::Text(queries.iter().map(text).collect())
        }
        let double =
            |place: usize| Cells::Double(queries.iter().map(|q| q.doubles[place]).collect());
        let whole = |number: u64| i64::try_from(number).ok();
        let mut columns =
            vec![("row".to_owned(), Cells::Whole(queries.iter().map(|q| whole(q.row)).collect()))];
        if matches!(record.arches, Arches::Data { .. }) {
            let file = queries.iter().map(|q| q.origin.as_ref().map(|(file, _)| file.clone()));
            let line = queries.iter().map(|q| q.origin.as_ref().and_then(|(_, line)| whole(*line)));
            columns.push(("file".into(), Cells::Text(file.collect())));
            columns.push(("line".into(), Cells::Whole(line.collect())));
        }
        columns.extend([
            ("weight".into(), text(queries, 0)),
            ("half_opening".into(), text(queries, 1)),
            ("friction".into(), text(queries, 2)),
            ("half_opening_rad".into(), double(0)),
            ("friction_double".into(), double(1)),
        ]);
        Self(columns)
    }

    /// All columns.
    pub(super) fn new(record: &Record, wanted: &Wanted, (queries, found): Rows) -> Self {
        let Self(mut columns) = Self::asked(record, queries);
        columns.extend(Self::answered(wanted, found).0);
        Self(columns)
    }

    /// The columns that are answered.
    pub(super) fn answered(wanted: &Wanted, found: &[Arc<Found>]) -> Self {
        // The texts of names are shared.
        let verdicts = Verdict::ALL.map(|verdict| ByteArray::from(verdict.name()));
        let verdict = |found: &Arc<Found>| Some(verdicts[found.verdict as usize].clone());
        let modes = Mode::ALL.map(|mode| (mode, ByteArray::from(mode.label())));
        let mode = |found: &Arc<Found>| {
            let (_, label) = modes.iter().find(|(mode, _)| Some(*mode) == found.mode)?;
            Some(label.clone())
        };
        let mut columns = vec![
            ("verdict".to_owned(), Cells::Text(found.iter().map(verdict).collect())),
            ("mode".to_owned(), Cells::Text(found.iter().map(mode).collect())),
        ];
        for (place, quantity) in wanted.quantities.iter().enumerate() {
            let values = || found.iter().map(|found| found.values[place].as_ref());
            let (name, bytes) = (quantity.name(), |text: &String| ByteArray::from(text.as_str()));
            let double = values().map(|value| value.map(|value| value.double)).collect();
            let side = values().map(|value| value.and_then(|value| value.side)).collect();
            columns.push((name.to_owned(), Cells::Double(double)));
            columns.push((format!("{name}_side"), Cells::Short(side)));
            if wanted.has_texts {
                let text = values().map(|value| value.and_then(|v| v.text.as_ref()).map(bytes));
                columns.push((format!("{name}_text"), Cells::Text(text.collect())));
            }
        }
        let reason = |found: &Arc<Found>| found.reason.as_deref().map(ByteArray::from);
        columns.push(("reason".into(), Cells::Text(found.iter().map(reason).collect())));
        Self(columns)
    }

    /// The cells of a column, if there is one of that name.
    pub(super) fn column(&self, name: &str) -> Option<&Cells> {
        self.0.iter().find(|(of, _)| of == name).map(|(_, cells)| cells)
    }

    /// The file.
    pub(super) fn bytes(&self, notes: &Notes) -> Result<Vec<u8>> {
        let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let counts = Verdict::ALL.iter().zip(notes.counts);
        let counts = counts.map(|(verdict, count)| note(&counted(*verdict), count.to_string()));
        let mut told = vec![
            note("couplet.schema", SWEEP_SCHEMA.to_owned()),
            note("couplet.tool", TOOL.to_owned()),
            note("couplet.plan", notes.plan.clone()),
            note("couplet.rows", format!("{}..{}", notes.rows.start, notes.rows.end)),
        ];
        told.extend(counts);
        let row = ColumnPath::from("row");
        let properties = WriterProperties::builder()
            .set_compression(Compression::UNCOMPRESSED)
            .set_created_by(TOOL.to_owned())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_column_dictionary_enabled(row.clone(), false)
            .set_column_encoding(row, Encoding::DELTA_BINARY_PACKED)
            .set_key_value_metadata(Some(told))
            .build();
        let fields = self.0.iter().map(|(name, cells)| Ok(Arc::new(field(name, cells)?)));
        let schema =
            Type::group_type_builder("couplet").with_fields(fields.collect::<Result<_>>()?);
        let (schema, properties) = (Arc::new(schema.build()?), Arc::new(properties));
        let mut writer = SerializedFileWriter::new(Vec::new(), schema, properties)?;
        let mut group = writer.next_row_group()?;
        for (_, cells) in &self.0 {
            let Some(mut column) = group.next_column()? else { break };
            match (cells, column.untyped()) {
                (Cells::Text(cells), ColumnWriter::ByteArrayColumnWriter(out)) => {
                    write(out, cells)?
                }
                (Cells::Double(cells), ColumnWriter::DoubleColumnWriter(out)) => write(out, cells)?,
                (Cells::Whole(cells), ColumnWriter::Int64ColumnWriter(out)) => write(out, cells)?,
                (Cells::Short(cells), ColumnWriter::Int32ColumnWriter(out)) => write(out, cells)?,
                // The schema is made of the same columns.
                _ => unreachable!(),
            }
            column.close()?;
        }
        group.close()?;
        writer.into_inner()
    }

    /// The columns of a file, as they were written.
    pub(super) fn read(file: File) -> Result<Self> {
        let reader = SerializedFileReader::new(file)?;
        let group = reader.get_row_group(0)?;
        let rows = group.metadata().num_rows().try_into().unwrap_or(0);
        let schema = group.metadata().schema_descr_ptr();
        let columns = schema.columns().iter().enumerate().map(|(place, column)| {
            let cells = match group.get_column_reader(place)? {
                ColumnReader::ByteArrayColumnReader(reader) => Cells::Text(read(reader, rows)?),
                ColumnReader::DoubleColumnReader(reader) => Cells::Double(read(reader, rows)?),
                ColumnReader::Int64ColumnReader(reader) => Cells::Whole(read(reader, rows)?),
                ColumnReader::Int32ColumnReader(reader) => Cells::Short(read(reader, rows)?),
                _ => return Err(ParquetError::General("a column of another type".into())),
            };
            Ok((column.name().to_owned(), cells))
        });
        columns.collect::<Result<_>>().map(Self)
    }
}

impl Notes {
    /// What a file says of itself; none if it is no part of a sweep, or is not whole.
    pub(super) fn of(file: &File) -> Option<Self> {
        let reader = SerializedFileReader::new(file.try_clone().ok()?).ok()?;
        let notes = reader.metadata().file_metadata().key_value_metadata()?;
        let notes: BTreeMap<&str, &str> =
            notes.iter().filter_map(|n| Some((n.key.as_str(), n.value.as_deref()?))).collect();
        let (start, end) = notes.get("couplet.rows")?.split_once("..")?;
        let rows: Range<u64> = start.parse().ok()?..end.parse().ok()?;
        let mut counts = [0; 4];
        for verdict in Verdict::ALL {
            counts[verdict as usize] = notes.get(counted(verdict).as_str())?.parse().ok()?;
        }
        let length = rows.end.checked_sub(rows.start)?;
        let whole = u64::try_from(reader.metadata().file_metadata().num_rows()) == Ok(length)
            && notes.get("couplet.schema") == Some(&SWEEP_SCHEMA)
            && counts.iter().sum::<u64>() == length;
        let plan = (*notes.get("couplet.plan")?).to_owned();
        whole.then_some(Self { plan, rows, counts })
    }
}

/// The key of a count.
fn counted(verdict: Verdict) -> String {
    format!("couplet.{}", verdict.name())
}

fn field(name: &str, cells: &Cells) -> Result<Type> {
    let (kind, logical) = match cells {
        Cells::Text(_) => (PhysicalType::BYTE_ARRAY, Some(LogicalType::String)),
        Cells::Double(_) => (PhysicalType::DOUBLE, None),
        Cells::Whole(_) => (PhysicalType::INT64, None),
        Cells::Short(_) => (PhysicalType::INT32, Some(LogicalType::integer(8, true))),
    };
    Type::primitive_type_builder(name, kind)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical)
        .build()
}

fn write<T: DataType>(out: &mut ColumnWriterImpl<T>, cells: &[Option<T::T>]) -> Result<()> {
    let there: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    let values: Vec<T::T> = cells.iter().flatten().cloned().collect();
    out.write_batch(&values, Some(&there), None).map(drop)
}

fn read<T: DataType>(mut column: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<Option<T::T>>> {
    let (mut values, mut there) = (Vec::new(), Vec::new());
    let (read, ..) = column.read_records(rows, Some(&mut there), None, &mut values)?;
    let mut values = values.into_iter();
    match read == rows {
        true => Ok(there
            .into_iter()
            .map(|there| if there > 0 { values.next() } else { None })
            .collect()),
        false => Err(ParquetError::General("rows are missing".into())),
    }
}
