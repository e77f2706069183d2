//! A column of a row group of a Parquet file.
//!
//! It is read by its pages and not by `get_column_reader` of the group, which would bring readers of all types and of
//! nested records into a program, although we read numbers and texts.

use ::parquet::column::reader::ColumnReaderImpl;
use ::parquet::data_type::DataType;
use ::parquet::errors::Result;
use ::parquet::file::metadata::{ColumnChunkMetaData, RowGroupMetaData};
use ::parquet::file::serialized_reader::SerializedPageReader;
use std::fs::File;
use std::sync::Arc;

/// A column, with its group and file.
pub(super) type Of<'a> = (&'a Arc<File>, &'a RowGroupMetaData, &'a ColumnChunkMetaData);

/// What reads the values of a column, which has this type.
pub(super) fn reader<T: DataType>((file, group, column): Of) -> Result<ColumnReaderImpl<T>> {
    let rows = usize::try_from(group.num_rows())?;
    let pages = SerializedPageReader::new(Arc::clone(file), column, rows, None)?;
    Ok(ColumnReaderImpl::new(column.column_descr_ptr(), Box::new(pages)))
}
