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
    /// The joints between so many equal stones, in halves of a stone from the crown, with their angles.
    pub fn joints<T: Real>(self, stones: i32, half_opening: &T) -> Vec<(i32, Angle<T>)> {
        let first = match self {
            Self::Whole => -stones,
            Self::Half => stones % 2,
        };
        let angle = |k: i32| match k {
            0 => Angle::zero(half_opening),
            _ => {
                let side = if k < 0 { Side::Left } else { Side::Right };
                side.joint(&Angle::new(half_opening.clone() * half_opening.ratio(k.abs(), stones)))
            }
        };
        (first..=stones).step_by(2).map(|k| (k, angle(k))).collect()
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
