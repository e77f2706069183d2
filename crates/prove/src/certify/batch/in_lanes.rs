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

/// Columns of a batch, in which what is not all proved is undecided without a reason.
pub(super) fn columns(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
) -> BatchColumns {
    let wants = LaneWants::new(quantities);
    let count = arches.count();
    let starts: Vec<usize> = (0..count).step_by(PIECE).collect();
    let pieces = threads.each(&starts, |start| {
        let rows = *start..count.min(start + PIECE);
        let mut columns = BatchColumns::open(rows.len(), quantities.len());
        // One row's at a time: a row has no memory of its own.
        let mut doubles = vec![[f64::NAN; 3]; quantities.len()];
        each_in_lanes(&arches.many_in_lanes(rows), wants, |row, found| {
            if let Some(verdict) = in_doubles(&found, quantities, &mut doubles) {
                columns.set(row, verdict, doubles.iter().copied());
            }
        });
        columns
    });
    let mut all = BatchColumns::open(0, quantities.len());
    pieces.into_iter().for_each(|piece| all.append(piece));
    all
}

/// Verdict and mode of what is proved of an arch, if all that is asked is decided: then each quantity is in doubles.
#[inline(always)]
fn in_doubles(
    found: &LaneFound,
    quantities: &[Quantity],
    doubles: &mut [[f64; 3]],
) -> Option<(RowVerdict, Option<Mode>)> {
    match found {
        LaneFound::Stands(state) => {
            values(quantities, |of| Some(state.value(of)?.copied()), doubles)?;
            Some((RowVerdict::Stands, Some(state.mode)))
        }
        LaneFound::Falls(falling) => {
            let of = |of| falling.sliding.filter(|_| of == Quantity::SlidingFriction).map(Some);
            values(quantities, of, doubles)?;
            Some((RowVerdict::Falls, None))
        }
        LaneFound::Assessment(found, _) => {
            let stands = *found.stands.as_ref().ok()?;
            if found.open().any(|(of, _)| quantities.contains(&of)) {
                return None;
            }
            let of = |of| Some(found.figures().find(|(figure, _)| *figure == of)?.1);
            values(quantities, of, doubles)?;
            Some((if stands { RowVerdict::Stands } else { RowVerdict::Falls }, None))
        }
    }
}

/// Puts quantities in doubles, if all are decided: infinite without a figure, and no numbers where there is
/// none at all.
#[inline(always)]
fn values<'a>(
    quantities: &[Quantity],
    figure: impl Fn(Quantity) -> Option<Option<&'a DoubleDoubleBall>>,
    all: &mut [[f64; 3]],
) -> Option<()> {
    for (of, value) in quantities.iter().zip(all) {
        *value = match figure(*of) {
            Some(Some(ball)) => doubles(ball)?,
            Some(None) => [f64::INFINITY; 3],
            None => [f64::NAN; 3],
        };
    }
    Some(())
}

/// The nearest double of a number with its bounds, if they are decided.
#[inline(always)]
fn doubles(ball: &DoubleDoubleBall) -> Option<[f64; 3]> {
    if ball.mid().hi() == 0.0 && ball.rad() == 0.0 {
        return Some([0.0; 3]);
    }
    let (double, binary) = Binary::of_double_double(ball)?;
    let [lower, upper] = binary.bounds();
    Some([double, lower, upper])
}
