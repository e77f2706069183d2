//! Rows that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. A row is the same either way: the nearest double and the doubles next
//! to the value depend on the value alone.

use super::arches::{BatchArches, InLanes, Threads};
use super::columns::BatchColumns;
use super::row::RowVerdict;
use crate::arch::SelfWeight;
use crate::certify::state::{Assessment, assessed_in_lanes, standing};
use crate::lanes::{
    FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneRoots, LaneState, Lanes,
};
use crate::number::{Binary, DoubleDoubleBall, Enclosure, Field};
use crate::problem::{Mode, Quantity};
use crate::prover::Undecided;

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
    let asks = |of: fn(Quantity) -> bool| quantities.iter().any(|quantity| of(*quantity));
    let half_openings: Vec<_> =
        arches.iter().filter(|_| asks(Quantity::is_friction)).map(|(alpha, _)| *alpha).collect();
    let frictions = lanes.frictions(&half_openings);
    let wants = [asks(is_of_friction), asks(is_thrust)];
    let thrusts = wants.contains(&true).then(|| Thrusts::new(lanes, (given, &answers), wants));
    let mut columns = BatchColumns::open(0, quantities.len());
    let row = |place: usize| {
        let answer = answers[place].as_ref()?;
        let (verdict, doubles) = match &given[place] {
            (_, None) => of_state(answer, frictions.get(place), quantities)?,
            (_, Some(eta)) => {
                let found = match &thrusts {
                    None => standing(eta, Ok(least(answer))),
                    Some(thrusts) => thrusts.assessed(place, answer, eta),
                };
                of_thickness(&found, quantities)?
            }
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

/// The least thickness of an arch, if there is one.
fn least(answer: &LaneAnswer) -> Option<DoubleDoubleBall> {
    match answer {
        LaneAnswer::Stands(state) => Some(state.thickness),
        LaneAnswer::Falls => None,
    }
}

/// Bounds of the thrusts of arches with thicknesses: what they are found from.
struct Thrusts<'a> {
    weight: SelfWeight,
    given: &'a [InLanes],
    /// True if the required friction is asked for; and the thrusts.
    wants: [bool; 2],
    roots: Vec<LaneRoots>,
    /// The answers at unlimited friction, where they are others.
    unlimited: Vec<Option<LaneAnswer>>,
}

impl<'a> Thrusts<'a> {
    fn new(
        lanes: Lanes,
        (given, answers): (&'a [InLanes], &[Option<LaneAnswer>]),
        wants: [bool; 2],
    ) -> Self {
        let with = |(arch, eta): &InLanes| (*arch, eta.unwrap_or(DoubleDoubleBall::WHOLE));
        let roots = lanes.roots(&given.iter().map(with).collect::<Vec<_>>(), wants);
        let mut unlimited: Vec<Option<LaneAnswer>> = answers.to_vec();
        // A thickness that is enough with friction is so without its limit: then the least with friction says so.
        let is_other = |place: &usize| match (&answers[*place], &given[*place]) {
            (Some(LaneAnswer::Stands(state)), (_, Some(eta))) => {
                state.mode != Mode::Rotational && !state.thickness.is_less_than(eta).is_proved()
            }
            _ => true,
        };
        let places: Vec<usize> = (0..roots.len()).filter(is_other).collect();
        let arches: Vec<LaneArch> = places.iter().map(|place| (given[*place].0.0, None)).collect();
        for (place, answer) in places.iter().zip(lanes.states(&arches)) {
            unlimited[*place] = answer;
        }
        Self { weight: lanes.weight, given, wants, roots, unlimited }
    }

    /// The assessment of an arch from its answer.
    fn assessed(
        &self,
        place: usize,
        answer: &LaneAnswer,
        eta: &DoubleDoubleBall,
    ) -> Assessment<DoubleDoubleBall> {
        let unlimited = self.unlimited[place].as_ref().map(least);
        let unlimited = unlimited.ok_or_else(|| Undecided::new("whether a line of thrust fits"));
        let (arch, _) = self.given[place];
        let least = [Ok(least(answer)), unlimited];
        assessed_in_lanes(self.weight, (arch, eta), least, (&self.roots[place], self.wants))
    }
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
