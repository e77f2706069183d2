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
    mechanism: OnceCell<ExaminedMechanism<E>>,
}

/// The rates of the collapse mechanism, and its weight `W` as a linear function of the thrust.
struct ExaminedMechanism<E> {
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

    fn mechanism(&self) -> &ExaminedMechanism<E> {
        self.mechanism.get_or_init(|| {
            let at = self.at;
            let rates = match self.mode {
                Mode::Rotational => contact::rates_of_rotation(at),
                Mode::SlidingRotational => contact::rates_of_shoulder_sliding(at),
                _ => contact::rates_of_inner_sliding(at),
            };
            let weight = contact::weight_term(&rates, at);
            let slope = contact::thrust_coefficient(&rates, at);
            ExaminedMechanism { rates, weight, slope }
        })
    }

    /// Condition of the thinnest arch at the largest thrust that the shoulder bears: nothing more than at
    /// none if the weight of the mechanism grows with the thrust.
    fn at_largest_thrust(&self, margin: impl Fn(E) -> E) -> E {
        let ExaminedMechanism { weight, slope, .. } = self.mechanism();
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

    /// Margin of a condition: positive where it holds.
    pub fn margin(&self, condition: Condition) -> E {
        tally::condition();
        let Self { weight, at, .. } = *self;
        let alpha = &at.half_opening.rad;
        let sliding_joint_above = || at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
        use Condition::*;
        match condition {
            Above(unknown) => at.value(unknown).clone(),
            Below(Unknown::HalfOpening) => alpha.pi() - alpha,
            Below(Unknown::RotationJoint) => alpha.clone() - &at.rotation_joint.rad,
            Below(Unknown::SlidingJoint) => alpha.clone() - &at.sliding_joint.rad,
            Below(Unknown::CrownHinge) => alpha.clone() - &at.crown_hinge.rad,
            Below(Unknown::Thickness) => alpha.int(2) - &at.thickness,
            Below(Unknown::Thrust) => alpha.int(1) - &at.thrust,
            // Any number is.
            Below(Unknown::Friction | Unknown::CrownMoment | Unknown::VerticalForce) => {
                alpha.int(1)
            }
            Compression => statics::normal_force(&at.half_opening, &at.thrust),
            IntradosAtCrown => contact::crown_slope(weight, at),
            ExtradosAtShoulder => {
                contact::extrados_margin_at_shoulder(weight, at, &contact::crown_moment(at))
            }
            ExtradosAtCrown => contact::crown_moment(at) - contact::shoulder_moment(weight, at),
            ThickerStands => contact::margin_at_physical_limit(weight, at),
            SteepestAboveShoulder => room_for_steepest(at),
            FrictionAtShoulder => at.friction.clone() - shoulder_friction(at),
            FrictionInside => at.friction.clone() - inner_friction(at),
            SlidesAboveHaunch => sliding_joint_above(),
            SlidesBelowHaunch => -sliding_joint_above(),
            OpensAtShoulder => self.mechanism().rates.shoulder.clone(),
            SlidesTheRightWay => self.mechanism().rates.sliding.clone(),
            ShoulderBoundsThrust => {
                sliding::shoulder_thrust(&at.half_opening, &at.friction).denominator
            }
            GrowsOrIsBounded => match self.mechanism().slope.is_positive() {
                Ternary::True => self.mechanism().slope.clone(),
                _ => self.margin(ShoulderBoundsThrust),
            },
            GrowsWithThrust => self.mechanism().slope.clone(),
            Weight => self.mechanism().weight.clone(),
            NoneThinner => self.growth(&self.mechanism().weight),
            WeightAtLargestThrust => self.at_largest_thrust(|weight| weight),
            NoneThinnerAtLargestThrust => self.at_largest_thrust(|weight| self.growth(&weight)),
            // These are about what a state does not have: they are not shown.
            Beyond(_) | InsideIntrados | NearestAtShoulder | HingesInOrder | SlidesInwards => {
                alpha.int(0)
            }
        }
    }
}

/// The friction that the shoulder asks for at the thrust of a state.
pub fn shoulder_friction<T: Field>(at: &Configuration<T>) -> T {
    tally::equation(Equation::ShoulderSliding);
    sliding::shoulder(&at.half_opening, &at.thrust).value()
}

/// Angle between the shoulder and the joint that is steepest at the thrust of a state, rad.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::AstroInterval;
    use crate::problem::{Arch, Problem};
    use Condition as C;

    /// The conditions that do not hold in a made-up configuration `alpha, beta_r, beta_s, eta, h, mu`, in
    /// hundredths. It solves no equation: that a condition is looked at shows where it fails.
    fn failures(mode: Mode, friction: &str, hundredths: [i32; 6]) -> Vec<Condition> {
        let weight = SelfWeight::Milankovitch;
        let arch = Arch::new(weight, "1".parse().unwrap(), friction.parse().unwrap()).unwrap();
        let problem = Problem::State { mode, arch };
        let like = AstroInterval::integer(0, 128);
        let unknowns = [
            Unknown::HalfOpening,
            Unknown::RotationJoint,
            Unknown::SlidingJoint,
            Unknown::Thickness,
            Unknown::Thrust,
            Unknown::Friction,
        ];
        let at = unknowns
            .into_iter()
            .zip(hundredths)
            .fold(Configuration::zero(&like), |at, (unknown, n)| {
                at.with(unknown, like.ratio(n, 100))
            });
        let state = Examined::new(weight, mode, &at);
        let fails = |condition: &C| !state.margin(*condition).is_positive().is_proved();
        let [(_, conditions)] = &problem.conditions()[..] else { panic!("{mode} is one mode") };
        let failures: Vec<C> = conditions.iter().copied().filter(fails).collect();
        // What the checker calls finds the first of them.
        assert_eq!(problem.first_failure(&at, 128), failures.first().copied());
        failures
    }

    /// Conditions that hold at every known root where the others do are refused alone: all the others hold here.
    #[test]
    fn a_condition_fails_alone() {
        let cases = [
            (Mode::Rotational, "1", [264, 180, 0, 125, 50, 359], C::ThickerStands),
            (Mode::RotationalSliding, "1", [259, 165, 19, 136, 50, 347], C::ThickerStands),
            (
                Mode::RotationalSlidingRotational,
                "1",
                [259, 81, 158, 140, 51, 315],
                C::ThickerStands,
            ),
            (Mode::OverturningSliding, "1", [242, 0, 104, 175, 74, 321], C::ThickerStands),
            (Mode::Overturning, "inf", [267, 0, 0, 153, 0, 0], C::ThickerStands),
            (Mode::Rotational, "1", [42, 10, 0, 6, 34, 377], C::SteepestAboveShoulder),
            (Mode::SlidingRotational, "1", [42, 35, 0, 134, 51, 35], C::SteepestAboveShoulder),
            (Mode::SlidingRotational, "1", [121, 83, 0, 147, 39, 391], C::ShoulderBoundsThrust),
            (Mode::Rotational, "inf", [229, 175, 0, 83, 50, 0], C::GrowsWithThrust),
        ];
        for (mode, friction, at, condition) in cases {
            assert_eq!(failures(mode, friction, at), [condition], "{mode} {at:?}");
        }
        // A wider arch of the same numbers has no fault.
        assert_eq!(failures(Mode::SlidingRotational, "1", [171, 83, 0, 147, 39, 391]), []);
    }

    /// Two conditions follow from the equations and the other conditions: that no arch is thinner, and that the
    /// mechanism has a weight (`proofs/coq/States.v`, whose theorems do without them). So they fail in company only.
    #[test]
    fn what_excludes_thinner_arches_fails_too() {
        let none = C::NoneThinner;
        let thick = [C::ThickerStands, none];
        assert_eq!(failures(Mode::Rotational, "inf", [292, 21, 0, 179, 28, 0]), thick);
        assert_eq!(failures(Mode::Rotational, "1", [277, 9, 0, 193, 27, 374]), thick);
        assert_eq!(failures(Mode::OverturningSliding, "1", [275, 0, 11, 188, 30, 394]), thick);
        assert_eq!(failures(Mode::Overturning, "inf", [274, 0, 0, 192, 0, 0]), thick);
        let closes = C::OpensAtShoulder;
        let bounded = [closes, C::GrowsOrIsBounded, C::Weight, none];
        assert_eq!(failures(Mode::Rotational, "1", [117, 59, 0, 121, 50, 385])[..4], bounded);
        let grows = [closes, C::GrowsWithThrust, C::Weight, none];
        assert_eq!(failures(Mode::Rotational, "inf", [117, 59, 0, 121, 50, 0]), grows);
        let largest = [C::WeightAtLargestThrust, C::NoneThinnerAtLargestThrust];
        let all = [&[closes, C::Weight, none], &largest[..]].concat();
        assert_eq!(failures(Mode::Rotational, "1", [143, 86, 0, 144, 50, 287]), all);
    }
}
