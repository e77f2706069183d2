//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::arches::{BatchArches, Threads};
use super::columns::BatchColumns;
use super::row::{BatchRow, RowValue, RowVerdict};
use crate::arch::SelfWeight;
use crate::lanes::{FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneState, Lanes};
use crate::number::{Binary, DoubleDoubleBall};
use crate::problem::{Mode, Quantity};
use std::sync::Arc;

/// Rows below which tables and half-filled lanes would cost more than they spare.
const FEW: usize = 64;

/// Rows that are one piece of work.
const PIECE: usize = 1024;

/// An answer with its place among the rows.
struct Answered<'a> {
    row: usize,
    half_opening: &'a DoubleDoubleBall,
    answer: &'a LaneAnswer,
    /// The frictions at which the mode changes, if they are asked for.
    frictions: Option<&'a LaneFrictions>,
}

/// Things made of the answers to each piece of the rows of a batch and of a weight; none where these would not be rows.
/// Of an answer not all that is asked may be known.
fn pieces<T: Send>(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
    made: impl Fn(&[Answered]) -> T + Send + Sync,
) -> Vec<T> {
    let is_known = |of: &Quantity| *of != Quantity::AsymmetricThickness;
    let count = arches.count();
    if count < FEW || !quantities.iter().all(is_known) {
        return Vec::new();
    }
    let has_frictions = quantities.iter().any(|of| of.is_friction());
    let starts: Vec<usize> = (0..count).step_by(PIECE).collect();
    let found = threads.each(&starts, |start| {
        SelfWeight::ALL.map(|weight| {
            let of_weight = |row: usize| {
                let (of, arch) = arches.in_lanes(row)?;
                (of == weight).then_some((row, arch))
            };
            let rows = (*start..count.min(start + PIECE)).filter_map(of_weight);
            let (rows, arches): (Vec<usize>, Vec<LaneArch>) = rows.unzip();
            answered(has_frictions, weight, (&rows, &arches), &made)
        })
    });
    found.into_iter().flatten().collect()
}

/// Thing made of the answers to some rows of a weight.
fn answered<T>(
    has_frictions: bool,
    weight: SelfWeight,
    (rows, arches): (&[usize], &[LaneArch]),
    made: impl Fn(&[Answered]) -> T,
) -> T {
    let lanes = Lanes::of(weight);
    let answers = lanes.states(arches);
    let half_openings: Vec<_> =
        arches.iter().filter(|_| has_frictions).map(|(alpha, _)| *alpha).collect();
    let frictions = lanes.frictions(&half_openings);
    let each = answers.iter().zip(arches).zip(rows).enumerate();
    let all = each.filter_map(|(place, ((answer, (half_opening, _)), row))| {
        let (answer, frictions) = (answer.as_ref()?, frictions.get(place));
        Some(Answered { row: *row, half_opening, answer, frictions })
    });
    made(&all.collect::<Vec<_>>())
}

/// Rows of a batch with their places; none of which not all that is asked is proved.
pub(super) fn rows(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
) -> Vec<(usize, Arc<BatchRow>)> {
    let made = |answers: &[Answered]| {
        let mut last: Option<(LastRow, Arc<BatchRow>)> = None;
        let row = |answered: &Answered| {
            // At one half opening a rotational state does not depend on the friction, nor does a fall.
            let key = LastRow::new(answered);
            if let Some((of, row)) = &last
                && key.as_ref() == Some(of)
            {
                return Some((answered.row, Arc::clone(row)));
            }
            let row = Arc::new(answered.as_row(quantities)?);
            if let Some(key) = key {
                last = Some((key, Arc::clone(&row)));
            }
            Some((answered.row, row))
        };
        answers.iter().filter_map(row).collect::<Vec<_>>()
    };
    pieces(quantities, arches, threads, made).into_iter().flatten().collect()
}

/// Rows of a batch by columns, some with their places at a time.
pub(super) fn columns(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
) -> Vec<(Vec<usize>, BatchColumns)> {
    let made = |answers: &[Answered]| {
        let mut columns = BatchColumns::open(0, quantities.len());
        let row = |answered: &Answered| {
            columns.push(answered.verdict(), &answered.all_doubles(quantities)?);
            Some(answered.row)
        };
        let rows = answers.iter().filter_map(row).collect();
        (rows, columns)
    };
    pieces(quantities, arches, threads, made)
}

/// All that a row depends on, where it does not depend on its friction.
#[derive(PartialEq, Eq)]
struct LastRow {
    half_opening: [u64; 2],
    falls: bool,
}

impl LastRow {
    fn new(Answered { answer, half_opening, .. }: &Answered) -> Option<Self> {
        let falls = match answer {
            LaneAnswer::Falls => true,
            LaneAnswer::Stands(state) if state.mode == Mode::Rotational => false,
            _ => return None,
        };
        let mid = half_opening.mid();
        Some(Self { half_opening: [mid.hi(), mid.lo()].map(f64::to_bits), falls })
    }
}

/// No number with its bounds: there is none.
const NONE: [f64; 3] = [f64::NAN; 3];

impl Answered<'_> {
    /// Verdict and mode of the row.
    fn verdict(&self) -> (RowVerdict, Option<Mode>) {
        match self.answer {
            LaneAnswer::Stands(state) => (RowVerdict::Stands, Some(state.mode)),
            LaneAnswer::Falls => (RowVerdict::Falls, None),
        }
    }

    /// The nearest double of a quantity with its bounds, not a number where there is no value; `None` where it is not
    /// decided.
    fn doubles(&self, of: Quantity) -> Option<[f64; 3]> {
        use Quantity as Q;
        let state = match self.answer {
            LaneAnswer::Stands(state) => Some(state),
            LaneAnswer::Falls => None,
        };
        let of_state = |of: fn(&LaneState) -> &DoubleDoubleBall| {
            state.map_or(Some(NONE), |state| doubles(of(state)))
        };
        match of {
            Q::Thickness => of_state(|state| &state.thickness),
            Q::Thrust => of_state(|state| &state.thrust),
            Q::IntrinsicThrust => of_state(|state| &state.intrinsic_thrust),
            Q::RotationJoint => of_state(|state| &state.rotation_joint),
            Q::SlidingJoint => {
                state.and_then(|state| state.sliding_joint).map_or(Some(NONE), |x| doubles(&x))
            }
            Q::SlidingFriction => doubles(self.frictions?.sliding.as_ref()?),
            Q::RotationalFriction if state.is_none() => Some(NONE),
            Q::RotationalFriction => match self.frictions?.rotational.as_ref()? {
                FromFriction::From(friction) => doubles(friction),
                FromFriction::Never => Some([f64::INFINITY; 3]),
            },
            _ => None,
        }
    }

    /// The row, if each double is decided.
    fn as_row(&self, quantities: &[Quantity]) -> Option<BatchRow> {
        let (verdict, mode) = self.verdict();
        let value = |[double, lower, upper]: [f64; 3]| {
            let value = RowValue { double, bounds: [lower, upper], text: None };
            (!double.is_nan()).then_some(value)
        };
        let values = self.all_doubles(quantities)?.into_iter().map(value).collect();
        Some(BatchRow { verdict, mode, values, reason: None })
    }

    /// The doubles of each quantity, if they are decided.
    fn all_doubles(&self, quantities: &[Quantity]) -> Option<Vec<[f64; 3]>> {
        quantities.iter().map(|of| self.doubles(*of)).collect()
    }
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
