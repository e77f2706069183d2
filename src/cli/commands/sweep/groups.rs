//! Pieces of a Parquet file: rows of its row groups.

use super::column::{Of, reader as reads};
use super::pieces::{CHANGED, columns, hash_of_pieces};
use super::query::Listed;
use crate::arch::SelfWeight;
use crate::cli::commands::rows::{Cells, Reader, Spelling};
use crate::cli::failure::reason;
use crate::number::ExactNumber;
use ::parquet::basic::{Compression, Type};
use ::parquet::column::reader::ColumnReaderImpl;
use ::parquet::data_type::{ByteArrayType, DataType, DoubleType, FloatType, Int32Type, Int64Type};
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::RowGroupMetaData;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use rug::Rational;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// A piece.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GroupSlice {
    pub rows: u64,
    group: usize,
    /// Rows of the group before it.
    skip: u64,
    /// Of the columns of the group that are read.
    sha256: String,
}

/// The names of the columns of a file; those within others are none.
fn header(reader: &SerializedFileReader<File>) -> Vec<String> {
    let schema = reader.metadata().file_metadata().schema_descr_ptr();
    schema.columns().iter().map(|column| column.path().string()).collect()
}

fn failed(error: ParquetError) -> String {
    error.to_string()
}

/// The hash of the columns of a group that are read.
fn hash(file: &mut File, group: &RowGroupMetaData, places: &[usize]) -> Result<String, String> {
    let pieces: Vec<(u64, u64)> =
        places.iter().map(|&place| group.column(place).byte_range()).collect();
    hash_of_pieces(file, &pieces).map_err(|error| reason(&error))
}

/// The pieces of a file, with at most so many rows each; or what is wrong with the file.
pub(super) fn slices(path: &Path, rows: u64) -> Result<Vec<GroupSlice>, String> {
    let mut file = File::open(path).map_err(|error| reason(&error))?;
    let reader = SerializedFileReader::new(file.try_clone().map_err(|error| reason(&error))?);
    let reader = reader.map_err(failed)?;
    let (_, places) = columns(&header(&reader))?;
    let mut slices = Vec::new();
    for (number, group) in reader.metadata().row_groups().iter().enumerate() {
        for column in places.iter().map(|&place| group.column(place)) {
            let codec = column.compression();
            if !matches!(codec, Compression::UNCOMPRESSED | Compression::SNAPPY) {
                return Err(format!(
                    "it is compressed with {codec}; none and SNAPPY are read here"
                ));
            }
            if column.column_descr().max_rep_level() > 0
                || column.column_descr().max_def_level() > 1
            {
                return Err(format!("its column '{}' is no list of values", column.column_path()));
            }
        }
        let sha256 = hash(&mut file, group, &places)?;
        let length = u64::try_from(group.num_rows()).unwrap_or(0);
        slices.extend((0..length).step_by(rows as usize).map(|skip| GroupSlice {
            rows: rows.min(length - skip),
            group: number,
            skip,
            sha256: sha256.clone(),
        }));
    }
    Ok(slices)
}

/// The rows of a piece whose first row is the one of the file with this number, from 0; and their numbers, from 1.
pub(super) fn read(
    path: &Path,
    slice: &GroupSlice,
    first: u64,
    weight: SelfWeight,
) -> Result<(Vec<u64>, Listed), String> {
    let mut file = File::open(path).map_err(|error| reason(&error))?;
    let reader = SerializedFileReader::new(file.try_clone().map_err(|error| reason(&error))?);
    let reader = reader.map_err(|_| CHANGED.to_owned())?;
    let (columns, places) = columns(&header(&reader))?;
    let Some(group) = reader.metadata().row_groups().get(slice.group) else {
        return Err(CHANGED.into());
    };
    if hash(&mut file, group, &places)? != slice.sha256 {
        return Err(CHANGED.into());
    }
    let file = Arc::new(file);
    let read = |place: &usize| texts((&file, group, group.column(*place)), slice);
    let texts = places.iter().map(read).collect::<Result<Vec<_>, _>>().map_err(failed)?;
    let reader = Reader { columns, weight, doubles: false, spelling: Spelling::default() };
    let mut listed = Listed::default();
    for row in 0..slice.rows as usize {
        let cells: Cells = texts.iter().map(|column| Some(column[row].clone())).collect();
        listed.push_row(&reader, &cells);
    }
    Ok(((first + 1..=first + slice.rows).collect(), listed))
}

/// The cells of a column as exact texts; empty where there is none.
fn texts(of: Of, slice: &GroupSlice) -> Result<Vec<String>, ParquetError> {
    let how = (slice, of.2.column_descr().max_def_level() > 0);
    match of.2.column_type() {
        Type::DOUBLE => cells::<DoubleType>(reads(of)?, how, |x| exact(*x)),
        Type::FLOAT => cells::<FloatType>(reads(of)?, how, |x| exact(f64::from(*x))),
        Type::INT32 => cells::<Int32Type>(reads(of)?, how, ToString::to_string),
        Type::INT64 => cells::<Int64Type>(reads(of)?, how, ToString::to_string),
        Type::BYTE_ARRAY => cells::<ByteArrayType>(reads(of)?, how, |text| {
            String::from_utf8_lossy(text.data()).trim().to_owned()
        }),
        _ => Err(ParquetError::General("a column is neither of numbers nor of texts".into())),
    }
}

/// A double as the number that it is.
fn exact(x: f64) -> String {
    match Rational::from_f64(x) {
        Some(x) => ExactNumber::from(&x).to_string(),
        None => x.to_string(),
    }
}

fn cells<T: DataType>(
    mut column: ColumnReaderImpl<T>,
    (slice, is_optional): (&GroupSlice, bool),
    text: impl Fn(&T::T) -> String,
) -> Result<Vec<String>, ParquetError> {
    let (skip, rows) = (slice.skip as usize, slice.rows as usize);
    let (mut values, mut there) = (Vec::new(), Vec::new());
    let skipped = column.skip_records(skip)?;
    let levels = is_optional.then_some(&mut there);
    let (read, ..) = column.read_records(rows, levels, None, &mut values)?;
    if skipped != skip || read != rows {
        return Err(ParquetError::General("rows are missing".into()));
    }
    let mut values = values.iter().map(text);
    Ok(match is_optional {
        true => {
            let mut cell = |level: i16| if level > 0 { values.next() } else { None };
            there.into_iter().map(|level| cell(level).unwrap_or_default()).collect()
        }
        false => values.collect(),
    })
}
