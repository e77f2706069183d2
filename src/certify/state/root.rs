//! The root of a mode's equations, proved to exist and to be unique in a box.

use super::question::{Attempt, Doubt, Query};
use crate::arch::{Configuration, Equation, Unknown};
use crate::check::krawczyk;
use crate::number::{Ball, Dual, Enclosure, Magnitude};
use crate::solve::{inverse, polish};
use rug::Float;

impl Query {
    /// The root of a system next to a start value, proved to exist and to be unique in a box.
    pub(super) fn root(
        &self,
        (unknowns, equations): (&[Unknown], &[Equation]),
        start: &[Float],
    ) -> Attempt<Configuration<Ball>> {
        let mid = |x: Ball| Float::with_val(self.bits, x.mid());
        let given = self.given.clone().map(mid);
        let candidate = polish(self.weight, (unknowns, equations), &given, start);
        let place = |values: &[Ball]| {
            unknowns
                .iter()
                .zip(values)
                .fold(self.given.clone(), |at, (&u, x)| at.with(u, x.clone()))
        };
        let slopes = |values: &[Ball]| -> Vec<Dual<Ball>> {
            let given = self.given.clone().map(Dual::constant);
            let at =
                unknowns.iter().zip(values).enumerate().fold(given, |at, (index, (&u, x))| {
                    at.with(u, Dual::variable(x.clone(), index))
                });
            equations.iter().map(|e| e.residual(self.weight, &at)).collect()
        };
        let is_regular = |values: &[Ball]| {
            let placed = place(values);
            equations
                .iter()
                .filter_map(|e| e.denominator(self.weight, &placed))
                .all(|d| d.excludes_zero())
        };
        unique_root(self.bits, candidate, slopes, is_regular).map(|root| place(&root))
    }
}

/// Encloses the root of equations next to a candidate, proved to exist and to be unique in a box on which
/// the equations are regular. `slopes` gives the equations with their derivatives to the unknowns.
pub(super) fn unique_root(
    bits: u32,
    candidate: Option<Vec<Float>>,
    slopes: impl Fn(&[Ball]) -> Vec<Dual<Ball>>,
    is_regular: impl Fn(&[Ball]) -> bool,
) -> Attempt<Vec<Ball>> {
    let doubt = |question| Doubt { question, between: Vec::new(), gap: f64::NAN };
    let candidate = candidate.ok_or_else(|| doubt("no candidate is found"))?;
    let n = candidate.len();
    let exact = |x: &Float| Ball::exact(x.clone(), bits);
    let centre: Vec<Ball> = candidate.iter().map(exact).collect();
    let at_centre = slopes(&centre);
    let residuals: Vec<Ball> = at_centre.iter().map(|r| r.value().clone()).collect();
    let entry = |r: &Dual<Ball>, k| {
        r.slope(k).map_or_else(|| Float::new(bits), |s| Float::with_val(bits, s.mid()))
    };
    let jacobian = at_centre.iter().map(|r| (0..n).map(|k| entry(r, k)).collect()).collect();
    let preconditioner: Vec<Vec<Ball>> = inverse(jacobian)
        .ok_or_else(|| doubt("the Jacobian is singular"))?
        .iter()
        .map(|row| row.iter().map(exact).collect())
        .collect();
    // A box several times as wide as the correction that the residuals ask for.
    let radius = |(row, x): (&Vec<Ball>, &Ball)| {
        let terms = row.iter().zip(&residuals).map(|(y, r)| y.clone() * r);
        let size =
            terms.fold(Magnitude::ZERO, |sum, t| sum.plus(Magnitude::upper(t.mid())).plus(t.rad()));
        size.plus(Magnitude::upper(x.mid()).shifted(-i64::from(bits)))
    };
    let radii: Vec<Magnitude> = preconditioner.iter().zip(&centre).map(radius).collect();
    for inflation in [2, 8, 20] {
        let domain: Vec<Ball> = centre
            .iter()
            .zip(&radii)
            .map(|(x, r)| x.clone().widened(r.shifted(inflation)))
            .collect();
        if !is_regular(&domain) {
            continue;
        }
        let image =
            krawczyk::image(&centre, &residuals, &slopes(&domain), &preconditioner, &domain);
        if krawczyk::is_contracted(&image, &domain) {
            return Ok(image);
        }
    }
    Err(doubt("no box around the candidate is mapped into itself"))
}
