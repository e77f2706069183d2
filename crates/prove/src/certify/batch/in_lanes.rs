//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::arches::{BatchArches, Threads};
use super::columns::BatchColumns;
use super::row::RowVerdict;
use crate::certify::state::{LaneFound, LaneWants, each_in_lanes};
use crate::number::{Binary, DoubleDoubleBall};
use crate::problem::{Mode, Quantity};

/// Rows that are one piece of work: few enough that what it takes stays near the processor, and that less is given back
/// to the system after each.
const PIECE: usize = 512;

/// Rows of a batch by columns, some with their places at a time; none of which not all that is asked is proved.
pub(super) fn columns(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
) -> Vec<(Vec<usize>, BatchColumns)> {
    // No lane has it.
    if quantities.contains(&Quantity::AsymmetricThickness) {
        return Vec::new();
    }
    let wants = LaneWants::new(quantities);
    let count = arches.count();
    let starts: Vec<usize> = (0..count).step_by(PIECE).collect();
    threads.each(&starts, |start| {
        let all = arches.many_in_lanes(*start..count.min(start + PIECE));
        let (mut rows, mut columns) = (Vec::new(), BatchColumns::open(0, quantities.len()));
        // One row's at a time: a row has no memory of its own.
        let mut doubles = Vec::with_capacity(quantities.len());
        each_in_lanes(&all, wants, |row, found| {
            doubles.clear();
            if let Some(verdict) = in_doubles(&found, quantities, &mut doubles) {
                columns.push(verdict, &doubles);
                rows.push(start + row);
            }
        });
        (rows, columns)
    })
}

/// Verdict and mode of what is proved of an arch, if all that is asked is decided: then each quantity is in doubles.
fn in_doubles(
    found: &LaneFound,
    quantities: &[Quantity],
    doubles: &mut Vec<[f64; 3]>,
) -> Option<(RowVerdict, Option<Mode>)> {
    match found {
        LaneFound::Stands(state) => {
            let of = |of| Some(state.figures().find(|(figure, _)| *figure == of)?.1.copied());
            values(quantities, of, doubles)?;
            Some((RowVerdict::Stands, Some(state.mode)))
        }
        LaneFound::Falls(falling) => {
            let of = |of| falling.sliding.filter(|_| of == Quantity::SlidingFriction).map(Some);
            values(quantities, of, doubles)?;
            Some((RowVerdict::Falls, None))
        }
        LaneFound::Assessment(found, _) => {
            let stands = *found.stands.as_ref().ok()?;
            let verdict = if stands { RowVerdict::Stands } else { RowVerdict::Falls };
            let is_open = |of: &Quantity| found.why_open(*of).is_some();
            let of = |of| Some(found.figures().find(|(figure, _)| *figure == of)?.1);
            if quantities.iter().any(is_open) {
                return None;
            }
            values(quantities, of, doubles)?;
            Some((verdict, None))
        }
    }
}

/// Adds quantities in doubles, if all are decided: infinite without a figure, and no numbers where there is
/// none at all.
fn values<'a>(
    quantities: &[Quantity],
    figure: impl Fn(Quantity) -> Option<Option<&'a DoubleDoubleBall>>,
    all: &mut Vec<[f64; 3]>,
) -> Option<()> {
    let value = |of: &Quantity| match figure(*of) {
        Some(Some(ball)) => doubles(ball),
        Some(None) => Some([f64::INFINITY; 3]),
        None => Some([f64::NAN; 3]),
    };
    for of in quantities {
        all.push(value(of)?);
    }
    Some(())
}

/// The nearest double of a number with its bounds, if they are decided.
fn doubles(ball: &DoubleDoubleBall) -> Option<[f64; 3]> {
    if ball.mid().hi() == 0.0 && ball.rad() == 0.0 {
        return Some([0.0; 3]);
    }
    let (double, binary) = Binary::of_double_double(ball)?;
    let [lower, upper] = binary.bounds();
    Some([double, lower, upper])
}
