//! The seven collapse modes: which joints open or slide, and which equations hold.

use super::System;
use super::system::system;
use crate::arch::mechanism::{self, Mechanism};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{Angle, Field, Real, list, worded};

worded! {
    /// A collapse mode of the half arch.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Mode {
        /// `[r,r,r]`: hinges at the shoulder, at the haunch and at the crown.
        Rotational = "[r,r,r]",
        /// `[s,r,r]`: the shoulder slides, the haunch and the crown open.
        SlidingRotational = "[s,r,r]",
        /// `[r,r,s]`: shoulder and haunch open, a joint above the haunch slides; `beta_r > beta_s`.
        RotationalSliding = "[r,r,s]",
        /// `[r,s,r]`: the same with the sliding joint below the rotational one; `beta_r < beta_s`.
        RotationalSlidingRotational = "[r,s,r]",
        /// `[r,s]`: the half arch turns about the shoulder with the crown's intrados as its other hinge,
        /// and a joint slides; `beta_r = 0`.
        OverturningSliding = "[r,s]",
        /// `[r]`: the half arch turns about the shoulder, without thrust, at unlimited friction.
        Overturning = "[r]",
        /// `[s,s]`: the shoulder and an inner joint slide, whatever the thickness.
        Sliding = "[s,s]",
    }
    /// All modes.
    pub const ALL;
    /// The joints from the shoulder, rotational or sliding, as the paper writes them.
    pub fn label -> &'static str;
}

impl Mode {
    /// Orders in which the modes follow each other as the friction grows, each on an interval or not at all: before T,
    /// beyond it (the claim `map-rows`), and beyond the end of rotation, with unlimited friction at the end. With less
    /// friction than where pure sliding begins each of them nothing stands.
    pub const ROWS: [&[Self]; 3] = [
        &list![Mode: Sliding SlidingRotational Rotational],
        &list![Mode: Sliding OverturningSliding RotationalSlidingRotational RotationalSliding Rotational],
        &list![Mode: Sliding OverturningSliding Overturning],
    ];

    /// Orders in which they do as the half opening or the thickness grows, at a limited friction (the claim
    /// `map-columns`) and at unlimited; beyond pure sliding nothing stands.
    pub const COLUMNS: [&[Self]; 2] = [
        &list![Mode:
            Rotational SlidingRotational RotationalSliding RotationalSlidingRotational OverturningSliding Sliding
        ],
        &list![Mode: Rotational Overturning Sliding],
    ];

    /// The mode of a label, by its letters: brackets, commas, spaces, hyphens and the case do not matter.
    pub fn named(text: &str) -> Option<Self> {
        let letters = |text: &str| -> String {
            let kept = text.chars().filter(|c| !"[](){},; -".contains(*c));
            kept.map(|c| c.to_ascii_lowercase()).collect()
        };
        let asked = letters(text);
        Self::ALL.into_iter().find(|mode| letters(mode.label()) == asked)
    }

    /// Tells whether the line of thrust touches the intrados at a hinge below the crown.
    pub fn has_haunch(self) -> bool {
        !matches!(self, Self::OverturningSliding | Self::Overturning | Self::Sliding)
    }

    /// Tells whether an inner joint slides.
    pub fn slides_inside(self) -> bool {
        !matches!(self, Self::Rotational | Self::SlidingRotational | Self::Overturning)
    }

    /// Tells whether the mode exists with limited friction, and with unlimited.
    pub fn exists_with(self, limited_friction: bool) -> bool {
        match self {
            Self::Rotational => true,
            Self::Overturning => !limited_friction,
            _ => limited_friction,
        }
    }

    /// System of the mode: the unknowns at a given half opening and friction, the equations that hold, and
    /// what is fixed.
    pub fn system(self, weight: SelfWeight) -> System {
        use Mode::*;
        match self {
            Rotational => {
                system!(weight; RotationJoint Thickness Thrust; LowerThrust WholeThrust Tangency;)
            }
            SlidingRotational => system! { weight;
                RotationJoint Thickness Thrust; LowerThrust Tangency ShoulderSliding;
            },
            RotationalSliding | RotationalSlidingRotational => system! { weight;
                RotationJoint Thickness Thrust SlidingJoint; UpperThrust Tangency InnerSliding Steepest;
            },
            OverturningSliding => system! { weight;
                Thickness Thrust SlidingJoint; UpperThrust InnerSliding Steepest;
                RotationJoint = Integer(0)
            },
            Overturning => system! { weight;
                Thickness; WholeThrust;
                RotationJoint = Integer(0), Thrust = Integer(0)
            },
            Sliding => {
                system!(weight; Friction Thrust SlidingJoint; ShoulderSliding InnerSliding Steepest;)
            }
        }
    }

    /// Motion of the blocks at collapse, with no dilatancy (zero) or some: what a joint opens by a slip of one.
    pub fn mechanism<T: Field>(self, at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
        match self {
            Self::Rotational => mechanism::rotation(at),
            Self::SlidingRotational => mechanism::shoulder_sliding(at, dilatancy),
            Self::RotationalSliding => mechanism::sliding_above_haunch(at, dilatancy),
            Self::RotationalSlidingRotational => mechanism::sliding_below_haunch(at, dilatancy),
            Self::OverturningSliding => mechanism::overturning_sliding(at, dilatancy),
            Self::Overturning => mechanism::overturning(at),
            Self::Sliding => mechanism::sliding(at, dilatancy),
        }
    }

    /// The finite motion of the blocks, by the angle in radians or the slip at the shoulder.
    pub fn moves<T: Real>(
        self,
        at: &Configuration<T>,
        by: &T,
        dilatancy: &T,
    ) -> Vec<mechanism::Motion<T>> {
        let turn = Angle::new(by.clone());
        use Mode::*;
        match self {
            Rotational => mechanism::moves_rotating(at, &turn),
            SlidingRotational => mechanism::moves_with_shoulder_sliding(at, by, dilatancy),
            RotationalSliding => mechanism::moves_sliding_above_haunch(at, &turn, dilatancy),
            RotationalSlidingRotational => {
                mechanism::moves_sliding_below_haunch(at, &turn, dilatancy)
            }
            OverturningSliding => mechanism::moves_overturning_sliding(at, &turn, dilatancy),
            Overturning => mechanism::moves_overturning(at, &turn),
            Sliding => mechanism::moves_sliding(at, by, dilatancy),
        }
    }

    /// System at a given thickness and friction: the half opening is solved for in place of the thickness,
    /// and for pure sliding in place of the friction.
    pub fn system_for_half_opening(self, weight: SelfWeight) -> System {
        use {Mode::*, Unknown as U};
        let unknowns: &[U] = match self {
            Rotational | SlidingRotational => &[U::RotationJoint, U::HalfOpening, U::Thrust],
            RotationalSliding | RotationalSlidingRotational => {
                &[U::RotationJoint, U::HalfOpening, U::Thrust, U::SlidingJoint]
            }
            OverturningSliding | Sliding => &[U::HalfOpening, U::Thrust, U::SlidingJoint],
            Overturning => &[U::HalfOpening],
        };
        System { unknowns, ..self.system(weight) }
    }
}
