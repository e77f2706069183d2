//! States of small half openings: the same conditions, each divided by a power of the half opening, so
//! that nothing cancels.

use super::{Condition, Equation, Mode, tally};
use crate::arch::small::{self, Scaled};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Real, Stumpff};

/// A state of a small half opening to be examined, `[r,r,r]` or `[s,r,r]`.
pub struct ExaminedSmall<'a, T> {
    at: &'a Scaled<T>,
    weight: SelfWeight,
    /// The rotation at the shoulder; that at the crown is one.
    shoulder: T,
    /// The lever arm of the thrust between the haunch's intrados and the crown's extrados, over `alpha²`.
    upper_arm: T,
}

impl<'a, T: Real + Stumpff> ExaminedSmall<'a, T> {
    /// The state of a mode; `None` for a mode that small half openings do not have.
    pub fn new(weight: SelfWeight, mode: Mode, at: &'a Scaled<T>) -> Option<Self> {
        let (upper_arm, lower) = small::arms(at);
        let shoulder = match mode {
            Mode::Rotational => upper_arm.clone() / lower,
            Mode::SlidingRotational => lower.int(0),
            _ => return None,
        };
        Some(Self { at, weight, shoulder, upper_arm })
    }

    /// The weight of the mechanism without thrust, over `alpha²`.
    fn weight_term(&self) -> T {
        let (y, haunch) = (&self.at.opening, &self.at.rotation);
        let turned = self.shoulder.int(1) + &self.shoulder;
        turned * &haunch.square * &haunch.functions[1] + self.shoulder.clone() * &y.functions[1]
    }

    /// Addition of a thrust to that weight.
    fn slope(&self) -> T {
        let one = self.shoulder.int(1);
        let turned = one.clone() + &self.shoulder;
        one + turned * &self.at.rotation.functions[0]
            + self.shoulder.clone() * &self.at.opening.functions[0]
    }

    /// [`Examined::margin`](super::Examined::margin) over a power of the half opening; for a joint, a difference of
    /// squares with the same sign. `None` for a condition that no state of a small half opening has.
    pub fn margin(&self, condition: Condition) -> Option<T> {
        tally::condition();
        let Self { at, weight, .. } = *self;
        let one = at.deficit.int(1);
        let (y, haunch) = (&at.opening, &at.rotation);
        Some(match condition {
            Condition::Above(Unknown::Thickness) => at.thickness.clone(),
            Condition::Below(Unknown::Thickness) => one.int(2) - small::thickness(at),
            Condition::Above(Unknown::Thrust) => one - small::rest(at),
            Condition::Below(Unknown::Thrust) => at.deficit.clone(),
            Condition::Above(Unknown::RotationJoint) => haunch.square.clone(),
            Condition::Below(Unknown::RotationJoint) => one - &haunch.square,
            Condition::Compression => small::normal_force(at),
            Condition::ExtradosAtShoulder => small::extrados_margin_at_shoulder(weight, at),
            Condition::ThickerStands => {
                let centroid = one.clone() + one.ratio(weight.flag(), 3);
                small::normal_force(at) * one.int(2) - centroid * &y.square * &y.functions[2]
            }
            Condition::SteepestAboveShoulder => scaled_room_for_steepest(at),
            Condition::FrictionAtShoulder => at.friction.clone() - scaled_shoulder_friction(at),
            Condition::FrictionInside => at.friction.clone() - scaled_inner_friction(at),
            Condition::OpensAtShoulder => self.shoulder.clone(),
            Condition::SlidesTheRightWay => self.upper_arm.clone(),
            // The denominator of the thrust that the shoulder can bear.
            Condition::ShoulderBoundsThrust => {
                let depth = y.square.clone() * &at.friction;
                y.functions[1].clone() - depth * &y.functions[0]
            }
            // It grows with the thrust: then nothing more is needed at the largest.
            Condition::GrowsWithThrust
            | Condition::GrowsOrIsBounded
            | Condition::WeightAtLargestThrust
            | Condition::NoneThinnerAtLargestThrust => self.slope(),
            Condition::Weight => self.weight_term(),
            Condition::NoneThinner => {
                let turned = self.shoulder.int(1) + &self.shoulder;
                let drop = turned * &haunch.square * &haunch.functions[2]
                    - self.shoulder.clone() * &y.functions[2];
                let centroid = one.int(weight.flag()) * small::thickness(at) * drop / one.int(6);
                self.weight_term() / one.int(2) + centroid
            }
            _ => return None,
        })
    }
}

/// The friction that the shoulder asks for at the thrust of a state, over `alpha³`.
pub fn scaled_shoulder_friction<T: Real + Stumpff>(at: &Scaled<T>) -> T {
    tally::equation(Equation::ShoulderSliding);
    small::shoulder(at).value()
}

/// The friction that the steepest joint asks for at the thrust of a state, over `alpha³`.
pub fn scaled_inner_friction<T: Real + Stumpff>(at: &Scaled<T>) -> T {
    tally::equation(Equation::InnerSliding);
    let h = at.deficit.int(1) - small::rest(at);
    let steepest = (h * &at.deficit).sqrt();
    small::inner(&at.clone().with(Unknown::SlidingJoint, steepest)).value()
}

/// `1 - (beta_s/alpha)²` at the joint that is steepest at the thrust of a state.
pub fn scaled_room_for_steepest<T: Real + Stumpff>(at: &Scaled<T>) -> T {
    let h = at.deficit.int(1) - small::rest(at);
    h.int(1) - h * &at.deficit
}
