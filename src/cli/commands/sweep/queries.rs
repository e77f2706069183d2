//! The rows of a part as they are asked.

use super::query::{Asked, Query};
use super::record::{Arches, Record};
use super::slices::read_slice;
use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction};
use crate::report::GivenDoubles;
use crate::strategies::samples;
use ::parquet::data_type::ByteArray;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// Rows of a sample that are drawn from one seed: the block `b` has the arches of `couplet sample --seed SEED+b`.
const BLOCK: u64 = 1_000;

/// The rows of a part; `base` is where the paths of a data set begin.
pub(super) fn queries(
    record: &Record,
    rows: &Range<u64>,
    base: &Path,
) -> Result<Vec<Query>, String> {
    match &record.arches {
        Arches::Grid { half_opening, friction } => {
            grid(&record.weights(), (half_opening, friction), rows)
        }
        Arches::Sample { seed, hard } => Ok(sample(*seed, *hard, rows)),
        Arches::Data { files } => {
            let mut first = 0;
            for file in files {
                let length = file.slices.rows();
                if rows.start < first + length {
                    let weight = record.weights().first().copied();
                    let weight = weight.unwrap_or(SelfWeight::Milankovitch);
                    let path = base.join(&file.file);
                    let within = rows.start - first;
                    let found = read_slice(&file.slices, &path, within, weight)
                        .map_err(|error| format!("{}: {error}", file.file))?;
                    let name = ByteArray::from(file.file.as_str());
                    return Ok(found
                        .into_iter()
                        .zip(rows.clone())
                        .map(|((line, query), row)| Query {
                            row,
                            origin: Some((name.clone(), line)),
                            ..query
                        })
                        .collect());
                }
                first += length;
            }
            Ok(Vec::new())
        }
    }
}

/// A number of an axis: its text, the nearest double, and itself.
struct Given<T> {
    text: ByteArray,
    double: Option<f64>,
    number: Arc<T>,
}

fn grid(
    weights: &[SelfWeight],
    (half_openings, frictions): (&[String], &[String]),
    rows: &Range<u64>,
) -> Result<Vec<Query>, String> {
    let column = frictions.len() as u64;
    let columns = rows.start / column..rows.end.div_ceil(column);
    // An axis may be long, and a part has a piece of it.
    let needed = match columns.end - columns.start {
        1 => (rows.start % column) as usize..((rows.end - 1) % column + 1) as usize,
        _ => 0..frictions.len(),
    };
    let of = |error: &dyn std::fmt::Display| format!("the record of the sweep: {error}");
    let one = ExactNumber::from(&rug::Rational::from(1));
    let friction = |text: &String| {
        let number: Friction = text.parse().map_err(|error| of(&error))?;
        let arch = Arch::new(SelfWeight::Heyman, one.clone(), number.clone());
        let double = GivenDoubles::new(&arch.map_err(|error| of(&error))?, None).friction;
        Ok(Given { text: ByteArray::from(text.as_str()), double, number: Arc::new(number) })
    };
    let given = frictions[needed.clone()].iter().map(friction);
    let frictions: Vec<Given<Friction>> = given.collect::<Result<_, String>>()?;
    let mut queries = Vec::with_capacity((rows.end - rows.start) as usize);
    for place in columns {
        let count = half_openings.len() as u64;
        let (weight, text) =
            (weights[(place / count) as usize], &half_openings[(place % count) as usize]);
        let number: ExactNumber = text.parse().map_err(|error| of(&error))?;
        let double = number.nearest_double();
        let (text, number) = (ByteArray::from(text.as_str()), Arc::new(number));
        let name = ByteArray::from(weight.name());
        for (place_in_column, friction) in (needed.start as u64..).zip(&frictions) {
            let row = place * column + place_in_column;
            if !rows.contains(&row) {
                continue;
            }
            queries.push(Query {
                row,
                origin: None,
                texts: [name.clone(), text.clone(), friction.text.clone()],
                doubles: [double, friction.double],
                asked: Ok(Asked {
                    weight,
                    half_opening: Arc::clone(&number),
                    friction: Arc::clone(&friction.number),
                }),
            });
        }
    }
    Ok(queries)
}

fn sample(seed: u64, hard: bool, rows: &Range<u64>) -> Vec<Query> {
    let blocks = rows.start / BLOCK..rows.end.div_ceil(BLOCK);
    let drawn = blocks.flat_map(|block| {
        let drawn = samples(seed.wrapping_add(block), hard);
        (block * BLOCK..(block + 1) * BLOCK).zip(drawn)
    });
    let drawn = drawn.filter(|(row, _)| rows.contains(row));
    drawn.map(|(row, sample)| Query::new(row, &sample.arch)).collect()
}
