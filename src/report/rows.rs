//! Many states, one row or one line each, in the order in which they were asked.

use super::csv::{
    ASSESS_COLUMNS, STATE_COLUMNS, STATE_VALUES, assess_record, state_record, state_values,
};
use super::json::{AssessEntry, StateEntry};
use super::{AssessReport, StateReport, hexadecimal};
use serde::Serialize;
use std::io;

/// What became of one query.
pub enum Answered<'a> {
    /// A state.
    State(StateReport<'a>),
    /// A state of a given thickness.
    Assessment(AssessReport<'a>),
    /// The line of the query and what was wrong with it.
    Error(u64, String),
}

/// How rows are written.
#[derive(Clone, Copy, Debug)]
pub struct Rows {
    /// JSON lines instead of CSV.
    pub json: bool,
    /// The queries have a thickness.
    pub thickness: bool,
    /// The nearest double of each value too.
    pub doubles: bool,
}

#[derive(Serialize)]
struct ErrorEntry<'a> {
    line: u64,
    error: &'a str,
}

impl Rows {
    /// The header, where the format has one.
    pub fn header(&self) -> io::Result<Vec<u8>> {
        if self.json {
            return Ok(Vec::new());
        }
        let columns = if self.thickness { ASSESS_COLUMNS } else { STATE_COLUMNS };
        let mut record: Vec<String> = columns.iter().map(ToString::to_string).collect();
        record.extend(["line", "error"].map(str::to_owned));
        if self.doubles && !self.thickness {
            record.extend(
                STATE_VALUES.iter().flat_map(|v| [format!("{v}_double"), format!("{v}_hex")]),
            );
        }
        csv_line(&record)
    }

    /// One answer, with the line of its query.
    pub fn row(&self, line: u64, answer: &Answered) -> io::Result<Vec<u8>> {
        if self.json { self.json_row(answer) } else { self.csv_row(line, answer) }
    }

    fn json_row(&self, answer: &Answered) -> io::Result<Vec<u8>> {
        let mut text = match answer {
            Answered::State(report) => serde_json::to_vec(&StateEntry::new(report))?,
            Answered::Assessment(report) => serde_json::to_vec(&AssessEntry::new(report))?,
            Answered::Error(line, error) => serde_json::to_vec(&ErrorEntry { line: *line, error })?,
        };
        text.push(b'\n');
        Ok(text)
    }

    fn csv_row(&self, line: u64, answer: &Answered) -> io::Result<Vec<u8>> {
        let width = if self.thickness { ASSESS_COLUMNS.len() } else { STATE_COLUMNS.len() };
        let (mut record, error) = match answer {
            Answered::State(report) => (state_record(report), ""),
            Answered::Assessment(report) => (assess_record(report), ""),
            Answered::Error(_, error) => (vec![String::new(); width], error.as_str()),
        };
        record.extend([line.to_string(), error.to_owned()]);
        if self.doubles && !self.thickness {
            let values = match answer {
                Answered::State(report) => state_values(report),
                _ => [None; STATE_VALUES.len()],
            };
            record.extend(values.iter().flat_map(|value| match value {
                Some(figure) => [format!("{:?}", figure.double), hexadecimal(figure.double)],
                None => [String::new(), String::new()],
            }));
        }
        csv_line(&record)
    }
}

/// One line of CSV.
pub(super) fn csv_line(record: &[String]) -> io::Result<Vec<u8>> {
    let mut csv = ::csv::Writer::from_writer(Vec::new());
    csv.write_record(record)?;
    csv.into_inner().map_err(|error| io::Error::other(error.to_string()))
}
