//! The rows of a file that is read: of a table, or of JSON.

use super::columns::Columns;
use super::csv::TextTable;
use super::json::objects;
use super::keep::{Keep, ReadRow};
use super::source::{Input, Numbered, Syntax};
use super::spelling::Spelling;
use crate::failure::Failure;

/// Rows of a file, of a table or of JSON.
pub struct GivenRows {
    /// Columns that are read.
    pub columns: Columns,
    /// Spelling of the numbers.
    pub spelling: Spelling,
    /// The names of what is handed on, where the rows are those of a table.
    pub kept: Vec<String>,
    /// The rows.
    pub rows: Box<dyn Iterator<Item = Numbered<ReadRow>> + Send>,
}

impl GivenRows {
    /// Rows of a file in a syntax; `in_lines` tells whether the output has an object on each line.
    pub fn new(
        (syntax, input): (Syntax, Input),
        mut columns: Columns,
        keep: Keep,
        in_lines: bool,
    ) -> Result<Self, Failure> {
        if let Syntax::Json = syntax {
            // Each row has keys of its own.
            let (kept, read) = (keep.names(in_lines)?, columns.clone());
            let rows = objects(input, move |object| {
                Ok(ReadRow { cells: read.cells(object)?, kept: keep.entries(object, &read) })
            });
            return Ok(Self { columns, spelling: Spelling::default(), kept, rows: Box::new(rows) });
        }
        let table = TextTable::open(input)?;
        let kept = keep.places(&table.header, &columns)?;
        let places = columns.places(&table.header)?;
        let spelling = Spelling { decimal_comma: table.has_decimal_commas() };
        let names = kept.iter().map(|(name, _)| name.clone()).collect();
        let read = move |row: Vec<String>| Keep::row(&row, &places, &kept);
        let rows = Box::new(table.map(move |(line, row)| (line, row.map(&read))));
        Ok(Self { columns, spelling, kept: names, rows })
    }
}
