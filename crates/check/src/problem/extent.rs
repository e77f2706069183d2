//! The part of an arch of equal stones that is looked at.

use crate::arch::whole::Side;
use crate::number::{Angle, Field, Real};

/// States that are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Extent {
    /// The whole arch, with a vertical force in the crown.
    Whole,
    /// A half of it, whose crown bears none and moves up and down: symmetric states.
    Half,
}

impl Extent {
    /// The joints between so many equal stones, in halves of a stone from the crown.
    pub fn joints(self, stones: i32) -> impl Iterator<Item = i32> {
        let first = match self {
            Self::Whole => -stones,
            Self::Half => stones % 2,
        };
        (first..=stones).step_by(2)
    }

    /// The angle of a joint between so many equal stones, by its place in halves of a stone from the crown.
    pub fn angle<T: Real>(joint: i32, stones: i32, half_opening: &T) -> Angle<T> {
        let side = match joint {
            0 => return Angle::zero(half_opening),
            left if left < 0 => Side::Left,
            _ => Side::Right,
        };
        side.joint(&Angle::new(half_opening.clone() * half_opening.ratio(joint.abs(), stones)))
    }

    /// The coefficients of `h, p` and `v`, or the motion dual to them, that count: in a half arch nothing goes with
    /// `v`.
    pub fn seen<T: Field>(self, [h, p, v]: [T; 3]) -> [T; 3] {
        match self {
            Self::Whole => [h, p, v],
            Self::Half => [h, p, v.int(0)],
        }
    }
}
