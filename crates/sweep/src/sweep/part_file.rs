//! A part as a Parquet file, `couplet.sweep/1`, written row group by row group: the same rows are the same bytes.

use super::notes::Notes;
use super::table::{CellOf, PartColumn, PartTable};
use crate::report::with_common_order;
use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as PhysicalType};
use ::parquet::column::writer::ColumnWriterImpl;
use ::parquet::data_type::{ByteArrayType, DataType, DoubleType, Int32Type, Int64Type};
use ::parquet::errors::Result;
use ::parquet::file::properties::{DEFAULT_WRITE_BATCH_SIZE, EnabledStatistics, WriterProperties};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{ColumnPath, Type};
use std::mem;
use std::sync::Arc;

/// Rows that are written at a time: as many as are encoded at a time, so that pages end where they would end if all
/// were written at once.
const BATCH: usize = DEFAULT_WRITE_BATCH_SIZE;

/// The most bytes of a dictionary of numbers that come again: those of 100,000, where usually a column goes on without.
const DICTIONARY: usize = 1 << 22;

/// Name of the program that writes.
const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// Writer of the file of a part, which begins with the first rows.
#[derive(Default)]
pub(super) struct PartWriter(Option<SerializedFileWriter<Vec<u8>>>);

impl PartWriter {
    /// Writer of a file with the columns of a table, whose rows are not written yet.
    fn begin(table: &PartTable) -> Result<SerializedFileWriter<Vec<u8>>> {
        let row = ColumnPath::from("row");
        let properties = WriterProperties::builder()
            .set_compression(Compression::UNCOMPRESSED)
            .set_created_by(TOOL.to_owned())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_column_dictionary_enabled(row.clone(), false)
            .set_column_encoding(row, Encoding::DELTA_BINARY_PACKED);
        // The least of decimals as texts tells nothing.
        let texts =
            table.columns.iter().filter(|(_, column)| matches!(column, PartColumn::Text(_)));
        let properties = texts.fold(properties, |properties, (name, _)| {
            let name = ColumnPath::from(name.as_str());
            properties.set_column_statistics_enabled(name, EnabledStatistics::None)
        });
        let properties = table.again.iter().fold(properties, |properties, name| {
            properties.set_column_dictionary_page_size_limit(ColumnPath::from(*name), DICTIONARY)
        });
        let fields = table.columns.iter().map(|(name, column)| Ok(Arc::new(field(name, column)?)));
        let schema =
            Type::group_type_builder("couplet").with_fields(fields.collect::<Result<_>>()?);
        let (schema, properties) = (Arc::new(schema.build()?), Arc::new(properties.build()));
        SerializedFileWriter::new(Vec::new(), schema, properties)
    }

    /// The bytes of the file up to the end of these rows, behind those that were there before.
    pub(super) fn group(&mut self, table: &PartTable) -> Result<Vec<u8>> {
        let writer = match &mut self.0 {
            Some(writer) => writer,
            none => none.insert(Self::begin(table)?),
        };
        let mut group = writer.next_row_group()?;
        for (_, cells) in &table.columns {
            let Some(mut column) = group.next_column()? else { break };
            let rows = table.rows;
            // The schema is made of the same columns.
            match cells {
                PartColumn::Name(cell) | PartColumn::Text(cell) => {
                    write(column.typed::<ByteArrayType>(), rows, cell)
                }
                PartColumn::Double(cell) => write(column.typed::<DoubleType>(), rows, cell),
                PartColumn::Whole(cell) => write(column.typed::<Int64Type>(), rows, cell),
                PartColumn::Short(cell) => write(column.typed::<Int32Type>(), rows, cell),
            }?;
            column.close()?;
        }
        group.close()?;
        writer.flush()?;
        // The writer keeps its own count of the bytes.
        Ok(mem::take(writer.inner_mut()))
    }

    /// The last bytes of the file.
    pub(super) fn end(self, notes: &Notes) -> Result<Vec<u8>> {
        let Some(mut writer) = self.0 else { return Ok(Vec::new()) };
        notes.entries(TOOL).into_iter().for_each(|note| writer.append_key_value_metadata(note));
        writer.into_inner().map(with_common_order)
    }
}

fn field(name: &str, column: &PartColumn) -> Result<Type> {
    let (kind, logical) = match column {
        PartColumn::Name(_) | PartColumn::Text(_) => {
            (PhysicalType::BYTE_ARRAY, Some(LogicalType::String))
        }
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
