//! Mean of the least thickness over a survey, each measure spread evenly between its ends.
//!
//! The least thickness `T`, a ratio or in metres, is a function of the measures `c`: of half opening and friction, or
//! of span, rise and friction. About their middle `c0`
//!
//! ```text
//! T(c) = T(c0) + T'(xi) (c - c0)
//! ```
//!
//! The mean of `c - c0` is zero, and that of its size is half the half-width `w`. So the mean of `T` is `T(c0)` to
//! within `d w/2` for each measure, with `d` the radius of the slope: it is known to second order.

use super::patch::{Patch, between};
use crate::arch::Unknown;
use crate::number::{DoubleBall, Dual, Enclosure, ExactNumber, Field};
use crate::problem::Friction;
use crate::problem::measures::{Length, of_span_and_rise};
use crate::problem::survey::{Shape, Survey};
use num_bigint::BigInt;

/// Least thicknesses of the arches of a survey, as ratios or in metres.
pub(super) struct LeastThicknesses {
    /// All of them.
    pub all: DoubleBall,
    /// Mean of them.
    pub mean: DoubleBall,
}

/// Bits of a double.
const BITS: u32 = 53;

/// Range of a measure, and its middle.
#[derive(Clone)]
struct Measure {
    all: DoubleBall,
    middle: DoubleBall,
}

impl Measure {
    fn new([first, last]: [DoubleBall; 2]) -> Self {
        Self { all: between([first, last]), middle: (first + last) / DoubleBall::exact(2.0) }
    }

    fn of_numbers(range: &[ExactNumber; 2]) -> Self {
        Self::new(range.each_ref().map(|x| x.enclosure(BITS)))
    }

    fn of_lengths(range: &[Length; 2]) -> Self {
        Self::new(range.each_ref().map(metres))
    }

    /// Measure of the frictions; with no limit it is zero, and nothing reads it.
    fn of_frictions(range: &[Friction; 2]) -> Option<Self> {
        match range {
            [Friction::Coefficient(a), Friction::Coefficient(b)] => {
                Some(Self::of_numbers(&[a.clone(), b.clone()]))
            }
            [Friction::Infinite, Friction::Infinite] => {
                Some(Self::new([DoubleBall::exact(0.0); 2]))
            }
            _ => None,
        }
    }
}

fn metres(length: &Length) -> DoubleBall {
    ExactNumber::rational(length.metres().clone()).enclosure(BITS)
}

/// A number with its slopes to the measures, and behind them to what the plane leaves.
type Sloped = Dual<DoubleBall>;

/// Least thicknesses of the arches of a survey; `None` if these are not seen to have states of one mode, or if their
/// frictions are angles.
pub(super) fn least_thicknesses(survey: &Survey) -> Option<LeastThicknesses> {
    let friction = Measure::of_frictions(survey.friction())?;
    let half_opening = Measure::of_numbers(&survey.half_opening());
    let is_limited = survey.friction()[0] != Friction::Infinite;
    let patch =
        Patch::prove(survey.weight(), half_opening.all, is_limited.then_some(friction.all))?;
    let plane = patch.plane(Unknown::Thickness)?;
    let (measures, middle) = match survey.shape() {
        Shape::Free { .. } => {
            let middle = half_opening.middle;
            (vec![half_opening.clone(), friction], middle)
        }
        Shape::Spanned { span, rise, .. } => {
            let middle = of_span_and_rise(&midway(span)?, &midway(rise)?).0.enclosure(BITS);
            (vec![Measure::of_lengths(span), Measure::of_lengths(rise), friction], middle)
        }
    };
    let n = measures.len();
    let thickness = |of: &dyn Fn(usize) -> Sloped, half_opening, rest| match survey.shape() {
        Shape::Free { .. } => plane.on([of(0), of(1)], constant) + rest,
        Shape::Spanned { circle, .. } => {
            let (alpha, radius) = circle_of([of(0), of(1)], half_opening);
            let ratio = plane.on([alpha, of(2)], constant) + rest;
            circle.centreline(radius, &ratio) * ratio
        }
    };
    let at_middle = thickness(&|k| Dual::constant(measures[k].middle), middle, constant(0.0));
    let on_all = thickness(
        &|k| Dual::variable(measures[k].all, k),
        half_opening.all,
        // The slopes are asked for from the plane on, where the rest is zero.
        Dual::variable(plane.rest.widened(plane.rest.size()), n),
    );
    let base = *at_middle.value() + on_all.derivative(n) * plane.rest;
    let half = DoubleBall::exact(0.5);
    let (mut all, mut mean) = (base, base);
    for (k, measure) in measures.iter().enumerate() {
        let (slope, offsets) = (on_all.derivative(k), measure.all - measure.middle);
        all = all + slope * offsets;
        mean = mean + slope.centred() * offsets * half;
    }
    Some(LeastThicknesses { all, mean })
}

fn constant(x: f64) -> Sloped {
    Dual::constant(DoubleBall::exact(x))
}

/// Half opening, whose values are known, and radius of the circle of a span and a rise.
fn circle_of([span, rise]: [Sloped; 2], half_opening: DoubleBall) -> (Sloped, Sloped) {
    let half = span * constant(0.5);
    let tangent = rise.clone() / &half;
    // alpha = 2 atan(tangent)
    let slope = constant(2.0) / (constant(1.0) + tangent.square());
    let slopes = (0..2).map(|k| tangent.derivative(k) * slope.value()).collect();
    let radius = (half.square() + rise.square()) / (rise * constant(2.0));
    (Dual::new(half_opening, slopes), radius)
}

fn midway([first, last]: &[Length; 2]) -> Option<Length> {
    Length::of_metres((first.metres() + last.metres()) / BigInt::from(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::state::Certify;
    use crate::problem::Arch;
    use crate::problem::measures::Circle;

    fn ends<T: std::str::FromStr<Err: std::fmt::Debug>>(range: [&str; 2]) -> [T; 2] {
        range.map(|text| text.parse().unwrap())
    }

    /// Mean over the middles of `n` by `n` parts of two ranges, and the extremes.
    fn of_grid(n: u32, at: impl Fn(f64, f64) -> f64) -> [f64; 3] {
        let part = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
        let all: Vec<f64> = (0..n * n).map(|k| at(part(k % n), part(k / n))).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let [low, high] = [f64::min, f64::max].map(|of| all.iter().copied().reduce(of).unwrap());
        [low, mean, high]
    }

    fn agrees(found: &LeastThicknesses, [low, mean, high]: [f64; 3], near: f64) {
        assert!(found.all.lower() <= low && high <= found.all.upper(), "{low} {high}");
        let (lower, upper) = (found.mean.lower(), found.mean.upper());
        assert!(upper - lower < near, "{lower} {upper}");
        assert!(
            lower - near / 10.0 <= mean && mean <= upper + near / 10.0,
            "{lower} {mean} {upper}"
        );
    }

    #[test]
    fn the_mean_is_that_of_a_grid() {
        let shape = Shape::Free { half_opening: ends(["1.7", "1.704"]), thickness: None };
        let survey = Survey::new(SelfWeight::Heyman, ends(["0.43", "0.434"]), shape).unwrap();
        let grid = of_grid(12, |x, y| {
            let (alpha, mu) = (1.7 + 0.004 * x, 0.43 + 0.004 * y);
            let arch = Arch::from_doubles(SelfWeight::Heyman, alpha, mu).unwrap();
            arch.least(12).unwrap().thickness.double
        });
        agrees(&least_thicknesses(&survey).unwrap(), grid, 1e-3);
    }

    #[test]
    fn the_mean_in_metres_is_that_of_a_grid() {
        for (circle, c) in
            [(Circle::Intrados, 1.0), (Circle::Centreline, 0.0), (Circle::Extrados, -1.0)]
        {
            let shape = Shape::Spanned {
                circle,
                span: ends(["9.98m", "10.02m"]),
                rise: ends(["2.98m", "3m"]),
                thickness: ends(["0.1m", "0.2m"]),
            };
            let survey = Survey::new(SelfWeight::Heyman, ends(["0.7", "0.7"]), shape).unwrap();
            let grid = of_grid(8, |x, y| {
                let (half, rise) = (4.99 + 0.02 * x, 2.98 + 0.02 * y);
                let (alpha, radius) =
                    (2.0 * (rise / half).atan(), (half * half + rise * rise) / (2.0 * rise));
                let arch = Arch::from_doubles(SelfWeight::Heyman, alpha, 0.7).unwrap();
                let ratio = arch.least(12).unwrap().thickness.double;
                radius * ratio / (1.0 - c * ratio / 2.0)
            });
            agrees(&least_thicknesses(&survey).unwrap(), grid, 1e-3);
        }
    }

    #[test]
    fn arches_of_two_modes_have_no_mean_here() {
        let shape = Shape::Free { half_opening: ends(["1.5", "1.53"]), thickness: None };
        let survey = Survey::new(SelfWeight::Heyman, ends(["0.34", "0.42"]), shape).unwrap();
        assert!(least_thicknesses(&survey).is_none());
    }
}
