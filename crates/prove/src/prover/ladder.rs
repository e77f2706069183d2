//! Refinement from a proved box to a box of any number of digits, for any equations.
//!
//! Sine and cosine are what costs; everything else is algebraic in an angle, its sine and its cosine. So each level of
//! the ladder evaluates them **once**, at a short argument:
//!
//! 1. the root to a hundredth of the bits, or a little more, comes from the level below, the first bits from the
//!    proof that there is one root;
//! 2. it becomes the place of each angle: sine and cosine to full precision there ([`Sines`]);
//! 3. Newton steps triple the bits, two with one Jacobian, up to a third, sine and cosine moved along from the
//!    place, which moves too when the root is known better;
//! 4. the Jacobian is taken once more; with that each further step gains a third, or a smaller part where the root is
//!    known to more at the beginning, at the precision it reaches.
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
//! has to lie in the one where the root is known to be unique and the equations to be regular.

use super::Undecided;
use super::linear::Eliminated;
use super::operator::Form;
use super::sines::{SinedBall, Sines};
use crate::check::krawczyk;
use crate::number::{Ball, Dual, Enclosure, Magnitude};
use crate::problem::tally;
use rug::Float;
use std::iter;

/// Steps with the last Jacobian, and the one to its accuracy: each gains this part of the bits.
const SPAN: u32 = 3;
/// Bits in which a root is proved to be the only one, as a rule.
pub(super) const FEW: u32 = 400;
/// The places move once the root is known to this part of the bits, and again at this many times as many.
const NEAR: u32 = 12;
const NEARER: u32 = 4;
/// Bits of a level beyond its share, so that the condition of the system eats no digits.
pub(super) const GUARD: u32 = 32;

/// Bits that a step gains less as the equations are bent, of which nothing is known beforehand.
const BENT: u32 = 24;

/// A box in which a root is the only one, and what is known of it.
#[derive(Clone, Debug)]
pub(super) struct Unique {
    pub domain: Vec<Ball>,
    /// The root to some bits, beside the sizes `2^e` of its unknowns.
    pub centre: Vec<Float>,
    pub bits: u32,
    pub sizes: Vec<i64>,
    /// Bits that a step gains less than the ones that are known: by which the sizes are above the unknowns, and more.
    pub lost: u32,
}

impl Unique {
    /// The image of the box, found in numbers of `bits` bits; `None` if the equations lose a large part of them.
    pub(super) fn new(domain: Vec<Ball>, image: &[Ball], bits: u32) -> Option<Self> {
        let exponent = |x: &Ball| x.mid().get_exp().map(i64::from);
        let noise = |x: &Ball| x.rad().exponent().map(|e| e + i64::from(bits));
        let size = |x: &Ball| exponent(x).max(noise(x)).unwrap_or(0);
        let lost = |x: &Ball| size(x) - exponent(x).unwrap_or(size(x));
        let lost = image.iter().map(lost).max().unwrap_or(0);
        let lost = u32::try_from(lost).ok().filter(|lost| *lost <= bits / 8)? + BENT;
        let centre = image.iter().map(|x| x.mid().clone()).collect();
        let sizes = image.iter().map(size).collect();
        Some(Self { domain, centre, bits, sizes, lost })
    }

    /// Bits of a step beyond its share.
    fn guard(&self) -> u32 {
        GUARD + 2 * self.lost
    }
}

/// Equations with a root that is known to be the only one in a box.
pub(super) struct Ladder<'a, F> {
    pub form: &'a F,
    pub unique: &'a Unique,
    /// Called once for each angle that is known to be needed.
    pub tick: &'a (dyn Fn() + Sync),
}

/// A root in a small box, with the sines and cosines that it took: an angle of it, or of its equations, costs nearly
/// nothing more.
#[derive(Default)]
pub struct Rooted {
    pub values: Vec<Ball>,
    pub sines: Sines,
}

/// The bits of the places of a level.
fn place_bits(bits: u32) -> u32 {
    (bits / if bits < 8_000 { 16 } else { 100 }).max(100)
}

/// The way of a level.
struct Way {
    /// The bits of the places.
    near: u32,
    /// The bits of the root at the beginning.
    start: u32,
    /// The bits of the last Jacobian, the steps with it, and what each of them gains.
    slopes: u32,
    steps: u32,
    gain: u32,
}

impl Way {
    /// The way to `bits` bits, if `known` are known at the beginning.
    fn new(bits: u32, known: u32, guard: u32) -> Self {
        let near = place_bits(bits);
        let bits = bits + GUARD;
        // With one Jacobian where few steps lead there from what is known, else from a third of the bits.
        let steps = bits.saturating_sub(known).div_ceil(known.saturating_sub(guard).max(1));
        if (1..=SPAN).contains(&steps) {
            let gain = (bits - known) / steps + guard;
            return Self { near, start: known, slopes: known.min(gain + guard), steps, gain };
        }
        let gain = bits / SPAN + guard;
        Self { near, start: near.max(gain.min(known)), slopes: gain, steps: SPAN - 1, gain }
    }
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

impl<F: Form<Ball>> Ladder<'_, F> {
    /// The root to about `bits` bits, proved; undecided if a Jacobian is singular or the last step is not contracted
    /// into the box of uniqueness.
    pub(super) fn refined(&self, bits: u32) -> Result<Rooted, Undecided> {
        self.level(bits, self.tick)?.enclosed()
    }

    /// The root to about `bits` bits: a candidate, nothing is proved.
    fn approximate(&self, bits: u32) -> Result<Vec<Float>, Undecided> {
        if bits <= self.unique.bits {
            return Ok(self.unique.centre.clone());
        }
        let level = self.level(bits, &|| ())?;
        let (_, corrections) = level.corrections(level.bits);
        let corrected = level.centre.iter().zip(corrections);
        Ok(corrected.map(|(x, dx)| Float::with_val(bits, x - dx.mid())).collect())
    }

    /// Everything but the last step: the centre is known to all bits but those of one step.
    fn level(&self, bits: u32, tick: &(dyn Fn() + Sync)) -> Result<Level<'_, F>, Undecided> {
        let way = Way::new(bits, self.unique.bits, self.unique.guard());
        let (bits, mut step) = (bits + GUARD, way.start);
        tally::working_bits(bits);
        let centre = self.approximate(step)?;
        let centre: Vec<Float> = centre.iter().map(|x| Float::with_val(step, x)).collect();
        let sines = Sines::new(way.near, bits);
        let angles: Vec<&Float> = self.form.angles().into_iter().map(|k| &centre[k]).collect();
        sines.prepare(&angles, tick);
        // What follows is expensive: from nearer places it sums fewer terms.
        let mut far = bits / NEAR;
        let mut draw_near = |known: u32, sines: &Sines| {
            if known >= far {
                sines.come_nearer(known);
                far = far.saturating_mul(NEARER);
            }
        };
        draw_near(step, &sines);
        let mut parts = (centre, sines);
        for goal in climb(step, way.slopes) {
            let mut level = Level::at(self, parts, step, bits)?;
            while step < goal {
                step = goal.min(step + level.step - GUARD / 4 - self.unique.lost);
                level.advance(step);
            }
            parts = (level.centre, level.sines);
            draw_near(goal, &parts.1);
        }
        let mut level = Level::at(self, parts, way.slopes, bits)?;
        for part in 1..way.steps {
            level.advance(step + part * way.gain);
        }
        Ok(level)
    }
}

/// One level of the ladder.
struct Level<'a, F> {
    form: &'a F,
    unique: &'a Unique,
    bits: u32,
    sines: Sines,
    centre: Vec<Float>,
    /// The bits of the Jacobian: what a step with it gains. The centre is known to no fewer.
    step: u32,
    /// A box about the root, and the Jacobian on it.
    around: Vec<Ball>,
    jacobian: Eliminated,
}

impl<'a, F: Form<Ball>> Level<'a, F> {
    /// A level at a centre that is known to `step` bits or more, with the Jacobian on a box that is wide enough to hold
    /// the root.
    fn at(
        ladder: &Ladder<'a, F>,
        (centre, sines): (Vec<Float>, Sines),
        step: u32,
        bits: u32,
    ) -> Result<Self, Undecided> {
        let (form, unique) = (ladder.form, ladder.unique);
        let room = i64::from(unique.guard()) - i64::from(step);
        let side = |(x, size): (&Float, &i64)| {
            Ball::new(x.clone(), Magnitude::power_of_two(room + size), step).with_precision(step)
        };
        let around: Vec<Ball> = centre.iter().zip(&unique.sizes).map(side).collect();
        let balls: Vec<SinedBall> = around.iter().map(|x| sines.ball(x.clone())).collect();
        let given = |given: &Ball| Dual::constant(sines.ball(given.with_precision(step)));
        let slopes = form.at(given, &Dual::variables(&balls)).into_iter();
        let slopes: Vec<Dual<Ball>> = slopes.map(|r| r.map(|x| x.ball)).collect();
        let jacobian = Eliminated::new(&slopes).ok_or_else(Undecided::singular)?;
        Ok(Self { form, unique, bits, sines, centre, step, around, jacobian })
    }

    /// A Newton step to `bits` bits.
    fn advance(&mut self, bits: u32) {
        tally::newton_step();
        let (_, corrections) = self.corrections(bits);
        for (x, dx) in self.centre.iter_mut().zip(corrections) {
            *x = Float::with_val(bits, &*x - dx.mid());
        }
    }

    /// The centre and the Newton corrections `A⁻¹ F`, from residuals at `bits` bits.
    fn corrections(&self, bits: u32) -> (Vec<Ball>, Vec<Ball>) {
        tally::newton_step();
        let centre: Vec<Ball> = self.centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
        let balls: Vec<SinedBall> = centre.iter().map(|x| self.sines.ball(x.clone())).collect();
        let given = |given: &Ball| self.sines.ball(given.with_precision(bits));
        let residuals = self.form.at(given, &balls).into_iter();
        // Residuals are small and have few bits that mean anything.
        let short = residuals.map(|r| r.ball.trimmed().with_precision(self.step));
        let corrections = self.jacobian.solve(short.collect());
        (centre, corrections)
    }

    /// The last step, with the proof.
    fn enclosed(self) -> Result<Rooted, Undecided> {
        if !self.around.iter().zip(&self.unique.domain).all(|(x, whole)| x.lies_inside(whole)) {
            return Err(Undecided::astray());
        }
        let (centre, corrections) = self.corrections(self.bits);
        let values = centre.iter().zip(&corrections).map(|(x, dx)| x.clone() - dx);
        let values: Vec<Ball> = values.collect();
        let is_within = |x: &[Ball]| krawczyk::is_contracted(x, &self.around);
        if !(is_within(&centre) && is_within(&values)) {
            return Err(Undecided::not_alone());
        }
        Ok(Rooted { values, sines: self.sines })
    }
}

#[cfg(test)]
mod tests;
