//! The solution at the least thickness of the stones.
//!
//! That the state there is admissible, and none in a thinner arch, is proved with the
//! [voussoirs](crate::voussoirs()). Without dilatancy the rates of its three conditions are others than
//! the multipliers, but positive too: then it is a solution of (19). Of the whole arch it is one with each rate
//! shared by both sides.

use super::conditions::Conditions;
use super::event::EventKind;
use super::found::JointedSolution;
use super::refine::{RefinedState, StonesInDigits, zero_near};
use super::vertex::SweepStart;
use crate::arch::mechanism::Contact;
use crate::number::{Ball, DoubleBall, Enclosure, Field, bits_of};
use crate::problem::stones::JointContact;
use crate::problem::{Extent, Mode};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::{Undecided, raise};
use crate::voussoirs::VoussoirDigits;

/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// A joint of the half arch, in halves of a stone from the crown.
fn joint(number: i32, (_, index): &JointContact) -> Option<i32> {
    Some(2 * i32::try_from(*index).ok()? + number % 2)
}

/// The conditions of a half arch that are zero at its least thickness and move. A crown that bears nothing, where
/// an arch overturns, opens: both of its hinges turn.
fn moving(state: &VoussoirDigits) -> [JointContact; 3] {
    match (state.mode == Mode::Overturning, state.contacts) {
        (true, [_, haunch, shoulder]) => [(Contact::Extrados, 0), haunch, shoulder],
        (false, same) => same,
    }
}

/// Places of contacts among the conditions.
fn places<T: Arithmetic>(
    conditions: &Conditions<T>,
    number: i32,
    contacts: &[JointContact],
) -> Option<Vec<usize>> {
    contacts.iter().map(|at| conditions.place(at.0, joint(number, at)?)).collect()
}

/// Start of the search: at the least thickness, with its conditions on both sides.
pub(super) fn start(
    conditions: &Conditions<DoubleBall>,
    number: i32,
    state: &VoussoirDigits,
) -> Option<SweepStart> {
    let below = state.thickness.double.next_down();
    let moving = moving(state);
    // A crown that bears nothing is at all of its limits.
    let crown = conditions.all.iter().filter(|at| at.joint == 0 && moving != state.contacts);
    let crown = crown.map(|at| (at.contact, 0));
    let contacts: Vec<JointContact> = moving.iter().copied().chain(crown).collect();
    let half = places(conditions, number, &contacts)?;
    let mirrored = conditions.mirrored(&half);
    let mut touching: Vec<usize> = half.into_iter().chain(mirrored).collect();
    touching.sort_unstable();
    touching.dedup();
    Some(SweepStart { below, touching })
}

/// Start of the search if every thickness stands, with two or three stones: at 0, where the line of thrust
/// through the middle of all joints is a state in which all hinges are zero. So the polynomials of four of
/// them at different joints are zero there.
pub(super) fn start_at_zero(conditions: &Conditions<DoubleBall>) -> SweepStart {
    let is_hinge = |place: &usize| conditions.all[*place].contact.is_hinge();
    SweepStart { below: 0.0, touching: (0..conditions.all.len()).filter(is_hinge).collect() }
}

/// The solution at the least thickness.
pub(super) fn solution(
    digits: &StonesInDigits<'_>,
    found: &VoussoirDigits,
) -> Result<JointedSolution, Undecided> {
    let contacts = moving(found);
    let joints: Vec<i32> = contacts.iter().filter_map(|at| joint(digits.number, at)).collect();
    raise(bits_of(digits.digits) + GUARD, |bits| {
        let half = StonesInDigits { extent: Extent::Half, ..*digits };
        let conditions = half.conditions(bits, &joints);
        let question = || Undecided::new("which conditions are zero at the least thickness");
        let of = places(&conditions, digits.number, &contacts).ok_or_else(question)?;
        // The outer two fix the forces; the order is that of the rates.
        let outer = [of[0], of[2]];
        let kind = EventKind::Statics(outer.to_vec(), of[1]);
        let polynomial = conditions.value(of[1], &outer, &conditions.meeting(&outer));
        let thickness = zero_near(&polynomial, found.thickness.double, bits)?;
        // The zero next to a number is the one that is proved to be the least thickness: it is the only one between
        // them.
        let [low, high] = [&found.thickness.decimal.lower, &found.thickness.decimal.upper]
            .map(|bound| Ball::enclosing(&bound.to_rational(), bits));
        let around = thickness.hull(&low).hull(&high);
        if !polynomial.derivative().at(&around).excludes_zero() {
            return Err(question());
        }
        let mut state = RefinedState::at(&conditions, &kind, thickness)?;
        if found.mode == Mode::Overturning {
            // A crown that bears nothing: no ball tells that the thrust and its moment are zero.
            let zero = state.thickness.int(0);
            state.forces = [zero.clone(), zero.clone(), zero];
        }
        if digits.extent == Extent::Half {
            return Ok(digits.rounded(&conditions, &state, true));
        }
        let whole = digits.conditions(bits, &[]);
        let mut moving = Vec::new();
        for (place, rate) in &state.moving {
            let at = &conditions.all[*place];
            let right = whole.place(at.contact, at.joint).ok_or_else(question)?;
            let left = whole.mirrored(&[right])[0];
            if left == right {
                moving.push((right, rate.clone()));
            } else {
                let share = rate.clone() / rate.int(2);
                moving.extend([(right, share.clone()), (left, share)]);
            }
        }
        Ok(digits.rounded(&whole, &RefinedState { moving, ..state }, true))
    })
}
