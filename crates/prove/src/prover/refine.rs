//! An isolated root refined to a box of any number of digits.

use super::isolate::Beginning;
use super::ladder::{FEW, GUARD, Ladder, Rooted, Unique};
use super::posed::Posed;
use super::root::box_near;
use super::{Isolated, Undecided};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Ball, arctangent};
use crate::problem::{Fixed, System, tally};
use std::sync::OnceLock;

/// A result has at least so many bits.
const FLOOR: u32 = 256;
/// Bits that are kept of a root once more than few are asked for: those of 600 digits.
const MORE: u32 = 2080;

/// The root of a system in a box of many digits.
#[derive(Clone, Debug)]
pub struct Refined {
    system: System,
    at: Configuration<Ball>,
    friction_angle: OnceLock<Option<Ball>>,
}

impl Refined {
    fn new(system: System, at: Configuration<Ball>) -> Self {
        Self { system, at, friction_angle: OnceLock::new() }
    }

    /// An enclosure of `phi = atan(mu)`, computed when first asked for; `None` where there is no
    /// finite friction.
    pub fn friction_angle(&self) -> Option<Ball> {
        let compute = || self.value(Unknown::Friction).map(|friction| arctangent(&friction));
        self.friction_angle.get_or_init(compute).clone()
    }

    /// An enclosure of a variable; `None` where the system does not know it or it is infinite.
    pub fn value(&self, unknown: Unknown) -> Option<Ball> {
        let is_infinite = self.system.fixed_value(unknown) == Some(Fixed::Infinite);
        let is_known = self.system.knows(unknown) && !is_infinite;
        is_known.then(|| self.at.value(unknown).clone())
    }

    /// Enclosures of all variables, angles with sine and cosine.
    pub fn configuration(&self) -> &Configuration<Ball> {
        &self.at
    }
}

/// Encloses the isolated root to about `bits` bits; undecided if Newton's method does not settle or the
/// last step is not contracted into the box of uniqueness.
pub fn refine(isolated: &Isolated, bits: u32) -> Result<Refined, Undecided> {
    refine_watched(isolated, bits, &|| ())
}

/// Refines the root, calling `tick` [`stages`] times on the way.
pub fn refine_watched(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
) -> Result<Refined, Undecided> {
    let system = *isolated.system();
    let bits = bits.max(FLOOR);
    tally::working_bits(bits + GUARD);
    let at = from_known(isolated, bits, tick).or_else(|_| plainly(isolated, bits))?;
    tick();
    Ok(Refined::new(system, at))
}

/// The root from what is known of it: few bits, more of them, or by the ladder from these.
fn from_known(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
) -> Result<Configuration<Ball>, Undecided> {
    let [few, more] = &isolated.known;
    let begin = |at: Configuration<Ball>, bits| {
        let image = isolated.system().values(&at);
        Unique::new(isolated.domain().to_vec(), &image, bits).map(|unique| Beginning { at, unique })
    };
    let few = few.get_or_init(|| begin(plainly(isolated, FEW - GUARD).ok()?, FEW));
    let few = few.as_ref().ok_or_else(Undecided::not_alone)?;
    if bits + GUARD <= FEW {
        return Ok(few.at.clone());
    }
    let climb = || begin(by_ladder(isolated, &few.unique, MORE - GUARD, &|| ()).ok()?, MORE);
    let more = more.get_or_init(climb).as_ref().ok_or_else(Undecided::not_alone)?;
    match bits + GUARD <= MORE {
        true => Ok(more.at.clone()),
        false => by_ladder(isolated, &more.unique, bits, tick),
    }
}

fn by_ladder(
    isolated: &Isolated,
    unique: &Unique,
    bits: u32,
    tick: &(dyn Fn() + Sync),
) -> Result<Configuration<Ball>, Undecided> {
    let system = isolated.system();
    let given = Configuration::zero(&Ball::integer(0, bits + GUARD));
    let form = Posed { system, given: &given };
    let Rooted { values, sines } = Ladder { form: &form, unique, tick }.refined(bits)?;
    Ok(system.place_with(given.clone(), &values, |_, rad| sines.angle(rad)))
}

/// The root by Newton's method at all bits: what the ladder finds, at any price.
fn plainly(isolated: &Isolated, bits: u32) -> Result<Configuration<Ball>, Undecided> {
    let system = isolated.system();
    let given = Configuration::zero(&Ball::integer(0, bits + GUARD));
    let [domain, image] =
        box_near(&Posed { system, given: &given }, bits + GUARD, &isolated.middle(), false)?;
    match krawczyk::is_contracted(&domain, isolated.domain()) {
        true => Ok(system.place(given, &image)),
        false => Err(Undecided::astray()),
    }
}

/// Number of times that [`refine_watched`] reports progress: once for each angle and once at the end.
pub fn stages(system: &System) -> u64 {
    system.unknowns.iter().filter(|unknown| unknown.is_angle()).count() as u64 + 1
}

#[cfg(test)]
mod tests;
