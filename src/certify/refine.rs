//! From a proved box to a box of any number of digits.
//!
//! Sine and cosine are what costs; everything else in a system is algebraic in an angle, its sine and
//! its cosine. So each level of the ladder evaluates them **once**, at a short argument:
//!
//! 1. the root to a hundredth of the bits, or a little more, comes from the level below;
//! 2. it becomes the [`Anchor`] of each angle: sine and cosine to full precision there;
//! 3. Newton steps triple the bits, two with one inverse, up to a third, sine and cosine moved along from the anchor, which moves
//!    too when the root is known better;
//! 4. the Jacobian is inverted once more; with that fixed inverse each further step gains a third, at the
//!    precision it reaches.
//!
//! On the last level the last step is not a plain Newton step but the Krawczyk operator: with the
//! residual at full precision and slopes of a third of the bits, over a box about as narrow, it refines and
//! encloses in one. The box has to lie in the one where the root is known to be unique.

use super::root::inverse_jacobian;
use super::{Isolated, Undecided, short};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Anchor, Angle, Ball, Dual, Enclosure, Magnitude, arctangent};
use crate::problem::{Fixed, System, tally};
use rayon::prelude::*;
use rug::Float;
use std::iter;
use std::sync::OnceLock;

/// Steps with the last Jacobian, and the one to its accuracy: each gains this part of the bits.
const SPAN: u32 = 3;
/// The anchors move once the root is known to this part of the bits, and again at this many times as many.
const NEAR: u32 = 12;
const NEARER: u32 = 4;
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
    if bits <= short::MOST
        && let Some(at) = isolated.approach().and_then(|way| way.enclose(bits.max(FLOOR)))
    {
        let system = *isolated.system();
        tally::working_bits(bits.max(FLOOR) + GUARD);
        (0..stages(&system)).for_each(|_| tick());
        return Ok(Refined { system, at, friction_angle: OnceLock::new() });
    }
    refine_by(isolated, bits, tick, |system, start, bits| Level::new(system, start, bits, tick))
}

/// The same by a ladder that is given: where it leads astray, Newton's method at all bits is asked.
fn refine_by(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
    ladder: impl Fn(&System, Vec<Float>, u32) -> Result<Level, Undecided>,
) -> Result<Refined, Undecided> {
    let system = *isolated.system();
    let bits = bits.max(FLOOR);
    tally::working_bits(bits + GUARD);
    let start = || isolated.image().iter().map(|x| x.mid().clone()).collect();
    let prove = |level: Level| {
        let values = level.enclose(isolated)?;
        Ok(level.place(&values, level.bits))
    };
    let climbed = newton(&system, start(), FLOOR)
        .and_then(|start| ladder(&system, start, bits))
        .and_then(prove);
    let at =
        climbed.or_else(|_: Undecided| Level::plain(&system, start(), bits).and_then(prove))?;
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

/// The bits of the anchors of a level.
fn anchor_bits(bits: u32) -> u32 {
    (bits / if bits < 8_000 { 32 } else { 100 }).max(100)
}

/// The bits to which the Jacobian is inverted on the way from some bits to a goal: each time up to [`SPAN`] times
/// as many.
fn climb(start: u32, goal: u32) -> Vec<u32> {
    let below = |bits: &u32| (*bits > SPAN * start).then(|| bits / SPAN + GUARD / 2);
    let mut bits: Vec<u32> = iter::successors(Some(goal), below).collect();
    bits.reverse();
    bits
}

/// One level of the ladder.
struct Level {
    system: System,
    bits: u32,
    anchors: Vec<Option<Anchor>>,
    centre: Vec<Float>,
    /// The bits to which the centre was known when the slopes were taken: what a step with them gains.
    step: u32,
    /// A box about the root, the residuals with their slopes on it, and the inverse of the slopes' midpoints.
    around: Vec<Ball>,
    slopes: Vec<Dual<Ball>>,
    inverse: Vec<Vec<Ball>>,
}

impl Level {
    /// Everything but the last step: the centre is known to all bits but those of one step.
    fn new(
        system: &System,
        start: Vec<Float>,
        bits: u32,
        tick: &(dyn Fn() + Sync),
    ) -> Result<Self, Undecided> {
        let step = anchor_bits(bits);
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
            false => {
                Anchor::prepare(bits);
                (0..centre.len()).into_par_iter().map(anchor).collect()
            }
        };
        let mut level = Self::at(system, centre, anchors, step, bits);
        let mut near = bits / NEAR;
        for goal in climb(step, bits / SPAN + GUARD) {
            level.linearise()?;
            let mut known = level.step;
            while known < goal {
                known = goal.min(known + level.step - GUARD / 4);
                level.advance(known);
            }
            level.step = goal;
            if goal >= near {
                // What follows is expensive: from nearer anchors it sums fewer terms.
                for (anchor, x) in level.anchors.iter_mut().zip(&level.centre) {
                    *anchor = anchor.take().map(|anchor| anchor.moved(x));
                }
                near *= NEARER;
            }
        }
        level.linearise()?;
        for part in 2..SPAN {
            level.advance(part * level.step);
        }
        Ok(level)
    }

    /// The same without anchors, by Newton's method at all bits: what the ladder finds, at any price.
    fn plain(system: &System, start: Vec<Float>, bits: u32) -> Result<Self, Undecided> {
        let bits = bits + GUARD;
        let centre = newton(system, start, bits)?;
        let anchors = vec![None; centre.len()];
        let mut level = Self::at(system, centre, anchors, bits, bits);
        level.linearise()?;
        Ok(level)
    }

    /// A level without slopes.
    fn at(
        system: &System,
        centre: Vec<Float>,
        anchors: Vec<Option<Anchor>>,
        step: u32,
        bits: u32,
    ) -> Self {
        let (around, slopes, inverse) = (Vec::new(), Vec::new(), Vec::new());
        Self { system: *system, bits, anchors, centre, step, around, slopes, inverse }
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

    /// The residuals with their slopes on a box, with numbers as long as the centre was known.
    fn slopes_on(&self, domain: &[Ball]) -> Vec<Dual<Ball>> {
        let domain: Vec<Ball> = domain.iter().map(|x| x.with_precision(self.step)).collect();
        self.system.residuals(&self.system.variables(&self.place(&domain, self.step)))
    }

    /// Takes the slopes on a box that is wide enough to hold the root, and inverts their midpoints.
    fn linearise(&mut self) -> Result<(), Undecided> {
        let radius = Magnitude::power_of_two(i64::from(GUARD) - i64::from(self.step));
        let box_about = |x: &Float| Ball::new(x.clone(), radius, self.step);
        self.around = self.centre.iter().map(box_about).collect();
        self.slopes = self.slopes_on(&self.around);
        let inverse = inverse_jacobian(&self.slopes, self.step)
            .ok_or_else(|| Undecided::new("the Jacobian at the root is singular"))?;
        let exact = |row: Vec<Float>| row.into_iter().map(|y| Ball::exact(y, self.step)).collect();
        self.inverse = inverse.into_iter().map(exact).collect();
        Ok(())
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
        // The box must hold the corrected centre, which is rounded, and the spread about it.
        let noise = |x: &Ball| Magnitude::upper(x.mid()).shifted(1 - i64::from(self.bits));
        let radii = centre.iter().zip(&corrections);
        let radii = radii.map(|(x, (_, size))| size.plus(noise(x)).shifted(1));
        let domain: Vec<Ball> =
            centre.iter().zip(radii).map(|(x, radius)| x.clone().widened(radius)).collect();
        if !domain.iter().zip(isolated.domain()).all(|(x, whole)| x.lies_inside(whole)) {
            return Err(Undecided::new("the refined box leaves the box of uniqueness"));
        }
        // The slopes need only the accuracy of the inverse, so that those on the wider box do.
        let wider = domain.iter().zip(&self.around).all(|(x, around)| x.lies_inside(around));
        let fresh = (!wider).then(|| self.slopes_on(&domain));
        let slopes = fresh.as_ref().unwrap_or(&self.slopes);
        let offsets: Vec<Ball> = domain.iter().map(Ball::centred).collect();
        let spread = krawczyk::spread(slopes, &self.inverse, &offsets);
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
    use crate::number::Field;
    use crate::problem::Landmark;
    use crate::solve::start;

    fn isolated(landmark: Landmark, weight: SelfWeight) -> Isolated {
        let system = landmark.system(weight);
        let candidate = crate::solve::newton(&system, start::landmark(landmark, weight), 64);
        isolate(landmark, weight, &candidate.unwrap()).unwrap()
    }

    fn all() -> impl Iterator<Item = Isolated> {
        Landmark::ALL.into_iter().flat_map(|landmark| {
            SelfWeight::ALL.into_iter().map(move |weight| isolated(landmark, weight))
        })
    }

    fn overlap(isolated: &Isolated, a: &Refined, b: &Refined) {
        for &unknown in isolated.system().unknowns {
            let (a, b) = (a.value(unknown).unwrap(), b.value(unknown).unwrap());
            assert!(a.overlaps(&b), "{unknown:?} {a:?} {b:?}");
        }
        let (a, b) = (a.friction_angle(), b.friction_angle());
        assert!(a.zip(b).is_none_or(|(a, b)| a.overlaps(&b)));
    }

    #[test]
    fn precisions_overlap_and_have_the_bits_asked_for() {
        for isolated in all() {
            let sizes = [256, 700, 1061, 5000, 12_000];
            let refined = sizes.map(|bits| refine(&isolated, bits).unwrap());
            for (bits, one) in sizes.into_iter().zip(&refined) {
                overlap(&isolated, one, &refined[4]);
                for &unknown in isolated.system().unknowns {
                    let value = one.value(unknown).unwrap();
                    assert!(value.rad() < Magnitude::power_of_two(-i64::from(bits)), "{value:?}");
                }
            }
        }
    }

    /// By MPFR's sines and the Jacobian at all bits: another way to the same root.
    #[test]
    fn the_ladder_and_plain_newton_overlap() {
        for isolated in all() {
            let astray = |_: &System, _: Vec<Float>, _: u32| Err(Undecided::new("forced"));
            for bits in [300, 2500] {
                let plain = refine_by(&isolated, bits, &|| (), astray).unwrap();
                overlap(&isolated, &plain, &refine(&isolated, bits).unwrap());
                let thickness = plain.configuration().half_opening.rad.rad();
                assert!(thickness < Magnitude::power_of_two(-i64::from(bits)));
            }
        }
    }

    /// With a matrix that is no inverse nothing is contracted: then Newton's method at all bits proves the root.
    #[test]
    fn a_last_step_that_proves_nothing_is_repeated_plainly() {
        let isolated = isolated(Landmark::Triple, SelfWeight::Milankovitch);
        let spoiled = |system: &System, start: Vec<Float>, bits: u32| {
            let mut level = Level::new(system, start, bits, &|| ())?;
            level.inverse.iter_mut().flatten().for_each(|y| *y = y.int(0));
            Ok(level)
        };
        let system = *isolated.system();
        let start: Vec<Float> = isolated.image().iter().map(|x| x.mid().clone()).collect();
        let level = spoiled(&system, newton(&system, start, FLOOR).unwrap(), 600).unwrap();
        assert!(level.enclose(&isolated).is_err());
        let refined = refine_by(&isolated, 600, &|| (), spoiled).unwrap();
        overlap(&isolated, &refined, &refine(&isolated, 2000).unwrap());
    }

    #[test]
    fn a_climb_ends_at_its_goal_in_few_stages() {
        for (start, goal) in
            [(100, 112), (100, 300), (100, 301), (333, 11_000), (33_000, 1_100_000)]
        {
            let bits = climb(start, goal);
            assert!(bits[0] <= SPAN * start && bits.last() == Some(&goal));
            assert!(bits.windows(2).all(|pair| pair[0] < pair[1] && pair[1] <= SPAN * pair[0]));
        }
    }
}
