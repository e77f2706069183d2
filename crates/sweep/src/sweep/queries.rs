//! The rows of a part as they are asked.

use super::query::{AxisNumber, Listed, PartArches, PartGrid, PartQueries};
use super::record::{self, DataFile, SweepRecord};
use super::strategies::samples;
use super::text;
use crate::arch::SelfWeight;
use crate::certify::batch::SharedOpening;
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction};
use crate::report::GivenDoubles;
use ::parquet::data_type::ByteArray;
use std::fmt;
use std::ops::Range;
use std::path::Path;

/// Rows of a sample that are drawn from one seed: the block `b` has the arches of `couplet sample --seed SEED+b`.
const BLOCK: u64 = 1_000;

/// Frictions of a grid; none of other sweeps.
pub(super) fn frictions(record: &SweepRecord) -> Result<Vec<AxisNumber<Friction>>, String> {
    let record::Arches::Grid { friction, .. } = &record.arches else { return Ok(Vec::new()) };
    let one = ExactNumber::from(&rug::Rational::from(1));
    let read = |text: &String| {
        let number: Friction = text.parse().map_err(|error| wrong(&error))?;
        let arch = Arch::new(SelfWeight::Heyman, one.clone(), number.clone());
        let double = GivenDoubles::new(&arch.map_err(|error| wrong(&error))?, None).friction;
        let enclosed = SharedOpening::enclosed(&number);
        Ok(AxisNumber { text: ByteArray::from(text.as_str()), double, enclosed, number })
    };
    friction.iter().map(read).collect()
}

fn wrong(error: &dyn fmt::Display) -> String {
    format!("the record of the sweep: {error}")
}

/// The rows of a group of a part; `base` is where the paths of a data set begin.
pub(super) fn queries<'a>(
    record: &SweepRecord,
    frictions: &'a [AxisNumber<Friction>],
    rows: &Range<u64>,
    base: &Path,
) -> Result<PartQueries<'a>, String> {
    let arches = match &record.arches {
        record::Arches::Grid { half_opening, .. } => {
            PartArches::Grid(grid(&record.weights(), half_opening, frictions, rows)?)
        }
        record::Arches::Sample { seed, hard } => {
            PartArches::Listed(Box::new(sample(*seed, *hard, rows)))
        }
        record::Arches::Data { files } => {
            PartArches::Listed(Box::new(data(record, files, rows, base)?))
        }
    };
    Ok(PartQueries { first: rows.start, arches })
}

/// The rows of a piece of a file.
fn data(
    record: &SweepRecord,
    files: &[DataFile],
    rows: &Range<u64>,
    base: &Path,
) -> Result<Listed, String> {
    let weight = record.weights().first().copied().unwrap_or(SelfWeight::Milankovitch);
    let mut first = 0;
    for file in files {
        for slice in &file.slices {
            if first == rows.start {
                let read = text::read(&base.join(&file.file), file.head.as_ref(), slice, weight);
                let (lines, listed) = read.map_err(|error| format!("{}: {error}", file.file))?;
                let origin = Some((ByteArray::from(file.file.as_str()), lines));
                return Ok(Listed { origin, ..listed });
            }
            first += slice.rows;
        }
    }
    Ok(Listed::default())
}

fn grid<'a>(
    weights: &[SelfWeight],
    half_openings: &[String],
    frictions: &'a [AxisNumber<Friction>],
    rows: &Range<u64>,
) -> Result<PartGrid<'a>, String> {
    let column = frictions.len() as u64;
    let columns = rows.start / column..rows.end.div_ceil(column);
    // Whole columns, or a piece of one.
    let needed = match columns.end - columns.start {
        1 => (rows.start % column) as usize..((rows.end - 1) % column + 1) as usize,
        _ => 0..frictions.len(),
    };
    let count = half_openings.len() as u64;
    let column = |place: u64| {
        let (weight, text) =
            (weights[(place / count) as usize], &half_openings[(place % count) as usize]);
        let number: ExactNumber = text.parse().map_err(|error| wrong(&error))?;
        let (text, double) = (ByteArray::from(text.as_str()), number.nearest_double());
        let enclosed = Some(SharedOpening::enclosed_number(&number));
        Ok((weight, AxisNumber { text, double, enclosed, number }))
    };
    let columns = columns.map(column).collect::<Result<_, String>>()?;
    Ok(PartGrid { columns, frictions: &frictions[needed] })
}

fn sample(seed: u64, hard: bool, rows: &Range<u64>) -> Listed {
    let blocks = rows.start / BLOCK..rows.end.div_ceil(BLOCK);
    let drawn = blocks.flat_map(|block| {
        let drawn = samples(seed.wrapping_add(block), hard);
        (block * BLOCK..(block + 1) * BLOCK).zip(drawn)
    });
    let mut listed = Listed::default();
    let drawn = drawn.filter(|(row, _)| rows.contains(row));
    drawn.for_each(|(_, sample)| listed.push(sample.arch));
    listed
}
