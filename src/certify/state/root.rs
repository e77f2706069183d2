//! The root of a mode's equations, proved to exist and to be unique in a box.

use super::question::{Attempt, Doubt, Query};
use crate::arch::{Configuration, Unknown};
use crate::check::krawczyk;
use crate::number::{Ball, Dual, Enclosure, Field, Magnitude, Real};
use crate::problem::Equation;
use crate::solve::{inverse, settle};
use rug::Float;

/// As many equations as unknowns, over candidates and over balls.
pub(super) trait Equations {
    /// The residuals of candidates with `bits` bits.
    fn approximate(&self, bits: u32, x: Vec<Dual<Float>>) -> Vec<Dual<Float>>;

    /// The residuals enclosed, with `bits` bits.
    fn enclose(&self, bits: u32, x: Vec<Dual<Ball>>) -> Vec<Dual<Ball>>;

    /// Whether nothing that was divided by or cleared vanishes anywhere in a box.
    fn is_regular(&self, x: &[Ball]) -> bool;
}

/// Up to this precision one is as dear as another.
const SHORT: u32 = 512;

/// Encloses the root of equations next to a start value, proved to exist and to be unique in a box on which
/// the equations are regular.
pub(super) fn unique_root(
    equations: &impl Equations,
    bits: u32,
    start: Vec<Float>,
) -> Attempt<Vec<Ball>> {
    let candidate = climb(equations, bits, start).ok_or_else(|| doubt("no candidate is found"))?;
    let centre: Vec<Ball> = candidate.into_iter().map(|x| Ball::exact(x, bits)).collect();
    // What a slope is multiplied with is small, so that a part of its digits is enough, as a rule.
    let few = (bits / 4).max(SHORT);
    let with_few = (few < bits).then(|| {
        let constants = centre.iter().cloned().map(Dual::constant).collect();
        let residuals = values(&equations.enclose(bits, constants));
        contracted(equations, few, &centre, &slopes(equations, few, &centre), &residuals)
    });
    match with_few {
        Some(Ok(root)) => Ok(root),
        _ => {
            let at_centre = slopes(equations, bits, &centre);
            let residuals = values(&at_centre);
            contracted(equations, bits, &centre, &at_centre, &residuals).map_err(doubt)
        }
    }
}

fn doubt(question: &'static str) -> Doubt {
    Doubt { question, between: Vec::new(), gap: f64::NAN }
}

/// The doubt where there is nothing to prove.
pub(super) fn no_candidate() -> Doubt {
    doubt("no candidate is found")
}

/// Newton's method with more and more bits: at each precision it starts from the root to half of it.
fn climb(equations: &impl Equations, bits: u32, start: Vec<Float>) -> Option<Vec<Float>> {
    let halves =
        std::iter::successors(Some(bits), |bits| (*bits > SHORT).then(|| bits.div_ceil(2)));
    let precisions: Vec<u32> = halves.collect();
    let settled = |x: Vec<Float>, bits| {
        let x = x.iter().map(|x| Float::with_val(bits, x)).collect();
        settle(x, |x| equations.approximate(bits, variables(x)))
    };
    // Where the equations lose more digits than the first precision has, only the last is of use.
    let root = precisions.into_iter().rev().try_fold(start.clone(), settled);
    root.or_else(|| settled(start, bits))
}

fn values(residuals: &[Dual<Ball>]) -> Vec<Ball> {
    residuals.iter().map(|r| r.value().clone()).collect()
}

/// The equations with their slopes on a box, by numbers of `few` bits.
fn slopes(equations: &impl Equations, few: u32, x: &[Ball]) -> Vec<Dual<Ball>> {
    let coarse: Vec<Ball> = x.iter().map(|x| x.with_precision(few)).collect();
    equations.enclose(few, variables(&coarse))
}

/// The Krawczyk operator on boxes around the centre, with slopes of `few` bits.
fn contracted(
    equations: &impl Equations,
    few: u32,
    centre: &[Ball],
    at_centre: &[Dual<Ball>],
    residuals: &[Ball],
) -> Result<Vec<Ball>, &'static str> {
    let (n, bits) = (centre.len(), centre.first().map_or(few, Ball::prec));
    let entry = |r: &Dual<Ball>, k| {
        r.slope(k).map_or_else(|| Float::new(few), |s| Float::with_val(few, s.mid()))
    };
    let jacobian = at_centre.iter().map(|r| (0..n).map(|k| entry(r, k)).collect()).collect();
    let preconditioner: Vec<Vec<Ball>> = inverse(jacobian)
        .ok_or("the Jacobian is singular")?
        .into_iter()
        .map(|row| row.into_iter().map(|y| Ball::exact(y, few)).collect())
        .collect();
    // A box several times as wide as the correction that the residuals ask for.
    let radius = |(row, x): (&Vec<Ball>, &Ball)| {
        let terms = row.iter().zip(residuals).map(|(y, r)| y.clone() * r);
        let size =
            terms.fold(Magnitude::ZERO, |sum, t| sum.plus(Magnitude::upper(t.mid())).plus(t.rad()));
        size.plus(Magnitude::upper(x.mid()).shifted(-i64::from(bits)))
    };
    let radii: Vec<Magnitude> = preconditioner.iter().zip(centre).map(radius).collect();
    for inflation in [2, 8, 20] {
        let widened = |(x, r): (&Ball, &Magnitude)| x.clone().widened(r.shifted(inflation));
        let domain: Vec<Ball> = centre.iter().zip(&radii).map(widened).collect();
        if !equations.is_regular(&domain) {
            continue;
        }
        let slopes = slopes(equations, few, &domain);
        let image = krawczyk::image(centre, residuals, &slopes, &preconditioner, &domain);
        if krawczyk::is_contracted(&image, &domain) {
            return Ok(image);
        }
    }
    Err("no box around the candidate is mapped into itself")
}

/// Each value as an unknown.
fn variables<T: Field>(x: &[T]) -> Vec<Dual<T>> {
    x.iter().enumerate().map(|(index, x)| Dual::variable(x.clone(), index)).collect()
}

/// The printed equations of a mode.
struct Printed<'a> {
    query: &'a Query,
    unknowns: &'a [Unknown],
    equations: &'a [Equation],
}

impl Printed<'_> {
    fn place<T: Real>(&self, given: Configuration<T>, x: Vec<T>) -> Configuration<T> {
        self.unknowns.iter().zip(x).fold(given, |at, (&unknown, x)| at.with(unknown, x))
    }

    fn residuals<T: Real>(&self, given: Configuration<T>, x: Vec<Dual<T>>) -> Vec<Dual<T>> {
        let at = self.place(given.map(Dual::constant), x);
        self.equations.iter().map(|equation| equation.residual(self.query.weight, &at)).collect()
    }
}

impl Equations for Printed<'_> {
    fn approximate(&self, bits: u32, x: Vec<Dual<Float>>) -> Vec<Dual<Float>> {
        self.residuals(self.query.given.clone().map(|x| Float::with_val(bits, x.mid())), x)
    }

    fn enclose(&self, bits: u32, x: Vec<Dual<Ball>>) -> Vec<Dual<Ball>> {
        self.residuals(self.query.given.clone().map(|x| x.with_precision(bits)), x)
    }

    fn is_regular(&self, x: &[Ball]) -> bool {
        let at = self.place(self.query.given.clone(), x.to_vec());
        self.equations
            .iter()
            .filter_map(|equation| equation.denominator(self.query.weight, &at))
            .all(|denominator| denominator.excludes_zero())
    }
}

impl Query {
    /// The root of a system next to a start value, proved to exist and to be unique in a box.
    pub(super) fn root(
        &self,
        (unknowns, equations): (&[Unknown], &[Equation]),
        start: &[Float],
    ) -> Attempt<Configuration<Ball>> {
        let printed = Printed { query: self, unknowns, equations };
        let root = unique_root(&printed, self.bits, start.to_vec())?;
        Ok(printed.place(self.given.clone(), root))
    }
}
