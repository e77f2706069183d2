//! Rows of which each is about all arches between its ends.

use super::arguments::Arguments;
use super::counts::Counts;
use super::opened::Opened;
use crate::ask::{ArchQuestion, Field, Spelling, SurveyGiven};
use crate::cli::commands::output::{chosen, is_written};
use crate::cli::commands::stream::written;
use crate::problem::Quantity;
use crate::report::words::distinct;
use crate::report::{Content, SurveyedArches, SurveyedRow, SurveyedRows};
use crate::sweep::failure::Failure;
use crate::sweep::rows::{ArchReader, Cells, Numbered, ReadRow};
use crate::sweep::surveyed::{of_rows, surveyed};
use rayon::prelude::*;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(format) = arguments.format {
        is_written("the answer of a range", Content::RANGES, format)?;
    }
    let Some(opened) = Opened::new(arguments, Content::RANGES)? else { return Ok(()) };
    let Opened { given, progress, output, format, .. } = opened;
    let has = |field| given.columns.has(field);
    let (have_thickness, all) = (has(Field::Thickness), of_rows(has));
    let asked = arguments.quantities.iter().map(|of| match of {
        // Of arches without a thickness it is the least.
        Quantity::Thickness => Quantity::LeastThickness,
        other => *other,
    });
    let quantities = chosen(&distinct(asked), &all)?;
    let are_objects = format.name == "jsonl";
    let tells_measures = have_thickness && quantities.contains(&Quantity::GeometricSafety);
    let kept = given.kept;
    let file = SurveyedRows { quantities, have_thickness, tells_measures, kept, are_objects };
    let (weight, spelling) = (arguments.weight, given.spelling);
    let reader = ArchReader { columns: given.columns, weight, doubles: false, spelling };
    let mut counts = Counts::default();
    output.write(|out| {
        out.write_all(&file.header()?)?;
        let asked = (&file.quantities[..], arguments.digits);
        let answer = |line| {
            let row = answer(&reader, line, asked);
            let text = file.row(&row);
            (row, text)
        };
        let count = |row: SurveyedRow| counts.add(row.is_refused(), row.is_undecided());
        let answers = |rows: Vec<_>| rows.into_par_iter().map(answer).collect();
        counts.rows = Some(written(given.rows, &progress, answers, out, count)?);
        Ok(())
    })?;
    counts.verdict()
}

/// The answer to a query, or its error.
fn answer(
    reader: &ArchReader,
    (line, query): Numbered<ReadRow>,
    asked: (&[Quantity], usize),
) -> SurveyedRow {
    match query {
        Ok(ReadRow { cells, kept }) => {
            SurveyedRow { line, kept, found: found(reader, &cells, asked) }
        }
        Err(error) => SurveyedRow { line, kept: Vec::new(), found: Err(error) },
    }
}

fn found(
    reader: &ArchReader,
    cells: &Cells,
    (quantities, digits): (&[Quantity], usize),
) -> Result<SurveyedArches, String> {
    let (weight, asked) = reader.ranged(cells)?;
    let given = SurveyGiven::read(&ArchQuestion::ANY, &asked, Spelling::Key);
    let given = given.map_err(|misfit| misfit.message)?;
    surveyed(&asked, &given, weight, (quantities, digits)).map_err(|error| error.to_string())
}
