//! A part as a Parquet file: its notes on itself, and its columns as whoever looks through a sweep reads them again.
//! Nothing else is read here: other files have other engines.
//!
//! A column is read by its pages and not by `get_column_reader` of the group, which would bring readers of all types
//! and of nested records into a program, although we write numbers and texts.

use crate::certify::batch::RowVerdict;
use crate::report::{ParquetColumn, ParquetTable};
use crate::scene::SWEEP_SCHEMA;
use ::parquet::basic::Type;
use ::parquet::column::reader::ColumnReaderImpl;
use ::parquet::data_type::{ByteArrayType, DataType, DoubleType, Int32Type, Int64Type};
use ::parquet::errors::{ParquetError, Result};
use ::parquet::file::metadata::{ColumnChunkMetaData, KeyValue};
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::file::serialized_reader::SerializedPageReader;
use std::fs::File;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// Notes of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Notes {
    /// The hash of the record of its sweep.
    pub plan: String,
    /// Rows of the part.
    pub rows: Range<u64>,
    /// Numbers of rows with each verdict, in the order of [`RowVerdict::ALL`].
    pub counts: [u64; 4],
}

impl Notes {
    /// The entries of the file.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, String)> {
        let rows = format!("{}..{}", self.rows.start, self.rows.end);
        let own =
            [("schema", SWEEP_SCHEMA.to_owned()), ("plan", self.plan.clone()), ("rows", rows)];
        let counts = RowVerdict::ALL.iter().zip(self.counts);
        let counts = counts.map(|(verdict, count)| (verdict.name(), count.to_string()));
        own.into_iter().chain(counts)
    }

    /// Tells whether a file has these notes, and as many rows as they say.
    pub(super) fn are_of(&self, path: &Path) -> bool {
        let reader = File::open(path).ok().and_then(|file| SerializedFileReader::new(file).ok());
        let Some(reader) = reader else { return false };
        let there = reader.metadata().file_metadata();
        let is_there = |(key, text): (&str, String)| {
            let is = |n: &KeyValue| {
                n.key.strip_prefix("couplet.") == Some(key) && n.value.as_ref() == Some(&text)
            };
            there.key_value_metadata().is_some_and(|all| all.iter().any(is))
        };
        u64::try_from(there.num_rows()) == Ok(self.rows.end - self.rows.start)
            && self.entries().all(is_there)
    }
}

/// File of a part whose content has the hash of its name.
pub(super) struct ReadPart(SerializedFileReader<File>, Arc<File>);

impl ReadPart {
    pub(super) fn of(file: File) -> Result<Self> {
        let pages = Arc::new(file.try_clone()?);
        Ok(Self(SerializedFileReader::new(file)?, pages))
    }

    /// Number of row groups.
    pub(super) fn groups(&self) -> usize {
        self.0.metadata().num_row_groups()
    }

    /// The columns of a row group, as they were written.
    pub(super) fn group(&self, place: usize) -> Result<ParquetTable<'static>> {
        let group = self.0.metadata().row_group(place);
        let rows = usize::try_from(group.num_rows())?;
        let columns = group.columns().iter().map(|column| {
            let of = (&self.1, column, rows);
            let cells = match column.column_type() {
                Type::BYTE_ARRAY => ParquetColumn::Text(cells::<ByteArrayType>(of)?),
                Type::DOUBLE => ParquetColumn::Double(cells::<DoubleType>(of)?),
                Type::INT64 => ParquetColumn::Whole(cells::<Int64Type>(of)?),
                Type::INT32 => ParquetColumn::Short(cells::<Int32Type>(of)?),
                _ => return Err(ParquetError::General("a column of another type".into())),
            };
            Ok((column.column_descr().name().to_owned(), cells))
        });
        Ok(ParquetTable { rows, again: &[], once: &[], columns: columns.collect::<Result<_>>()? })
    }
}

/// The cell of each row of a column that was read.
type ReadCell<T> = Box<dyn Fn(usize) -> Option<T>>;

/// The cells of a column with so many rows, which has this type; none where there is no value.
fn cells<T: DataType>(
    (file, column, rows): (&Arc<File>, &ColumnChunkMetaData, usize),
) -> Result<ReadCell<T::T>> {
    // Of bytes before the beginning of the file there are none.
    let numbers = [column.compressed_size(), column.data_page_offset()];
    let numbers = numbers.into_iter().chain(column.dictionary_page_offset());
    numbers.map(u64::try_from).collect::<std::result::Result<Vec<_>, _>>()?;
    let pages = SerializedPageReader::new(Arc::clone(file), column, rows, None)?;
    let mut reader = ColumnReaderImpl::<T>::new(column.column_descr_ptr(), Box::new(pages));
    let (mut values, mut there) = (Vec::new(), Vec::new());
    let (read, ..) = reader.read_records(rows, Some(&mut there), None, &mut values)?;
    // Every column is written so that it may have nulls.
    if read != rows || there.len() != rows {
        return Err(ParquetError::General("rows are missing".into()));
    }
    let mut values = values.into_iter();
    let cell = |level: &i16| if *level > 0 { values.next() } else { None };
    let cells: Vec<Option<T::T>> = there.iter().map(cell).collect();
    Ok(Box::new(move |row| cells.get(row).cloned().flatten()))
}
