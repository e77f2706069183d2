//! Rows of which each is about one arch.

use super::arguments::Arguments;
use super::counts::Counts;
use super::opened::Opened;
use crate::ask::Field;
use crate::cli::commands::output::chosen;
use crate::cli::commands::stream::{Chunk, in_order};
use crate::problem::Quantity;
use crate::report::{Answer, Answers, Content, open_rows};
use crate::sweep::failure::Failure;
use crate::sweep::rows::{ArchReader, GivenRows, RowQuestion, Syntax};
use std::io;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(opened) = Opened::new(arguments, Content::ROWS)? else { return Ok(()) };
    let Opened { given, progress, output, format, syntax, beside } = opened;
    let GivenRows { columns, spelling, kept, rows } = given;
    let (digits, in_lines) = (arguments.digits, format.name == "jsonl");
    // A table without a column for the thickness asks for states alone.
    let answers = match columns.has(Field::Thickness) {
        true => Answers::mixed(digits),
        false => Answers::arches(digits, false),
    };
    // Each object may have sizes or not.
    let may_be_measured = !matches!(syntax, Syntax::Json) || in_lines;
    let is_measured = may_be_measured && (columns.has(Field::Span) || columns.has(Field::Radius));
    // Without a density no forces are known.
    let forces = is_measured.then(|| columns.has(Field::Density));
    let mut known = Quantity::of_arch(answers.have_assessments(), forces);
    let usual = known.iter().position(|of| of.is_measured()).unwrap_or(known.len());
    let measured = known.split_off(usual);
    let states = if answers.have_assessments() { &Quantity::STATE[..] } else { &[] };
    let answers = match arguments.quantities.is_empty() {
        true => Answers { quantities: [&answers.quantities[..], &measured].concat(), ..answers },
        false => {
            let all = [states, &known, &measured].concat();
            answers.only(&chosen(&arguments.quantities, &all)?)
        }
    };
    let asked = RowQuestion::new(&answers, format, beside)?;
    let reader = ArchReader { columns, weight: arguments.weight, doubles: false, spelling };
    let mut file = open_rows(Answers { kept, ..answers }, format, beside).map_err(unwritten)?;
    let mut counts = Counts::default();
    let is_read_to_its_end = format.is_binary || progress.is_of_file;
    let together = if is_read_to_its_end { Chunk::Full } else { Chunk::WhatIsThere };
    output.write(|out| {
        out.write_all(&file.begin()?)?;
        let answers = |rows| asked.answers(&reader, rows);
        let rows = in_order(rows, (&progress, together), answers, |answers: Vec<Answer>| {
            for answer in &answers {
                counts.add(answer.fault().is_some(), answer.is_undecided());
            }
            out.write_all(&file.group(answers)?)?;
            out.flush()
        })?;
        out.write_all(&file.end()?)?;
        counts.rows = Some(rows);
        Ok(())
    })?;
    counts.verdict()
}

fn unwritten(error: io::Error) -> Failure {
    Failure::writing("the rows", &error)
}
