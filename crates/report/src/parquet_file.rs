//! A Parquet file of a table, written row group by row group: the same rows are the same bytes.

use super::answers::TOOL;
use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::column::writer::ColumnWriterImpl;
use ::parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type,
};
use ::parquet::errors::Result;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{DEFAULT_WRITE_BATCH_SIZE, EnabledStatistics, WriterProperties};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{ColumnPath, Type};
use std::fmt::Display;
use std::io::{self, Write};
use std::mem;
use std::ops::Range;
use std::sync::Arc;

/// The cell of each row of a column. A column is never there as a whole: some rows are written at a time.
type CellOf<'a, T> = Box<dyn Fn(usize) -> Option<T> + 'a>;

/// A column of a file.
pub enum ParquetColumn<'a> {
    /// A text of a few: a name.
    Name(CellOf<'a, ByteArray>),
    /// Any text.
    Text(CellOf<'a, ByteArray>),
    /// A double.
    Double(CellOf<'a, f64>),
    /// A whole number.
    Whole(CellOf<'a, i64>),
    /// A whole number of one byte.
    Short(CellOf<'a, i32>),
    /// A statement.
    Truth(CellOf<'a, bool>),
}

/// Rows that are held in memory, by columns, with the names of these.
pub struct ParquetTable<'a> {
    /// Number of rows.
    pub rows: usize,
    /// Columns of which every value comes again, after many others.
    pub again: &'static [&'static str],
    /// Columns of which hardly any value comes again; whole numbers grow.
    pub once: &'static [&'static str],
    /// The columns.
    pub columns: Vec<(String, ParquetColumn<'a>)>,
}

/// A Parquet file, which begins with the first rows.
#[derive(Default)]
pub struct ParquetFile(Option<SerializedFileWriter<Vec<u8>>>);

/// Rows that are written at a time: as many as are encoded at a time, so that pages end where they would end if all
/// were written at once.
const BATCH: usize = DEFAULT_WRITE_BATCH_SIZE;

/// The most bytes of a dictionary of numbers that come again: those of 100,000, where usually a column goes on without.
const DICTIONARY: usize = 1 << 22;

impl ParquetFile {
    /// Writer of a file with the columns of a table, whose rows are not written yet.
    fn begin(table: &ParquetTable) -> Result<SerializedFileWriter<Vec<u8>>> {
        let mut properties = WriterProperties::builder()
            .set_compression(Compression::UNCOMPRESSED)
            .set_created_by(TOOL.to_owned())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true);
        for (name, column) in &table.columns {
            let path = ColumnPath::new(vec![name.clone()]);
            // The least of decimals as texts tells nothing.
            if let ParquetColumn::Text(_) = column {
                let none = EnabledStatistics::None;
                properties = properties.set_column_statistics_enabled(path.clone(), none);
            }
            if table.again.contains(&name.as_str()) {
                let path = path.clone();
                properties = properties.set_column_dictionary_page_size_limit(path, DICTIONARY);
            }
            if table.once.contains(&name.as_str()) {
                properties = properties.set_column_dictionary_enabled(path.clone(), false);
                if let ParquetColumn::Whole(_) = column {
                    let growing = Encoding::DELTA_BINARY_PACKED;
                    properties = properties.set_column_encoding(path, growing);
                }
            }
        }
        let fields = table.columns.iter().map(|(name, column)| Ok(Arc::new(field(name, column)?)));
        let schema =
            Type::group_type_builder("couplet").with_fields(fields.collect::<Result<_>>()?);
        let (schema, properties) = (Arc::new(schema.build()?), Arc::new(properties.build()));
        SerializedFileWriter::new(Vec::new(), schema, properties)
    }

    /// The bytes of the file up to the end of these rows, behind those that were there before.
    pub fn group(&mut self, table: &ParquetTable) -> io::Result<Vec<u8>> {
        let writer = match &mut self.0 {
            Some(writer) => writer,
            none => none.insert(Self::begin(table)?),
        };
        if table.rows > 0 {
            let mut group = writer.next_row_group()?;
            for (_, cells) in &table.columns {
                let Some(mut column) = group.next_column()? else { break };
                let rows = table.rows;
                // The schema is made of the same columns.
                match cells {
                    ParquetColumn::Name(cell) | ParquetColumn::Text(cell) => {
                        write(column.typed::<ByteArrayType>(), rows, cell)
                    }
                    ParquetColumn::Double(cell) => write(column.typed::<DoubleType>(), rows, cell),
                    ParquetColumn::Whole(cell) => write(column.typed::<Int64Type>(), rows, cell),
                    ParquetColumn::Short(cell) => write(column.typed::<Int32Type>(), rows, cell),
                    ParquetColumn::Truth(cell) => write(column.typed::<BoolType>(), rows, cell),
                }?;
                column.close()?;
            }
            group.close()?;
        }
        writer.flush()?;
        // The writer keeps its own count of the bytes.
        Ok(mem::take(writer.inner_mut()))
    }

    /// The last bytes of the file, without which it cannot be read, with notes and the program; none where it has not
    /// begun.
    pub fn end(
        self,
        notes: impl IntoIterator<Item = (&'static str, String)>,
    ) -> io::Result<Vec<u8>> {
        let Some(mut writer) = self.0 else { return Ok(Vec::new()) };
        for (key, value) in [("tool", TOOL.to_owned())].into_iter().chain(notes) {
            writer.append_key_value_metadata(KeyValue::new(format!("couplet.{key}"), value));
        }
        Ok(with_common_order(writer.into_inner()?))
    }
}

fn field(name: &str, column: &ParquetColumn) -> Result<Type> {
    let (kind, logical) = match column {
        ParquetColumn::Name(_) | ParquetColumn::Text(_) => {
            (PhysicalType::BYTE_ARRAY, Some(LogicalType::String))
        }
        ParquetColumn::Double(_) => (PhysicalType::DOUBLE, None),
        ParquetColumn::Whole(_) => (PhysicalType::INT64, None),
        ParquetColumn::Short(_) => (PhysicalType::INT32, Some(LogicalType::integer(8, true))),
        ParquetColumn::Truth(_) => (PhysicalType::BOOLEAN, None),
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

/// The last bytes of a file, with the order that every reader knows for its doubles. The writer notes the total order
/// of IEEE 754, and a reader that does not know it leaves the least and the largest values unread. Both orders are one
/// where every cell is a number, as here.
fn with_common_order(mut bytes: Vec<u8>) -> Vec<u8> {
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

/// Texts of rows one behind the other.
#[derive(Default)]
pub struct Texts {
    all: Vec<u8>,
    ends: Vec<usize>,
}

impl Texts {
    /// Adds the text of the next row; an empty one is none.
    pub fn push(&mut self, text: &dyn Display) {
        // A vector takes everything.
        let _ = write!(self.all, "{text}");
        self.ends.push(self.all.len());
    }

    fn place(&self, row: usize) -> Range<usize> {
        let start = row.checked_sub(1).map_or(0, |before| self.ends[before]);
        start..self.ends[row]
    }

    /// The text of a row.
    pub fn of(&self, row: usize) -> &[u8] {
        &self.all[self.place(row)]
    }

    /// The texts as the cells of a column, which share one piece of memory.
    pub fn cells(&self) -> impl Fn(usize) -> Option<ByteArray> {
        let all = ByteArray::from(self.all.as_slice());
        move |row| {
            let place = self.place(row);
            (!place.is_empty()).then(|| all.slice(place.start, place.len()))
        }
    }
}

impl<T: Display> FromIterator<Option<T>> for Texts {
    fn from_iter<I: IntoIterator<Item = Option<T>>>(all: I) -> Self {
        let mut texts = Self::default();
        all.into_iter().for_each(|text| match text {
            Some(text) => texts.push(&text),
            None => texts.push(&""),
        });
        texts
    }
}

impl<'a> ParquetColumn<'a> {
    /// Whole numbers.
    pub fn whole(cell: impl Fn(usize) -> Option<u64> + 'a) -> Self {
        Self::Whole(Box::new(move |row| i64::try_from(cell(row)?).ok()))
    }
}
