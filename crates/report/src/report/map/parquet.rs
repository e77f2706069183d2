//! Parquet: a row for each node, in one group.

use super::Map;
use super::rows::{COLUMNS, Column, MapRow};
use crate::report::answers::TOOL;
use ::parquet::basic::Compression;
use ::parquet::column::writer::ColumnWriter;
use ::parquet::data_type::ByteArray;
use ::parquet::errors::Result;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::parser::parse_message_type;
use std::io;
use std::sync::Arc;

pub(in crate::report) fn parquet(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let rows = MapRow::of_map(report);
    out.write_all(&file(report, &rows).map_err(io::Error::other)?)
}

fn file(report: &Map, rows: &[MapRow]) -> Result<Vec<u8>> {
    let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
    let notes = vec![
        note("couplet.schema", "couplet.map/1".to_owned()),
        note("couplet.tool", TOOL.to_owned()),
        note("couplet.tolerance", format!("{:?}", report.tolerance)),
    ];
    let properties = WriterProperties::builder()
        .set_compression(Compression::UNCOMPRESSED)
        .set_created_by(TOOL.to_owned())
        .set_key_value_metadata(Some(notes))
        .build();
    let columns = COLUMNS.iter().map(|(name, column)| match column {
        Column::Text(_) => format!("optional binary {name} (STRING);"),
        Column::Double(_) => format!("optional double {name};"),
        Column::Integer(_) => format!("optional int64 {name};"),
        Column::Truth(_) => format!("optional boolean {name};"),
    });
    let schema =
        parse_message_type(&format!("message couplet {{ {} }}", columns.collect::<String>()))?;
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for (_, column) in &COLUMNS {
        let Some(mut written) = group.next_column()? else { break };
        match (column, written.untyped()) {
            (Column::Text(cell), ColumnWriter::ByteArrayColumnWriter(writer)) => {
                let (values, there) =
                    present(rows, |row| cell(row).map(|x| ByteArray::from(&x[..])));
                writer.write_batch(&values, Some(&there), None)?
            }
            (Column::Double(cell), ColumnWriter::DoubleColumnWriter(writer)) => {
                let (values, there) = present(rows, cell);
                writer.write_batch(&values, Some(&there), None)?
            }
            (Column::Integer(cell), ColumnWriter::Int64ColumnWriter(writer)) => {
                let (values, there) = present(rows, |row| i64::try_from(cell(row)?).ok());
                writer.write_batch(&values, Some(&there), None)?
            }
            (Column::Truth(cell), ColumnWriter::BoolColumnWriter(writer)) => {
                let (values, there) = present(rows, cell);
                writer.write_batch(&values, Some(&there), None)?
            }
            // The schema is made of the same list.
            _ => unreachable!(),
        };
        written.close()?;
    }
    group.close()?;
    writer.into_inner()
}

/// The cells that are there, and for each row whether it has one.
fn present<'a, T>(
    rows: &[MapRow<'a>],
    cell: impl Fn(&MapRow<'a>) -> Option<T>,
) -> (Vec<T>, Vec<i16>) {
    let (mut values, mut there) = (Vec::new(), Vec::new());
    for cell in rows.iter().map(cell) {
        there.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    (values, there)
}
