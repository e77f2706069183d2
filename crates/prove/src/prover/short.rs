//! Refinement from a proved box to some hundred bits, by steps with one inverse and without a heap.
//!
//! Next to the root the Jacobian hardly changes. Its inverse `Y`, to the bits of a double-double, is computed once, and
//! with it, over balls of double-doubles, a bound `C` of `|I - Y F'(X)|`, entry by entry, on one small box `X`
//! about the root. Then for every box `x ± r` within `X` the image of the Krawczyk operator is within
//!
//! ```text
//! x - Y F(x) ± C r
//! ```
//!
//! So each step costs residuals and nothing else, and gains the bits of `C`; the last one proves. With more bits it is
//! cheaper to compute slopes again and to double what a step gains.
//!
//! Residuals are over [`ShortBall`]; what is small, they and the steps, becomes double-doubles, times a power of
//! two. Sines and cosines are computed once, at the candidate, and moved along. The first steps are made in fewer
//! words.

use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{
    Angle, Ball, DoubleDouble, DoubleDoubleBall, Enclosure, Field, ShortBall, power_of_two,
};
use crate::problem::{System, tally};
use crate::solve::inverse;

/// Largest number of bits for which it pays.
pub(super) const MOST: u32 = 928;
/// Bits of a result beyond those asked for, so that the condition of the system eats no digits.
const GUARD: u32 = 32;
/// Ratio of the width of `X` to the one that the corrections ask for.
const ROOM: f64 = 64.0;
/// The words of the first steps, and the bits to which they are made.
const FEW_WORDS: usize = 8;
const FEW_BITS: u32 = 64 * (FEW_WORDS as u32 - 1) - GUARD;
/// The least gain of a step that is worth while, in bits.
const LEAST_GAIN: u32 = 32;

/// Numbers that the steps need to know of a root.
#[derive(Clone, Debug)]
pub(super) struct Approach {
    system: System,
    /// A candidate.
    centre: Vec<DoubleDouble>,
    /// The radii of `X`, whose centre is the candidate; the root is unique in it and the equations are regular.
    near: Vec<f64>,
    /// `Y`.
    inverse: Vec<Vec<DoubleDoubleBall>>,
    /// Bounds of `C`.
    contraction: Vec<Vec<f64>>,
    /// The bits to which the candidate is known, and those that a step gains.
    known: u32,
    gain: u32,
}

impl Approach {
    /// Approach to the root next to the centre of a box in which it is unique; `None` where double-doubles do
    /// not tell enough.
    pub(super) fn new(system: &System, domain: &[Ball]) -> Option<Self> {
        let start = domain.iter().map(|x| DoubleDoubleBall::from(&x.midpoint()).mid());
        let mut centre: Vec<DoubleDouble> = start.collect();
        let rough = in_doubles(system, &centre)?;
        let mut corrections = Vec::new();
        // The first step leaves the bits of a double times those of the start; the second tells how much.
        for _ in 0..2 {
            let residuals = system.residuals(&place(system, &exact(&centre)));
            let step = |row: &Vec<f64>| {
                let terms = row.iter().zip(&residuals);
                terms
                    .fold(DoubleDouble::ZERO, |sum, (y, r)| sum + DoubleDouble::exact(*y) * r.mid())
            };
            let size = |row: &Vec<f64>| -> f64 {
                row.iter().zip(&residuals).map(|(y, r)| y.abs() * r.size()).sum()
            };
            corrections = rough.iter().map(size).collect();
            centre = centre.iter().zip(&rough).map(|(x, row)| *x - step(row)).collect();
        }
        let points = exact(&centre);
        let slopes = system.residuals(&system.variables(&place(system, &points)));
        let inverse = refined(&rough, |i, k| slopes[i].derivative(k).mid());
        let inverse: Vec<Vec<DoubleDoubleBall>> = inverse.iter().map(|row| exact(row)).collect();
        let near: Vec<f64> = corrections.iter().map(|size| ROOM * size).collect();
        let sides = points.iter().zip(&near);
        let widened: Vec<DoubleDoubleBall> = sides.map(|(x, radius)| x.widened(*radius)).collect();
        let is_inside = |(x, outer): (&DoubleDoubleBall, &Ball)| x.to_ball(256).lies_inside(outer);
        if !widened.iter().zip(domain).all(is_inside) {
            return None;
        }
        let slopes = system.residuals(&system.variables(&place(system, &widened)));
        let contraction: Vec<Vec<f64>> = krawczyk::contraction(&slopes, &inverse)
            .iter()
            .map(|row| row.iter().map(DoubleDoubleBall::size).collect())
            .collect();
        let largest = |sizes: &[f64]| sizes.iter().copied().fold(0.0, f64::max);
        let gain = bits_below(largest(&contraction.concat()) * centre.len() as f64)?;
        let known = bits_below(largest(&corrections))?;
        let system = *system;
        (gain >= LEAST_GAIN).then_some(Self {
            system,
            centre,
            near,
            inverse,
            contraction,
            known,
            gain,
        })
    }

    /// All variables to about `bits` bits, at most [`MOST`], proved; `None` if the last step does not prove it.
    pub(super) fn enclose(&self, bits: u32) -> Option<Configuration<Ball>> {
        match bits + GUARD {
            0..=320 => self.in_words::<6>(bits),
            321..=448 => self.in_words::<FEW_WORDS>(bits),
            449..=576 => self.in_words::<10>(bits),
            577..=704 => self.in_words::<12>(bits),
            705..=832 => self.in_words::<14>(bits),
            _ => self.in_words::<16>(bits),
        }
    }

    fn in_words<const N: usize>(&self, bits: u32) -> Option<Configuration<Ball>> {
        let centre = self.centre_in::<N>();
        let angle = |(unknown, x): (&Unknown, &ShortBall<N>)| {
            unknown.is_angle().then(|| Angle::new(x.to_ball(64 * N as u32)))
        };
        let angles: Vec<Option<Angle<Ball>>> =
            self.system.unknowns.iter().zip(&centre).map(angle).collect();
        let (x, known) = match N > FEW_WORDS {
            true => {
                let mut few = self.point::<FEW_WORDS>(self.centre_in(), &angles);
                let known = self.climb(&mut few, self.known, FEW_BITS);
                (few.x.iter().map(ShortBall::lengthened).collect(), known)
            }
            false => (centre, self.known),
        };
        let mut point = self.point::<N>(x, &angles);
        let known = self.climb(&mut point, known, bits);
        let (steps, asked) = self.steps(&self.place(&point), known);
        let steps = self.image(&point.x, &steps, &asked, known)?;
        point.advance(steps.iter().map(|step| ShortBall::of(step, known)));
        Some(self.place(&point).map(|x| x.to_ball(bits + GUARD)))
    }

    fn centre_in<const N: usize>(&self) -> Vec<ShortBall<N>> {
        self.centre.iter().map(|x| ShortBall::scaled(*x, 0).midpoint()).collect()
    }

    /// The point `x`, from sines and cosines at the candidate.
    fn point<const N: usize>(
        &self,
        x: Vec<ShortBall<N>>,
        angles: &[Option<Angle<Ball>>],
    ) -> ShortPoint<N> {
        let centre = self.centre_in::<N>().into_iter().zip(&x);
        let angle =
            |(angle, (centre, x)): (&Option<Angle<Ball>>, (ShortBall<N>, &ShortBall<N>))| {
                let Angle { sin, cos, .. } = angle.as_ref()?;
                let from = Angle { rad: *x, sin: ShortBall::from(sin), cos: ShortBall::from(cos) };
                Some(moved(&from, &(*x - centre)))
            };
        let angles = angles.iter().zip(centre).map(angle).collect();
        ShortPoint { x, angles }
    }

    /// Steps without a proof, until one more has `bits` bits. Any point near by will do, so that radii are left away.
    fn climb<const N: usize>(&self, point: &mut ShortPoint<N>, mut known: u32, bits: u32) -> u32 {
        while known + self.gain < bits {
            let (steps, _) = self.steps(&self.place(point), known);
            point.advance(steps.iter().map(|step| ShortBall::of(step, known).midpoint()));
            known += self.gain;
        }
        known
    }

    fn place<const N: usize>(&self, at: &ShortPoint<N>) -> Configuration<ShortBall<N>> {
        let given = Configuration::zero(&at.x[0]);
        self.system.place_with(given, &at.x, |index, rad| {
            at.angles[index].clone().unwrap_or_else(|| Angle::zero(rad))
        })
    }

    /// `-Y F(x) 2^known`, and how large the terms of each sum are together.
    fn steps<const N: usize>(
        &self,
        at: &Configuration<ShortBall<N>>,
        known: u32,
    ) -> (Vec<DoubleDoubleBall>, Vec<f64>) {
        tally::newton_step();
        let residuals = self.system.residuals(at);
        let residuals: Vec<DoubleDoubleBall> = residuals.iter().map(|r| r.leading(known)).collect();
        let zero = DoubleDoubleBall::exact(DoubleDouble::ZERO);
        let step = |row: &Vec<DoubleDoubleBall>| {
            let terms = row.iter().zip(&residuals).map(|(y, r)| *y * r);
            terms.fold((zero, 0.0), |(sum, size), term| (sum - term, size + term.size()))
        };
        self.inverse.iter().map(step).unzip()
    }

    /// The proof: `-Y F(x) ± C r` on a box just wide enough, if it lies in the interior of the box and the box in
    /// `X`; all times `2^known`.
    fn image<const N: usize>(
        &self,
        x: &[ShortBall<N>],
        steps: &[DoubleDoubleBall],
        asked: &[f64],
        known: u32,
    ) -> Option<Vec<DoubleDoubleBall>> {
        // What is chosen need not be rounded in a direction, what is computed with it has to be.
        const UP: f64 = 1.0 + 1e-14;
        let noise = power_of_two(known as i32 - 64 * (N as i32 - 1));
        let radii: Vec<f64> = asked.iter().map(|size| 2.0 * size + noise).collect();
        let scale = power_of_two(-(known as i32));
        type Side<'a, const N: usize> = (((&'a ShortBall<N>, &'a DoubleDouble), &'a f64), &'a f64);
        let is_near = |(((x, centre), near), radius): Side<N>| {
            let distance = (*x - ShortBall::<N>::scaled(*centre, 0)).bound();
            (distance + radius * scale) * UP < *near
        };
        let sides = x.iter().zip(&self.centre).zip(&self.near).zip(&radii);
        let spread = |row: &Vec<f64>| -> f64 {
            row.iter().zip(&radii).map(|(c, r)| c * r).sum::<f64>() * UP
        };
        let spreads = self.contraction.iter().map(spread);
        let image: Vec<DoubleDoubleBall> =
            steps.iter().zip(spreads).map(|(step, spread)| step.widened(spread)).collect();
        let side = |r: &f64| DoubleDoubleBall::new(DoubleDouble::ZERO, *r);
        let domain: Vec<DoubleDoubleBall> = radii.iter().map(side).collect();
        (sides.into_iter().all(is_near) && krawczyk::is_contracted(&image, &domain))
            .then_some(image)
    }
}

/// Values of the unknowns, and those that are angles with sine and cosine.
struct ShortPoint<const N: usize> {
    x: Vec<ShortBall<N>>,
    angles: Vec<Option<Angle<ShortBall<N>>>>,
}

impl<const N: usize> ShortPoint<N> {
    fn advance(&mut self, steps: impl Iterator<Item = ShortBall<N>>) {
        for ((x, angle), step) in self.x.iter_mut().zip(&mut self.angles).zip(steps) {
            *x = *x + step;
            *angle = angle.as_ref().map(|angle| Angle { rad: *x, ..moved(angle, &step) });
        }
    }
}

fn exact(x: &[DoubleDouble]) -> Vec<DoubleDoubleBall> {
    x.iter().map(|x| DoubleDoubleBall::exact(*x)).collect()
}

fn place(system: &System, x: &[DoubleDoubleBall]) -> Configuration<DoubleDoubleBall> {
    system.place(Configuration::zero(&DoubleDoubleBall::exact(DoubleDouble::ZERO)), x)
}

/// The inverse of the Jacobian in doubles: nothing of it is certain.
fn in_doubles(system: &System, centre: &[DoubleDouble]) -> Option<Vec<Vec<f64>>> {
    let x: Vec<f64> = centre.iter().map(|x| x.hi()).collect();
    let at = system.place(Configuration::zero(&0.0), &x);
    let slopes = system.residuals(&system.variables(&at));
    inverse(slopes.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect())
}

/// The inverse of `J` to twice its digits: `Y + Y (I - J Y)`.
fn refined(y: &[Vec<f64>], j: impl Fn(usize, usize) -> DoubleDouble) -> Vec<Vec<DoubleDouble>> {
    let places = 0..y.len();
    let sum = |terms: &dyn Fn(usize) -> DoubleDouble| {
        places.clone().map(terms).fold(DoubleDouble::ZERO, |sum, term| sum + term)
    };
    let dd = DoubleDouble::exact;
    let rest = |i: usize, k: usize| {
        let one = dd(f64::from(u8::from(i == k)));
        one - sum(&|l| j(i, l) * dd(y[l][k]))
    };
    let rest: Vec<Vec<DoubleDouble>> =
        places.clone().map(|i| places.clone().map(|k| rest(i, k)).collect()).collect();
    let entry = |i: usize, k: usize| dd(y[i][k]) + sum(&|l| dd(y[i][l]) * rest[l][k]);
    places.clone().map(|i| places.clone().map(|k| entry(i, k)).collect()).collect()
}

/// The bits by which a size is below one.
fn bits_below(size: f64) -> Option<u32> {
    (size > 0.0 && size < 1.0).then(|| (-size.log2()).floor() as u32)
}

/// The angle by a small `step` further, but for `rad`.
///
/// `sin d` and `1 - cos d` by their series, up to the first power `d^k/k!` that is below one unit: it bounds what
/// is left out of both.
fn moved<const N: usize>(from: &Angle<ShortBall<N>>, step: &ShortBall<N>) -> Angle<ShortBall<N>> {
    let Angle { rad, sin, cos } = *from;
    if step.bound() > 1.0 / 256.0 {
        return Angle { rad, sin: ShortBall::WHOLE, cos: ShortBall::WHOLE };
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
    let (sine, less) = (sine.widened(power.bound()), less.widened(power.bound()));
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
            assert!(way.gain > 60 && way.known > 80, "{} {}", way.gain, way.known);
            for bits in [64, 100, 256, 333, 512, 640, 780, MOST] {
                let short = way.enclose(bits).unwrap();
                for &unknown in way.system.unknowns {
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
        let none = |change: &dyn Fn(&mut Approach)| {
            let mut spoiled = way.clone();
            change(&mut spoiled);
            spoiled.enclose(256).is_none()
        };
        assert!(none(&|way| way.near[0] = 0.0), "it leaves the box of the slopes");
        assert!(none(&|way| way.contraction[1][1] = 1.0), "nothing is contracted");
        assert!(none(&|way| way.centre[0] = way.centre[0] * DoubleDouble::exact(1.01)), "no root");
        assert!(none(&|way| way.inverse[2][3] = DoubleDoubleBall::WHOLE), "nothing is known");
        let narrow: Vec<Ball> = isolated.domain().iter().map(Ball::midpoint).collect();
        assert!(Approach::new(isolated.system(), &narrow).is_none(), "outside the box of one root");
        let without = isolated.clone().without_approach();
        let [quick, slow] = [&isolated, &without].map(|isolated| refine(isolated, 256).unwrap());
        for &unknown in way.system.unknowns {
            assert!(quick.value(unknown).unwrap().overlaps(&slow.value(unknown).unwrap()));
        }
    }
}
