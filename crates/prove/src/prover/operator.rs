//! Exactly one root in a box: the only prover of that.
//!
//! It is asked in two ways. `Operator::image` tells whether a given box is mapped into itself, and
//! `largest_box` looks for a large one of that kind; `smallest_box` looks for one that is just wide
//! enough around a centre. The operator is in [`check::krawczyk`](crate::check::krawczyk).

use super::Undecided;
use crate::check::krawczyk;
use crate::number::{Ball, Derivatives, Dual, Dyadic, Enclosure, Engine, Magnitude, Real, Stumpff};
use crate::problem::Problem;
use crate::solve::inverse;
use rug::Float;

/// As many equations as unknowns, over enclosures.
pub trait Equations<E> {
    /// The residuals, in numbers of `bits` bits.
    fn residuals(&self, bits: u32, x: &[E]) -> Vec<E>;

    /// The residuals with their slopes.
    fn slopes(&self, bits: u32, x: &[E]) -> Vec<Dual<E>>;

    /// Tells whether nothing that was divided by or cleared vanishes anywhere in a box.
    fn is_regular(&self, bits: u32, x: &[E]) -> bool;
}

impl<E: Engine> Equations<E> for Problem {
    fn residuals(&self, bits: u32, x: &[E]) -> Vec<E> {
        let system = self.system();
        system.residuals(&system.place(self.given(bits), x))
    }

    fn slopes(&self, bits: u32, x: &[E]) -> Vec<Dual<E>> {
        let system = self.system();
        system.residuals(&system.variables(&system.place(self.given(bits), x)))
    }

    fn is_regular(&self, bits: u32, x: &[E]) -> bool {
        let system = self.system();
        let at = system.place(self.given(bits), x);
        system.denominators(&at).iter().all(Enclosure::excludes_zero)
    }
}

/// A form of the equations of an arch, over candidates too: as printed, or in variables in which nothing
/// cancels. What is given is given in numbers `E`.
pub trait Form<E> {
    /// The residuals; `number` makes a number like those of `x` of what is given.
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T>;

    /// Tells whether nothing that was divided by or cleared vanishes anywhere in a box; `number` as before.
    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> bool;

    /// Unknowns that are angles of which it is known beforehand that sine and cosine are asked for.
    fn angles(&self) -> Vec<usize> {
        Vec::new()
    }
}

impl<F: Form<Ball>> Equations<Ball> for F {
    fn residuals(&self, bits: u32, x: &[Ball]) -> Vec<Ball> {
        self.at(|given| given.with_precision(bits), x)
    }

    fn slopes(&self, bits: u32, x: &[Ball]) -> Vec<Dual<Ball>> {
        self.at(|given| Dual::constant(given.with_precision(bits)), &Dual::variables(x))
    }

    fn is_regular(&self, _bits: u32, x: &[Ball]) -> bool {
        Form::is_regular(self, Ball::clone, x)
    }
}

/// The Krawczyk operator of some equations about a centre, in numbers of some bits.
pub struct Operator<'a, S, E> {
    equations: &'a S,
    bits: u32,
    points: Vec<E>,
    residuals: Vec<E>,
    inverse: Vec<Vec<E>>,
}

impl<'a, S: Equations<E>, E: Engine> Operator<'a, S, E> {
    /// The operator with an approximate inverse of the Jacobian at the centre.
    pub fn new(equations: &'a S, bits: u32, centre: &[Float], inverse: &[Vec<Float>]) -> Self {
        let exact = |x: &Float| E::exact(&Dyadic::from(x), bits as usize);
        let points: Vec<E> = centre.iter().map(exact).collect();
        Self {
            equations,
            bits,
            residuals: equations.residuals(bits, &points),
            points,
            inverse: inverse.iter().map(|row| row.iter().map(exact).collect()).collect(),
        }
    }

    /// The box of all points within the radii of the centre.
    pub(crate) fn domain(&self, radii: &[Magnitude]) -> Vec<E> {
        let sides = self.points.iter().zip(radii);
        sides.map(|(x, r)| x.widened_by(&Dyadic::from(&r.to_float()))).collect()
    }

    /// The proof: the image of the box within `radii`, if it lies in the interior of the box and nothing
    /// that is divided by vanishes there. Then the box holds exactly one root, and the image holds it.
    /// `None` says nothing.
    pub(crate) fn image(&self, radii: &[Magnitude]) -> Option<Vec<E>> {
        let domain = self.domain(radii);
        self.image_of(&domain).filter(|image| krawczyk::is_contracted(image, &domain))
    }

    /// Image of a box, with room to spare: the image lies in the interior of a smaller box.
    pub(crate) fn image_in(&self, radii: &[Magnitude], smaller: &[Magnitude]) -> Option<Vec<E>> {
        let image = self.image_of(&self.domain(radii))?;
        krawczyk::is_contracted(&image, &self.domain(smaller)).then_some(image)
    }

    /// The image of a box, if nothing that is divided by vanishes there.
    fn image_of(&self, domain: &[E]) -> Option<Vec<E>> {
        if !self.equations.is_regular(self.bits, domain) {
            return None;
        }
        let slopes = self.equations.slopes(self.bits, domain);
        Some(krawczyk::image(&self.points, &self.residuals, &slopes, &self.inverse, domain))
    }
}

/// An approximate inverse of the Jacobian, in numbers of `bits` bits; `None` if it is singular.
pub fn inverse_jacobian(slopes: &[Dual<Ball>], bits: u32) -> Option<Vec<Vec<Float>>> {
    let n = slopes.len();
    let entry = |r: &Dual<Ball>, k| {
        r.slope(k).map_or_else(|| Float::new(bits), |s| Float::with_val(bits, s.mid()))
    };
    inverse(slopes.iter().map(|r| (0..n).map(|k| entry(r, k)).collect()).collect())
}

/// The scales on which a large box is sought.
#[derive(Clone, Copy)]
pub(crate) struct Scales {
    /// Ratio of each scale to the one before.
    pub step: f64,
    /// Number of scales that are tried, from one downwards.
    pub trials: i32,
}

/// Bits by which a side is below the widest where it is rounding.
const ROUNDING: i64 = -40;
/// Changes of shape after which the box has stopped growing.
const SHAPES: usize = 4;

/// Boxes that `prove` proves, each with its image: the largest of the scales of each of some shapes. The
/// shape is first in proportion to the values of the unknowns; then the radii of the image of the
/// largest box become the next shape, since they tell how much room each unknown needs. No radius exceeds
/// its value.
///
/// `seems` is a quick test that is nearly always right, and only tells where the search begins.
pub(crate) fn largest_boxes(
    values: &[Magnitude],
    scales: Scales,
    seems: impl Fn(&[Magnitude]) -> bool,
    prove: impl Fn(&[Magnitude]) -> Option<Vec<Ball>>,
) -> Vec<(Vec<Magnitude>, Vec<Ball>)> {
    let mut found = Vec::new();
    let mut shape = values.to_vec();
    for _ in 0..SHAPES {
        let radii = |trial: i32| -> Vec<Magnitude> {
            let scale = Magnitude::upper(&Float::with_val(53, scales.step.powi(trial)));
            shape.iter().map(|s| s.times(scale)).collect()
        };
        let proved = |trial| prove(&radii(trial)).map(|image| (trial, image));
        let Some((trial, image)) = first(scales.trials, |trial| seems(&radii(trial)), proved)
        else {
            break;
        };
        let widths: Vec<Magnitude> = image.iter().map(Ball::rad).collect();
        found.push((radii(trial), image));
        let sizes = || widths.iter().zip(values).map(|(w, v)| w.over(*v));
        let Some((least, widest)) = sizes().min().zip(sizes().max()) else { break };
        // An unknown that the equations fix alone leaves rounding, which is no shape.
        if least < widest.shifted(ROUNDING) {
            break;
        }
        shape = widths.iter().map(|w| w.over(widest)).collect();
    }
    found
}

/// The first success of `proved` among some trials, which fail up to somewhere and succeed from there on, at first at
/// least: what a box contains is contracted too, until it is as small as the roundings.
///
/// The first trial that `seems` to succeed is found by doubling and halving. From there the search goes up and down
/// by `proved` alone, so that a wrong guess costs time and nothing else.
fn first<P>(
    trials: i32,
    seems: impl Fn(i32) -> bool,
    proved: impl Fn(i32) -> Option<(i32, P)>,
) -> Option<(i32, P)> {
    let powers = std::iter::successors(Some(1), |k| Some(2 * k)).take_while(|k| *k <= trials);
    // Trials begin with the largest box, which has number zero.
    let guess = powers.map(|k| k - 1).find(|k| seems(*k)).map_or(0, |success| {
        let (mut failure, mut success) = ((success + 1) / 2 - 1, success);
        while success - failure > 1 {
            let middle = failure + (success - failure) / 2;
            if seems(middle) { success = middle } else { failure = middle }
        }
        success
    });
    let mut best = (guess..trials).find_map(&proved)?;
    // Usually the one before is tried and fails.
    while best.0 > 0 && best.0 <= guess {
        let Some(better) = proved(best.0 - 1) else { break };
        best = better;
    }
    Some(best)
}

/// Ratio of the width of a box to the correction that the residuals ask for, in bits.
const INFLATIONS: [i64; 3] = [2, 8, 20];
/// Bits by which a wide box is narrower than half of all: its image is about its square, and may be bent.
const ROOM: i64 = 40;

/// A box around the centre that is proved to hold exactly one root, and its image: just wide enough for the proof, or
/// `wide`, as far as no digit of the image is lost.
pub(super) fn box_around<S: Equations<Ball>>(
    equations: &S,
    bits: u32,
    centre: &[Float],
    wide: bool,
) -> Result<[Vec<Ball>; 2], Undecided> {
    let points: Vec<Ball> = centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
    let at_centre = equations.slopes(bits, &points);
    let inverse = inverse_jacobian(&at_centre, bits).ok_or_else(Undecided::singular)?;
    let exact = |y: &Float| Ball::exact(y.clone(), bits);
    let operator = Operator {
        equations,
        bits,
        residuals: at_centre.iter().map(|r| r.value().clone()).collect(),
        points,
        inverse: inverse.iter().map(|row| row.iter().map(exact).collect()).collect(),
    };
    let radii = corrections(&inverse, &operator.residuals, centre, bits);
    let proved = |inflation| proved_box(&operator, &radii, inflation);
    let wide = wide.then(|| i64::from(bits / 2) - ROOM).and_then(proved);
    wide.or_else(|| INFLATIONS.into_iter().find_map(proved)).ok_or_else(Undecided::not_alone)
}

/// The sizes of the corrections that the residuals at a centre of `bits` bits ask for, rounding included.
pub fn corrections(
    inverse: &[Vec<Float>],
    residuals: &[Ball],
    centre: &[Float],
    bits: u32,
) -> Vec<Magnitude> {
    let size = |r: &Ball| Magnitude::upper(r.mid()).plus(r.rad());
    let correction = |(row, x): (&Vec<Float>, &Float)| {
        let terms = row.iter().zip(residuals).map(|(y, r)| Magnitude::upper(y).times(size(r)));
        terms.fold(Magnitude::upper(x).shifted(-i64::from(bits)), Magnitude::plus)
    };
    inverse.iter().zip(centre).map(correction).collect()
}

/// The first of some boxes, several times as wide as the corrections, that is mapped into itself, and its image.
pub fn inflated<S: Equations<E>, E: Engine>(
    operator: &Operator<S, E>,
    corrections: &[Magnitude],
) -> Option<[Vec<E>; 2]> {
    INFLATIONS.into_iter().find_map(|inflation| proved_box(operator, corrections, inflation))
}

/// A box `2^inflation` times as wide as the corrections, if it is mapped into itself, and its image.
fn proved_box<S: Equations<E>, E: Engine>(
    operator: &Operator<S, E>,
    corrections: &[Magnitude],
    inflation: i64,
) -> Option<[Vec<E>; 2]> {
    let radii: Vec<Magnitude> = corrections.iter().map(|r| r.shifted(inflation)).collect();
    Some([operator.domain(&radii), operator.image(&radii)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The trials from 17 up to 130 succeed. Whatever seems to, the first of them is found.
    #[test]
    fn a_wrong_guess_changes_nothing() {
        let proved = |k: i32| (17..130).contains(&k).then_some((k, ()));
        let guesses: [fn(i32) -> bool; 6] =
            [|k| k >= 17, |k| k >= 15, |k| k >= 25, |_| false, |_| true, |k| k >= 90];
        for (number, seems) in guesses.iter().enumerate() {
            assert_eq!(first(200, seems, proved), Some((17, ())), "guess {number}");
        }
        assert_eq!(first(200, |k| k >= 17, |_| None::<(i32, ())>), None);
        assert_eq!(first(17, |k| k >= 17, proved), None, "too few trials");
        assert_eq!(first(200, |k| k >= 0, |k| Some((k, ()))), Some((0, ())));
    }

    /// A good guess costs few proofs: the one that succeeds and the one before.
    #[test]
    fn a_good_guess_saves_the_walk() {
        let count = std::cell::Cell::new(0);
        let proved = |k: i32| {
            count.set(count.get() + 1);
            (k >= 100).then_some((k, ()))
        };
        assert_eq!(first(200, |k| k >= 100, proved), Some((100, ())));
        assert_eq!(count.get(), 2);
    }
}
