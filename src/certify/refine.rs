//! From a proved box to a box of any number of digits.
//!
//! Sine and cosine are what costs; everything else in a system is algebraic in an angle, its sine and
//! its cosine. So each level of the ladder evaluates them **once**, at a short argument:
//!
//! 1. the root to a sixteenth of the bits comes from the level below;
//! 2. it becomes the [`Anchor`] of each angle: sine and cosine to full precision there;
//! 3. Newton steps double the bits up to a quarter, sine and cosine moved along from the anchor;
//! 4. the anchors move to that quarter, and the Jacobian is inverted once more; with that fixed inverse
//!    each further step gains a quarter, at the precision it reaches.
//!
//! On the last level the last step is not a plain Newton step but the Krawczyk operator: with the
//! residual at full precision and the slopes over a box of a quarter of the bits less, it refines and
//! encloses in one. The box has to lie in the one where the root is known to be unique.

use super::root::inverse_jacobian;
use super::{Isolated, Undecided, short};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Anchor, Angle, Ball, Dual, Enclosure, Magnitude, arctangent};
use crate::problem::{Fixed, System, tally};
use rayon::prelude::*;
use rug::Float;
use std::sync::OnceLock;

/// Newton steps with the last Jacobian, each of which gains this part of the bits.
const SPAN: u32 = 4;
/// The bits of a level over those of the level below, whose root is the anchor.
const STRETCH: u32 = 16;
/// Bits of a level beyond its share, so that the condition of the system eats no digits.
const GUARD: u32 = 32;
/// Below this, angles are computed one after the other: faster, and it avoids a deadlock when a thread
/// that fills a `OnceLock` steals a job that waits for it.
const WORTH_THREADS: u32 = 1 << 14;
/// At this size a level is one plain Newton iteration.
const FLOOR: u32 = 256;

/// The root of a system in a box of many digits.
#[derive(Clone, Debug)]
pub struct Refined {
    system: System,
    at: Configuration<Ball>,
    friction_angle: OnceLock<Option<Ball>>,
}

impl Refined {
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

/// The same, calling `tick` [`stages`] times on the way.
pub fn refine_watched(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
) -> Result<Refined, Undecided> {
    let system = *isolated.system();
    let bits = bits.max(FLOOR);
    tally::working_bits(bits + GUARD);
    if bits <= short::MOST
        && let Some(at) = isolated.approach().and_then(|way| way.enclose(bits))
    {
        (0..stages(&system)).for_each(|_| tick());
        return Ok(Refined { system, at, friction_angle: OnceLock::new() });
    }
    let mut start: Vec<Float> = isolated.image().iter().map(|x| x.mid().clone()).collect();
    start = newton(&system, start, FLOOR)?;
    let level = Level::new(&system, start, bits, tick)?;
    let values = level.enclose(isolated)?;
    let at = level.place(&values, level.bits);
    tick();
    Ok(Refined { system, at, friction_angle: OnceLock::new() })
}

/// How often [`refine_watched`] reports progress: once for each angle and once at the end.
pub fn stages(system: &System) -> u64 {
    system.unknowns.iter().filter(|unknown| unknown.is_angle()).count() as u64 + 1
}

/// Newton's method up to a small number of bits.
fn newton(system: &System, start: Vec<Float>, bits: u32) -> Result<Vec<Float>, Undecided> {
    let start: Vec<f64> = start.iter().map(Float::to_f64).collect();
    crate::solve::newton(system, &start, bits)
        .map(|candidate| candidate.0)
        .ok_or_else(|| Undecided::new("Newton's method leaves the isolated root"))
}

/// One level of the ladder.
struct Level<'a> {
    system: &'a System,
    bits: u32,
    anchors: Vec<Option<Anchor>>,
    centre: Vec<Float>,
    /// The bits to which `inverse` is known: what a step with it gains.
    step: u32,
    inverse: Vec<Vec<Ball>>,
}

impl<'a> Level<'a> {
    /// Everything but the last step: the centre is known to all bits but those of one step.
    fn new(
        system: &'a System,
        start: Vec<Float>,
        bits: u32,
        tick: &(dyn Fn() + Sync),
    ) -> Result<Self, Undecided> {
        let step = bits / STRETCH + GUARD;
        let bits = bits + GUARD;
        tally::working_bits(bits);
        let centre = approximate(system, start, step)?;
        let anchor = |index: usize| {
            system.unknowns[index].is_angle().then(|| {
                let anchor = Anchor::new(&centre[index], bits);
                tick();
                anchor
            })
        };
        let anchors = match bits < WORTH_THREADS {
            true => (0..centre.len()).map(anchor).collect(),
            false => (0..centre.len()).into_par_iter().map(anchor).collect(),
        };
        let mut level = Self { system, bits, anchors, centre, step, inverse: Vec::new() };
        level.inverse = level.inverse()?;
        while level.step * SPAN < bits {
            level.advance(2 * level.step);
            level.step *= 2;
            level.inverse = level.inverse()?;
        }
        // The remaining steps are expensive: from nearer anchors they sum fewer terms.
        for (anchor, x) in level.anchors.iter_mut().zip(&level.centre) {
            *anchor = anchor.take().map(|anchor| anchor.moved(x));
        }
        for quarters in 2..SPAN {
            level.advance(quarters * level.step);
        }
        Ok(level)
    }

    /// A Newton step to `bits` bits.
    fn advance(&mut self, bits: u32) {
        tally::newton_step();
        let corrections = self.corrections(bits);
        for (x, (dx, _)) in self.centre.iter_mut().zip(corrections) {
            *x = Float::with_val(bits, &*x - dx.mid());
        }
    }

    /// The values with their angles, moved from the anchors, at a precision.
    fn place(&self, values: &[Ball], bits: u32) -> Configuration<Ball> {
        let given = Configuration::zero(&Ball::integer(0, bits));
        self.system.place_with(given, values, |index, rad| match &self.anchors[index] {
            Some(anchor) => anchor.with_precision(bits).angle(rad),
            None => Angle::new(rad.clone()),
        })
    }

    /// The residuals with their slopes.
    fn slopes(&self, values: &[Ball]) -> Vec<Dual<Ball>> {
        self.system.residuals(&self.system.variables(&self.place(values, self.step)))
    }

    /// The inverse of the Jacobian at the centre, to the accuracy of the centre.
    fn inverse(&self) -> Result<Vec<Vec<Ball>>, Undecided> {
        let values: Vec<Ball> =
            self.centre.iter().map(|x| Ball::exact(x.clone(), self.step)).collect();
        let inverse = inverse_jacobian(&self.slopes(&values), self.step)
            .ok_or_else(|| Undecided::new("the Jacobian at the root is singular"))?;
        let exact = |row: Vec<Float>| row.into_iter().map(|y| Ball::exact(y, self.step)).collect();
        Ok(inverse.into_iter().map(exact).collect())
    }

    /// The Newton corrections `Y F(centre)` from residuals at `bits` bits, each with a bound of the
    /// sum of its terms' sizes.
    fn corrections(&self, bits: u32) -> Vec<(Ball, Magnitude)> {
        tally::newton_step();
        let values: Vec<Ball> = self.centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        let residuals = self.system.residuals(&self.place(&values, bits));
        // Residuals are small and have few bits that mean anything; so have the products.
        let residuals: Vec<Ball> =
            residuals.into_iter().map(|r| r.trimmed().with_precision(self.step)).collect();
        let start = (Ball::integer(0, self.step), Magnitude::ZERO);
        let correction = |row: &Vec<Ball>| {
            row.iter().zip(&residuals).filter(|(y, _)| !y.mid().is_zero()).fold(
                start.clone(),
                |(sum, size), (y, residual)| {
                    let term = y.clone() * residual;
                    let size = size.plus(Magnitude::upper(term.mid())).plus(term.rad());
                    (sum + term, size)
                },
            )
        };
        self.inverse.iter().map(correction).collect()
    }

    /// The last step: the Krawczyk operator on a box just wide enough to hold its image.
    fn enclose(&self, isolated: &Isolated) -> Result<Vec<Ball>, Undecided> {
        let corrections = self.corrections(self.bits);
        let centre: Vec<Ball> =
            self.centre.iter().map(|x| Ball::exact(x.clone(), self.bits)).collect();
        // The box must hold the corrected centre and the spread about it.
        let noise = Magnitude::power_of_two(-i64::from(self.bits));
        let radii = corrections.iter().map(|(_, size)| size.plus(noise).shifted(1));
        let domain: Vec<Ball> =
            centre.iter().zip(radii).map(|(x, radius)| x.clone().widened(radius)).collect();
        if !domain.iter().zip(isolated.domain()).all(|(x, whole)| x.lies_inside(whole)) {
            return Err(Undecided::new("the refined box leaves the box of uniqueness"));
        }
        // The slopes need only the accuracy of the inverse: a wider box with shorter numbers.
        let coarse: Vec<Ball> = domain.iter().map(|x| x.with_precision(self.step)).collect();
        let slopes = self.slopes(&coarse);
        let offsets: Vec<Ball> = domain.iter().map(Ball::centred).collect();
        let spread = krawczyk::spread(&slopes, &self.inverse, &offsets);
        let image: Vec<Ball> = centre
            .iter()
            .zip(corrections.iter().zip(spread))
            .map(|(x, ((dx, _), spread))| (x.clone() - dx) + spread)
            .collect();
        if !krawczyk::is_contracted(&image, &domain) {
            return Err(Undecided::new("the refined box is not mapped into itself"));
        }
        Ok(image)
    }
}

/// The root to about `bits` bits: a candidate, nothing is proved.
fn approximate(system: &System, start: Vec<Float>, bits: u32) -> Result<Vec<Float>, Undecided> {
    if bits <= FLOOR {
        return newton(system, start, bits);
    }
    let level = Level::new(system, start, bits, &|| ())?;
    let corrections = level.corrections(level.bits);
    let corrected = level.centre.iter().zip(corrections);
    Ok(corrected.map(|(x, (dx, _))| Float::with_val(bits, x - dx.mid())).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::isolate;
    use crate::problem::Landmark;
    use crate::solve::start;

    #[test]
    fn two_precisions_overlap_and_have_the_bits_asked_for() {
        for landmark in Landmark::ALL {
            let system = landmark.system(SelfWeight::Milankovitch);
            let candidate =
                crate::solve::newton(&system, start::landmark(landmark, system.weight), 64)
                    .unwrap();
            let isolated = isolate(landmark, system.weight, &candidate).unwrap();
            let [coarse, fine] = [700, 5000].map(|bits| refine(&isolated, bits).unwrap());
            for &unknown in system.unknowns {
                let (coarse, fine) = (coarse.value(unknown).unwrap(), fine.value(unknown).unwrap());
                assert!(coarse.overlaps(&fine), "{landmark:?} {unknown:?}");
                assert!(coarse.rad() < Magnitude::power_of_two(-700), "{landmark:?} {coarse:?}");
                assert!(fine.rad() < Magnitude::power_of_two(-5000), "{landmark:?} {fine:?}");
            }
        }
    }
}
