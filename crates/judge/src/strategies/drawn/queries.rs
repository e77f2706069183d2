//! A question about an arch, as it is typed.

use super::numbers::{friction, half_opening, weight};
use crate::arch::joint::Grip;
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Ball, ExactNumber, shown_as_text};
use crate::problem::{Arch, ArchError, Friction, Landmark};
use crate::strategies::places::{DIGITS, beside};
use proptest::prelude::*;
use proptest::sample::select;
use std::fmt;

/// Question about an arch. It is shown as the command that answers it.
#[derive(Clone, PartialEq, Eq)]
pub struct DrawnQuery {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening, rad; its text is what was drawn.
    pub half_opening: ExactNumber,
    /// The friction.
    pub friction: Friction,
}

impl DrawnQuery {
    /// The arch, to be certified; an error for a query that no strategy here draws.
    pub fn arch(&self) -> Result<Arch, ArchError> {
        Arch::new(self.weight, self.half_opening.clone(), self.friction.clone())
    }

    /// Half opening (rad) and friction coefficient as the nearest doubles, for a solver that has no more;
    /// unlimited friction is infinite.
    pub fn doubles(&self) -> (f64, f64) {
        // More bits than a tie between two doubles could hide in.
        let Grip { shear, normal } = self.friction.grip::<Ball>(256);
        let friction = match self.friction {
            Friction::Infinite => f64::INFINITY,
            _ => (normal / shear).mid().to_f64(),
        };
        (self.half_opening.enclosure::<Ball>(256).mid().to_f64(), friction)
    }
}

impl fmt::Display for DrawnQuery {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { weight, half_opening, friction } = self;
        write!(f, "couplet state --weight {weight} --half-opening {half_opening}")?;
        match friction {
            Friction::Coefficient(mu) => write!(f, " --friction {mu}"),
            Friction::Angle(phi) => write!(f, " --friction-angle {phi}"),
            Friction::Infinite => f.write_str(" --friction inf"),
        }
    }
}

shown_as_text!(DrawnQuery);

/// Queries of the domain and next to it; one in five next to a landmark.
pub(super) fn any_query() -> impl Strategy<Value = DrawnQuery> {
    let anywhere = (weight(), half_opening(), friction())
        .prop_map(|(weight, half_opening, friction)| DrawnQuery { weight, half_opening, friction });
    prop_oneof![4 => anywhere, 1 => beside_a_landmark()]
}

/// Half opening and, where the landmark has one, friction just below or above those of a landmark.
fn beside_a_landmark() -> impl Strategy<Value = DrawnQuery> {
    let digits = || (3..=DIGITS, any::<bool>());
    let drawn = (weight(), select(&Landmark::ALL), digits(), digits(), friction());
    drawn.prop_filter_map("the landmark is certified", |(weight, landmark, first, second, any)| {
        let beside = |unknown, (digits, above)| {
            beside(landmark, weight, unknown, digits, above)?.parse::<ExactNumber>().ok()
        };
        let friction = beside(Unknown::Friction, second).map_or(any, Friction::Coefficient);
        Some(DrawnQuery { weight, half_opening: beside(Unknown::HalfOpening, first)?, friction })
    })
}
