//! The digits of a solution that is alone on its piece.

use super::conditions::Conditions;
use super::event::{Event, EventKind};
use super::found::{JointedMotion, JointedSolution};
use super::polynomial::ShortPolynomial;
use crate::arch::mechanism::Contact;
use crate::arch::whole::Side;
use crate::number::{Ball, Enclosure, ExactNumber, bits_of};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Extent, JointLimit};
use crate::prover::decide::{ensure, is_positive};
use crate::prover::{Figure, Undecided, raise};
use crate::zero::around_zero;
use rug::{Float, Rational};

/// An arch of equal stones, in as many digits as are asked for.
#[derive(Clone, Copy)]
pub(super) struct StonesInDigits<'a> {
    pub arch: &'a Arch,
    pub stones: &'a Stones,
    pub number: i32,
    pub extent: Extent,
    pub digits: usize,
}

/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// A thickness with its forces, and the conditions with their rates.
pub(super) struct RefinedState {
    pub thickness: Ball,
    /// `h, p, v`.
    pub forces: [Ball; 3],
    pub moving: Vec<(usize, Ball)>,
}

impl RefinedState {
    /// The state of a solution at its thickness, with positive rates. The hinges of one face turn by as much as
    /// those of the other: by one together, or without hinges all rates add up to one.
    pub(super) fn at(
        conditions: &Conditions<Ball>,
        kind: &EventKind,
        thickness: Ball,
    ) -> Result<Self, Undecided> {
        let (of, places, rates) = match kind {
            EventKind::Statics(of, other) => {
                let places: Vec<usize> = of.iter().copied().chain([*other]).collect();
                let rates = conditions.rates(&places);
                (of.clone(), places, rates)
            }
            EventKind::Motion(of, by) => {
                (of.to_vec(), of.to_vec(), conditions.rates_of_three(of, *by))
            }
        };
        let rates: Vec<Ball> = rates.iter().map(|rate| rate.at(&thickness)).collect();
        let contact = |place: &usize| conditions.all[*place].contact;
        let turns = |place: &usize| contact(place) == Contact::Extrados;
        let has_hinges = places.iter().any(turns);
        let counted = places.iter().zip(&rates).filter(|(place, _)| turns(place) || !has_hinges);
        let zero = thickness.clone() - &thickness;
        let sum = counted.fold(zero, |sum, (_, rate)| sum + rate);
        let levels: Vec<Ball> = rates.into_iter().map(|rate| rate / &sum).collect();
        ensure(levels.iter().all(is_positive), "whether each joint moves its way")?;
        let [h, p, v, whole] = conditions.meeting(&of).map(|entry| entry.at(&thickness));
        let forces = [h, p, v].map(|x| x / &whole);
        Ok(Self { thickness, forces, moving: places.into_iter().zip(levels).collect() })
    }
}

impl StonesInDigits<'_> {
    /// The conditions in balls, of `bits` bits at some joints: the others are only named.
    pub(super) fn conditions(&self, bits: u32, joints: &[i32]) -> Conditions<Ball> {
        let is_asked = |joint| joints.contains(&joint);
        Conditions::of(self.arch, self.number, self.extent, bits, is_asked)
    }

    /// The solution on a piece.
    pub(super) fn of(&self, event: &Event) -> Result<JointedSolution, Undecided> {
        let joint = |place: usize| self.extent.joints(self.number).nth(place / 4);
        let joints: Vec<i32> = event.kind.conditions().into_iter().filter_map(joint).collect();
        raise(bits_of(self.digits) + GUARD, |bits| {
            let conditions = self.conditions(bits, &joints);
            let polynomial = match &event.kind {
                EventKind::Statics(of, other) => {
                    conditions.value(*other, of, &conditions.meeting(of))
                }
                EventKind::Motion(of, _) => conditions.determinant(of),
            };
            let thickness = zero_near(&polynomial, event.piece.middle(), bits)?;
            let [low, high] = [event.piece.low, event.piece.high].map(|x| Float::with_val(64, x));
            let is_inside = thickness.lower() >= low && thickness.upper() <= high;
            ensure(is_inside, "which zero of the conditions it is")?;
            let mut state = RefinedState::at(&conditions, &event.kind, thickness)?;
            // Of two mirror images the one with a positive vertical force.
            if (-state.forces[2].clone()).is_positive().is_proved() {
                for (place, _) in &mut state.moving {
                    *place = conditions.mirrored(&[*place])[0];
                }
                state.forces[2] = -state.forces[2].clone();
            }
            Ok(self.rounded(&conditions, &state, false))
        })
    }

    /// The digits of a state; `None` if a rounding is not decided.
    pub(super) fn rounded(
        &self,
        conditions: &Conditions<Ball>,
        state: &RefinedState,
        is_symmetric: bool,
    ) -> Option<JointedSolution> {
        let figure = |x: &Ball| Figure::new(x, self.digits);
        let whole = |n: i32| ExactNumber::from(&Rational::from(n));
        let zero = Figure::exact(&whole(0), 1);
        let [h, p, v] = &state.forces;
        let mut moving: Vec<(&JointLimit<ShortPolynomial<Ball>>, &Ball)> =
            state.moving.iter().map(|(place, rate)| (&conditions.all[*place], rate)).collect();
        moving.sort_by_key(|(condition, _)| -condition.joint);
        let contacts: Vec<Contact> =
            moving.iter().map(|(condition, _)| condition.contact).collect();
        let of_face = |contact| contacts.iter().filter(|other| **other == contact).count();
        let joints = moving.into_iter().map(|(condition, rate)| {
            let side = match condition.joint {
                0 => None,
                k if k > 0 => Some(Side::Right),
                _ => Some(Side::Left),
            };
            let index = u64::from(condition.joint.unsigned_abs() / 2);
            let angle = match (side, self.stones.exact_joint(index)) {
                (None, _) => zero.clone()?,
                (_, Some(exact)) => Figure::exact(&exact, self.digits)?,
                _ => figure(&self.stones.joint(index, state.thickness.prec()))?,
            };
            let contact = side.map_or(condition.contact, |side| side.contact(condition.contact));
            // One hinge of a face turns by one exactly, two mirror images by a half: no ball tells.
            let rate = match (contact.is_hinge(), of_face(contact), is_symmetric) {
                (true, 1, _) => Figure::exact(&whole(1), self.digits)?,
                (true, 2, true) => {
                    Figure::exact(&ExactNumber::from(&Rational::from((1, 2))), self.digits)?
                }
                _ => figure(rate)?,
            };
            Some(JointedMotion { contact, side, angle, rate })
        });
        Some(JointedSolution {
            is_symmetric,
            thickness: figure(&state.thickness)?,
            thrust: figure(h)?,
            crown_moment: figure(p)?,
            vertical_force: if is_symmetric { zero.clone()? } else { figure(v)? },
            joints: joints.collect::<Option<_>>()?,
        })
    }
}

/// Encloses a zero of a polynomial next to a number, by a change of sign.
pub(super) fn zero_near(
    polynomial: &ShortPolynomial<Ball>,
    near: f64,
    bits: u32,
) -> Result<Ball, Undecided> {
    let [low, high] = around_zero(polynomial.coefficients(), &Float::with_val(53, near), bits);
    let [below, above] = [&low, &high].map(|x| polynomial.at(x));
    let changes =
        below.excludes_zero() && above.excludes_zero() && (*below.mid() > 0) != (*above.mid() > 0);
    if changes {
        Ok(low.hull(&high))
    } else {
        Err(Undecided::new("whether a condition changes its sign"))
    }
}
