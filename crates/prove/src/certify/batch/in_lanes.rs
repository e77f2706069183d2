//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::batch::{Batch, BatchArches, Threads};
use super::row::{BatchRow, RowValue, RowVerdict};
use crate::arch::SelfWeight;
use crate::lanes::{LaneAnswer, LaneArch, LaneFrictions, LaneState, Width};
use crate::number::{Binary, DoubleDoubleBall};
use crate::problem::{Mode, Quantity};
use std::sync::Arc;

/// Rows below which tables and half-filled lanes would cost more than they spare.
const FEW: usize = 64;

/// Rows that are one piece of work.
const PIECE: usize = 4096;

/// With so many digits a row is what its doubles tell.
const OF_A_DOUBLE: usize = 17;

/// The rows of a batch, in the order of the arches; `None` where nothing is proved, or not all that is asked.
pub(super) fn rows(
    batch: &Batch,
    arches: &impl BatchArches,
    threads: Threads,
) -> Vec<Option<Arc<BatchRow>>> {
    let mut all = vec![None; arches.count()];
    let is_known = |of: &Quantity| *of != Quantity::AsymmetricThickness;
    let are_doubles = !batch.has_texts && batch.digits <= OF_A_DOUBLE;
    if all.len() < FEW || !are_doubles || !batch.quantities.iter().all(is_known) {
        return all;
    }
    let mut of_weights = SelfWeight::ALL.map(|weight| (weight, Vec::new()));
    for row in 0..all.len() {
        if let Some((weight, arch)) = arches.in_lanes(row)
            && let Some((_, rows)) = of_weights.iter_mut().find(|(of, _)| *of == weight)
        {
            rows.push((row, arch));
        }
    }
    let pieces: Vec<_> = of_weights
        .iter()
        .flat_map(|(weight, rows)| rows.chunks(PIECE).map(|rows| (*weight, rows)))
        .collect();
    let found = threads.each(&pieces, |(weight, rows)| piece(batch, *weight, rows));
    for ((_, rows), found) in pieces.iter().zip(found) {
        rows.iter().zip(found).for_each(|((row, _), found)| all[*row] = found);
    }
    all
}

fn piece(
    batch: &Batch,
    weight: SelfWeight,
    rows: &[(usize, LaneArch)],
) -> Vec<Option<Arc<BatchRow>>> {
    let width = Width::widest();
    let arches: Vec<LaneArch> = rows.iter().map(|(_, arch)| *arch).collect();
    let answers = width.states(weight, &arches);
    let frictions = match batch.has_frictions() {
        true => {
            let half_openings: Vec<_> = arches.iter().map(|(alpha, _)| *alpha).collect();
            width.frictions(weight, &half_openings)
        }
        false => vec![LaneFrictions::default(); rows.len()],
    };
    let mut last: Option<(LastRow, Arc<BatchRow>)> = None;
    let row = |((arch, answer), frictions): ((&LaneArch, Option<LaneAnswer>), &LaneFrictions)| {
        let answer = answer?;
        // At one half opening a rotational state does not depend on the friction, nor does a fall.
        let key = LastRow::new(arch, &answer);
        if let Some((of, row)) = &last
            && key.as_ref() == Some(of)
        {
            return Some(Arc::clone(row));
        }
        let row = Arc::new(of_answer(&answer, frictions, &batch.quantities)?);
        if let Some(key) = key {
            last = Some((key, Arc::clone(&row)));
        }
        Some(row)
    };
    arches.iter().zip(answers).zip(&frictions).map(row).collect()
}

/// What a row depends on that does not depend on its friction.
#[derive(PartialEq, Eq)]
struct LastRow {
    half_opening: [u64; 2],
    falls: bool,
}

impl LastRow {
    fn new((alpha, _): &LaneArch, answer: &LaneAnswer) -> Option<Self> {
        let falls = match answer {
            LaneAnswer::Falls => true,
            LaneAnswer::Stands(state) if state.mode == Mode::Rotational => false,
            _ => return None,
        };
        let half_opening = [alpha.mid().hi(), alpha.mid().lo()].map(f64::to_bits);
        Some(Self { half_opening, falls })
    }
}

/// The row of an answer; `None` where a double is not decided.
fn of_answer(
    answer: &LaneAnswer,
    frictions: &LaneFrictions,
    quantities: &[Quantity],
) -> Option<BatchRow> {
    use Quantity as Q;
    let (verdict, mode, state) = match answer {
        LaneAnswer::Stands(state) => (RowVerdict::Stands, Some(state.mode), Some(state)),
        LaneAnswer::Falls => (RowVerdict::Falls, None, None),
        _ => return None,
    };
    let of_state = |of: fn(&LaneState) -> &DoubleDoubleBall| {
        state.map_or(Some(None), |state| shown(of(state)))
    };
    let value = |of: &Quantity| match of {
        Q::Thickness => of_state(|state| &state.thickness),
        Q::Thrust => of_state(|state| &state.thrust),
        Q::IntrinsicThrust => of_state(|state| &state.intrinsic_thrust),
        Q::RotationJoint => of_state(|state| &state.rotation_joint),
        Q::SlidingJoint => match state.and_then(|state| state.sliding_joint.as_ref()) {
            Some(joint) => shown(joint),
            None => Some(None),
        },
        Q::SlidingFriction => shown(frictions.sliding.as_ref()?),
        Q::RotationalFriction if state.is_none() => Some(None),
        Q::RotationalFriction => shown(frictions.rotational.as_ref()?),
        _ => None,
    };
    let values = quantities.iter().map(value).collect::<Option<Vec<_>>>()?;
    Some(BatchRow { verdict, mode, values, reason: None })
}

/// The value of a row, if its double is decided.
fn shown(ball: &DoubleDoubleBall) -> Option<Option<RowValue>> {
    let zero = ball.mid().hi() == 0.0 && ball.rad() == 0.0;
    let (double, bounds) = match Binary::of_double_double(ball) {
        Some((double, binary)) => (double, binary.bounds()),
        None if zero => (0.0, [0.0; 2]),
        None => return None,
    };
    Some(Some(RowValue { double, bounds, text: None }))
}
