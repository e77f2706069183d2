//! Start values in a table: the square of the rotational joint, a parabola on each cell of the half opening.
//!
//! The table is made of candidates, once for each weight and when it is first asked for. Nothing that is proved rests
//! on it.

use crate::arch::{PerWeight, SelfWeight};
use crate::number::{SinePoint, SinePoints};
use crate::solve::start;
use std::sync::OnceLock;

/// Half openings of the table, rad: below the first one other equations keep their digits, and the last one is next to
/// the end of rotation.
pub(super) const FIRST: f64 = 0.125;
pub(super) const LAST: f64 = 2.5625;

/// The cells. A power of two, so that a place is some bits of a number.
const CELLS: usize = 512;
const WIDTH: f64 = (LAST - FIRST) / (CELLS - 1) as f64;

/// The parabolas, by the distance from the middle of a cell in widths.
pub(super) struct StartTable([[f64; 6]; CELLS]);

/// Candidates of a state.
struct Start {
    /// `beta_r`.
    joint: f64,
    /// The joint that is steepest at the thrust.
    steepest: f64,
}

impl StartTable {
    /// The table of a weight.
    pub(super) fn of(weight: SelfWeight) -> &'static Self {
        static TABLES: PerWeight<OnceLock<StartTable>> =
            PerWeight { heyman: OnceLock::new(), milankovitch: OnceLock::new() };
        TABLES.get(weight).get_or_init(|| Self::new(weight))
    }

    fn new(weight: SelfWeight) -> Self {
        let at = |place: f64| squares(weight, FIRST + place * WIDTH);
        let mut cells = [[0.0; 6]; CELLS];
        let mut left = at(-0.5);
        for (k, cell) in cells.iter_mut().enumerate() {
            let [middle, right] = [0.0, 0.5].map(|by| at(k as f64 + by));
            for (which, parabola) in cell.chunks_exact_mut(3).enumerate() {
                let [left, middle, right] = [left, middle, right].map(|of| of[which]);
                let bend = 2.0 * (left - 2.0 * middle + right);
                parabola.copy_from_slice(&[middle, right - left, bend]);
            }
            left = right;
        }
        Self(cells)
    }

    /// The candidates at a half opening in [`FIRST`] to [`LAST`]; elsewhere they mean nothing.
    #[inline(always)]
    fn start(&self, alpha: f64) -> Start {
        const ROUNDING: f64 = (3u64 << 51) as f64;
        let place = (alpha - FIRST) * (1.0 / WIDTH);
        let rounded = place + ROUNDING;
        let from = place - (rounded - ROUNDING);
        // The last bits of the sum are the integer.
        let [a, b, c, d, e, f] = self.0[rounded.to_bits() as usize % CELLS];
        let root = |square: f64| square.sqrt();
        Start { joint: root(a + from * (b + from * c)), steepest: root(d + from * (e + from * f)) }
    }
}

/// The squares of both joints.
fn squares(weight: SelfWeight, alpha: f64) -> [f64; 2] {
    let [beta, _, thrust] = start::rotational(weight, &alpha);
    [beta * beta, (1.0 - thrust) * thrust]
}

/// Entries of tables for `N` arches, looked up before many go through one text at a time: start values, and the points
/// from which sines and cosines are found.
pub(super) struct Starts<const N: usize> {
    /// Candidates `beta_r`.
    pub(super) joints: [f64; N],
    /// Points next to the half openings.
    pub(super) at_half_openings: SinePoints<N>,
    /// Points next to the candidates `beta_r`.
    pub(super) at_joints: SinePoints<N>,
    /// Points next to the steepest joints.
    pub(super) at_steepest: SinePoints<N>,
}

impl<const N: usize> Starts<N> {
    /// Entries for some half openings.
    #[inline(always)]
    pub(super) fn new(table: &StartTable, half_openings: &[f64; N]) -> Self {
        let (at_half_openings, at_joints, at_steepest) =
            (SinePoints::NONE, SinePoints::NONE, SinePoints::NONE);
        let mut all = Self { joints: [f64::NAN; N], at_half_openings, at_joints, at_steepest };
        for (place, &alpha) in half_openings.iter().enumerate() {
            let Start { joint, steepest } = table.start(alpha);
            all.joints[place] = joint;
            all.at_half_openings.set(place, SinePoint::nearest(alpha));
            all.at_joints.set(place, SinePoint::nearest(joint));
            all.at_steepest.set(place, SinePoint::nearest(steepest));
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_of_the_table_is_the_candidate() {
        for weight in SelfWeight::ALL {
            let table = StartTable::of(weight);
            let steps = (0..=10_000).map(|k| FIRST + (LAST - FIRST) * f64::from(k) / 10_000.0);
            let errors = steps.map(|alpha| {
                let ([joint, steepest], found) = (squares(weight, alpha), table.start(alpha));
                let of_joint = (found.joint - joint.sqrt()).abs();
                of_joint.max((found.steepest - steepest.sqrt()).abs())
            });
            let worst = errors.fold(0.0, f64::max);
            assert!(worst < 1e-4, "{worst}");
            assert!(worst > 0.0);
        }
    }
}
