//! Rows of arches that collapse by rotation alone, proved many at a time: [`lanes`](couplet_lanes::lanes) has the
//! proof.
//!
//! What it leaves open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::batch::Threads;
use super::row::{BatchRow, RowValue, RowVerdict};
use crate::arch::SelfWeight;
use crate::lanes::{RotationalState, Width};
use crate::number::Binary;
use crate::problem::{Mode, Quantity};
use std::sync::Arc;

/// Rows below which tables and half-filled lanes would cost more than they spare.
const FEW: usize = 64;

/// Rows that are one piece of work.
const PIECE: usize = 4096;

/// Rows with the quantities, in the order of the arches; `None` where it is not proved that the arch collapses so, and
/// where the proof does not have a quantity.
pub(super) fn rotational(
    weight: SelfWeight,
    [half_openings, frictions]: [&[f64]; 2],
    quantities: &[Quantity],
    threads: Threads,
) -> Vec<Option<Arc<BatchRow>>> {
    if half_openings.len() < FEW || !quantities.iter().all(|of| is_known(*of)) {
        return vec![None; half_openings.len()];
    }
    let pieces: Vec<_> = half_openings.chunks(PIECE).zip(frictions.chunks(PIECE)).collect();
    let rows = |&(alphas, mus): &(&[f64], &[f64])| {
        let states = Width::widest().rotational(weight, alphas, mus);
        let mut last: Option<(u64, Arc<BatchRow>)> = None;
        let row = |(alpha, state): (&f64, Option<RotationalState>)| {
            let state = state?;
            // At one half opening the state does not depend on the friction.
            if let Some((of, row)) = &last
                && *of == alpha.to_bits()
            {
                return Some(Arc::clone(row));
            }
            let row = Arc::new(of_state(&state, quantities)?);
            last = Some((alpha.to_bits(), Arc::clone(&row)));
            Some(row)
        };
        alphas.iter().zip(states).map(row).collect::<Vec<_>>()
    };
    threads.each(&pieces, rows).into_iter().flatten().collect()
}

/// Tells whether a quantity of a purely rotational state is known from its proof.
fn is_known(of: Quantity) -> bool {
    use Quantity as Q;
    matches!(of, Q::Thickness | Q::Thrust | Q::IntrinsicThrust | Q::RotationJoint | Q::SlidingJoint)
}

/// The row of a state; `None` where a double is not decided.
fn of_state(state: &RotationalState, quantities: &[Quantity]) -> Option<BatchRow> {
    let value = |of: &Quantity| {
        let ball = match of {
            Quantity::Thickness => &state.thickness,
            Quantity::Thrust => &state.thrust,
            Quantity::IntrinsicThrust => &state.intrinsic_thrust,
            Quantity::RotationJoint => &state.rotation_joint,
            // No inner joint slides.
            _ => return Some(None),
        };
        let (double, binary) = Binary::of_double_double(ball)?;
        Some(Some(RowValue { double, bounds: binary.bounds(), text: None }))
    };
    let values = quantities.iter().map(value).collect::<Option<Vec<_>>>()?;
    let mode = Some(Mode::Rotational);
    Some(BatchRow { verdict: RowVerdict::Stands, mode, values, reason: None })
}
