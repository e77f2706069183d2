//! Pieces of a Parquet file: rows of its row groups.

use super::column::{Of, reader as reads};
use super::kind::Kind;
use super::pieces::{CHANGED, columns, hash_of, hash_of_pieces};
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
    /// Of the columns of the group that are read, with their names and types.
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

/// The hash of the columns of a group that are read, with their names and types: the same bytes may be other numbers.
fn hash(file: &mut File, group: &RowGroupMetaData, places: &[usize]) -> Result<String, String> {
    let columns: Vec<_> = places.iter().map(|&place| group.column(place)).collect();
    let pieces: Vec<(u64, u64)> = columns.iter().map(|column| column.byte_range()).collect();
    let mut told = hash_of_pieces(file, &pieces).map_err(|error| reason(&error))?;
    for column in columns {
        let (name, stored) = (column.column_path().string(), column.column_type());
        told += &format!("\n{name} {stored} {:?}", Kind::of(column.column_descr())?);
    }
    Ok(hash_of(told.as_bytes()))
}

/// The pieces of a file, with at most so many rows each; or what is wrong with the file.
pub(super) fn slices(path: &Path, rows: u64) -> Result<Vec<GroupSlice>, String> {
    let mut file = File::open(path).map_err(|error| reason(&error))?;
    let reader = SerializedFileReader::new(file.try_clone().map_err(|error| reason(&error))?);
    let reader = reader.map_err(failed)?;
    let (_, places) = columns(&header(&reader))?;
    let schema = reader.metadata().file_metadata().schema_descr_ptr();
    places.iter().try_for_each(|&place| Kind::of(&schema.column(place)).map(drop))?;
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
                return Err(format!(
                    "its column '{}' is no list of values",
                    column.column_path().string()
                ));
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
    let kind = Kind::of(of.2.column_descr()).map_err(ParquetError::General)?;
    match of.2.column_type() {
        Type::DOUBLE => cells::<DoubleType>(reads(of)?, how, |x| exact(*x)),
        Type::FLOAT => cells::<FloatType>(reads(of)?, how, |x| exact(f64::from(*x))),
        Type::INT32 => cells::<Int32Type>(reads(of)?, how, |x| {
            kind.whole(i64::from(*x), u64::from(x.cast_unsigned()))
        }),
        Type::INT64 => cells::<Int64Type>(reads(of)?, how, |x| kind.whole(*x, x.cast_unsigned())),
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

#[cfg(test)]
mod tests {
    use super::*;
    use ::parquet::data_type::ByteArray;
    use ::parquet::file::writer::SerializedFileWriter;
    use ::parquet::schema::parser::parse_message_type;
    use tempfile::NamedTempFile;

    /// A file with one half opening as text and one friction of a type.
    fn file<T: DataType>(friction: &str, value: T::T) -> NamedTempFile {
        let file = NamedTempFile::new().unwrap();
        let schema =
            format!("message m {{ required binary half_opening (UTF8); required {friction}; }}");
        let schema = Arc::new(parse_message_type(&schema).unwrap());
        let mut writer =
            SerializedFileWriter::new(file.reopen().unwrap(), schema, Arc::default()).unwrap();
        let mut group = writer.next_row_group().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let text = [ByteArray::from("pi/2")];
        column.typed::<ByteArrayType>().write_batch(&text, None, None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<T>().write_batch(&[value], None, None).unwrap();
        column.close().unwrap();
        group.close().unwrap();
        writer.close().unwrap();
        file
    }

    /// The friction as it is read, or what is said of the file.
    fn friction<T: DataType>(friction: &str, value: T::T) -> Result<String, String> {
        let file = file::<T>(friction, value);
        let slices = slices(file.path(), 1)?;
        let (_, listed) = read(file.path(), &slices[0], 0, SelfWeight::Heyman)?;
        Ok(String::from_utf8(listed.texts[2].of(0).to_vec()).unwrap())
    }

    #[test]
    fn whole_numbers_are_what_their_type_says() {
        for (kind, value, text) in [
            ("friction", 30, "30"),
            ("friction (DECIMAL(9,2))", 30, "0.30"),
            ("friction (DECIMAL(9,0))", 30, "30"),
            ("friction (DECIMAL(9,3))", -1234, "-1.234"),
            ("friction (INTEGER(32,true))", -1, "-1"),
            ("friction (INTEGER(32,false))", -1, "4294967295"),
            ("friction (UINT_32)", -1, "4294967295"),
        ] {
            let found = friction::<Int32Type>(&format!("int32 {kind}"), value);
            assert_eq!(found.as_deref(), Ok(text), "{kind}");
        }
        for (kind, value, text) in [
            ("friction (DECIMAL(18,18))", 1, "0.000000000000000001"),
            ("friction (INTEGER(64,false))", -1, "18446744073709551615"),
        ] {
            let found = friction::<Int64Type>(&format!("int64 {kind}"), value);
            assert_eq!(found.as_deref(), Ok(text), "{kind}");
        }
        assert_eq!(
            friction::<ByteArrayType>("binary friction", "inf".into()).as_deref(),
            Ok("inf")
        );
    }

    #[test]
    fn what_is_neither_a_number_nor_a_text_is_refused_by_its_name() {
        let refused = |found: Result<String, String>, kind: &str| {
            let said = format!("its column 'friction' is of the type {kind}; DOUBLE, FLOAT,");
            let error = found.unwrap_err();
            assert!(error.starts_with(&said), "{error}");
        };
        for (kind, name) in
            [("DATE", "DATE"), ("TIME(MILLIS,true)", "TIME"), ("TIME_MILLIS", "TIME_MILLIS")]
        {
            let kind = format!("int32 friction ({kind})");
            refused(friction::<Int32Type>(&kind, 1), &format!("{name} as INT32"));
        }
        for kind in ["TIMESTAMP(MICROS,true)", "TIMESTAMP(NANOS,false)", "TIMESTAMP_MICROS"] {
            let name = kind.split('(').next().unwrap();
            let kind = format!("int64 friction ({kind})");
            refused(friction::<Int64Type>(&kind, 1), &format!("{name} as INT64"));
        }
        for kind in ["DECIMAL(9,2)", "JSON", "BSON"] {
            let name = kind.split('(').next().unwrap();
            let kind = format!("binary friction ({kind})");
            refused(friction::<ByteArrayType>(&kind, "1".into()), &format!("{name} as BYTE_ARRAY"));
        }
        refused(friction::<::parquet::data_type::BoolType>("boolean friction", true), "BOOLEAN");
    }

    #[test]
    fn the_same_bytes_of_another_type_are_another_file() {
        let hash = |kind: &str| {
            let file = file::<Int32Type>(kind, 300);
            slices(file.path(), 1).unwrap().remove(0).sha256
        };
        let kinds = ["friction", "friction (DECIMAL(9,2))", "friction (DECIMAL(9,3))", "mu"];
        let hashes = kinds.map(|kind| hash(&format!("int32 {kind}")));
        for (place, one) in hashes.iter().enumerate() {
            assert!(!hashes[..place].contains(one), "{}", kinds[place]);
        }
    }
}
