//! Rows of which each is about one arch.

use super::arguments::Arguments;
use super::counts::Counts;
use super::opened::Opened;
use crate::ask::{Field, Spelling, given_thickness};
use crate::certify::Refused;
use crate::certify::batch::SharedOpenings;
use crate::certify::state::Balls;
use crate::cli::commands::output::chosen;
use crate::cli::commands::stream::{Chunk, in_order};
use crate::door::answer;
use crate::problem::Quantity;
use crate::report::{Answer, Answers, Content, Format, Status, open_rows};
use crate::sweep::failure::Failure;
use crate::sweep::rows::{ArchReader, Cells, GivenRows, Numbered, ReadRow, Role, Syntax};
use std::io;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(opened) = Opened::new(arguments, Content::ROWS)? else { return Ok(()) };
    let Opened { given, progress, output, format, syntax } = opened;
    let GivenRows { columns, spelling, kept, rows } = given;
    let (digits, in_lines) = (arguments.digits, format.name == "jsonl");
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
    let mut counts = Counts::default();
    let together = if format.is_binary { Chunk::Full } else { Chunk::WhatIsThere };
    output.write(|out| {
        out.write_all(&file.begin()?)?;
        let answer = |line| answer(&reader, line, &asked);
        let rows = in_order(rows, (&progress, together), answer, |answers: Vec<Answer>| {
            for answer in &answers {
                counts.add(matches!(answer.status, Status::Refused(_)), answer.is_undecided());
            }
            out.write_all(&file.group(&answers)?)?;
            out.flush()?;
            Ok::<_, io::Error>(())
        })?;
        out.write_all(&file.end()?)?;
        counts.rows = Some(rows);
        Ok(())
    })?;
    counts.verdict()
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
