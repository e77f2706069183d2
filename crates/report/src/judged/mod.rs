//! Other people's results, judged: every row, or a summary of all.

mod assemblies;
mod csv;
mod json;
mod row;
mod summary;
mod words;

pub use assemblies::JudgedAssemblies;
pub use row::JudgedRow;
pub use summary::JudgeSummary;
pub use words::verdicts;

use crate::format::{Content, Format};
use crate::problem::Quantity;
use crate::record::Record;
use crate::reported::Reported;
use std::io;

/// Writes a row, with the quantities that have columns and the texts of what is handed on.
type RowWriter = fn(&JudgedRow, &[Quantity], &[String]) -> io::Result<Vec<u8>>;

/// Writers of rows as they come.
#[derive(Clone, Copy, Debug)]
pub struct JudgedLines {
    /// The header, with the quantities that have columns, and with the names of what is handed on.
    pub header: fn(&[Quantity], &[String]) -> io::Result<Vec<u8>>,
    /// One row.
    pub row: RowWriter,
}

impl JudgedLines {
    /// CSV or JSON lines (`couplet.judged/2`); no other format has rows as they come.
    pub fn of(format: &Format) -> Option<Self> {
        match format.name {
            "csv" => Some(Self { header: csv::header, row: csv::row }),
            "jsonl" => {
                Some(Self { header: |_, _| Ok(Vec::new()), row: |row, _, _| json::row(row) })
            }
            _ => None,
        }
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
