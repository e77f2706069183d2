//! The landmark points of the `eta`-`mu` map, each as a square system with a simple root.
//!
//! | point | equations | what is fixed |
//! |---|---|---|
//! | `T` triple | (2), (4), (5), (17), (18) | |
//! | `S` shift | (3), (5), (17), (18) | `beta_r = beta_s` |
//! | `J` junction | (3), (5) at `beta_r -> 0`, (17), (18) | `beta_r = 0` |
//! | `B` border | (3), (17), (18) | `beta_r = 0`, `eta = 2` |
//! | `l` end of rotation | (4), (5) at `beta_r -> 0` | `h = 0`, `beta_r = beta_s = 0`, `mu = inf` |
//! | `L` end of overturning | (4) | `h = 0`, `eta = 2`, `beta_r = beta_s = 0`, `mu = inf` |
//! | `sb` widest joint | (2), (4), (5), `d/d eta` of (2) = (5) | |
//!
//! (18) stands for two equations, the friction at `beta_s` and `beta_s² = h (1 - h)`, which keeps
//! square roots out of the system.
//!
//! Three of them are degenerate as the paper states them, and are posed here so that the root is
//! simple:
//!
//! - **`l` and `J`**, `beta_r -> 0`. Equation (5) is 0/0 at `beta_r = 0` and even in `beta_r`, so the
//!   states nearby come in pairs `±beta_r` and `beta_r` grows like the square root of the distance.
//!   But (5) sees the joint only through `beta cot(beta) = 1 - beta²/3 - …`, which is analytic with
//!   the value 1; putting that value leaves a regular system in the other unknowns. For `l`, (2) holds
//!   too, since its numerator has a factor `beta²`.
//! - **`sb`**: there two branches of the cubic (7) meet, so (2) and (5) have a double root in `eta`,
//!   and adding the radicand (12) leaves the Jacobian singular. Adding instead that the derivative of
//!   (2) = (5) to `eta` is zero gives, in `(beta, eta)`, the Jacobian
//!   `[[G_beta, 0], [G_beta_eta, G_eta_eta]]`, which is regular because neither `G_beta` nor
//!   `G_eta_eta` vanishes; and it is the same equation for both weights.

use super::system::system;
use super::{Condition, Fixed, Mode, System};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{says, worded};
use std::iter;

/// Reason why a text is no landmark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoLandmark;

says!(NoLandmark {
    Self => "a landmark is one of {}, or {}",
        Landmark::ALL.map(Landmark::symbol).join(", "), Landmark::ALL.map(Landmark::long_name).join(", ");
});

worded! {
    /// A landmark point.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum Landmark {
        /// `T`: four collapse modes meet.
        Triple = ["T", "triple point", "triple"],
        /// `S`: the rotational and the sliding joint coincide.
        Shift = ["S", "shift point", "shift"],
        /// `J`: the rotational joint reaches the crown.
        Junction = ["J", "junction point", "junction"],
        /// `B`: the physical limit `eta = 2` is reached.
        Border = ["B", "border point", "border"],
        /// `l`: the end of the purely rotational states.
        RotationEnd = ["l", "end of rotation", "rotation-end"],
        /// `L`: the end of the purely overturning states.
        OverturningEnd = ["L", "end of overturning", "overturning-end"],
        /// `sb`: the rotational joint is widest.
        WidestJoint = ["sb", "widest rotational joint", "widest-joint"],
    }
    /// All landmarks in the order in which they are shown.
    pub const ALL;
    /// Symbol, name to show, and name to type.
    fn names -> [&'static str; 3];
}

impl Landmark {
    /// The symbol used on the command line and in files; `l` and `L` differ.
    pub fn symbol(self) -> &'static str {
        self.names()[0]
    }

    /// A name to show.
    pub fn name(self) -> &'static str {
        self.names()[1]
    }

    /// A name to type: the symbols `l` and `L` are easily confused.
    pub fn long_name(self) -> &'static str {
        self.names()[2]
    }

    /// The landmark of a symbol or of a long name, whose case does not matter.
    pub fn named(name: &str) -> Option<Self> {
        let is_named = |landmark: &Self| {
            landmark.symbol() == name
                || landmark.long_name().eq_ignore_ascii_case(&name.replace(['_', ' '], "-"))
        };
        Self::ALL.into_iter().find(is_named)
    }

    /// The collapse modes that meet at the landmark: those whose equations follow from its own. At `T`
    /// (3) follows from (2) and (4); at the others each mode has a part of the landmark's equations.
    pub fn modes(self) -> &'static [Mode] {
        use Mode::*;
        match self {
            Self::Triple => &[Rotational, SlidingRotational, RotationalSliding, Sliding],
            Self::Shift => &[RotationalSliding, RotationalSlidingRotational, Sliding],
            Self::Junction => &[RotationalSlidingRotational, OverturningSliding, Sliding],
            Self::Border => &[OverturningSliding, Sliding],
            Self::RotationEnd => &[Rotational, Overturning],
            Self::OverturningEnd => &[Overturning],
            Self::WidestJoint => &[Rotational],
        }
    }

    /// The system whose root the landmark is.
    pub fn system(self, weight: SelfWeight) -> System {
        match self {
            Self::Triple => system! { weight;
                HalfOpening RotationJoint SlidingJoint Thickness Thrust Friction;
                LowerThrust WholeThrust Tangency ShoulderSliding InnerSliding Steepest;
            },
            Self::Shift => system! { weight;
                HalfOpening SlidingJoint Thickness Thrust Friction;
                UpperThrust Tangency ShoulderSliding InnerSliding Steepest;
                RotationJoint = SameAs(Unknown::SlidingJoint)
            },
            Self::Junction => system! { weight;
                HalfOpening SlidingJoint Thickness Thrust Friction;
                UpperThrust TangencyAtCrown ShoulderSliding InnerSliding Steepest;
                RotationJoint = Integer(0)
            },
            Self::Border => system! { weight;
                HalfOpening SlidingJoint Thrust Friction; UpperThrust ShoulderSliding InnerSliding Steepest;
                RotationJoint = Integer(0), Thickness = Integer(2)
            },
            Self::RotationEnd => system! { weight;
                HalfOpening Thickness; WholeThrust TangencyAtCrown;
                Thrust = Integer(0), RotationJoint = Integer(0), SlidingJoint = Integer(0), Friction = Infinite
            },
            Self::OverturningEnd => system! { weight;
                HalfOpening; WholeThrust;
                Thickness = Integer(2), Thrust = Integer(0), RotationJoint = Integer(0), SlidingJoint = Integer(0), Friction = Infinite
            },
            Self::WidestJoint => system! { weight;
                HalfOpening RotationJoint Thickness Thrust; LowerThrust WholeThrust Tangency DoubleThickness;
            },
        }
    }

    /// Conditions of the landmark, mode by mode: the physical range of what is solved for, `0 < alpha < pi`,
    /// `0 < beta < alpha`, `0 < eta < 2`, `0 < h < 1`, `mu > 0`; and all that the state of each mode that
    /// meets there needs, so that its lines of thrust and of friction are inside the arch and no thinner one
    /// stands. What is zero by the equations is left out: there the modes meet.
    pub fn conditions(self, weight: SelfWeight) -> Vec<(Mode, Vec<Condition>)> {
        let range = |unknown: &Unknown| [Condition::Above(*unknown), Condition::Below(*unknown)];
        let range = self.system(weight).unknowns.iter().flat_map(range).collect();
        iter::once((self.modes()[0], range)).chain(self.of_modes(weight, false)).collect()
    }

    /// Conditions that the state of each mode that meets there needs and that are zero by the equations.
    pub fn ties(self, weight: SelfWeight) -> Vec<(Mode, Vec<Condition>)> {
        self.of_modes(weight, true).collect()
    }

    /// Tells whether the landmark has a friction, and not an unlimited one.
    pub fn is_limited(self) -> bool {
        let system = self.system(SelfWeight::Heyman);
        system.knows(Unknown::Friction)
            && system.fixed_value(Unknown::Friction) != Some(Fixed::Infinite)
    }

    /// Conditions of the modes, mode by mode: those that are zero by the equations, or the others.
    fn of_modes(
        self,
        weight: SelfWeight,
        are_ties: bool,
    ) -> impl Iterator<Item = (Mode, Vec<Condition>)> {
        let system = self.system(weight);
        self.modes().iter().map(move |mode| {
            let all = Condition::of(*mode, self.is_limited());
            (*mode, all.filter(|condition| condition.is_tie(&system) == are_ties).collect())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::Configuration;
    use crate::number::Angle;

    #[test]
    fn a_landmark_has_two_names() {
        for landmark in Landmark::ALL {
            assert_eq!(Landmark::named(landmark.symbol()), Some(landmark));
            assert_eq!(Landmark::named(landmark.long_name()), Some(landmark));
        }
        assert_eq!(Landmark::named("Rotation_End"), Some(Landmark::RotationEnd));
        assert_eq!(Landmark::named("t"), None, "in symbols the case counts");
    }

    #[test]
    fn every_system_is_square_and_reads_only_what_it_knows() {
        for landmark in Landmark::ALL {
            let system = landmark.system(SelfWeight::Milankovitch);
            assert_eq!(system.unknowns.len(), system.equations.len(), "{landmark:?}");
            // A variable that the system does not know is set to NaN: no residual may see it.
            let values: Vec<f64> = (1..=system.unknowns.len()).map(|i| 0.3 * i as f64).collect();
            let at = system.place(Configuration::zero(&0.0), &values);
            let known = |u| system.knows(u) && system.fixed_value(u) != Some(Fixed::Infinite);
            let spoiled = at.map_each(
                |u, x| if known(u) { x } else { Angle::new(f64::NAN) },
                |u, x| if known(u) { x } else { f64::NAN },
            );
            for equation in system.equations {
                let residual = equation.residual(system.weight, &spoiled);
                assert!(residual.is_finite(), "{landmark:?} {equation:?}");
            }
        }
    }
}
