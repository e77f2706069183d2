//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::arches::{BatchArches, InLanes, Threads};
use super::columns::BatchColumns;
use super::row::RowVerdict;
use crate::arch::SelfWeight;
use crate::lanes::{FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneState, Lanes};
use crate::number::{Binary, DoubleDoubleBall, Enclosure, Field, Ternary};
use crate::problem::{Mode, Quantity};

/// Rows that are one piece of work.
const PIECE: usize = 1024;

/// An answer with its place among the rows.
struct Answered<'a> {
    row: usize,
    answer: &'a LaneAnswer,
    /// The frictions at which the mode changes, if they are asked for.
    frictions: Option<&'a LaneFrictions>,
    /// The thickness of the arch, if it has one.
    thickness: Option<&'a DoubleDoubleBall>,
}

/// Rows of a batch by columns, some with their places at a time; none of which not all that is asked is proved.
pub(super) fn columns(
    quantities: &[Quantity],
    arches: &impl BatchArches,
    threads: Threads,
) -> Vec<(Vec<usize>, BatchColumns)> {
    let count = arches.count();
    if !quantities.iter().all(|of| is_known(*of)) {
        return Vec::new();
    }
    let starts: Vec<usize> = (0..count).step_by(PIECE).collect();
    let found = threads.each(&starts, |start| {
        SelfWeight::ALL.map(|weight| {
            let of_weight = |row: usize| {
                let (of, given) = arches.in_lanes(row)?;
                (of == weight && given.1.as_ref().is_none_or(is_thickness)).then_some((row, given))
            };
            let rows = (*start..count.min(start + PIECE)).filter_map(of_weight);
            let (rows, given): (Vec<usize>, Vec<InLanes>) = rows.unzip();
            answered(quantities, weight, (&rows, &given))
        })
    });
    found.into_iter().flatten().collect()
}

/// Tells whether rows may have a quantity.
fn is_known(of: Quantity) -> bool {
    use Quantity as Q;
    Q::STATE.contains(&of) || matches!(of, Q::LeastThickness | Q::GeometricSafety)
}

/// Tells whether a number is proved to be in `(0, 2)`.
fn is_thickness(eta: &DoubleDoubleBall) -> bool {
    eta.is_positive().is_proved() && eta.is_less_than(&eta.int(2)).is_proved()
}

/// The answers to some rows of a weight, with those that are answered.
fn answered(
    quantities: &[Quantity],
    weight: SelfWeight,
    (rows, given): (&[usize], &[InLanes]),
) -> (Vec<usize>, BatchColumns) {
    let lanes = Lanes::of(weight);
    let arches: Vec<LaneArch> = given.iter().map(|(arch, _)| *arch).collect();
    let answers = lanes.states(&arches);
    let has_frictions = quantities.iter().any(|of| of.is_friction());
    let half_openings: Vec<_> =
        arches.iter().filter(|_| has_frictions).map(|(alpha, _)| *alpha).collect();
    let frictions = lanes.frictions(&half_openings);
    let mut columns = BatchColumns::open(0, quantities.len());
    let all = rows.iter().zip(&answers).zip(given).enumerate();
    let answered = all.filter_map(|(place, ((row, answer), (_, thickness)))| {
        let (answer, thickness) = (answer.as_ref()?, thickness.as_ref());
        let of = Answered { row: *row, answer, frictions: frictions.get(place), thickness };
        columns.push(of.verdict()?, &of.all_doubles(quantities)?);
        Some(of.row)
    });
    (answered.collect(), columns)
}

/// No number with its bounds: there is none.
const NONE: [f64; 3] = [f64::NAN; 3];

impl Answered<'_> {
    /// Verdict of the row, and mode of a state; `None` where it is not decided.
    fn verdict(&self) -> Option<(RowVerdict, Option<Mode>)> {
        let LaneAnswer::Stands(state) = self.answer else { return Some((RowVerdict::Falls, None)) };
        let Some(eta) = self.thickness else { return Some((RowVerdict::Stands, Some(state.mode))) };
        match (eta.clone() - &state.thickness).is_positive() {
            Ternary::True => Some((RowVerdict::Stands, None)),
            Ternary::False => Some((RowVerdict::Falls, None)),
            Ternary::Undecided => None,
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
            Q::Thickness | Q::LeastThickness => of_state(|state| &state.thickness),
            Q::GeometricSafety => match state {
                Some(state) => doubles(&(self.thickness?.clone() / &state.thickness)),
                None => Some(NONE),
            },
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
