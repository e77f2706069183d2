//! The four ways in which a joint can be at its limit, as conditions on the thrust `h` and the crown moment `p`,
//! and how it gives way there.

use super::Twist;
use crate::arch::Ring;
use crate::arch::joint::{self, Grip, Row};
use crate::number::{Angle, Field, worded};

worded! {
    /// A joint at its limit.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Contact {
        /// The line of thrust is on the extrados, `U = 0`.
        Extrados = "hinge at the extrados",
        /// The line of thrust is on the intrados, `L = 0`.
        Intrados = "hinge at the intrados",
        /// `T = mu N`: the part above slides inwards.
        Inwards = "slides inwards",
        /// `-T = mu N`: the part above slides outwards.
        Outwards = "slides outwards",
    }
    /// All four contacts.
    pub const ALL;
    /// The name in files.
    pub fn name -> &'static str;
}

impl Contact {
    /// Tells whether the joint is a hinge.
    pub fn is_hinge(self) -> bool {
        matches!(self, Self::Extrados | Self::Intrados)
    }

    /// Row of a joint's condition: what must not be positive.
    pub fn row<T: Field>(self, joint: &Angle<T>, ring: &Ring<T>, grip: &Grip<T>) -> Row<T> {
        match self {
            Self::Extrados => joint::extrados(joint, ring),
            Self::Intrados => joint::intrados(joint, ring),
            Self::Inwards => joint::inwards(joint, grip),
            Self::Outwards => joint::outwards(joint, grip),
        }
    }

    /// Margin of a joint, for a thrust `h` and a crown moment `p`: the distances of the line of thrust from
    /// the extrados and from the intrados, times `N`; `mu N - T` and `mu N + T`.
    pub fn margin<T: Field>(
        self,
        joint: &Angle<T>,
        ring: &Ring<T>,
        [thrust, crown_moment, friction]: [&T; 3],
    ) -> T {
        let grip = Grip { shear: thrust.int(1), normal: friction.clone() };
        -self.row(joint, ring, &grip).at(thrust, crown_moment)
    }

    /// Motion of the crown side of a joint against its shoulder side at the rate one. A hinge turns about its
    /// face, so that the other face opens; a joint slides along itself and, with `dilatancy`, opens by so
    /// much a slip.
    pub fn twist<T: Field>(self, joint: &Angle<T>, thickness: &T, dilatancy: &T) -> Twist<T> {
        let two = thickness.int(2);
        let at = |twice: T| [&joint.sin, &joint.cos].map(|x| twice.clone() * x / &two);
        let opens = [-(dilatancy.clone() * &joint.cos), dilatancy.clone() * &joint.sin];
        let [across, up] = opens;
        match self {
            Self::Extrados => Twist::about(&at(two.clone() + thickness), -thickness.int(1)),
            Self::Intrados => Twist::about(&at(two.clone() - thickness), thickness.int(1)),
            Self::Inwards => Twist::translation([across - &joint.sin, up - &joint.cos]),
            Self::Outwards => Twist::translation([across + &joint.sin, up + &joint.cos]),
        }
    }

    /// The slip that moves the crown side sideways by `across`, inwards or outwards as the joint slides.
    pub(super) fn slip<T: Field>(self, joint: &Angle<T>, across: &T, dilatancy: &T) -> T {
        let [unit, _] = self.twist(joint, dilatancy, dilatancy).velocity;
        let sideways = match self {
            Self::Inwards => -unit,
            _ => unit,
        };
        across.clone() / sideways
    }
}

/// A joint that gives way.
#[derive(Clone, Debug)]
pub struct Joint<T> {
    /// Contact of the joint.
    pub contact: Contact,
    /// Place of the joint.
    pub at: Angle<T>,
    /// The rotation or the slip: not negative.
    pub rate: T,
    /// Opening for each unit of slip; zero without dilatancy.
    pub dilatancy: T,
}

impl<T: Field> Joint<T> {
    /// The relative twist "crown side less shoulder side" in an arch of a thickness.
    pub fn twist(&self, thickness: &T) -> Twist<T> {
        let unit = self.contact.twist(&self.at, thickness, &self.dilatancy);
        let [across, up] = unit.velocity.map(|x| x * &self.rate);
        Twist { rotation: unit.rotation * &self.rate, velocity: [across, up] }
    }
}
