//! Refinement from a proved box to some hundred bits, by steps with one inverse and without a heap.
//!
//! Next to the root the Jacobian hardly changes. Its inverse `Y` is computed once, and with it a bound `C` of `|I - Y
//! F'(X)|`, entry by entry, on one small box `X` about the root. Then for every box `x ± r` within `X` the image of the
//! Krawczyk operator is within
//!
//! ```text
//! x - Y F(x) ± C r
//! ```
//!
//! So each step costs residuals and nothing else, and gains the bits of `C`; the last one proves. A [`Stage`] knows the
//! root, `Y` and `C` to the bits of a few words. The first one starts from doubles, each other from the one before,
//! once more bits are asked for.
//!
//! All is over [`ShortBall`]. What is small, residuals and steps, is held in the few words of the stage, times a power
//! of two. Sines and cosines are computed once, at the candidate, and moved along. Steps have as many words as they
//! need.

use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{
    Angle, Ball, Dual, Enclosure, Field, ShortBall, arctangent, arctangent_from, power_of_two,
};
use crate::problem::{System, tally};
use crate::solve::inverse;
use std::sync::OnceLock;

/// Largest number of bits for which it pays.
pub(super) const MOST: u32 = 64 * (WORDS as u32 - 1) - GUARD;
/// Bits of a result beyond those asked for, so that the condition of the system eats no digits.
const GUARD: u32 = 32;
/// Ratio of the width of `X` to the one that the corrections ask for.
const ROOM: f64 = 64.0;
/// Steps of a stage: all but the last gain the bits of what it starts from, and the last tells how many there are. The
/// inverse doubles with each but the last.
const STEPS: usize = 3;
/// Most words of a step.
const WORDS: usize = 40;
/// Bits up to which the first stage is asked, and the second.
pub(super) const FIRST: u32 = 256;
const SECOND: u32 = 448;
/// The least gain of a step that is worth while, in bits.
const LEAST_GAIN: u32 = 32;

/// The way to the root next to the centre of a box in which it is unique.
#[derive(Clone, Debug)]
pub(super) struct Approach {
    domain: Vec<Ball>,
    first: Stage<3>,
    second: OnceLock<Option<Stage<5>>>,
    third: OnceLock<Option<Stage<9>>>,
    /// A friction angle next to that of the root, if friction is an unknown: from the second stage and from the third.
    friction_angles: [OnceLock<Option<Angle<Ball>>>; 2],
}

impl Approach {
    /// `None` where few words do not tell enough.
    pub(super) fn new(system: &System, domain: &[Ball]) -> Option<Self> {
        let start: Vec<_> = domain.iter().map(|x| ShortBall::from(&x.midpoint())).collect();
        let doubles: Vec<f64> = domain.iter().map(|x| x.mid().to_f64()).collect();
        let inverse = in_doubles(system, &doubles)?;
        let inverse = inverse.iter().map(|row| row.iter().map(|y| ShortBall::from(*y)).collect());
        let first = Stage::new(system, domain, start, inverse.collect())?;
        let (second, third) = (OnceLock::new(), OnceLock::new());
        let domain = domain.to_vec();
        Some(Self { domain, first, second, third, friction_angles: Default::default() })
    }

    /// All variables to about `bits` bits, at most [`MOST`], proved; `None` if the last step does not prove it.
    pub(super) fn enclose(&self, bits: u32) -> Option<Configuration<Ball>> {
        let third = if bits > SECOND { self.third() } else { None };
        if let Some(third) = third {
            return third.enclose(bits);
        }
        let second = if bits > FIRST { self.second() } else { None };
        second.map_or_else(|| self.first.enclose(bits), |second| second.enclose(bits))
    }

    /// The friction angle of an enclosure of more than [`FIRST`] bits, from one near by that is kept.
    pub(super) fn friction_angle(&self, at: &Configuration<Ball>) -> Option<Ball> {
        let is_long = at.friction.prec() > SECOND + GUARD;
        let near = || {
            let index = self.first.system.index(Unknown::Friction)?;
            let (friction, bits) = match is_long {
                true => (self.third()?.centre[index].to_ball(512), 64 * WORDS as u32),
                false => (self.second()?.centre[index].to_ball(256), SECOND + GUARD),
            };
            Some(Angle::new(arctangent(&friction).midpoint().with_precision(bits)))
        };
        let angle = &self.friction_angles[usize::from(is_long)];
        let Angle { rad, sin, cos } = angle.get_or_init(near).as_ref()?;
        let [rad, sin, cos] = [rad, sin, cos].map(|x| x.with_precision(at.friction.prec()));
        let angle = arctangent_from(&Angle { rad, sin, cos }, &at.friction);
        angle.is_bounded().then_some(angle)
    }

    fn second(&self) -> Option<&Stage<5>> {
        self.second.get_or_init(|| self.first.next(&self.domain)).as_ref()
    }

    fn third(&self) -> Option<&Stage<9>> {
        self.third.get_or_init(|| self.second()?.next(&self.domain)).as_ref()
    }
}

/// Numbers that the steps need to know of a root, in `M` words.
#[derive(Clone, Debug)]
struct Stage<const M: usize> {
    system: System,
    /// A candidate.
    centre: Vec<ShortBall<M>>,
    /// The angles with sine and cosine, to the bits of so many words.
    angles: [OnceLock<Vec<Option<Angle<Ball>>>>; ANGLE_WORDS.len()],
    /// The radii of `X`, whose centre is the candidate; the root is unique in it and the equations are regular.
    near: Vec<f64>,
    /// `Y`.
    inverse: Vec<Vec<ShortBall<M>>>,
    /// Bounds of `C`.
    contraction: Vec<Vec<f64>>,
    /// The bits to which the candidate is known, and those that a step gains.
    known: u32,
    gain: u32,
}

/// Numbers of words to which sines and cosines are kept.
const ANGLE_WORDS: [usize; 6] = [6, 10, 16, 24, 32, WORDS];

impl<const M: usize> Stage<M> {
    /// Unit of the last place.
    const UNIT: f64 = power_of_two(-64 * (M as i32 - 1));

    /// Stage from a candidate and an inverse to a part of its bits; `None` where it does not tell enough.
    fn new(
        system: &System,
        domain: &[Ball],
        start: Vec<ShortBall<M>>,
        rough: Vec<Vec<ShortBall<M>>>,
    ) -> Option<Self> {
        let angle = |(unknown, x): (&Unknown, &ShortBall<M>)| {
            unknown.is_angle().then(|| short(&angle_of(x, M)))
        };
        let angles = system.unknowns.iter().zip(&start).map(angle).collect();
        let mut point = ShortPoint { x: start, angles };
        let mut corrections = Vec::new();
        for _ in 0..STEPS {
            let residuals = system.residuals(&point.place(system));
            let (steps, sizes): (Vec<_>, Vec<f64>) =
                rough.iter().map(|row| step(row, &residuals)).unzip();
            corrections = sizes;
            point.advance(steps.iter().map(ShortBall::midpoint));
        }
        // A box has a width where nothing is to be corrected too.
        let near: Vec<f64> = corrections.iter().map(|size| ROOM * size.max(Self::UNIT)).collect();
        let centre = point.x.clone();
        point.widen(&near);
        let is_inside =
            |(x, outer): (&ShortBall<M>, &Ball)| x.to_ball(64 * M as u32).lies_inside(outer);
        if !point.x.iter().zip(domain).all(is_inside) {
            return None;
        }
        let slopes = system.residuals(&system.variables(&point.place(system)));
        let inverse = refined(&rough, &slopes);
        let contraction: Vec<Vec<f64>> = krawczyk::contraction(&slopes, &inverse)
            .iter()
            .map(|row| row.iter().map(ShortBall::bound).collect())
            .collect();
        let largest = |sizes: &[f64]| sizes.iter().copied().fold(0.0, f64::max);
        let gain = bits_below(largest(&contraction.concat()) * centre.len() as f64)?;
        let known = bits_below(largest(&corrections))?;
        let (system, angles) = (*system, Default::default());
        (gain >= LEAST_GAIN).then_some(Self {
            system,
            centre,
            angles,
            near,
            inverse,
            contraction,
            known,
            gain,
        })
    }

    /// The stage in other words that starts from this one.
    fn next<const L: usize>(&self, domain: &[Ball]) -> Option<Stage<L>> {
        let row = |row: &Vec<ShortBall<M>>| row.iter().map(|y| y.shifted(0)).collect();
        Stage::new(&self.system, domain, row(&self.centre), self.inverse.iter().map(row).collect())
    }

    fn enclose(&self, bits: u32) -> Option<Configuration<Ball>> {
        match (bits + GUARD).div_ceil(64) {
            0..=5 => self.in_words::<6>(bits),
            6..=7 => self.in_words::<8>(bits),
            8..=9 => self.in_words::<10>(bits),
            10..=11 => self.in_words::<12>(bits),
            12..=13 => self.in_words::<14>(bits),
            14..=15 => self.in_words::<16>(bits),
            16..=17 => self.in_words::<18>(bits),
            18..=19 => self.in_words::<20>(bits),
            20..=23 => self.in_words::<24>(bits),
            24..=27 => self.in_words::<28>(bits),
            28..=31 => self.in_words::<32>(bits),
            32..=35 => self.in_words::<36>(bits),
            _ => self.in_words::<WORDS>(bits),
        }
    }

    fn in_words<const N: usize>(&self, bits: u32) -> Option<Configuration<Ball>> {
        let mut x = self.centre.iter().map(|x| x.shifted(0)).collect();
        let known = self.climb_in::<10, N>(&mut x, self.known, bits);
        let known = self.climb_in::<14, N>(&mut x, known, bits);
        let known = self.climb_in::<18, N>(&mut x, known, bits);
        let known = self.climb_in::<24, N>(&mut x, known, bits);
        let known = self.climb_in::<32, N>(&mut x, known, bits);
        let mut point = self.point(&x);
        let known = self.climb(&mut point, known, bits.saturating_sub(self.gain));
        let (steps, asked) = self.steps(&point, known);
        let steps = self.image(&point.x, &steps, &asked, known)?;
        point.advance(steps.iter().map(|step| step.shifted(-(known as i32))));
        Some(point.place(&self.system).map(|x| x.to_ball(bits + GUARD)))
    }

    /// Steps in `L` words, as far as these go: to as many bits as the steps after them need.
    fn climb_in<const L: usize, const N: usize>(
        &self,
        x: &mut Vec<ShortBall<N>>,
        known: u32,
        bits: u32,
    ) -> u32 {
        let more = bits.saturating_sub(64 * (L as u32 - 1) - GUARD).div_ceil(self.gain);
        let goal = bits.saturating_sub(more.max(1) * self.gain);
        if L >= N || goal <= known {
            return known;
        }
        let few: Vec<ShortBall<L>> = x.iter().map(|x| x.shifted(0).midpoint()).collect();
        let mut point = self.point(&few);
        let known = self.climb(&mut point, known, goal);
        *x = point.x.iter().map(|x| x.shifted(0)).collect();
        known
    }

    /// A point next to the candidate.
    fn point<const N: usize>(&self, x: &[ShortBall<N>]) -> ShortPoint<N> {
        let last = ANGLE_WORDS.len() - 1;
        let place = ANGLE_WORDS.iter().position(|words| N <= *words).unwrap_or(last);
        let angle = |(unknown, x): (&Unknown, &ShortBall<M>)| {
            unknown.is_angle().then(|| angle_of(x, ANGLE_WORDS[place]))
        };
        let compute = || self.system.unknowns.iter().zip(&self.centre).map(angle).collect();
        let angles = self.angles[place].get_or_init(compute);
        let angles = angles.iter().map(|angle| angle.as_ref().map(short)).collect();
        let centre: Vec<ShortBall<N>> = self.centre.iter().map(|x| x.shifted(0)).collect();
        let steps: Vec<ShortBall<N>> =
            x.iter().zip(&centre).map(|(x, centre)| *x - centre).collect();
        let mut point = ShortPoint { x: centre, angles };
        point.advance(steps);
        point
    }

    /// Steps without a proof to `goal` bits. Any point near by will do, so that radii are left away.
    fn climb<const N: usize>(&self, point: &mut ShortPoint<N>, mut known: u32, goal: u32) -> u32 {
        while known < goal {
            let (steps, _) = self.steps(point, known);
            point.advance(steps.iter().map(|step| step.shifted(-(known as i32)).midpoint()));
            known = goal.min(known + self.gain);
        }
        known
    }

    /// `-Y F(x) 2^known`, and how large the terms of each sum are together.
    fn steps<const N: usize>(
        &self,
        at: &ShortPoint<N>,
        known: u32,
    ) -> (Vec<ShortBall<M>>, Vec<f64>) {
        tally::newton_step();
        let residuals = self.system.residuals(&at.place(&self.system));
        let residuals: Vec<ShortBall<M>> =
            residuals.iter().map(|r| r.shifted(known as i32)).collect();
        self.inverse.iter().map(|row| step(row, &residuals)).unzip()
    }

    /// The proof: `-Y F(x) ± C r` on a box just wide enough, if it lies in the interior of the box and the box in
    /// `X`; all times `2^known`.
    fn image<const N: usize>(
        &self,
        x: &[ShortBall<N>],
        steps: &[ShortBall<M>],
        asked: &[f64],
        known: u32,
    ) -> Option<Vec<ShortBall<M>>> {
        // What is chosen need not be rounded in a direction, what is computed with it has to be.
        const UP: f64 = 1.0 + 1e-14;
        let noise = 2f64.powi((known as i32 - 64 * (N as i32 - 1)).max(-1000));
        // An image has a radius of some units at least.
        let noise = noise.max(ROOM * Self::UNIT);
        let radii: Vec<f64> = asked.iter().map(|size| 2.0 * size + noise).collect();
        let scale = 2f64.powi(-(known as i32)).max(f64::MIN_POSITIVE);
        type Side<'a, const N: usize, const M: usize> =
            (((&'a ShortBall<N>, &'a ShortBall<M>), &'a f64), &'a f64);
        let is_near = |(((x, centre), near), radius): Side<N, M>| {
            let distance = (*x - centre.shifted::<N>(0)).bound();
            (distance + radius * scale) * UP < *near
        };
        let mut sides = x.iter().zip(&self.centre).zip(&self.near).zip(&radii);
        let spread = |row: &Vec<f64>| -> f64 {
            row.iter().zip(&radii).map(|(c, r)| c * r).sum::<f64>() * UP
        };
        let spreads = self.contraction.iter().map(spread);
        let image: Vec<ShortBall<M>> =
            steps.iter().zip(spreads).map(|(step, spread)| step.widened(spread)).collect();
        let is_contracted = image.iter().zip(&radii).all(|(x, radius)| x.bound() < *radius);
        (is_contracted && sides.all(is_near)).then_some(image)
    }
}

/// Values of the unknowns, and those that are angles with sine and cosine.
struct ShortPoint<const N: usize> {
    x: Vec<ShortBall<N>>,
    angles: Vec<Option<Angle<ShortBall<N>>>>,
}

impl<const N: usize> ShortPoint<N> {
    fn advance(&mut self, steps: impl IntoIterator<Item = ShortBall<N>>) {
        for ((x, angle), step) in self.x.iter_mut().zip(&mut self.angles).zip(steps) {
            *x = *x + step;
            *angle = angle.as_ref().map(|angle| Angle { rad: *x, ..moved(angle, &step) });
        }
    }

    /// Makes the point a box with these radii. Sines and cosines change by no more than their angles do.
    fn widen(&mut self, radii: &[f64]) {
        for ((x, angle), radius) in self.x.iter_mut().zip(&mut self.angles).zip(radii) {
            *x = x.widened(*radius);
            *angle = angle.as_ref().map(|angle| Angle {
                rad: *x,
                sin: angle.sin.widened(*radius),
                cos: angle.cos.widened(*radius),
            });
        }
    }

    /// All variables of a system at the point.
    fn place(&self, system: &System) -> Configuration<ShortBall<N>> {
        let given = Configuration::zero(&self.x[0]);
        system.place_with(given, &self.x, |index, rad| {
            self.angles[index].clone().unwrap_or_else(|| Angle::zero(rad))
        })
    }
}

/// The angle `x` to the bits of so many words.
fn angle_of<const N: usize>(x: &ShortBall<N>, words: usize) -> Angle<Ball> {
    Angle::new(x.to_ball(64 * words as u32))
}

fn short<const N: usize>(angle: &Angle<Ball>) -> Angle<ShortBall<N>> {
    let [rad, sin, cos] = [&angle.rad, &angle.sin, &angle.cos].map(ShortBall::from);
    Angle { rad, sin, cos }
}

/// `-y r`, and how large its terms are together.
fn step<const M: usize>(y: &[ShortBall<M>], r: &[ShortBall<M>]) -> (ShortBall<M>, f64) {
    let terms = y.iter().zip(r).map(|(y, r)| *y * r);
    terms.fold((r[0].int(0), 0.0), |(sum, size), term| (sum - term, size + term.bound()))
}

/// The inverse of the Jacobian in doubles: nothing of it is certain.
fn in_doubles(system: &System, centre: &[f64]) -> Option<Vec<Vec<f64>>> {
    let at = system.place(Configuration::zero(&0.0), centre);
    let slopes = system.residuals(&system.variables(&at));
    inverse(slopes.iter().map(|r| (0..centre.len()).map(|k| r.derivative(k)).collect()).collect())
}

/// The inverse of `J`, the slopes of some numbers, from one to some digits: twice as many by each `Y + Y (I - J Y)`.
/// Nothing of it is certain.
fn refined<const M: usize>(
    y: &[Vec<ShortBall<M>>],
    j: &[Dual<ShortBall<M>>],
) -> Vec<Vec<ShortBall<M>>> {
    let places = 0..y.len();
    let zero = y[0][0].int(0);
    let matrix = |entry: &dyn Fn(usize, usize) -> ShortBall<M>| -> Vec<Vec<ShortBall<M>>> {
        places.clone().map(|i| places.clone().map(|k| entry(i, k).midpoint()).collect()).collect()
    };
    let sum = |terms: &dyn Fn(usize) -> ShortBall<M>| {
        places.clone().map(terms).fold(zero, |sum, term| sum + term)
    };
    let j = matrix(&|i, k| j[i].derivative(k));
    let step = |y: Vec<Vec<ShortBall<M>>>, _| {
        let rest = matrix(&|i, k| zero.int(i32::from(i == k)) - sum(&|l| j[i][l] * y[l][k]));
        matrix(&|i, k| y[i][k] + sum(&|l| y[i][l] * rest[l][k]))
    };
    (1..STEPS).fold(y.to_vec(), step)
}

/// The bits by which a size is below one.
fn bits_below(size: f64) -> Option<u32> {
    (size > 0.0 && size < 1.0).then(|| (-size.log2()).floor() as u32)
}

/// The angle by a small `step` further, but for `rad`.
///
/// `sin d` and `1 - cos d` by their series, up to the first power `d^k/k!` whose midpoint is zero: as a ball it holds
/// what is left out of both.
fn moved<const N: usize>(from: &Angle<ShortBall<N>>, step: &ShortBall<N>) -> Angle<ShortBall<N>> {
    let Angle { rad, sin, cos } = *from;
    if step.bound() > 1.0 / 256.0 {
        return Angle { rad, sin: ShortBall::WHOLE, cos: ShortBall::WHOLE };
    }
    if step.is_about_zero() && step.bound() == 0.0 {
        return from.clone();
    }
    let (mut sine, mut less, mut power) = (*step, step.int(0), *step);
    for k in 2.. {
        power = power * step / step.int(k);
        if power.is_about_zero() {
            break;
        }
        match k % 4 {
            0 => less = less - power,
            1 => sine = sine + power,
            2 => less = less + power,
            _ => sine = sine - power,
        }
    }
    let (sine, less) = (sine + power, less + power);
    Angle { rad, sin: sin + (cos * sine - sin * less), cos: cos - (sin * sine + cos * less) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::number::{Magnitude, Real};
    use crate::problem::Landmark;
    use crate::prover::Isolated;
    use crate::prover::isolate::isolate;
    use crate::prover::refine::refine;
    use crate::solve::{newton, start};

    fn isolated(landmark: Landmark, weight: SelfWeight) -> Isolated {
        let system = landmark.system(weight);
        let candidate = newton(&system, start::landmark(landmark, weight), 64).unwrap();
        isolate(landmark, weight, &candidate).unwrap()
    }

    fn angle(at: &Configuration<Ball>, unknown: Unknown) -> &Angle<Ball> {
        match unknown {
            Unknown::HalfOpening => &at.half_opening,
            Unknown::RotationJoint => &at.rotation_joint,
            _ => &at.sliding_joint,
        }
    }

    #[test]
    fn it_has_the_bits_asked_for_and_overlaps_the_long_way() {
        for (landmark, weight) in
            Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w)))
        {
            let isolated = isolated(landmark, weight);
            let long = refine(&isolated, 2 * MOST).unwrap();
            let way = isolated.approach().unwrap();
            let first = &way.first;
            assert!(first.gain > 80 && first.known > 100, "{} {}", first.gain, first.known);
            let (second, third) = (way.second().unwrap(), way.third().unwrap());
            assert!(second.gain > 200 && second.known > 220, "{} {}", second.gain, second.known);
            assert!(third.gain > 450 && third.known > 470, "{} {}", third.gain, third.known);
            for bits in [64, 100, 256, 333, 512, 640, 780, 928, 1000, 1111, 1480, 1700, MOST] {
                let short = way.enclose(bits).unwrap();
                for &unknown in isolated.system().unknowns {
                    let (x, truth) = (short.value(unknown), long.value(unknown).unwrap());
                    assert!(truth.lies_inside(x), "{landmark:?} {unknown:?} {x:?}");
                    assert!(x.rad() < Magnitude::power_of_two(-i64::from(bits)), "{x:?}");
                    if unknown.is_angle() {
                        let (found, truth) = (angle(&short, unknown), truth.sin_cos());
                        assert!(truth.0.lies_inside(&found.sin) && truth.1.lies_inside(&found.cos));
                        assert!(found.sin.rad() < Magnitude::power_of_two(-i64::from(bits)));
                    }
                }
            }
        }
    }

    /// A step that proves nothing hands nothing out, and the other way is taken.
    #[test]
    fn a_step_that_proves_nothing_costs_no_more_than_time() {
        let isolated = isolated(Landmark::Triple, SelfWeight::Milankovitch);
        let way = isolated.approach().unwrap();
        assert!(way.enclose(256).is_some());
        let none = |change: &dyn Fn(&mut Stage<3>)| {
            let mut spoiled = way.clone();
            change(&mut spoiled.first);
            spoiled.enclose(256).is_none()
        };
        assert!(none(&|way| way.near[0] = 0.0), "it leaves the box of the slopes");
        assert!(none(&|way| way.contraction[1][1] = 1.0), "nothing is contracted");
        assert!(none(&|way| way.centre[0] = way.centre[0] * ShortBall::from(1.01)), "no root");
        assert!(none(&|way| way.inverse[2][3] = ShortBall::WHOLE), "nothing is known");
        let narrow: Vec<Ball> = isolated.domain().iter().map(Ball::midpoint).collect();
        assert!(Approach::new(isolated.system(), &narrow).is_none(), "outside the box of one root");
        let without = isolated.clone().without_approach();
        let [quick, slow] = [&isolated, &without].map(|isolated| refine(isolated, 256).unwrap());
        for &unknown in isolated.system().unknowns {
            assert!(quick.value(unknown).unwrap().overlaps(&slow.value(unknown).unwrap()));
        }
    }
}
