//! `couplet states`.

use super::Failure;
use super::arch::{angle, friction, thickness};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, Arch};
use crate::number::ExactNumber;
#[cfg(feature = "parquet")]
use crate::report::export::{Export, ParquetRows, Subject};
use crate::report::{Answered, AssessReport, Rows, StateOf, StateReport};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::Deserialize;
use serde_json::value::RawValue;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::time::Duration;

/// Read queries from standard input, one a row, and write their states in the same order.
///
/// The input is CSV with a header (columns weight, half_opening, friction and, to assess an arch of a
/// given thickness, thickness) or JSON lines with the same keys. Values are exact text, as for `state`.
/// A bad row becomes a row with its error and the number of its line; the rest goes on. What is
/// written stays written if the run is interrupted, except in a parquet file, which ends with what makes
/// it readable.
///
/// The format parquet, where couplet is built with that feature, has one row for each value: the query,
/// mode, quantity, the value as text with its bounds, the nearest double with its bounds.
#[derive(Args)]
pub struct Arguments {
    /// Significant digits, 1 to 10000. With 17 each state also has the nearest double of its values,
    /// in decimal and in hexadecimal.
    #[arg(long, default_value = "17", value_parser = super::state_digits, allow_negative_numbers = true)]
    digits: usize,

    /// Output format, csv, jsonl or parquet; that of the input if not given.
    #[arg(long, value_parser = format)]
    format: Option<RowFormat>,
}

#[derive(Clone, Copy, PartialEq)]
enum RowFormat {
    Csv,
    JsonLines,
    #[cfg(feature = "parquet")]
    Parquet,
}

fn format(text: &str) -> Result<RowFormat, String> {
    match text {
        "csv" => Ok(RowFormat::Csv),
        "jsonl" => Ok(RowFormat::JsonLines),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(RowFormat::Parquet),
        #[cfg(not(feature = "parquet"))]
        "parquet" => Err(super::NO_PARQUET.into()),
        _ => Err("a format is one of csv, jsonl, parquet".into()),
    }
}

/// Rows that are read, computed on all cores, and written before the next are read.
const CHUNK: usize = 2048;

/// A query as it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Query {
    weight: String,
    half_opening: String,
    friction: String,
    thickness: Option<String>,
}

/// A line of the input: its number, and the query or what is wrong with it.
type Line = (u64, Result<Query, String>);

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    #[cfg(feature = "parquet")]
    if arguments.format == Some(RowFormat::Parquet) {
        super::output::not_a_terminal()?;
    }
    let mut input = BufReader::new(io::stdin());
    let json_in = first_character(&mut input).map_err(reading)? == Some(b'{');
    let bar = bar();
    let counted = bar.wrap_read(input);
    let (lines, thickness): (Box<dyn Iterator<Item = Line>>, bool) = if json_in {
        let mut lines = json_lines(counted).peekable();
        // One shape of output for all: that of the first query.
        let first = lines.peek().and_then(|(_, query)| query.as_ref().ok());
        let thickness = first.is_some_and(|query| query.thickness.is_some());
        (Box::new(lines), thickness)
    } else {
        csv_lines(counted)?
    };
    let given = if json_in { RowFormat::JsonLines } else { RowFormat::Csv };
    let format = arguments.format.unwrap_or(given);
    let json = format == RowFormat::JsonLines;
    let rows = Rows { json, thickness, doubles: arguments.digits == 17 };
    let (out, tally) = (io::stdout().lock(), Tally::default());
    let mut run = Run { lines, digits: arguments.digits, rows, bar, tally, out };
    let all = match format {
        RowFormat::Csv | RowFormat::JsonLines => run.text()?,
        #[cfg(feature = "parquet")]
        RowFormat::Parquet => run.parquet()?,
    };
    if !all {
        return Ok(());
    }
    run.bar.finish_and_clear();
    run.tally.verdict()
}

/// What goes on from chunk to chunk. A method says whether the reader still listens.
struct Run<'a> {
    lines: Box<dyn Iterator<Item = Line>>,
    digits: usize,
    rows: Rows,
    bar: ProgressBar,
    tally: Tally,
    out: io::StdoutLock<'a>,
}

impl Run<'_> {
    fn text(&mut self) -> Result<bool, Failure> {
        let rows = self.rows;
        Ok(self.put(rows.header())?
            && self.chunks(
                |line, answer| rows.row(line, answer),
                |chunk| chunk.into_iter().collect::<io::Result<Vec<_>>>().map(|rows| rows.concat()),
            )?)
    }

    #[cfg(feature = "parquet")]
    fn parquet(&mut self) -> Result<bool, Failure> {
        let export = Export {
            title: "States of circular masonry arches of finite friction",
            schema: "couplet.states/1",
            digits: self.digits,
            subjects: Vec::new(),
        };
        let unwritten = |error: io::Error| Failure::Io(error.to_string());
        let mut file = ParquetRows::new(&export).map_err(unwritten)?;
        let row = |line, answer: &Answered| match answer {
            Answered::State(report) => Subject::state(line, report),
            Answered::Assessment(report) => Subject::assessment(line, report),
            Answered::Error(line, error) => Subject::refused(*line, error),
        };
        Ok(self.chunks(row, |subjects| file.group(&subjects))? && self.put(file.end())?)
    }

    /// Computes chunk after chunk on all cores, and writes each before the next is read.
    fn chunks<T: Send>(
        &mut self,
        row: impl Fn(u64, &Answered) -> T + Sync,
        mut bytes: impl FnMut(Vec<T>) -> io::Result<Vec<u8>>,
    ) -> Result<bool, Failure> {
        let (digits, rows) = (self.digits, self.rows);
        loop {
            let chunk: Vec<Line> = self.lines.by_ref().take(CHUNK).collect();
            if chunk.is_empty() {
                return Ok(true);
            }
            self.tally.rows += chunk.len() as u64;
            let (answers, outcomes): (Vec<T>, Vec<Tally>) = chunk
                .into_par_iter()
                .map(|(line, query)| answer(line, query, digits, &rows, &row))
                .unzip();
            outcomes.iter().for_each(|outcome| self.tally.add(outcome));
            if !self.put(bytes(answers))? {
                return Ok(false);
            }
            let rate = self.tally.rows as f64 / self.bar.elapsed().as_secs_f64().max(1e-3);
            self.bar.set_message(format!("{} rows, {rate:.0} rows/s", self.tally.rows));
        }
    }

    fn put(&mut self, bytes: io::Result<Vec<u8>>) -> Result<bool, Failure> {
        let put = |bytes: Vec<u8>| self.out.write_all(&bytes).and_then(|()| self.out.flush());
        match bytes.and_then(put) {
            Ok(()) => Ok(true),
            // The reader has what it wanted.
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
            Err(error) => Err(Failure::Io(format!("cannot write to standard output: {error}"))),
        }
    }
}

/// How many rows were bad, and how many undecided.
#[derive(Default)]
struct Tally {
    rows: u64,
    bad: u64,
    undecided: u64,
}

impl Tally {
    fn add(&mut self, other: &Self) {
        self.bad += other.bad;
        self.undecided += other.undecided;
    }

    fn verdict(&self) -> Result<(), Failure> {
        match (self.bad, self.undecided) {
            (0, 0) => Ok(()),
            (0, undecided) => {
                Err(Failure::Undecided(format!("{undecided} of {} rows are undecided", self.rows)))
            }
            (bad, _) => Err(Failure::Input(format!(
                "{bad} of {} rows could not be read; see their errors",
                self.rows
            ))),
        }
    }
}

fn answer<T>(
    line: u64,
    query: Result<Query, String>,
    digits: usize,
    rows: &Rows,
    row: &impl Fn(u64, &Answered) -> T,
) -> (T, Tally) {
    let read = query.and_then(|query| {
        let arch = arch(&query)?;
        let thickness = match query.thickness.as_deref().filter(|_| rows.thickness) {
            Some(text) => Some((thickness(text)?, text.to_owned())),
            None if rows.thickness => return Err("the thickness is missing".into()),
            None => None,
        };
        Ok((query, arch, thickness))
    });
    let (query, arch, thickness): (Query, Arch, Option<(ExactNumber, String)>) = match read {
        Ok(read) => read,
        Err(error) => {
            let error = Answered::Error(line, error);
            return (row(line, &error), Tally { bad: 1, ..Tally::default() });
        }
    };
    let (weight, half_opening, friction) = (arch.weight(), query.half_opening, query.friction);
    let doubles = rows.doubles;
    let undecided = |undecided: bool| Tally { undecided: u64::from(undecided), ..Tally::default() };
    if let Some((eta, thickness)) = thickness {
        let outcome = arch.certify_thickness(&eta, digits);
        let report =
            AssessReport { weight, half_opening, friction, thickness, doubles, outcome: &outcome };
        return (row(line, &Answered::Assessment(report)), undecided(outcome.is_err()));
    }
    let found = arch.certify(digits);
    let outcome = match &found {
        Ok(Answer::Stands(state)) => StateOf::Stands(state),
        Ok(Answer::Falls(fall)) => StateOf::Falls(*fall),
        Err(doubt) => StateOf::Undecided(doubt),
    };
    let report = StateReport { weight, half_opening, friction, doubles, outcome };
    (row(line, &Answered::State(report)), undecided(found.is_err()))
}

fn arch(query: &Query) -> Result<Arch, String> {
    let weight: SelfWeight = super::weight(&query.weight)?;
    let friction = friction(&query.friction)?;
    Arch::new(weight, angle(&query.half_opening)?, friction).map_err(|error| error.to_string())
}

fn reading(error: io::Error) -> Failure {
    Failure::Io(format!("cannot read standard input: {error}"))
}

/// The first character that is no white space, which is left unread.
fn first_character(input: &mut impl BufRead) -> io::Result<Option<u8>> {
    loop {
        let buffer = input.fill_buf()?;
        if buffer.is_empty() {
            return Ok(None);
        }
        match buffer.iter().position(|c| !c.is_ascii_whitespace()) {
            Some(place) => return Ok(Some(buffer[place])),
            None => {
                let length = buffer.len();
                input.consume(length);
            }
        }
    }
}

/// Lines longer than this are refused one by one; nothing that is read needs as much.
const MAX_LINE: u64 = 1 << 17;

/// The queries of JSON lines. Numbers are taken as they are written.
fn json_lines(input: impl Read) -> impl Iterator<Item = Line> {
    let mut input = BufReader::new(input);
    let mut number = 0;
    std::iter::from_fn(move || {
        loop {
            let mut bytes = Vec::new();
            number += 1;
            let read = input.by_ref().take(MAX_LINE).read_until(b'\n', &mut bytes);
            match read {
                Ok(0) => return None,
                Err(error) => return Some((number, Err(error.to_string()))),
                Ok(_) if bytes.len() as u64 == MAX_LINE && bytes.last() != Some(&b'\n') => {
                    // The rest of the line is skipped in pieces, never held.
                    skip_line(&mut input);
                    return Some((number, Err(format!("a line of more than {MAX_LINE} bytes"))));
                }
                Ok(_) if bytes.iter().all(u8::is_ascii_whitespace) => {}
                Ok(_) => return Some((number, json_query(&bytes))),
            }
        }
    })
}

fn skip_line(input: &mut impl BufRead) {
    while let Ok(buffer) = input.fill_buf() {
        if buffer.is_empty() {
            return;
        }
        let (length, ends) = match buffer.iter().position(|&c| c == b'\n') {
            Some(place) => (place + 1, true),
            None => (buffer.len(), false),
        };
        input.consume(length);
        if ends {
            return;
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JsonQuery<'a> {
    weight: String,
    #[serde(borrow, alias = "alpha")]
    half_opening: &'a RawValue,
    #[serde(borrow, alias = "mu")]
    friction: &'a RawValue,
    #[serde(borrow)]
    thickness: Option<&'a RawValue>,
}

fn json_query(bytes: &[u8]) -> Result<Query, String> {
    let read: JsonQuery = serde_json::from_slice(bytes).map_err(|error| error.to_string())?;
    let text = |raw: &RawValue| {
        serde_json::from_str::<String>(raw.get()).unwrap_or_else(|_| raw.get().to_owned())
    };
    Ok(Query {
        weight: read.weight,
        half_opening: text(read.half_opening),
        friction: text(read.friction),
        thickness: read.thickness.map(text),
    })
}

/// The queries of a CSV file, and whether it has a column for the thickness.
fn csv_lines(
    input: impl Read + 'static,
) -> Result<(Box<dyn Iterator<Item = Line>>, bool), Failure> {
    let mut reader =
        csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(input);
    let headers = reader.headers().map_err(|error| Failure::Input(error.to_string()))?.clone();
    let column = |names: &[&str]| headers.iter().position(|header| names.contains(&header));
    let required = |names: &[&str]| {
        column(names).ok_or_else(|| {
            Failure::Input(format!(
                "the input has no column '{}'; it needs weight, half_opening, friction",
                names[0]
            ))
        })
    };
    let (weight, half_opening, friction) = (
        required(&["weight"])?,
        required(&["half_opening", "alpha"])?,
        required(&["friction", "mu"])?,
    );
    let thickness = column(&["thickness", "eta"]);
    let lines = reader.into_records().map(move |record| match record {
        Err(error) => {
            let line = error.position().map_or(0, csv::Position::line);
            (line, Err(error.to_string()))
        }
        Ok(record) => {
            let line = record.position().map_or(0, csv::Position::line);
            let field = |place: usize| record.get(place).map(str::to_owned);
            let query = match (field(weight), field(half_opening), field(friction)) {
                (Some(weight), Some(half_opening), Some(friction)) => Ok(Query {
                    weight,
                    half_opening,
                    friction,
                    thickness: thickness.and_then(field),
                }),
                _ => Err(format!("{} columns are too few", record.len())),
            };
            (line, query)
        }
    });
    Ok((Box::new(lines), thickness.is_some()))
}

/// A bar with rate and time left, by the bytes read; hidden where standard error is no terminal.
fn bar() -> ProgressBar {
    let length = std::fs::metadata("/dev/stdin").ok().filter(|m| m.is_file()).map(|m| m.len());
    let (bar, template) = match length {
        Some(length) => (
            ProgressBar::new(length),
            "{spinner} {bar:40} {percent:>3}%  {msg}, {elapsed} elapsed, about {eta} left",
        ),
        None => (ProgressBar::new_spinner(), "{spinner} {msg}, {elapsed} elapsed"),
    };
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
