//! Refinement from a proved box to a box of any number of digits.
//!
//! Sine and cosine are what costs; everything else in a system is algebraic in an angle, its sine and
//! its cosine. So each level of the ladder evaluates them **once**, at a short argument:
//!
//! 1. the root to a hundredth of the bits, or a little more, comes from the level below, the first bits by [`short`];
//! 2. it becomes the [`SineAnchor`] of each angle: sine and cosine to full precision there;
//! 3. Newton steps triple the bits, two with one Jacobian, up to a third, sine and cosine moved along from the
//!    anchor, which moves too when the root is known better;
//! 4. the Jacobian is taken once more; with that each further step gains a third, or a smaller part where the root is
//!    known to more by [`short`], at the precision it reaches.
//!
//! On the last level the last step is the interval Newton operator. Let `A` enclose the Jacobian on a box `X` and
//! `m` be a point of it. If elimination shows each matrix in `A` to be regular, and
//!
//! ```text
//! N(X) = m - A⁻¹ F(m)
//! ```
//!
//! lies in `X`, then `X` holds a root, and `N(X)` holds it (Moore 1966; Neumaier 1990, chapter 5): for each `x` of
//! `X` there is `A(x)` in `A`, the mean of the Jacobian from `m` to `x`, with `F(x) = F(m) + A(x) (x - m)`, and `x
//! -> m - A(x)⁻¹ F(m)` maps `X` into itself, so that it has a fixed point. `X` is the box on which the Jacobian was
//! taken, to a third of the bits; with the residual at full precision the step refines and encloses in one. The box
//! has to lie in the one where the root is known to be unique.

use super::linear::Eliminated;
use super::{Isolated, Undecided, short};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Angle, Ball, Enclosure, Magnitude, SineAnchor, arctangent};
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
/// Bits of the root that cost next to nothing, and those of a result to which a few steps with one Jacobian lead from there.
const EASY: u32 = 928;
const MODERATE: u32 = 2 * EASY;
const FAR: u32 = 4 * EASY;
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
    if bits <= short::MOST
        && let Some(way) = isolated.approach()
        && let Some(at) = way.enclose(bits.max(FLOOR))
    {
        let system = *isolated.system();
        tally::working_bits(bits.max(FLOOR) + GUARD);
        (0..stages(&system)).for_each(|_| tick());
        let known = if bits > short::FIRST { way.friction_angle(&at) } else { None };
        let friction_angle = known.map_or_else(OnceLock::new, |angle| OnceLock::from(Some(angle)));
        return Ok(Refined { system, at, friction_angle });
    }
    refine_by(isolated, bits, tick, |bits| LadderLevel::new(isolated, bits, tick))
}

/// Refines the root by a ladder that is given: where it leads astray, Newton's method at all bits is asked.
fn refine_by(
    isolated: &Isolated,
    bits: u32,
    tick: &(dyn Fn() + Sync),
    ladder: impl Fn(u32) -> Result<LadderLevel, Undecided>,
) -> Result<Refined, Undecided> {
    let bits = bits.max(FLOOR);
    tally::working_bits(bits + GUARD);
    let prove = |level: LadderLevel| level.enclose(isolated);
    let at = ladder(bits)
        .and_then(prove)
        .or_else(|_: Undecided| LadderLevel::plain(isolated, bits).and_then(prove))?;
    tick();
    Ok(Refined { system: *isolated.system(), at, friction_angle: OnceLock::new() })
}

/// Number of times that [`refine_watched`] reports progress: once for each angle and once at the end.
pub fn stages(system: &System) -> u64 {
    system.unknowns.iter().filter(|unknown| unknown.is_angle()).count() as u64 + 1
}

/// Newton's method at all bits.
fn newton(isolated: &Isolated, bits: u32) -> Result<Vec<Float>, Undecided> {
    let start: Vec<f64> = isolated.image().iter().map(|x| x.mid().to_f64()).collect();
    crate::solve::newton(isolated.system(), &start, bits)
        .map(|candidate| candidate.0)
        .ok_or_else(|| Undecided::root("Newton's method leaves the isolated root"))
}

/// The bits of the anchors of a level.
fn anchor_bits(bits: u32) -> u32 {
    (bits / if bits < 8_000 { 16 } else { 100 }).max(100)
}

/// The bits to which the Jacobian is taken on the way from some bits to a goal: each time up to [`SPAN`] times
/// as many.
fn climb(start: u32, goal: u32) -> Vec<u32> {
    let below = |bits: &u32| (*bits > SPAN * start).then(|| bits / SPAN + GUARD / 2);
    let goal = (goal > start).then_some(goal);
    let mut bits: Vec<u32> = iter::successors(goal, below).collect();
    bits.reverse();
    bits
}

/// One level of the ladder.
struct LadderLevel {
    system: System,
    bits: u32,
    anchors: Vec<Option<SineAnchor>>,
    centre: Vec<Float>,
    /// The bits of the Jacobian: what a step with it gains. The centre is known to no fewer.
    step: u32,
    /// A box about the root, and the Jacobian on it.
    around: Vec<Ball>,
    jacobian: Eliminated,
}

impl LadderLevel {
    /// Everything but the last step: the centre is known to all bits but those of one step.
    fn new(isolated: &Isolated, bits: u32, tick: &(dyn Fn() + Sync)) -> Result<Self, Undecided> {
        let near = anchor_bits(bits);
        let bits = bits + GUARD;
        let last = bits / (SPAN + 1) + GUARD;
        // The bits of the root with the last Jacobian, those of that, and the steps with it.
        let (goal, gain, steps) = match bits {
            MODERATE..FAR => {
                let steps = (bits - EASY).div_ceil(EASY);
                (EASY, (bits - EASY) / steps + GUARD, steps)
            }
            // One step more where the first bits are enough for it.
            FAR.. if last <= short::MOST => (last, last, SPAN),
            _ => (bits / SPAN + GUARD, bits / SPAN + GUARD, SPAN - 1),
        };
        tally::working_bits(bits);
        // A long one is cheaper from a third of the bits.
        let mut start = goal;
        while start > short::MOST {
            start = start / SPAN + GUARD;
        }
        let mut step = near.max(start);
        let mut centre = approximate(isolated, step)?;
        let anchor = |index: usize| {
            isolated.system().unknowns[index].is_angle().then(|| {
                let anchor = SineAnchor::new(&Float::with_val(near, &centre[index]), bits);
                tick();
                anchor
            })
        };
        let mut anchors: Vec<Option<SineAnchor>> = match bits < WORTH_THREADS {
            true => (0..centre.len()).map(anchor).collect(),
            false => {
                SineAnchor::prepare(bits);
                (0..centre.len()).into_par_iter().map(anchor).collect()
            }
        };
        // What follows is expensive: from nearer anchors it sums fewer terms.
        let mut far = bits / NEAR;
        let mut draw_near =
            |known: u32, anchors: &mut Vec<Option<SineAnchor>>, centre: &[Float]| {
                if known < far {
                    return;
                }
                for (anchor, x) in anchors.iter_mut().zip(centre) {
                    *anchor = anchor.take().map(|anchor| anchor.moved(x));
                }
                far = far.saturating_mul(NEARER);
            };
        draw_near(step, &mut anchors, &centre);
        for goal in climb(step, goal) {
            let mut level = Self::at(isolated, centre, anchors, step, bits)?;
            while step < goal {
                step = goal.min(step + level.step - GUARD / 4);
                level.advance(step);
            }
            (centre, anchors) = (level.centre, level.anchors);
            draw_near(goal, &mut anchors, &centre);
        }
        let mut level = Self::at(isolated, centre, anchors, gain, bits)?;
        for part in 1..steps {
            level.advance(step + part * gain);
        }
        Ok(level)
    }

    /// Level without anchors, by Newton's method at all bits: what the ladder finds, at any price.
    fn plain(isolated: &Isolated, bits: u32) -> Result<Self, Undecided> {
        let bits = bits + GUARD;
        let centre = newton(isolated, bits)?;
        let anchors = vec![None; centre.len()];
        Self::at(isolated, centre, anchors, bits, bits)
    }

    /// A level at a centre that is known to `step` bits or more, with the Jacobian on a box that is wide enough to hold the
    /// root.
    fn at(
        isolated: &Isolated,
        centre: Vec<Float>,
        anchors: Vec<Option<SineAnchor>>,
        step: u32,
        bits: u32,
    ) -> Result<Self, Undecided> {
        let system = *isolated.system();
        let radius = Magnitude::power_of_two(i64::from(GUARD) - i64::from(step));
        let around = centre.iter().map(|x| Ball::new(x.clone(), radius, step).with_precision(step));
        let around: Vec<Ball> = around.collect();
        let at = place(&system, &anchors, &around, step);
        let slopes = system.residuals(&system.variables(&at));
        let jacobian = Eliminated::new(&slopes)
            .ok_or_else(|| Undecided::root("the Jacobian at the root is singular"))?;
        Ok(Self { system, bits, anchors, centre, step, around, jacobian })
    }

    /// A Newton step to `bits` bits.
    fn advance(&mut self, bits: u32) {
        tally::newton_step();
        let (_, corrections) = self.corrections(bits);
        for (x, dx) in self.centre.iter_mut().zip(corrections) {
            *x = Float::with_val(bits, &*x - dx.mid());
        }
    }

    /// All variables at the centre and the Newton corrections `A⁻¹ F`, from residuals at `bits` bits.
    fn corrections(&self, bits: u32) -> (Configuration<Ball>, Vec<Ball>) {
        tally::newton_step();
        let values: Vec<Ball> = self.centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        let at = place(&self.system, &self.anchors, &values, bits);
        let residuals = self.system.residuals(&at).into_iter();
        // Residuals are small and have few bits that mean anything.
        let short = residuals.map(|r| r.trimmed().with_precision(self.step));
        let corrections = self.jacobian.solve(short.collect());
        (at, corrections)
    }

    /// The last step, with the proof.
    fn enclose(&self, isolated: &Isolated) -> Result<Configuration<Ball>, Undecided> {
        if !self.around.iter().zip(isolated.domain()).all(|(x, whole)| x.lies_inside(whole)) {
            return Err(Undecided::root("the refined box leaves the box of uniqueness"));
        }
        let (at, corrections) = self.corrections(self.bits);
        let centre = self.system.values(&at);
        let image = centre.iter().zip(&corrections).map(|(x, dx)| x.clone() - dx);
        let image: Vec<Ball> = image.collect();
        let is_within = |x: &[Ball]| krawczyk::is_contracted(x, &self.around);
        if !(is_within(&centre) && is_within(&image)) {
            return Err(Undecided::root("the refined box is not mapped into itself"));
        }
        let given = Configuration::zero(&Ball::integer(0, self.bits));
        Ok(self.system.place_with(given, &image, |index, rad| {
            match at.angle(self.system.unknowns[index]) {
                Some(angle) => back(angle, &corrections[index], rad),
                None => Angle::new(rad.clone()),
            }
        }))
    }
}

/// Values with their angles, moved from the anchors, at a precision.
fn place(
    system: &System,
    anchors: &[Option<SineAnchor>],
    values: &[Ball],
    bits: u32,
) -> Configuration<Ball> {
    let given = Configuration::zero(&Ball::integer(0, bits));
    system.place_with(given, values, |index, rad| match &anchors[index] {
        Some(anchor) => anchor.with_precision(bits).angle(rad),
        None => Angle::new(rad.clone()),
    })
}

/// The angle `rad`, which is `d` below another: to the second order in `d`, which is small.
fn back(from: &Angle<Ball>, d: &Ball, rad: &Ball) -> Angle<Ball> {
    let by = |slope: &Ball| slope.with_precision(d.prec()) * d;
    let size = Magnitude::upper(d.mid()).plus(d.rad());
    let rest = size.times(size).shifted(-1);
    let sin = (from.sin.clone() - by(&from.cos)).widened(rest);
    let cos = (from.cos.clone() + by(&from.sin)).widened(rest);
    Angle { rad: rad.clone(), sin, cos }
}

/// The root to about `bits` bits: a candidate, nothing is proved.
fn approximate(isolated: &Isolated, bits: u32) -> Result<Vec<Float>, Undecided> {
    if bits <= short::MOST {
        let found = isolated.approach().and_then(|way| way.enclose(bits));
        return match found {
            Some(at) => {
                let values = isolated.system().values(&at);
                Ok(values.iter().map(|x| Float::with_val(bits, x.mid())).collect())
            }
            None => newton(isolated, bits),
        };
    }
    let level = LadderLevel::new(isolated, bits, &|| ())?;
    let (_, corrections) = level.corrections(level.bits);
    let corrected = level.centre.iter().zip(corrections);
    Ok(corrected.map(|(x, dx)| Float::with_val(bits, x - dx.mid())).collect())
}

#[cfg(test)]
mod tests;
