//! Probable course of the curve, in doubles. Nothing here proves anything.

use super::form::CurveForm;
use crate::number::{Ball, Dual};
use crate::solve::{inverse, newton_step};

/// A point of a curve in doubles, with its slopes to the parameter.
#[derive(Clone, Debug)]
pub(super) struct CurvePoint {
    pub s: f64,
    pub x: Vec<f64>,
    pub slopes: Vec<f64>,
}

/// The residuals with their slopes to the unknowns and, last, to the parameter.
fn residuals(form: &CurveForm, s: f64, x: &[f64]) -> Vec<Dual<f64>> {
    let number = |given: &Ball| Dual::constant(given.mid().to_f64());
    form.residuals(&number, &Dual::variable(s, x.len()), &Dual::variables(x))
}

/// An approximate inverse of the Jacobian at a point; `None` if it is singular.
pub(super) fn preconditioner(form: &CurveForm, s: f64, x: &[f64]) -> Option<Vec<Vec<f64>>> {
    let rows = residuals(form, s, x);
    inverse(rows.iter().map(|r| (0..x.len()).map(|k| r.derivative(k)).collect()).collect())
}

/// Steps of Newton's method; quadratic as it is, few are needed.
const STEPS: usize = 30;

/// Newton's method from a start; `None` if it leaves the numbers or does not settle.
pub(super) fn point(form: &CurveForm, s: f64, mut x: Vec<f64>) -> Option<CurvePoint> {
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let steps = newton_step(&residuals(form, s, &x))?;
        let size = steps.iter().map(|step| step.abs()).fold(0.0, f64::max);
        if !size.is_finite() {
            return None;
        }
        x.iter_mut().zip(steps).for_each(|(x, step)| *x -= step);
        // Short steps that no longer get shorter are rounding.
        if size == 0.0 || (size < 1e-9 && size >= last / 2.0) {
            let inverse = preconditioner(form, s, &x)?;
            let by_parameter: Vec<f64> =
                residuals(form, s, &x).iter().map(|r| r.derivative(x.len())).collect();
            let slope =
                |row: &Vec<f64>| -row.iter().zip(&by_parameter).map(|(y, f)| y * f).sum::<f64>();
            let slopes: Vec<f64> = inverse.iter().map(slope).collect();
            let is_finite = slopes.iter().all(|slope| slope.is_finite());
            return is_finite.then_some(CurvePoint { s, x, slopes });
        }
        last = size;
    }
    None
}
