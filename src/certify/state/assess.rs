//! An arch of a given thickness: does it stand, with what safety, and how much may it thrust?
//!
//! It stands exactly if the [range of thrusts](super::thrust_range) is not empty; the least thickness of
//! the arch, proved on its own, has to say the same.

use super::query::Query;
use super::state::{Fall, Outcome};
use super::thrust_range::{
    Limit, cut_by_friction, largest_thrust, least_thrust, required_friction,
};
use crate::arch::Unknown;
use crate::certify::Undecided;
use crate::certify::undecided::{decide, require};
use crate::number::{Ball, ExactNumber, Field};
use crate::problem::Arch;

/// What is certain of an arch of a given thickness.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Assessment {
    /// Whether it stands.
    pub stands: bool,
    /// The least thickness of the arch with this friction, or why there is none.
    pub least_thickness: Result<Ball, Fall>,
    /// The thickness over the least thickness.
    pub geometric_safety: Option<Ball>,
    /// The least friction with which the arch of this thickness stands; `None` if none is enough.
    pub required_friction: Option<Ball>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Option<Ball>,
    /// The least and the largest admissible thrust; `None` if the arch does not stand.
    pub thrust: Option<[Limit; 2]>,
}

/// What is asked of an arch of a given thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Whether it stands, and how far its thickness is from the least: its state says so.
    Standing,
    /// Also the range of thrusts, and the friction that it asks for.
    Everything,
}

/// Proves what holds for an arch with a given thickness, as far as it is wanted, with numbers of `bits`
/// bits. `state` proves the state of the arch, with its own friction if told so, or with unlimited
/// friction.
pub(super) fn assessment(
    arch: &Arch,
    thickness: &ExactNumber,
    bits: u32,
    wanted: Wanted,
    mut state: impl FnMut(bool) -> Result<Outcome, Undecided>,
) -> Result<Assessment, Undecided> {
    let eta: Ball = thickness.enclosure(bits);
    require(&eta, "whether the thickness is positive")?;
    require(&(eta.int(2) - &eta), "whether the thickness is below the limit 2")?;
    let enough = |least: &Ball, question| decide(&(eta.clone() - least), question, &[]);
    let (least_thickness, stands) = match state(true)? {
        Outcome::Falls(fall) => (Err(fall), false),
        Outcome::Stands(state) => {
            let stands = enough(&state.thickness, "whether the thickness is enough")?;
            (Ok(state.thickness), stands)
        }
    };
    let mut query = Query::new(arch, bits);
    query.given = query.given.with(Unknown::Thickness, eta.clone());
    // With unlimited friction the arch stands if a line of thrust lies inside it at all.
    let mut line_fits = || match state(false)? {
        Outcome::Falls(_) => Ok(false),
        Outcome::Stands(state) => enough(&state.thickness, "whether a line of thrust fits"),
    };
    let geometric = if wanted == Wanted::Everything && line_fits()? {
        Some([least_thrust(&query)?, largest_thrust(&query)?])
    } else {
        None
    };
    let required_friction = match &geometric {
        Some(range) => Some(required_friction(&query, range)?),
        None => None,
    };
    let friction_safety = match (query.friction(), &required_friction) {
        (Some(friction), Some(required)) => Some(friction.clone() / required),
        _ => None,
    };
    let thrust = match (stands, geometric) {
        (true, Some(range)) => Some(cut_by_friction(&query, range)?),
        _ => None,
    };
    let geometric_safety = least_thickness.as_ref().ok().map(|least| eta / least);
    Ok(Assessment {
        stands,
        least_thickness,
        geometric_safety,
        required_friction,
        friction_safety,
        thrust,
    })
}
