//! Other people's results, judged: every row, or a summary of all.

mod assemblies;
mod csv;
mod json;
mod row;
mod summary;
mod words;

pub use assemblies::JudgedAssemblies;
pub use row::{JudgedColumns, JudgedRow};
pub use summary::JudgeSummary;
pub use words::verdicts;

use crate::format::{Content, Format};
use crate::record::Record;
use crate::reported::Reported;
use std::io;

/// Tells whether a format has rows as they come: CSV, and JSON lines (`couplet.judged/2`).
pub fn has_rows(format: &Format) -> bool {
    matches!(format.name, "csv" | "jsonl")
}

/// The header of rows, where they have one.
pub fn header(format: &Format, columns: JudgedColumns) -> io::Result<Vec<u8>> {
    if format.name == "csv" { csv::header(columns) } else { Ok(Vec::new()) }
}

/// A row, in a format that has rows.
pub fn row(format: &Format, row: &JudgedRow, columns: JudgedColumns) -> io::Result<Vec<u8>> {
    match format.name {
        "csv" => csv::row(row, columns),
        "jsonl" => json::row(row),
        _ => Ok(Vec::new()),
    }
}

impl Reported for JudgeSummary {
    fn content() -> Content {
        Content(&["table", "json"])
    }

    fn records(&self) -> Vec<Record> {
        let mut record = json::summary(self);
        words::say(self, &mut record);
        vec![record]
    }
}
