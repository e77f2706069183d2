//! `couplet states`.

use super::arch::thickness;
use super::output::fits_standard_output;
use super::parse;
use super::rows::{Line, Progress, Source, Syntax, csv_records, in_order, json_error, json_lines};
use crate::certify::state::Certify;
use crate::cli::failure::Failure;
use crate::problem::Arch;
use crate::report::{Answer, Answers, Content, Format, Status};
use clap::Args;
use serde::Deserialize;
use serde_json::value::RawValue;
use std::io::{self, Read, Write};

/// Read queries from standard input, one a row, and write their states in the same order.
///
/// The input is CSV with a header (columns weight, half_opening, friction and, to assess an arch of a
/// given thickness, thickness) or JSON lines with the same keys. Values are exact text, as for `state`.
/// A bad row becomes a row with its error and its line number; the other rows are answered. An
/// interrupted run keeps the rows written so far, except Parquet, which is unreadable until its footer is
/// written at the end.
///
/// Parquet (needs the feature parquet) has one row for each value: the query, mode, quantity, the value as
/// text with its bounds, the nearest double with its bounds.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Significant digits, 1 to 10000. With 17 each state also has the nearest double of its values,
    /// in decimal and in hexadecimal.
    #[arg(long, default_value = "17", value_parser = parse::state_digits, allow_negative_numbers = true)]
    digits: usize,

    #[arg(
        long,
        value_parser = parse::format(Content::Rows),
        help = parse::format_help(Content::Rows) + "; that of the input if not given"
    )]
    format: Option<&'static Format>,
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

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(format) = arguments.format {
        fits_standard_output(format)?;
    }
    let source = Source::open(None)?;
    let progress = Progress::new(&source);
    let (syntax, digits) = (source.syntax, arguments.digits);
    let input = progress.counted(source.into_reader());
    let (lines, assessed): (Queries, bool) = match syntax {
        Syntax::JsonLines => {
            let mut lines = json_lines(input, json_query).peekable();
            // One shape of output for all: that of the first query.
            let first = lines.peek().and_then(|(_, query)| query.as_ref().ok());
            let assessed = first.is_some_and(|query| query.thickness.is_some());
            (Box::new(lines), assessed)
        }
        Syntax::Csv => csv_lines(input)?,
    };
    let format = arguments.format.or_else(|| Format::named(Content::Rows, syntax.format()));
    let Some(open) = format.and_then(|format| format.rows) else { return Ok(()) };
    let mut file = open(Answers::arches(digits, assessed)).map_err(unwritten)?;
    let mut out = io::stdout().lock();
    let (mut bad, mut undecided) = (0, 0);
    if !put(&mut out, file.begin())? {
        return Ok(());
    }
    let mut listens = true;
    // Computes chunk after chunk on all cores, and writes each before the next is read.
    let rows = in_order(
        lines,
        &progress,
        |(line, query)| {
            let answer = query.and_then(|query| answer(line, &query, digits, assessed));
            answer.unwrap_or_else(|error| Answer::refused(line, error))
        },
        |answers: Vec<Answer>| {
            let count =
                |is: fn(&Answer) -> bool| answers.iter().filter(|answer| is(answer)).count();
            bad += count(|answer| matches!(answer.status, Status::Refused(_)));
            undecided += count(Answer::is_undecided);
            listens = put(&mut out, file.group(&answers))?;
            Ok::<_, Failure>(listens)
        },
    )?;
    if !listens || !put(&mut out, file.end())? {
        return Ok(());
    }
    match (bad, undecided) {
        (0, 0) => Ok(()),
        (0, undecided) => {
            Err(Failure::Undecided(format!("{undecided} of {rows} rows are undecided")))
        }
        (bad, _) => {
            Err(Failure::Input(format!("{bad} of {rows} rows could not be read; see their errors")))
        }
    }
}

/// Writes; `false` if the reader has closed the pipe.
fn put(out: &mut impl Write, bytes: io::Result<Vec<u8>>) -> Result<bool, Failure> {
    match bytes.and_then(|bytes| out.write_all(&bytes).and_then(|()| out.flush())) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(unwritten(error)),
    }
}

fn unwritten(error: io::Error) -> Failure {
    Failure::writing("to standard output", &error)
}

/// The answer to a query, or its error.
fn answer(line: u64, query: &Query, digits: usize, assessed: bool) -> Result<Answer, String> {
    let arch = Arch::parse(&query.weight, &query.half_opening, &query.friction)
        .map_err(|error| error.to_string())?;
    if !assessed {
        return Ok(Answer::state(line, &arch, &arch.certify(digits)));
    }
    let eta = thickness(query.thickness.as_deref().ok_or("the thickness is missing")?)?;
    Ok(Answer::assessment(line, (&arch, &eta), &arch.certify_thickness(&eta, digits)))
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
            _ => Err(format!("too few columns: {}", record.len())),
        }
    };
    let lines = records.map(move |(line, record)| (line, record.and_then(&query)));
    Ok((Box::new(lines), thickness.is_some()))
}
