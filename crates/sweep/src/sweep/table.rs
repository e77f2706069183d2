//! The rows of a part as a Parquet file, `couplet.sweep/1`: the same rows are the same bytes.

use super::column::cells;
use super::query::{Listed, PartArches, PartGrid, PartQueries};
use crate::arch::SelfWeight;
use crate::certify::batch::{Batch, BatchRow, RowVerdict};
use crate::problem::Mode;
use crate::scene::SWEEP_SCHEMA;
use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::column::writer::ColumnWriterImpl;
use ::parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type};
use ::parquet::errors::{ParquetError, Result};
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{DEFAULT_WRITE_BATCH_SIZE, EnabledStatistics, WriterProperties};
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{ColumnPath, Type};
use std::collections::BTreeMap;
use std::fs::File;
use std::ops::Range;
use std::sync::Arc;

/// Rows that are written at a time: as many as are encoded at a time, so that pages end where they would end if all
/// were written at once.
const BATCH: usize = DEFAULT_WRITE_BATCH_SIZE;

/// Name of the program that writes.
const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// The cells of a column as they were read; they may be null.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ReadCells {
    Text(Vec<Option<ByteArray>>),
    Double(Vec<Option<f64>>),
    Whole(Vec<Option<i64>>),
    /// A whole number of one byte.
    Short(Vec<Option<i32>>),
}

/// The rows of a part by columns, with the names of these, as they were read.
pub(super) struct ReadTable(Vec<(String, ReadCells)>);

/// The cell of each row of a column. A column is never there as a whole: some rows are written at a time.
type CellOf<'a, T> = Box<dyn Fn(usize) -> Option<T> + 'a>;

/// A column that is written.
pub(super) enum PartColumn<'a> {
    Text(CellOf<'a, ByteArray>),
    Double(CellOf<'a, f64>),
    Whole(CellOf<'a, i64>),
    /// A whole number of one byte.
    Short(CellOf<'a, i32>),
}

/// The rows of a part by columns, with the names of these.
pub(super) struct PartTable<'a> {
    pub rows: usize,
    pub columns: Vec<(String, PartColumn<'a>)>,
}

/// Notes of a part on itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Notes {
    /// The hash of the record of its sweep.
    pub plan: String,
    /// Rows of the part.
    pub rows: Range<u64>,
    /// Numbers of rows with each verdict, in the order of [`RowVerdict::ALL`].
    pub counts: [u64; 4],
}

impl<'a> PartTable<'a> {
    /// The columns that are asked: row, file and line of a data set, texts and doubles.
    pub(super) fn asked(queries: &'a PartQueries) -> Self {
        let whole = |number: u64| i64::try_from(number).ok();
        let first = queries.first;
        let mut columns =
            vec![("row".to_owned(), PartColumn::whole(move |row| whole(first + row as u64)))];
        let origin = match &queries.arches {
            PartArches::Listed(listed) => listed.origin.as_ref(),
            PartArches::Grid(_) => None,
        };
        if let Some((file, lines)) = origin {
            columns.push(("file".into(), PartColumn::text(|_| Some(file.clone()))));
            columns.push(("line".into(), PartColumn::whole(move |row| whole(lines[row]))));
        }
        let given = match &queries.arches {
            PartArches::Grid(PartGrid { columns, frictions, .. }) => {
                let names = SelfWeight::ALL.map(|weight| (weight, ByteArray::from(weight.name())));
                let name = move |weight: SelfWeight| {
                    Some(names.iter().find(|(of, _)| *of == weight)?.1.clone())
                };
                let length = frictions.len();
                let column = move |row: usize| &columns[row / length];
                let friction = move |row: usize| &frictions[row % length];
                [
                    PartColumn::text(move |row| name(column(row).0)),
                    PartColumn::text(move |row| Some(column(row).1.text.clone())),
                    PartColumn::text(move |row| Some(friction(row).text.clone())),
                    PartColumn::double(move |row| column(row).1.double),
                    PartColumn::double(move |row| friction(row).double),
                ]
            }
            PartArches::Listed(listed) => {
                let Listed { texts: [weights, alphas, mus], doubles: [alpha, mu], .. } =
                    listed.as_ref();
                [
                    PartColumn::text(weights.cells()),
                    PartColumn::text(alphas.cells()),
                    PartColumn::text(mus.cells()),
                    PartColumn::double(|row| alpha[row]),
                    PartColumn::double(|row| mu[row]),
                ]
            }
        };
        let names = ["weight", "half_opening", "friction", "half_opening_rad", "friction_double"];
        columns.extend(names.map(str::to_owned).into_iter().zip(given));
        Self { rows: queries.len(), columns }
    }

    /// All columns.
    pub(super) fn new(batch: &Batch, queries: &'a PartQueries, found: &'a [Arc<BatchRow>]) -> Self {
        let Self { rows, mut columns } = Self::asked(queries);
        columns.extend(Self::answered(batch, found).columns);
        Self { rows, columns }
    }

    /// The columns that are answered.
    pub(super) fn answered(batch: &Batch, found: &'a [Arc<BatchRow>]) -> Self {
        // The texts of names are shared.
        let verdicts = RowVerdict::ALL.map(|verdict| ByteArray::from(verdict.name()));
        let modes = Mode::ALL.map(|mode| (mode, ByteArray::from(mode.label())));
        let mode = move |row: usize| {
            let mode = found[row].mode?;
            Some(modes.iter().find(|(of, _)| *of == mode)?.1.clone())
        };
        let verdict = move |row: usize| Some(verdicts[found[row].verdict as usize].clone());
        let mut columns = vec![
            ("verdict".to_owned(), PartColumn::text(verdict)),
            ("mode".to_owned(), PartColumn::text(mode)),
        ];
        for (place, quantity) in batch.quantities.iter().enumerate() {
            let value = move |row: usize| found[row].values[place].as_ref();
            let name = quantity.name();
            columns
                .push((name.to_owned(), PartColumn::double(move |row| Some(value(row)?.double))));
            columns
                .push((format!("{name}_side"), PartColumn::short(move |row| value(row)?.side())));
            if batch.has_texts {
                let text = move |row| value(row)?.text.as_deref().map(ByteArray::from);
                columns.push((format!("{name}_text"), PartColumn::text(text)));
            }
        }
        let reason = |row: usize| found[row].reason.as_deref().map(ByteArray::from);
        columns.push(("reason".into(), PartColumn::text(reason)));
        Self { rows: found.len(), columns }
    }

    /// The file.
    pub(super) fn bytes(&self, notes: &Notes) -> Result<Vec<u8>> {
        let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let counts = RowVerdict::ALL.iter().zip(notes.counts);
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
            .set_key_value_metadata(Some(told));
        // The least of decimals as texts tells nothing.
        let texts = self.columns.iter().filter(|(_, column)| matches!(column, PartColumn::Text(_)));
        let properties = texts.fold(properties, |properties, (name, _)| {
            let name = ColumnPath::from(name.as_str());
            properties.set_column_statistics_enabled(name, EnabledStatistics::None)
        });
        let fields = self.columns.iter().map(|(name, column)| Ok(Arc::new(field(name, column)?)));
        let schema =
            Type::group_type_builder("couplet").with_fields(fields.collect::<Result<_>>()?);
        let (schema, properties) = (Arc::new(schema.build()?), Arc::new(properties.build()));
        let mut writer = SerializedFileWriter::new(Vec::new(), schema, properties)?;
        let mut group = writer.next_row_group()?;
        for (_, cells) in &self.columns {
            let Some(mut column) = group.next_column()? else { break };
            let rows = self.rows;
            // The schema is made of the same columns.
            match cells {
                PartColumn::Text(cell) => write(column.typed::<ByteArrayType>(), rows, cell)?,
                PartColumn::Double(cell) => write(column.typed::<DoubleType>(), rows, cell)?,
                PartColumn::Whole(cell) => write(column.typed::<Int64Type>(), rows, cell)?,
                PartColumn::Short(cell) => write(column.typed::<Int32Type>(), rows, cell)?,
            }
            column.close()?;
        }
        group.close()?;
        writer.into_inner()
    }
}

impl<'a> PartColumn<'a> {
    fn text(cell: impl Fn(usize) -> Option<ByteArray> + 'a) -> Self {
        Self::Text(Box::new(cell))
    }

    fn double(cell: impl Fn(usize) -> Option<f64> + 'a) -> Self {
        Self::Double(Box::new(cell))
    }

    fn whole(cell: impl Fn(usize) -> Option<i64> + 'a) -> Self {
        Self::Whole(Box::new(cell))
    }

    fn short(cell: impl Fn(usize) -> Option<i32> + 'a) -> Self {
        Self::Short(Box::new(cell))
    }

    /// Tells whether a cell is one that was read, bit for bit.
    pub(super) fn is_same(&self, row: usize, there: &ReadCells, place: usize) -> bool {
        match (self, there) {
            (Self::Text(cell), ReadCells::Text(there)) => there.get(place) == Some(&cell(row)),
            (Self::Double(cell), ReadCells::Double(there)) => {
                let bits = |cell: &Option<f64>| cell.map(f64::to_bits);
                there.get(place).map(bits) == Some(bits(&cell(row)))
            }
            (Self::Whole(cell), ReadCells::Whole(there)) => there.get(place) == Some(&cell(row)),
            (Self::Short(cell), ReadCells::Short(there)) => there.get(place) == Some(&cell(row)),
            _ => false,
        }
    }
}

impl ReadTable {
    /// The columns of a file, as they were written.
    pub(super) fn of(file: File) -> Result<Self> {
        let file = Arc::new(file);
        let whole = SerializedFileReader::new(file.try_clone()?)?;
        let Some(group) = whole.metadata().row_groups().first() else {
            return Err(ParquetError::General("rows are missing".into()));
        };
        let rows = group.num_rows().try_into().unwrap_or(0);
        let columns = group.columns().iter().map(|column| {
            let of = (&file, group, column);
            let cells = match column.column_type() {
                // Every column is written so that it may have nulls.
                _ if column.column_descr().max_def_level() == 0 => ReadCells::Text(Vec::new()),
                PhysicalType::BYTE_ARRAY => ReadCells::Text(cells::<ByteArrayType>(of, 0..rows)?),
                PhysicalType::DOUBLE => ReadCells::Double(cells::<DoubleType>(of, 0..rows)?),
                PhysicalType::INT64 => ReadCells::Whole(cells::<Int64Type>(of, 0..rows)?),
                PhysicalType::INT32 => ReadCells::Short(cells::<Int32Type>(of, 0..rows)?),
                _ => return Err(ParquetError::General("a column of another type".into())),
            };
            Ok((column.column_descr().name().to_owned(), cells))
        });
        columns.collect::<Result<_>>().map(Self)
    }

    /// The cells of a column, if there is one of that name.
    pub(super) fn column(&self, name: &str) -> Option<&ReadCells> {
        self.0.iter().find(|(of, _)| of == name).map(|(_, cells)| cells)
    }
}

impl Notes {
    /// Notes of a file on itself; none if it is no part of a sweep, or is not whole.
    pub(super) fn of(file: &File) -> Option<Self> {
        let reader = SerializedFileReader::new(file.try_clone().ok()?).ok()?;
        let notes = reader.metadata().file_metadata().key_value_metadata()?;
        let notes: BTreeMap<&str, &str> =
            notes.iter().filter_map(|n| Some((n.key.as_str(), n.value.as_deref()?))).collect();
        let (start, end) = notes.get("couplet.rows")?.split_once("..")?;
        let rows: Range<u64> = start.parse().ok()?..end.parse().ok()?;
        let mut counts = [0; 4];
        for verdict in RowVerdict::ALL {
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
fn counted(verdict: RowVerdict) -> String {
    format!("couplet.{}", verdict.name())
}

fn field(name: &str, column: &PartColumn) -> Result<Type> {
    let (kind, logical) = match column {
        PartColumn::Text(_) => (PhysicalType::BYTE_ARRAY, Some(LogicalType::String)),
        PartColumn::Double(_) => (PhysicalType::DOUBLE, None),
        PartColumn::Whole(_) => (PhysicalType::INT64, None),
        PartColumn::Short(_) => (PhysicalType::INT32, Some(LogicalType::integer(8, true))),
    };
    Type::primitive_type_builder(name, kind)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical)
        .build()
}

fn write<T: DataType>(
    out: &mut ColumnWriterImpl<T>,
    rows: usize,
    cell: &CellOf<T::T>,
) -> Result<()> {
    let (mut there, mut values) = (Vec::with_capacity(BATCH), Vec::with_capacity(BATCH));
    for first in (0..rows).step_by(BATCH) {
        for cell in (first..rows.min(first + BATCH)).map(cell) {
            there.push(i16::from(cell.is_some()));
            values.extend(cell);
        }
        out.write_batch(&values, Some(&there), None)?;
        there.clear();
        values.clear();
    }
    Ok(())
}
