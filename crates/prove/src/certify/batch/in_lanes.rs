//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::arches::{BatchArches, Threads};
use super::columns::BatchColumns;
use super::row::RowVerdict;
use crate::arch::SelfWeight;
use crate::certify::state::{Assessment, InLanes, LaneAssessments, is_thickness};
use crate::lanes::{FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneState, Lanes};
use crate::number::{Binary, DoubleDoubleBall};
use crate::problem::{Mode, Quantity};

/// Rows that are one piece of work.
const PIECE: usize = 1024;

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
        let all = arches.many_in_lanes(*start..count.min(start + PIECE));
        SelfWeight::ALL.map(|weight| {
            let of_weight = |(row, given): (usize, &Option<(SelfWeight, InLanes)>)| {
                let (of, given) = (*given)?;
                (of == weight && given.1.as_ref().is_none_or(is_thickness)).then_some((row, given))
            };
            let rows = (*start..).zip(&all).filter_map(of_weight);
            let (rows, given): (Vec<usize>, Vec<InLanes>) = rows.unzip();
            answered(quantities, weight, (&rows, &given))
        })
    });
    found.into_iter().flatten().collect()
}

/// Tells whether rows may have a quantity.
fn is_known(of: Quantity) -> bool {
    of != Quantity::AsymmetricThickness
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
    let asks = |of: fn(Quantity) -> bool| quantities.iter().any(|quantity| of(*quantity));
    let half_openings: Vec<_> =
        arches.iter().filter(|_| asks(Quantity::is_friction)).map(|(alpha, _)| *alpha).collect();
    let frictions = lanes.frictions(&half_openings);
    let wants = [asks(is_of_friction), asks(is_thrust)];
    let assessments = LaneAssessments::new(lanes, (given, &answers), wants);
    let mut columns = BatchColumns::open(0, quantities.len());
    let row = |place: usize| {
        let answer = answers[place].as_ref()?;
        let (verdict, doubles) = match &given[place] {
            (_, None) => of_state(answer, frictions.get(place), quantities)?,
            (_, Some(_)) => of_thickness(&assessments.of(place)?, quantities)?,
        };
        columns.push(verdict, &doubles);
        Some(rows[place])
    };
    ((0..rows.len()).filter_map(row).collect(), columns)
}

fn is_of_friction(of: Quantity) -> bool {
    matches!(of, Quantity::RequiredFriction | Quantity::FrictionSafety)
}

fn is_thrust(of: Quantity) -> bool {
    matches!(of, Quantity::LeastThrust | Quantity::LargestThrust)
}

/// A row without its place: verdict, mode, and each quantity in doubles.
type Row = ((RowVerdict, Option<Mode>), Vec<[f64; 3]>);

/// The row of an assessment, if all that is asked is decided.
fn of_thickness(found: &Assessment<DoubleDoubleBall>, quantities: &[Quantity]) -> Option<Row> {
    let stands = *found.stands.as_ref().ok()?;
    let value = |of: &Quantity| {
        if found.why_open(*of).is_some() {
            return None;
        }
        match found.figures().find(|(figure, _)| figure == of) {
            Some((_, Some(ball))) => doubles(ball),
            Some((_, None)) => Some([f64::INFINITY; 3]),
            None => Some(NONE),
        }
    };
    let verdict = if stands { RowVerdict::Stands } else { RowVerdict::Falls };
    Some(((verdict, None), quantities.iter().map(value).collect::<Option<_>>()?))
}

/// No number with its bounds: there is none.
const NONE: [f64; 3] = [f64::NAN; 3];

/// The row of a state, with the frictions at which the mode changes if they are asked for.
fn of_state(
    answer: &LaneAnswer,
    frictions: Option<&LaneFrictions>,
    quantities: &[Quantity],
) -> Option<Row> {
    use Quantity as Q;
    let (verdict, state) = match answer {
        LaneAnswer::Stands(state) => ((RowVerdict::Stands, Some(state.mode)), Some(state)),
        LaneAnswer::Falls => ((RowVerdict::Falls, None), None),
    };
    let of_state = |of: fn(&LaneState) -> &DoubleDoubleBall| {
        state.map_or(Some(NONE), |state| doubles(of(state)))
    };
    let value = |of: &Quantity| match of {
        Q::Thickness => of_state(|state| &state.thickness),
        Q::Thrust => of_state(|state| &state.thrust),
        Q::IntrinsicThrust => of_state(|state| &state.intrinsic_thrust),
        Q::RotationJoint => of_state(|state| &state.rotation_joint),
        Q::SlidingJoint => {
            state.and_then(|state| state.sliding_joint).map_or(Some(NONE), |x| doubles(&x))
        }
        Q::SlidingFriction => doubles(frictions?.sliding.as_ref()?),
        Q::RotationalFriction if state.is_none() => Some(NONE),
        Q::RotationalFriction => match frictions?.rotational.as_ref()? {
            FromFriction::From(friction) => doubles(friction),
            FromFriction::Never => Some([f64::INFINITY; 3]),
        },
        _ => None,
    };
    Some((verdict, quantities.iter().map(value).collect::<Option<_>>()?))
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
