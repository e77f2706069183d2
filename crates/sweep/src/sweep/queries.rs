//! The rows of a part as they are asked.

use super::listed::Listed;
use super::strategies::samples;
use super::text;
use crate::arch::SelfWeight;
use crate::certify::batch::{BatchArches, InLanes, SharedOpening, grouped};
use crate::number::{DoubleDoubleBall, ExactNumber};
use crate::problem::{Arch, Friction};
use crate::report::GivenDoubles;
use crate::scene::{SweepArches, SweepRecord};
use ::parquet::data_type::ByteArray;
use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

/// The rows of a part as they are asked; they follow each other in the sweep.
pub(super) struct PartQueries<'a> {
    /// The place of the first one in the sweep, from 0.
    pub first: u64,
    pub arches: PartArches<'a>,
}

/// The arches of a part.
pub(super) enum PartArches<'a> {
    /// Arches of a grid: every half opening with every friction.
    Grid(PartGrid<'a>),
    /// Arches that are listed one by one.
    Listed(Box<Listed>),
}

/// Half openings with their weights, and the frictions that each of them has.
pub(super) struct PartGrid<'a> {
    pub columns: Vec<(SelfWeight, AxisNumber<ExactNumber>)>,
    pub frictions: &'a [AxisNumber<Friction>],
}

/// A number of an axis: its text, the nearest double, an enclosure, and itself.
#[derive(Debug)]
pub(super) struct AxisNumber<T> {
    pub text: ByteArray,
    pub double: Option<f64>,
    /// Nothing encloses a friction without a limit.
    pub enclosed: Option<DoubleDoubleBall>,
    pub number: T,
}

impl<'a> PartGrid<'a> {
    /// Weight, half opening and friction of a row.
    pub(super) fn at(
        &self,
        row: usize,
    ) -> (SelfWeight, &AxisNumber<ExactNumber>, &'a AxisNumber<Friction>) {
        let (weight, half_opening) = &self.columns[row / self.frictions.len()];
        (*weight, half_opening, &self.frictions[row % self.frictions.len()])
    }
}

impl BatchArches for PartQueries<'_> {
    fn count(&self) -> usize {
        match &self.arches {
            PartArches::Grid(PartGrid { columns, frictions }) => columns.len() * frictions.len(),
            PartArches::Listed(listed) => listed.arches.len(),
        }
    }

    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        match &self.arches {
            PartArches::Grid(PartGrid { frictions, .. }) => {
                grouped(rows, |row| Some(row / frictions.len()))
            }
            PartArches::Listed(listed) => grouped(rows, |row| {
                Some((listed.arches[row].as_ref().ok()?.weight(), listed.texts[1].of(row)))
            }),
        }
    }

    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, InLanes)> {
        match &self.arches {
            PartArches::Grid(grid) => {
                let (weight, half_opening, friction) = grid.at(row);
                Some((weight, ((half_opening.enclosed?, friction.enclosed), None)))
            }
            PartArches::Listed(listed) => {
                let arch = listed.arches[row].as_ref().ok()?;
                Some((arch.weight(), (SharedOpening::enclosed_arch(arch), None)))
            }
        }
    }

    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String> {
        match &self.arches {
            PartArches::Grid(grid) => {
                let (weight, half_opening, friction) = grid.at(row);
                let arch = Arch::new(weight, half_opening.number.clone(), friction.number.clone());
                arch.map(Cow::Owned).map_err(|error| error.to_string())
            }
            PartArches::Listed(listed) => {
                listed.arches[row].as_ref().map(Cow::Borrowed).map_err(Clone::clone)
            }
        }
    }
}

/// Rows of a sample that are drawn from one seed: the block `b` has the arches of `couplet sample --seed SEED+b`.
const BLOCK: u64 = 1_000;

/// Frictions of a grid; none of other sweeps.
pub(super) fn frictions(record: &SweepRecord) -> Result<Vec<AxisNumber<Friction>>, String> {
    let SweepArches::Grid { friction, .. } = &record.arches else { return Ok(Vec::new()) };
    let one = ExactNumber::from(&rug::Rational::from(1));
    let read = |number: &Friction| {
        let arch = Arch::new(SelfWeight::Heyman, one.clone(), number.clone());
        let arch = arch.map_err(|error| format!("the record of the sweep: {error}"))?;
        let (double, enclosed) =
            (GivenDoubles::new(&arch, None).friction, SharedOpening::enclosed(number));
        Ok(AxisNumber { text: text_of(number), double, enclosed, number: number.clone() })
    };
    friction.iter().map(read).collect()
}

fn text_of(number: &impl ToString) -> ByteArray {
    ByteArray::from(number.to_string().as_str())
}

/// The rows of a group of a part; `base` is where the paths of a data set begin.
pub(super) fn queries<'a>(
    record: &SweepRecord,
    frictions: &'a [AxisNumber<Friction>],
    rows: &Range<u64>,
    base: &Path,
) -> Result<PartQueries<'a>, String> {
    let arches = match &record.arches {
        SweepArches::Grid { half_opening, .. } => {
            PartArches::Grid(grid(&record.weights, half_opening, frictions, rows))
        }
        SweepArches::Sample { seed, hard } => {
            PartArches::Listed(Box::new(sample(*seed, *hard, rows)))
        }
        SweepArches::Data { .. } => PartArches::Listed(Box::new(data(record, rows, base)?)),
    };
    Ok(PartQueries { first: rows.start, arches })
}

/// The rows of a slice of a file.
fn data(record: &SweepRecord, rows: &Range<u64>, base: &Path) -> Result<Listed, String> {
    let weight = record.weights.first().copied().unwrap_or(SelfWeight::Milankovitch);
    let Some((_, file, slice)) = record.slices().find(|(of, ..)| of == rows) else {
        return Ok(Listed::default());
    };
    let read = text::read(&base.join(&file.file), file.head.as_ref(), slice, weight);
    let (lines, listed) = read.map_err(|error| format!("{}: {error}", file.file))?;
    Ok(Listed { origin: Some((ByteArray::from(file.file.as_str()), lines)), ..listed })
}

fn grid<'a>(
    weights: &[SelfWeight],
    half_openings: &[ExactNumber],
    frictions: &'a [AxisNumber<Friction>],
    rows: &Range<u64>,
) -> PartGrid<'a> {
    let column = frictions.len() as u64;
    let columns = rows.start / column..rows.end.div_ceil(column);
    // Whole columns, or a piece of one.
    let needed = match columns.end - columns.start {
        1 => (rows.start % column) as usize..((rows.end - 1) % column + 1) as usize,
        _ => 0..frictions.len(),
    };
    let count = half_openings.len() as u64;
    let column = |place: u64| {
        let number = half_openings[(place % count) as usize].clone();
        let (text, double) = (text_of(&number), number.nearest_double());
        let enclosed = Some(SharedOpening::enclosed_number(&number));
        (weights[(place / count) as usize], AxisNumber { text, double, enclosed, number })
    };
    PartGrid { columns: columns.map(column).collect(), frictions: &frictions[needed] }
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
