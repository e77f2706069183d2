//! `couplet states`.

use super::Failure;
use super::arch::{angle, friction, thickness};
use super::rows::{Kind, Line, Progress, Source, csv_records, in_order, json_error, json_lines};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, Certify};
use crate::number::ExactNumber;
use crate::problem::Arch;
#[cfg(feature = "parquet")]
use crate::report::export::{Export, ParquetRows, Subject};
use crate::report::{Answered, AssessReport, Rows, StateOf, StateReport};
use clap::Args;
use serde::Deserialize;
use serde_json::value::RawValue;
use std::io::{self, Read, Write};

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

/// A query as it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Query {
    weight: String,
    half_opening: String,
    friction: String,
    thickness: Option<String>,
}

type Queries = Box<dyn Iterator<Item = Line<Query>>>;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    #[cfg(feature = "parquet")]
    if arguments.format == Some(RowFormat::Parquet) {
        super::output::not_a_terminal()?;
    }
    let source = Source::open(None)?;
    let progress = Progress::new(&source);
    let json_in = source.kind == Kind::JsonLines;
    let input = progress.counted(source.into_reader());
    let (lines, thickness): (Queries, bool) = if json_in {
        let mut lines = json_lines(input, json_query).peekable();
        // One shape of output for all: that of the first query.
        let first = lines.peek().and_then(|(_, query)| query.as_ref().ok());
        let thickness = first.is_some_and(|query| query.thickness.is_some());
        (Box::new(lines), thickness)
    } else {
        csv_lines(input)?
    };
    let given = if json_in { RowFormat::JsonLines } else { RowFormat::Csv };
    let format = arguments.format.unwrap_or(given);
    let json = format == RowFormat::JsonLines;
    let rows = Rows { json, thickness, doubles: arguments.digits == 17 };
    let (out, tally) = (io::stdout().lock(), Tally::default());
    let mut run = Run { lines: Some(lines), digits: arguments.digits, rows, progress, tally, out };
    let all = match format {
        RowFormat::Csv | RowFormat::JsonLines => run.text()?,
        #[cfg(feature = "parquet")]
        RowFormat::Parquet => run.parquet()?,
    };
    if all { run.tally.verdict() } else { Ok(()) }
}

/// What goes on from chunk to chunk. A method says whether the reader still listens.
struct Run<'a> {
    lines: Option<Queries>,
    digits: usize,
    rows: Rows,
    progress: Progress,
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
        let (digits, rows, mut listens) = (self.digits, self.rows, true);
        let lines = self.lines.take().into_iter().flatten();
        let Self { progress, tally, out, .. } = self;
        tally.rows = in_order(
            lines,
            progress,
            |(line, query)| answer(line, query, digits, &rows, &row),
            |answers| {
                let (answers, outcomes): (Vec<T>, Vec<Tally>) = answers.into_iter().unzip();
                outcomes.iter().for_each(|outcome| tally.add(outcome));
                listens = put(out, bytes(answers))?;
                Ok::<_, Failure>(listens)
            },
        )?;
        Ok(listens)
    }

    fn put(&mut self, bytes: io::Result<Vec<u8>>) -> Result<bool, Failure> {
        put(&mut self.out, bytes)
    }
}

/// Writes; `false` if the reader has closed the pipe: it has what it wanted.
fn put(out: &mut impl Write, bytes: io::Result<Vec<u8>>) -> Result<bool, Failure> {
    match bytes.and_then(|bytes| out.write_all(&bytes).and_then(|()| out.flush())) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(Failure::writing("to standard output", &error)),
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

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JsonQuery<'a> {
    weight: String,
    #[serde(borrow, alias = "alpha")]
    half_opening: &'a RawValue,
    #[serde(borrow, alias = "mu")]
    friction: &'a RawValue,
    #[serde(borrow, alias = "eta")]
    thickness: Option<&'a RawValue>,
}

fn json_query(bytes: &[u8]) -> Result<Query, String> {
    let read: JsonQuery =
        serde_json::from_slice(bytes).map_err(|error| json_error(bytes, &error))?;
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
fn csv_lines(input: impl Read + 'static) -> Result<(Queries, bool), Failure> {
    let (header, records) = csv_records(input)?;
    let column = |names: &[&str]| header.iter().position(|name| names.contains(&name));
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
    let query = move |record: csv::StringRecord| {
        let field = |place: usize| record.get(place).map(str::to_owned);
        match (field(weight), field(half_opening), field(friction)) {
            (Some(weight), Some(half_opening), Some(friction)) => {
                Ok(Query { weight, half_opening, friction, thickness: thickness.and_then(field) })
            }
            _ => Err(format!("{} columns are too few", record.len())),
        }
    };
    let lines = records.map(move |(line, record)| (line, record.and_then(&query)));
    Ok((Box::new(lines), thickness.is_some()))
}
