//! The rows of a file that is read: of a table, or of JSON.

use super::columns::Columns;
use super::csv::TextRows;
use super::json::objects;
use super::keep::{Keep, ReadRow};
use super::number_style::NumberStyle;
use super::object::JsonObject;
use super::source::{Input, Numbered, Syntax};
use crate::failure::Failure;

/// Rows of a file, of a table or of JSON.
pub struct GivenRows {
    /// Columns that are read.
    pub columns: Columns,
    /// Spelling of the numbers.
    pub spelling: NumberStyle,
    /// The names of what is handed on; of rows of JSON those that are asked for.
    pub kept: Vec<String>,
    /// The rows.
    pub rows: Box<dyn Iterator<Item = Numbered<ReadRow>> + Send>,
}

impl GivenRows {
    /// Rows of a file in a syntax; `in_lines` tells whether the output has an object on each line.
    pub fn new(
        (syntax, input): (Syntax, Input),
        columns: Columns,
        keep: Keep,
        in_lines: bool,
    ) -> Result<Self, Failure> {
        match syntax {
            Syntax::Csv => Ok(Self::of_text(TextRows::open(input)?, columns, keep)?),
            // Each row has keys of its own.
            Syntax::Json if !in_lines && keep == Keep::All => {
                Err("JSON rows have no common columns: name those to keep, --keep id,name".into())
            }
            Syntax::Json => Ok(Self::of_objects(objects(input), columns, keep)),
        }
    }

    /// Rows of a table, or why these have no such columns; or those of lines of JSON.
    pub fn of_text(mut table: TextRows, columns: Columns, keep: Keep) -> Result<Self, String> {
        if !table.is_table() {
            return Ok(Self::of_objects(table.into_bytes(), columns, keep));
        }
        let mut columns = columns.beside(keep.named());
        let kept = keep.places(&table.header, &columns)?;
        let places = columns.places(&table.header)?;
        let spelling = NumberStyle { decimal_comma: table.has_decimal_commas() };
        table.read_only(places.iter().copied().chain(kept.iter().map(|(_, place)| *place)));
        let names = kept.iter().map(|(name, _)| name.clone()).collect();
        let read = move |row: Vec<String>| Keep::row(row, &places, &kept);
        let rows = Box::new(table.map(move |(line, row)| (line, row.map(&read))));
        Ok(Self { columns, spelling, kept: names, rows })
    }

    /// Rows of JSON, an object each.
    fn of_objects(
        objects: impl Iterator<Item = Numbered<Vec<u8>>> + Send + 'static,
        columns: Columns,
        keep: Keep,
    ) -> Self {
        let kept = keep.named();
        let columns = columns.beside(kept.clone());
        let of = columns.clone();
        let read = move |bytes: Vec<u8>| {
            let object = JsonObject::parse(&bytes)?;
            Ok(ReadRow { cells: of.cells(&object)?, kept: keep.entries(&object, &of) })
        };
        let rows = Box::new(objects.map(move |(line, row)| (line, row.and_then(&read))));
        Self { columns, spelling: NumberStyle::default(), kept, rows }
    }
}
