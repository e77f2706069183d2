//! The state of a mode, to be examined: how much each condition has to spare.

use super::{Condition, Equation, Mode, tally};
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, SelfWeight, Unknown, sliding, statics};
use crate::number::{Angle, Enclosure, Field, Real, Ternary};
use std::cell::OnceCell;

/// A state to be examined: what a margin is computed from.
pub struct Examined<'a, E> {
    weight: SelfWeight,
    mode: Mode,
    at: &'a Configuration<E>,
    mechanism: OnceCell<Mechanism<E>>,
}

/// The rates of the collapse mechanism, and its weight `W` as a linear function of the thrust.
struct Mechanism<E> {
    rates: Rates<E>,
    weight: E,
    slope: E,
}

impl<'a, E: Enclosure> Examined<'a, E> {
    /// The state of a mode, with angles in radians, lengths in `r` and the thrust in `w r`; the friction
    /// of `at` is read only by conditions on friction.
    pub fn new(weight: SelfWeight, mode: Mode, at: &'a Configuration<E>) -> Self {
        Self { weight, mode, at, mechanism: OnceCell::new() }
    }

    fn mechanism(&self) -> &Mechanism<E> {
        self.mechanism.get_or_init(|| {
            let at = self.at;
            let rates = match self.mode {
                Mode::Rotational => contact::rates_of_rotation(at),
                Mode::SlidingRotational => contact::rates_of_shoulder_sliding(at),
                _ => contact::rates_of_inner_sliding(at),
            };
            let weight = contact::weight_term(&rates, at);
            let slope = contact::thrust_coefficient(&rates, at);
            Mechanism { rates, weight, slope }
        })
    }

    /// What the thinnest arch needs at the largest thrust that the shoulder bears: nothing more than at
    /// none if the weight of the mechanism grows with the thrust.
    fn at_largest_thrust(&self, margin: impl Fn(E) -> E) -> E {
        let Mechanism { weight, slope, .. } = self.mechanism();
        match slope.is_positive() {
            Ternary::True => slope.clone(),
            _ => {
                let bound = sliding::shoulder_thrust(&self.at.half_opening, &self.at.friction);
                margin(weight.clone() + slope.clone() * bound.value())
            }
        }
    }

    fn growth(&self, weight: &E) -> E {
        contact::growth(self.weight, &self.mechanism().rates, self.at, weight)
    }

    /// What has to be positive for a condition to hold.
    pub fn margin(&self, condition: Condition) -> E {
        tally::condition();
        let Self { weight, at, .. } = *self;
        let alpha = &at.half_opening.rad;
        let sliding_joint_above = || at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
        match condition {
            Condition::Above(unknown) => at.value(unknown).clone(),
            Condition::Below(Unknown::HalfOpening) => alpha.pi() - alpha,
            Condition::Below(Unknown::RotationJoint) => alpha.clone() - &at.rotation_joint.rad,
            Condition::Below(Unknown::SlidingJoint) => alpha.clone() - &at.sliding_joint.rad,
            Condition::Below(Unknown::CrownHinge) => alpha.clone() - &at.crown_hinge.rad,
            Condition::Below(Unknown::Thickness) => alpha.int(2) - &at.thickness,
            Condition::Below(Unknown::Thrust) => alpha.int(1) - &at.thrust,
            // Any number is.
            Condition::Below(Unknown::Friction | Unknown::CrownMoment | Unknown::VerticalForce) => {
                alpha.int(1)
            }
            Condition::Compression => statics::normal_force(&at.half_opening, &at.thrust),
            Condition::IntradosAtCrown => contact::crown_slope(weight, at),
            Condition::ExtradosAtShoulder => {
                contact::extrados_margin_at_shoulder(weight, at, &contact::crown_moment(at))
            }
            Condition::ExtradosAtCrown => {
                contact::crown_moment(at) - contact::shoulder_moment(weight, at)
            }
            Condition::ThickerStands => contact::margin_at_physical_limit(weight, at),
            Condition::SteepestAboveShoulder => room_for_steepest(at),
            Condition::FrictionAtShoulder => at.friction.clone() - shoulder_friction(at),
            Condition::FrictionInside => at.friction.clone() - inner_friction(at),
            Condition::SlidesAboveHaunch => sliding_joint_above(),
            Condition::SlidesBelowHaunch => -sliding_joint_above(),
            Condition::OpensAtShoulder => self.mechanism().rates.shoulder.clone(),
            Condition::SlidesTheRightWay => self.mechanism().rates.sliding.clone(),
            Condition::ShoulderBoundsThrust => {
                sliding::shoulder_thrust(&at.half_opening, &at.friction).denominator
            }
            Condition::GrowsOrIsBounded => match self.mechanism().slope.is_positive() {
                Ternary::True => self.mechanism().slope.clone(),
                _ => self.margin(Condition::ShoulderBoundsThrust),
            },
            Condition::GrowsWithThrust => self.mechanism().slope.clone(),
            Condition::Weight => self.mechanism().weight.clone(),
            Condition::NoneThinner => self.growth(&self.mechanism().weight),
            Condition::WeightAtLargestThrust => self.at_largest_thrust(|weight| weight),
            Condition::NoneThinnerAtLargestThrust => {
                self.at_largest_thrust(|weight| self.growth(&weight))
            }
            // These are about what a state does not have: they are not shown.
            Condition::Beyond(_)
            | Condition::InsideIntrados
            | Condition::NearestAtShoulder
            | Condition::HingesInOrder
            | Condition::SlidesInwards => alpha.int(0),
        }
    }
}

/// The friction that the shoulder asks for at the thrust of a state.
pub fn shoulder_friction<T: Field>(at: &Configuration<T>) -> T {
    tally::equation(Equation::ShoulderSliding);
    sliding::shoulder(&at.half_opening, &at.thrust).value()
}

/// What is left between the shoulder and the joint that is steepest at the thrust of a state, rad.
pub fn room_for_steepest<T: Real>(at: &Configuration<T>) -> T {
    at.half_opening.rad.clone() - sliding::steepest_joint(&at.thrust)
}

/// The friction that the steepest joint asks for at the thrust of a state.
pub fn inner_friction<T: Real>(at: &Configuration<T>) -> T {
    tally::equation(Equation::InnerSliding);
    let joint = Angle::new(sliding::steepest_joint(&at.thrust));
    sliding::inner(&joint, &at.thrust).value()
}

/// The most friction that the joints above the shoulder ask for, inwards: at the steepest joint, or at the shoulder if
/// that comes first.
pub fn inward_friction<T: Real>(at: &Configuration<T>, steepest_comes_first: bool) -> T {
    match steepest_comes_first {
        true => inner_friction(at),
        false => -shoulder_friction(at),
    }
}
