//! Pieces of a Parquet file: rows of its row groups.

use super::column::{ColumnOf, cells, has_its_rows};
use super::cost::MAX_PARTS;
use super::kind::ValueKind;
use super::pieces::{CHANGED, columns, hash_of_pieces};
use super::query::Listed;
use crate::arch::SelfWeight;
use crate::check::reason;
use crate::number::ExactNumber;
use crate::rows::{ArchReader, Cells, Spelling};
use crate::scene::hash_of;
use ::parquet::basic::{Compression, Type};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType, FloatType, Int32Type, Int64Type};
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
    /// Hash of the columns of the group that are read, with their names and types.
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
        told += &format!("\n{name} {stored} {:?}", ValueKind::of(column.column_descr())?);
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
    places.iter().try_for_each(|&place| ValueKind::of(&schema.column(place)).map(drop))?;
    let pages = Arc::new(file.try_clone().map_err(|error| reason(&error))?);
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
        for &place in &places {
            let of = (&pages, group, group.column(place));
            if !has_its_rows(of).map_err(failed)? {
                let name = group.column(place).column_path().string();
                return Err(format!("its column '{name}' has not as many values as it says rows"));
            }
        }
        let sha256 = hash(&mut file, group, &places)?;
        let length = u64::try_from(group.num_rows()).unwrap_or(0);
        if length.div_ceil(rows) + slices.len() as u64 > MAX_PARTS {
            return Err(format!("it has more than {MAX_PARTS} parts; give a larger chunk"));
        }
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
    let reader = ArchReader { columns, weight, doubles: false, spelling: Spelling::default() };
    let mut listed = Listed::default();
    for row in 0..slice.rows as usize {
        let cells: Cells = texts.iter().map(|column| Some(column[row].clone())).collect();
        listed.push_row(&reader, &cells);
    }
    Ok(((first + 1..=first + slice.rows).collect(), listed))
}

/// Bytes of a text that are usual, and of all texts of a piece that are held whatever its rows: many rows may name
/// one long text, and be few bytes of a file.
const USUAL_TEXT: u64 = 512;
const TEXTS: u64 = 64 << 20;

/// Checks that texts are short enough to be held, one for each row that has one.
fn fit(texts: &[Option<ByteArray>]) -> Result<(), ParquetError> {
    let lengths = || texts.iter().flatten().map(|text| text.len() as u64);
    let (rows, bytes) = (lengths().count(), lengths().sum::<u64>());
    match bytes <= TEXTS.max(USUAL_TEXT * rows as u64) {
        true => Ok(()),
        false => Err(ParquetError::General(format!(
            "{rows} rows have {} MiB of text in a column; give a smaller chunk",
            bytes >> 20
        ))),
    }
}

/// The cells of a column as exact texts; empty where there is none.
fn texts(of: ColumnOf, slice: &GroupSlice) -> Result<Vec<String>, ParquetError> {
    let rows = slice.skip as usize..(slice.skip + slice.rows) as usize;
    let kind = ValueKind::of(of.2.column_descr()).map_err(ParquetError::General)?;
    Ok(match of.2.column_type() {
        Type::DOUBLE => written(&cells::<DoubleType>(of, rows)?, |x| exact(*x)),
        Type::FLOAT => written(&cells::<FloatType>(of, rows)?, |x| exact(f64::from(*x))),
        Type::INT32 => written(&cells::<Int32Type>(of, rows)?, |x| {
            kind.whole(i64::from(*x), u64::from(x.cast_unsigned()))
        }),
        Type::INT64 => {
            written(&cells::<Int64Type>(of, rows)?, |x| kind.whole(*x, x.cast_unsigned()))
        }
        Type::BYTE_ARRAY => {
            let texts = cells::<ByteArrayType>(of, rows)?;
            fit(&texts)?;
            written(&texts, |text| String::from_utf8_lossy(text.data()).trim().to_owned())
        }
        _ => {
            let message = "a column is neither of numbers nor of texts";
            return Err(ParquetError::General(message.into()));
        }
    })
}

/// A double as the number that it is.
fn exact(x: f64) -> String {
    match Rational::from_f64(x) {
        Some(x) => ExactNumber::from(&x).to_string(),
        None => x.to_string(),
    }
}

/// The texts of cells; empty where there is no value.
fn written<T>(cells: &[Option<T>], text: impl Fn(&T) -> String) -> Vec<String> {
    cells.iter().map(|cell| cell.as_ref().map(&text).unwrap_or_default()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::parquet::data_type::DataType;
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

    /// A number of a footer: twice itself without a sign, seven bits at a time.
    fn number(mut value: u64) -> Vec<u8> {
        value <<= 1;
        let mut bytes = Vec::new();
        while value > 127 {
            bytes.push(value as u8 | 128);
            value >>= 7;
        }
        bytes.push(value as u8);
        bytes
    }

    /// A Parquet file of `rows` rows whose footer says `said`, in as many bytes, wherever it says how many there are.
    fn says(rows: u64, said: u64) -> NamedTempFile {
        let file = NamedTempFile::new().unwrap();
        let schema = "message m { required double half_opening; required double friction; }";
        let schema = Arc::new(parse_message_type(schema).unwrap());
        let properties = ::parquet::file::properties::WriterProperties::builder()
            .set_statistics_enabled(::parquet::file::properties::EnabledStatistics::None)
            .build();
        let mut writer =
            SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
        let mut group = writer.next_row_group().unwrap();
        while let Some(mut column) = group.next_column().unwrap() {
            let ones = vec![1.0; rows as usize];
            column.typed::<DoubleType>().write_batch(&ones, None, None).unwrap();
            column.close().unwrap();
        }
        group.close().unwrap();
        let bytes = writer.into_inner().unwrap();
        let length = u32::from_le_bytes(bytes[bytes.len() - 8..][..4].try_into().unwrap());
        let (pages, footer) = bytes.split_at(bytes.len() - 8 - length as usize);
        let (rows, said) = (number(rows), number(said));
        let mut bent = footer[..footer.len() - 8].to_vec();
        let mut changed = 0;
        for place in (0..=bent.len() - rows.len()).rev() {
            if bent[place..].starts_with(&rows) {
                bent.splice(place..place + rows.len(), said.iter().copied());
                changed += 1;
            }
        }
        // Of each column, of the group, and of the file.
        assert!(rows == said || changed == 4, "{changed}");
        let length = (bent.len() as u32).to_le_bytes();
        std::fs::write(file.path(), [pages, &bent, &length, b"PAR1"].concat()).unwrap();
        file
    }

    #[test]
    fn a_footer_is_not_believed_how_many_rows_there_are() {
        let rows = 123_456;
        assert_eq!(slices(says(rows, rows).path(), 1_000).unwrap().len(), 124);
        for said in [rows - 1, rows + 1, 1_000_000_000_000, 1 << 62] {
            let error = slices(says(rows, said).path(), 1_000).unwrap_err();
            assert_eq!(error, "its column 'half_opening' has not as many values as it says rows");
        }
        let error = slices(says(1_000_001, 1_000_001).path(), 1).unwrap_err();
        assert_eq!(error, "it has more than 1000000 parts; give a larger chunk");
    }

    #[test]
    fn a_long_text_that_many_rows_name_is_not_unfolded() {
        let text = |length| Some(ByteArray::from(vec![b'1'; length]));
        let many = |length, rows| vec![text(length); rows];
        assert!(fit(&many(17, 1_000)).is_ok() && fit(&many(10_000, 1_000)).is_ok());
        let long = text(19_000);
        let error = fit(&vec![long; 130_000]).unwrap_err().to_string();
        assert!(
            error.ends_with("130000 rows have 2355 MiB of text in a column; give a smaller chunk"),
            "{error}"
        );
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
