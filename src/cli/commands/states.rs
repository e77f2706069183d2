//! `couplet states`.

use super::given_rows::{GivenRows, source};
use super::output::{OutputFile, chosen};
use super::stream::{Chunk, Progress, in_order};
use crate::arch::SelfWeight;
use crate::ask::{Field, Spelling, given_thickness};
use crate::certify::Refused;
use crate::certify::batch::SharedOpenings;
use crate::certify::state::Balls;
use crate::problem::Quantity;
use crate::report::{Answer, Answers, Content, Format, Status, open_rows};
use crate::sweep::answer;
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::rows::{
    ArchReader, Cells, Columns, Keep, Numbered, Purpose, ReadRow, Role, Syntax,
};
use clap::Args;
use std::io;
use std::path::PathBuf;

/// Read queries, one a row, and write what is proved of each, in the same order.
///
/// The input is a table with a header, or JSON objects, one on each line or in an array. Its columns or keys
/// are weight, half_opening (or alpha) or span and rise, friction (or mu) or friction_angle (or phi), and
/// thickness (or eta); radius and measured_at, as for `state`.
/// A row without a thickness is answered as by `couplet state`, one with a thickness as by `couplet assess`:
/// a table with a column for the thickness has the columns of both, and the least thickness is
/// least_thickness there. Commas, semicolons, tabs or blanks separate; where semicolons do, a number may have
/// a decimal comma. `#` may begin the header (NumPy). Values are exact text, as for `state`; also
/// 0.107D+00 (Fortran), and 0x1.8p+1, which is exactly that double.
///
/// Rows of one half opening share its proofs, wherever they stand, and no digit depends on it: a grid takes a
/// fraction of the time of as many arches.
///
/// Other columns are not read, and `--keep` hands them on. A bad row becomes a row with its error and its
/// line number; the other rows are answered. Rows are answered as they come: who waits for an answer before
/// the next question gets it. An interrupted run keeps the rows written so far, except Parquet, which is
/// unreadable until its footer is written at the end.
///
/// Parquet (needs the feature parquet) has one row for each value: the query, mode, quantity, the value as
/// text with its bounds, the nearest double with its bounds.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The queries; `-` is standard input, which is read if no file is given.
    #[arg(value_name = "FILE")]
    file: Option<PathBuf>,

    /// Self-weight model of the rows that have none: heyman or milankovitch.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weight)]
    weight: SelfWeight,

    /// Significant digits, 1 to 1000000. With 17 each state also has the nearest double of its values,
    /// in decimal and in hexadecimal.
    #[arg(long, default_value = "17", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    /// The columns to read, as theirs=ours separated by commas; theirs=ours:deg for an angle in degrees; just the
    /// name if both are the same. The default is our own names.
    #[arg(long, value_delimiter = ',', value_name = "THEIRS=OURS,…")]
    columns: Vec<String>,

    /// Columns or keys of the input that are handed on to the output, or `all` that are not read. One
    /// whose name the output has for itself is called input_NAME there; JSON has them in `kept`.
    #[arg(long, value_delimiter = ',', value_name = "NAME,…")]
    keep: Vec<String>,

    /// Only these quantities (thickness, thrust, …), with commas between several. Without a
    /// friction among them the frictions at which the mode changes are not proved, which saves time.
    #[arg(
        long = "quantity", alias = "quantities", value_name = "NAME", value_delimiter = ',',
        value_parser = parse::quantity
    )]
    quantities: Vec<Quantity>,

    #[arg(
        long,
        value_parser = parse::format(Content::ROWS),
        help = parse::format_help(Content::ROWS) + "; if not given what the name of the file ends with tells it, else \
            that of the input"
    )]
    format: Option<&'static Format>,

    #[command(flatten)]
    output: OutputFile,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let source = source(arguments.file.as_deref(), &arguments.output)?;
    let progress = Progress::new(&source);
    let (syntax, digits) = (source.syntax, arguments.digits);
    let format = match arguments.format {
        None => arguments.output.by_name(Content::ROWS)?,
        given => given,
    };
    let format = format.or_else(|| Format::named(Content::ROWS, syntax.format()));
    let Some(format) = format else { return Ok(()) };
    let output = arguments.output.open_for(format)?;
    let input = progress.counted(source.into_input());
    let keep = Keep::new(&arguments.keep);
    let in_lines = format.name == "jsonl";
    let columns = Columns::named(&arguments.columns, Purpose::Ask).map_err(Failure::Input)?;
    let queries = GivenRows::new((syntax, input), columns, keep, in_lines)?;
    let GivenRows { columns, spelling, kept, rows } = queries;
    // A table without a column for the thickness asks for states alone.
    let answers = match columns.all.iter().any(|column| column.role == Role::GivenThickness) {
        true => Answers::mixed(digits),
        false => Answers::arches(digits, false),
    };
    let mut all = Quantity::STATE.to_vec();
    if answers.have_assessments() {
        all.extend(Quantity::ASSESSMENT);
    }
    let is_size = |role| [Field::Span, Field::Radius].map(Role::Size).contains(&role);
    let measured = match columns.all.iter().any(|column| is_size(column.role)) {
        // Each object may have sizes or not.
        _ if matches!(syntax, Syntax::Json) && !in_lines => Vec::new(),
        true if answers.have_assessments() => measured(&Quantity::MEASURED_ASSESSMENT),
        true => measured(&Quantity::MEASURED_STATE),
        false => Vec::new(),
    };
    all.extend(&measured);
    let answers = match arguments.quantities.is_empty() {
        true => Answers { quantities: [&answers.quantities[..], &measured].concat(), ..answers },
        false => answers.of(&chosen(&arguments.quantities, &all)?),
    };
    let asked = RowQuestion::new(&answers, format)?;
    let reader = ArchReader { columns, weight: arguments.weight, doubles: false, spelling };
    let mut file = open_rows(Answers { kept, ..answers }, format).map_err(unwritten)?;
    let (mut bad, mut undecided, mut answered) = (0, 0, None);
    let together = if format.is_binary { Chunk::Full } else { Chunk::WhatIsThere };
    output.write(|out| {
        out.write_all(&file.begin()?)?;
        let answer = |line| answer(&reader, line, &asked);
        let rows = in_order(rows, (&progress, together), answer, |answers: Vec<Answer>| {
            let count =
                |is: fn(&Answer) -> bool| answers.iter().filter(|answer| is(answer)).count();
            bad += count(|answer| matches!(answer.status, Status::Refused(_)));
            undecided += count(Answer::is_undecided);
            out.write_all(&file.group(&answers)?)?;
            out.flush()?;
            Ok::<_, io::Error>(())
        })?;
        out.write_all(&file.end()?)?;
        answered = Some(rows);
        Ok(())
    })?;
    match (answered, bad, undecided) {
        // The reader closed the pipe early.
        (None, ..) | (_, 0, 0) => Ok(()),
        (Some(rows), 0, undecided) => {
            Err(Failure::Undecided(format!("{undecided} of {rows} rows are undecided")))
        }
        (Some(rows), bad, _) => {
            Err(Failure::Input(format!("{bad} of {rows} rows could not be read; see their errors")))
        }
    }
}

/// Sizes of an arch of which no forces are known.
fn measured(all: &[Quantity]) -> Vec<Quantity> {
    all.iter().copied().filter(|quantity| !quantity.is_force()).collect()
}

fn unwritten(error: io::Error) -> Failure {
    Failure::writing("the rows", &error)
}

/// Question to every row.
struct RowQuestion {
    digits: usize,
    quantities: Vec<Quantity>,
    /// Proofs that arches share.
    openings: SharedOpenings,
}

impl RowQuestion {
    fn new(answers: &Answers, format: &Format) -> Result<Self, Refused> {
        let (digits, quantities) = (answers.digits, answers.quantities.clone());
        let frictions = quantities.iter().any(|quantity| quantity.is_friction());
        let balls = if format.has_errors { Balls::Mpfr } else { Balls::DoubleDoubles };
        Ok(Self { digits, quantities, openings: SharedOpenings::new(balls, digits, frictions)? })
    }
}

/// The answer to a query, or its error.
fn answer(reader: &ArchReader, (line, query): Numbered<ReadRow>, asked: &RowQuestion) -> Answer {
    let (answer, kept) = match query {
        Ok(query) => (found(reader, line, &query.cells, asked), query.kept),
        Err(error) => (Err(error), Vec::new()),
    };
    let answer = answer.unwrap_or_else(|error| Answer::refused(line, error));
    Answer { kept, ..answer.only(&asked.quantities) }
}

/// A row is asked what it asks: about its thickness if it has one.
fn found(
    reader: &ArchReader,
    line: u64,
    cells: &Cells,
    asked: &RowQuestion,
) -> Result<Answer, String> {
    let ((arch, measures), digits) = (reader.measured_arch(cells)?, asked.digits);
    let (measures, sizes) = (measures.as_ref(), measures.as_ref().map(|of| (of, digits)));
    let Some((text, _)) = reader.given(cells, Role::GivenThickness) else {
        let found = asked.openings.state(&arch);
        return Ok(answer::state(line, (&arch, sizes), digits, &found));
    };
    let eta = given_thickness(&reader.spelling.exact(text), measures, Spelling::Key);
    let eta = eta.map_err(|misfit| misfit.message)?;
    let found = asked.openings.assess(&arch, &eta);
    Ok(answer::assessment(line, (&arch, &eta, sizes), digits, &found))
}
