//! Stability of an arch of a given thickness that is drawn, with a joint at every angle or between stones.

use crate::certify::state::{Assessment, Fall, Figure, Limit};
use crate::certify::{Answered, Undecided};
use crate::number::Ball;
use crate::problem::stones::Stones;
use couplet_stones::{VoussoirAssessment, VoussoirLimit, VoussoirStanding, Voussoirs};

/// Stability of an arch of a given thickness, all of it decided.
#[derive(Clone, Debug)]
pub struct Stability {
    /// Tells whether the arch stands.
    pub stands: bool,
    /// Reason why no thickness is enough, if none is.
    pub fall: Option<Fall>,
    /// The least thickness; `None` if there is none.
    pub least_thickness: Option<Ball>,
    /// The thickness over the least thickness.
    pub geometric_safety: Option<Ball>,
    /// The least friction with which it stands; `None` if none is enough: no line of thrust lies within it.
    pub required_friction: Option<Ball>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Option<Ball>,
    /// The least and the largest thrust of an arch that stands.
    pub thrust: [Option<Bound>; 2],
}

/// A bound of the thrust.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The thrust; `None` if any size will do.
    pub thrust: Option<Ball>,
    /// Description of the limit, in words.
    pub by: String,
}

impl Stability {
    /// Stability of an arch with a joint at every angle.
    pub(super) fn of_arch(found: &Assessment) -> Result<Self, Undecided> {
        if let Some((_, open)) = found.open().next() {
            return Err(open.clone());
        }
        let bound = |limit: &Limit| Bound {
            thrust: limit.thrust.clone(),
            by: limit.touch.name().to_owned(),
        };
        let [least, largest] = found.thrust.clone().map(|end| Ok(end?.as_ref().map(bound)));
        Ok(Self {
            stands: found.stands.clone()?,
            fall: found.fall,
            least_thickness: found.least_thickness.clone()?,
            geometric_safety: found.geometric_safety.clone()?,
            required_friction: found.required_friction.clone()?,
            friction_safety: found.friction_safety.clone()?,
            thrust: [least?, largest?],
        })
    }

    /// Stability of an arch of stones, with what is proved of its least thickness.
    pub(super) fn of_stones(
        (stones, is_limited): (&Stones, bool),
        least: &Voussoirs,
        found: &VoussoirAssessment,
    ) -> Result<Self, Undecided> {
        let bound = |limit: &VoussoirLimit| Bound {
            thrust: limit.thrust.as_ref().map(ball),
            by: limited_by((stones, is_limited), limit),
        };
        let thrust = match found.standing.clone()? {
            VoussoirStanding::Stands(ends) => Some(ends.map(|end| bound(&end))),
            VoussoirStanding::Falls(_) => None,
        };
        let value = |x: &Answered<Figure>| Ok(x.clone()?.as_ref().map(ball));
        Ok(Self {
            stands: thrust.is_some(),
            fall: match least {
                Voussoirs::Slides => Some(Fall::Sliding),
                Voussoirs::TooThick => Some(Fall::Thickness),
                Voussoirs::Stands(_) | Voussoirs::AnyThickness => None,
            },
            least_thickness: match least {
                Voussoirs::Stands(state) => Some(ball(&state.thickness)),
                _ => None,
            },
            geometric_safety: value(&found.geometric_safety)?,
            required_friction: value(&found.required_friction)?,
            friction_safety: value(&found.friction_safety)?,
            thrust: thrust.map_or([None, None], |ends| ends.map(Some)),
        })
    }
}

/// Description of the limit of the thrust of an arch of stones, in words.
pub(super) fn limited_by((stones, is_limited): (&Stones, bool), limit: &VoussoirLimit) -> String {
    let one = |(contact, joint): &(_, u64)| {
        format!("{} {}", stones.at_limit((*contact, *joint), is_limited), stones.place(*joint))
    };
    match &limit.contacts[..] {
        [] => "nothing".to_owned(),
        contacts => contacts.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}

/// Bits that hold the bounds of a figure.
const BITS: u32 = 256;

/// Ball in which the value of a figure lies.
pub(super) fn ball(figure: &Figure) -> Ball {
    figure.enclosure(BITS)
}
