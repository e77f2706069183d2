//! An isolated root refined to a box of any number of digits.

use super::ladder::{GUARD, Ladder, Rooted, Unique, first_bits};
use super::posed::Posed;
use super::root::box_near;
use super::{Isolated, Undecided, short};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Ball, arctangent};
use crate::problem::{Fixed, System, tally};
use rug::Float;
use std::sync::OnceLock;

/// A result has at least so many bits.
const FLOOR: u32 = 256;

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
    if bits <= short::MOST
        && let Some(way) = isolated.approach()
        && let Some(at) = way.enclose(bits)
    {
        (0..stages(&system)).for_each(|_| tick());
        let known = if bits > short::FIRST { way.friction_angle(&at) } else { None };
        let friction_angle = known.map_or_else(OnceLock::new, |angle| OnceLock::from(Some(angle)));
        return Ok(Refined { friction_angle, ..Refined::new(system, at) });
    }
    let at = by_ladder(isolated, bits, tick).or_else(|_| plainly(isolated, bits))?;
    tick();
    Ok(Refined::new(system, at))
}

/// The root by the ladder, from as many bits as the quick way gives.
fn by_ladder(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
) -> Result<Configuration<Ball>, Undecided> {
    let system = isolated.system();
    let given = Configuration::zero(&Ball::integer(0, bits + GUARD));
    let form = Posed { system, given: &given };
    let first = first_bits(bits, short::MOST);
    let centre: Vec<Float> = match isolated.approach().and_then(|way| way.enclose(first)) {
        Some(at) => system.values(&at).iter().map(|x| x.mid().clone()).collect(),
        None => box_near(&form, first, &start(isolated), false)?[1]
            .iter()
            .map(|x| x.mid().clone())
            .collect(),
    };
    let unique = Unique {
        domain: isolated.domain().to_vec(),
        sizes: vec![0; centre.len()],
        centre,
        bits: first,
        most: short::MOST,
        lost: 0,
    };
    let Rooted { values, sines } = Ladder { form: &form, unique: &unique, tick }.refined(bits)?;
    Ok(system.place_with(given.clone(), &values, |_, rad| sines.angle(rad)))
}

/// The root by Newton's method at all bits: what the ladder finds, at any price.
fn plainly(isolated: &Isolated, bits: u32) -> Result<Configuration<Ball>, Undecided> {
    let system = isolated.system();
    let given = Configuration::zero(&Ball::integer(0, bits + GUARD));
    let [domain, image] =
        box_near(&Posed { system, given: &given }, bits + GUARD, &start(isolated), false)?;
    match krawczyk::is_contracted(&domain, isolated.domain()) {
        true => Ok(system.place(given, &image)),
        false => Err(Undecided::astray()),
    }
}

/// Start values in the middle of what is known.
fn start(isolated: &Isolated) -> Vec<Float> {
    isolated.image().iter().map(|x| x.mid().clone()).collect()
}

/// Number of times that [`refine_watched`] reports progress: once for each angle and once at the end.
pub fn stages(system: &System) -> u64 {
    system.unknowns.iter().filter(|unknown| unknown.is_angle()).count() as u64 + 1
}

#[cfg(test)]
mod tests;
