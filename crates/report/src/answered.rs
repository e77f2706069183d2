//! Answers in every format: a file of code for each language, a table for a paper, rows as they come.

use super::answers::Answers;
use super::columns::Beside;
use super::csv::{CsvRows, RowsAtOnce};
use super::format::{Content, Format};
use super::json::JsonLines;
use super::paper::PaperTable;
use super::record::Record;
use super::reported::{Reported, unsupported};
use super::rows::Rows;
use super::tabular::{Separated, Tabular};
use super::{
    c, csv, fortran, json, julia, latex, matlab, parquet, plain, python, rust, table, toml,
};
use std::io;

/// Opens a file of arches that come one after the other; a table has columns beside what is asked and told.
pub fn open_rows(report: Answers, format: &Format, beside: Beside) -> io::Result<Box<dyn Rows>> {
    let rows = Vec::new();
    Ok(match format.name {
        "csv" => Box::new(CsvRows { report, beside, separated: Separated::Comma }),
        "csv2" => Box::new(CsvRows { report, beside, separated: Separated::Semicolon }),
        "latex" => Box::new(RowsAtOnce { report, beside, rows, write: PaperTable::latex }),
        "markdown" => Box::new(RowsAtOnce { report, beside, rows, write: PaperTable::markdown }),
        "jsonl" => Box::new(JsonLines(report)),
        "parquet" => parquet::rows(report)?,
        _ => return unsupported(),
    })
}

impl Reported for Answers {
    fn content() -> Content {
        Content(&[
            "table", "plain", "json", "csv", "csv2", "toml", "latex", "markdown", "c", "rust",
            "python", "julia", "matlab", "fortran", "parquet",
        ])
    }

    /// Records as JSON has them; the table for a person, in the order asked for, and the languages are of their own.
    fn records(&self) -> Vec<Record> {
        json::records(self)
    }

    fn tabular(&self) -> Tabular {
        csv::answers(self)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        let write = match format.name {
            "markdown" if self.has_row_each() => return Some(PaperTable::of(self).markdown(out)),
            "table" => table::answers,
            "plain" => plain::answers,
            "toml" => toml::answers,
            "latex" => latex::answers,
            "c" => c::answers,
            "rust" => rust::answers,
            "python" => python::answers,
            "julia" => julia::answers,
            "matlab" => matlab::answers,
            "fortran" => fortran::answers,
            "parquet" => parquet::answers,
            _ => return None,
        };
        Some(write(self, out))
    }
}
