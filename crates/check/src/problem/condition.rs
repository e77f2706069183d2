//! Conditions for a state to be admissible everywhere and the thinnest there is.
//!
//! The lemma behind it, and the multipliers, are in [`arch::contact`](crate::arch::contact).

use super::{Equation, Fixed, Mode, System};
use crate::arch::{SelfWeight, Unknown};
use crate::number::list;

/// One thing that has to be positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Condition {
    /// A variable is above zero.
    Above(Unknown),
    /// A variable is below the largest value it can have.
    Below(Unknown),
    /// `N(alpha) > 0`.
    Compression,
    /// The line of thrust touches the intrados at the crown and stays inside below it.
    IntradosAtCrown,
    /// The line of thrust is inside the extrados at the shoulder.
    ExtradosAtShoulder,
    /// The line of thrust is inside the extrados at the crown.
    ExtradosAtCrown,
    /// Every thicker arch up to `eta = 2` has an admissible state too.
    ThickerStands,
    /// The joint at which `T/N` is largest is a joint of the arch.
    SteepestAboveShoulder,
    /// `mu` is above what the shoulder asks for.
    FrictionAtShoulder,
    /// `mu` is above what the steepest joint asks for.
    FrictionInside,
    /// The joints that give way left of the crown are left of the hinge next to it.
    HingesInOrder,
    /// `beta_r > beta_s`.
    SlidesAboveHaunch,
    /// `beta_r < beta_s`.
    SlidesBelowHaunch,
    /// The mechanism opens the hinge at the shoulder.
    OpensAtShoulder,
    /// The mechanism slides the way friction allows.
    SlidesTheRightWay,
    /// The inner joint slides inwards.
    SlidesInwards,
    /// The shoulder bounds the thrust from above: `sin(alpha) > mu cos(alpha)`.
    ShoulderBoundsThrust,
    /// The shoulder bounds the thrust, unless the weight of the mechanism grows with the thrust.
    GrowsOrIsBounded,
    /// The weight of the mechanism grows with the thrust, which nothing bounds.
    GrowsWithThrust,
    /// The weight of the mechanism is positive without thrust.
    Weight,
    /// No thinner arch has an admissible state without thrust.
    NoneThinner,
    /// The weight of the mechanism is positive at the largest thrust that the shoulder bears.
    WeightAtLargestThrust,
    /// No thinner arch has an admissible state at the largest thrust that the shoulder bears.
    NoneThinnerAtLargestThrust,
    /// The given value of a variable is beyond the limit at which the arch could just stand.
    Beyond(Unknown),
    /// The line of thrust is inside the intrados where the moment about it is least.
    InsideIntrados,
    /// The moment about the intrados falls as far as the shoulder.
    NearestAtShoulder,
}

impl Condition {
    /// Conditions where the equations of the mode hold, for the state to be admissible on the whole half arch
    /// and no thinner arch to stand. What is zero by the equations is not listed.
    pub fn of(mode: Mode, is_limited: bool) -> impl Iterator<Item = Condition> {
        use {Condition as C, Unknown as U};
        let state = &[C::Compression, C::Above(U::Thickness), C::Below(U::Thickness)];
        let thrust = &[C::Above(U::Thrust), C::Below(U::Thrust)];
        let haunch = &[C::Above(U::RotationJoint), C::Below(U::RotationJoint)];
        let thinnest = &list![C:
            ThickerStands GrowsOrIsBounded GrowsWithThrust Weight NoneThinner WeightAtLargestThrust
            NoneThinnerAtLargestThrust
        ];
        // At [r,s] and [r] the crown's pressure point is on the intrados, so not on the extrados.
        let parts: [&[C]; 6] = match mode {
            Mode::Rotational => {
                let own = &[C::SteepestAboveShoulder, C::FrictionAtShoulder, C::FrictionInside];
                [state, thrust, haunch, own, &[C::OpensAtShoulder], thinnest]
            }
            Mode::SlidingRotational => {
                let own = &[C::ExtradosAtShoulder, C::SteepestAboveShoulder, C::FrictionInside];
                let slides = &[C::SlidesTheRightWay, C::ShoulderBoundsThrust];
                [state, thrust, haunch, own, slides, thinnest]
            }
            Mode::RotationalSliding => {
                let own = &[C::ExtradosAtCrown, C::Below(U::SlidingJoint), C::FrictionAtShoulder];
                let slides = &[C::SlidesTheRightWay, C::SlidesAboveHaunch];
                [state, thrust, haunch, own, slides, thinnest]
            }
            Mode::RotationalSlidingRotational => {
                let own = &[C::ExtradosAtCrown, C::Below(U::SlidingJoint), C::FrictionAtShoulder];
                let slides = &[C::SlidesTheRightWay, C::SlidesBelowHaunch];
                [state, thrust, haunch, own, slides, thinnest]
            }
            Mode::OverturningSliding => {
                let own = &[C::IntradosAtCrown, C::Below(U::SlidingJoint), C::FrictionAtShoulder];
                [state, thrust, &[], own, &[C::SlidesTheRightWay], thinnest]
            }
            Mode::Overturning => {
                [state, &[], &[], &[C::IntradosAtCrown], &[C::SlidesTheRightWay], thinnest]
            }
            // No thickness belongs to it.
            Mode::Sliding => {
                let own = &[C::Above(U::Friction), C::Below(U::SlidingJoint)];
                [&[], &[], &[], own, &[], &[]]
            }
        };
        let needed = move |condition: &C| match condition.needs_friction() {
            Some(limited) => limited == is_limited,
            None => true,
        };
        parts.into_iter().flatten().copied().filter(needed)
    }

    /// Description in words of what is positive.
    pub fn label(self) -> &'static str {
        use Unknown as U;
        match self {
            Self::Above(U::HalfOpening) => "a positive half opening",
            Self::Above(U::RotationJoint) => "a rotational joint below the crown",
            Self::Above(U::SlidingJoint) => "a sliding joint below the crown",
            Self::Above(U::Thickness) => "a positive thickness",
            Self::Above(U::Thrust) => "a positive thrust",
            Self::Above(U::Friction) => "a positive friction",
            Self::Above(U::CrownHinge) => "a hinge right of the crown",
            Self::Above(U::CrownMoment) => "a positive moment in the crown",
            Self::Above(U::VerticalForce) => "a positive vertical force in the crown",
            Self::Below(U::HalfOpening) => "a half opening below pi",
            Self::Below(U::RotationJoint) => "a rotational joint above the shoulder",
            Self::Below(U::SlidingJoint) => "a sliding joint above the shoulder",
            Self::Below(U::Thickness) => "a thickness below the physical limit",
            Self::Below(U::Thrust) => "a thrust below one",
            Self::Below(U::CrownHinge) => "a crown hinge above the shoulder",
            Self::Below(U::Friction | U::CrownMoment | U::VerticalForce) => "a bounded variable",
            Self::Compression => "compression at the shoulder",
            Self::IntradosAtCrown => "the line of thrust leaves the intrados at the crown",
            Self::ExtradosAtShoulder => "the line of thrust inside the extrados at the shoulder",
            Self::ExtradosAtCrown => "the line of thrust inside the extrados at the crown",
            Self::ThickerStands => "that every thicker arch stands, up to the physical limit",
            Self::SteepestAboveShoulder => "the steepest joint above the shoulder",
            Self::FrictionAtShoulder => "friction enough at the shoulder",
            Self::FrictionInside => "friction enough inside",
            Self::HingesInOrder => "a crown hinge on the side of the shoulder that slides",
            Self::SlidesInwards => "an inner joint that slides inwards",
            Self::SlidesAboveHaunch => "a sliding joint nearer to the crown",
            Self::SlidesBelowHaunch => "a rotational joint nearer to the crown",
            Self::OpensAtShoulder => "a mechanism that opens at the shoulder",
            Self::SlidesTheRightWay => "a mechanism that slides the right way",
            Self::ShoulderBoundsThrust | Self::GrowsOrIsBounded => {
                "a shoulder that bounds the thrust from above"
            }
            Self::GrowsWithThrust => "a combination that grows with the thrust",
            Self::Weight | Self::WeightAtLargestThrust => "a positive weight of the mechanism",
            Self::NoneThinner | Self::NoneThinnerAtLargestThrust => {
                "that no thinner arch has an admissible state"
            }
            Self::Beyond(U::Friction) => "a friction below that of the purely sliding state",
            Self::Beyond(U::HalfOpening) => "a half opening beyond the limit for the friction",
            Self::Beyond(_) => "a thickness below the least",
            Self::InsideIntrados => "the line of thrust inside the intrados",
            Self::NearestAtShoulder => "the moment about the intrados least at the shoulder",
        }
    }

    /// Tells whether the condition's margin is zero by the equations of a landmark: on one side the state is
    /// of one mode, on the other of another, or no thicker arch is physical.
    pub fn is_tie(self, system: &System) -> bool {
        let holds = |equation| system.equations.contains(&equation);
        let is = |unknown, n| system.fixed_value(unknown) == Some(Fixed::Integer(n));
        match self {
            Self::Above(unknown) => is(unknown, 0),
            Self::Below(Unknown::Thickness) | Self::ThickerStands => is(Unknown::Thickness, 2),
            Self::FrictionAtShoulder => holds(Equation::ShoulderSliding),
            Self::FrictionInside => holds(Equation::InnerSliding),
            Self::ExtradosAtShoulder | Self::ExtradosAtCrown => holds(Equation::WholeThrust),
            Self::IntradosAtCrown => holds(Equation::TangencyAtCrown),
            Self::SlidesAboveHaunch | Self::SlidesBelowHaunch => {
                let haunch = system.fixed_value(Unknown::RotationJoint);
                haunch == Some(Fixed::SameAs(Unknown::SlidingJoint))
            }
            // `L`, where the overturning curve is vertical for Milankovitch's weight: the bracket is (4).
            // It is positive for every thinner arch, as it falls with the thickness.
            Self::NoneThinner => {
                system.weight == SelfWeight::Milankovitch
                    && is(Unknown::Thickness, 2)
                    && is(Unknown::Thrust, 0)
            }
            _ => false,
        }
    }

    /// Tells whether the condition needs a limited friction, or an unlimited one.
    fn needs_friction(self) -> Option<bool> {
        match self {
            Self::SteepestAboveShoulder
            | Self::FrictionAtShoulder
            | Self::FrictionInside
            | Self::Below(Unknown::SlidingJoint)
            | Self::ShoulderBoundsThrust
            | Self::GrowsOrIsBounded
            | Self::WeightAtLargestThrust
            | Self::NoneThinnerAtLargestThrust => Some(true),
            Self::GrowsWithThrust => Some(false),
            _ => None,
        }
    }
}
