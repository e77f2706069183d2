//! A column of a row group of a Parquet file.
//!
//! It is read by its pages and not by `get_column_reader` of the group, which would bring readers of all types and of
//! nested records into a program, although we read numbers and texts.

use ::parquet::column::page::PageReader;
use ::parquet::column::reader::ColumnReaderImpl;
use ::parquet::data_type::DataType;
use ::parquet::errors::{ParquetError, Result};
use ::parquet::file::metadata::{ColumnChunkMetaData, RowGroupMetaData};
use ::parquet::file::serialized_reader::SerializedPageReader;
use std::fs::File;
use std::ops::Range;
use std::sync::Arc;

/// A column, with its group and file.
pub(super) type ColumnOf<'a> = (&'a Arc<File>, &'a RowGroupMetaData, &'a ColumnChunkMetaData);

fn pages((file, group, column): ColumnOf) -> Result<SerializedPageReader<File>> {
    // Of bytes before the beginning of the file there are none.
    let numbers = [group.num_rows(), column.compressed_size(), column.data_page_offset()];
    let numbers = numbers.into_iter().chain(column.dictionary_page_offset());
    numbers.map(u64::try_from).collect::<std::result::Result<Vec<_>, _>>()?;
    let rows = usize::try_from(group.num_rows())?;
    SerializedPageReader::new(Arc::clone(file), column, rows, None)
}

/// The cells of some rows of a column, which has this type; none where there is no value.
pub(super) fn cells<T: DataType>(of: ColumnOf, rows: Range<usize>) -> Result<Vec<Option<T::T>>> {
    let mut column = ColumnReaderImpl::<T>::new(of.2.column_descr_ptr(), Box::new(pages(of)?));
    let is_optional = of.2.column_descr().max_def_level() > 0;
    let (mut values, mut there) = (Vec::new(), is_optional.then(Vec::new));
    let skipped = column.skip_records(rows.start)?;
    let (read, ..) = column.read_records(rows.len(), there.as_mut(), None, &mut values)?;
    if skipped != rows.start || read != rows.len() {
        return Err(ParquetError::General("rows are missing".into()));
    }
    let mut values = values.into_iter();
    Ok(match there {
        Some(there) => {
            there.iter().map(|level| if *level > 0 { values.next() } else { None }).collect()
        }
        None => values.map(Some).collect(),
    })
}

/// Tells whether the pages of a column have a value for each row of its group: what is said of them elsewhere
/// may be anything.
pub(super) fn has_its_rows(of: ColumnOf) -> Result<bool> {
    let (mut pages, mut values) = (pages(of)?, 0u64);
    while let Some(page) = pages.peek_next_page()? {
        values = values.saturating_add(page.num_levels.unwrap_or(0) as u64);
        pages.skip_next_page()?;
    }
    Ok(of.1.num_rows() == of.2.num_values() && u64::try_from(of.1.num_rows()) == Ok(values))
}
