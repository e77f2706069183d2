//! A root from a start in doubles: candidates for the witnesses of a certificate, of which nothing is certain.

use crate::rounding::BITS;
use couplet_check::arch::Configuration;
use couplet_check::problem::Problem;
use couplet_number::number::{DoubleDouble, DoubleDoubleBall, Dual};
use couplet_solve::{inverse, newton_step};

/// Newton steps: a start good to five digits needs three.
const STEPS: usize = 6;

/// Where a root seems to be, and an approximate inverse of the Jacobian there, row by row.
pub(crate) struct Candidate {
    pub(crate) root: Vec<DoubleDouble>,
    pub(crate) inverse: Vec<Vec<f64>>,
    /// What is known of the problem at the root.
    pub(crate) at: Configuration<DoubleDoubleBall>,
}

/// Newton's method from a start; `None` where it meets a singular matrix, or leaves the doubles.
pub(crate) fn candidate(problem: &Problem, start: &[f64]) -> Option<Candidate> {
    let (system, given) = (problem.system(), problem.given::<DoubleDoubleBall>(BITS));
    let place = |root: &[DoubleDouble]| {
        let values: Vec<_> = root.iter().map(|x| DoubleDoubleBall::exact(*x)).collect();
        system.place(given.clone(), &values)
    };
    let mut root: Vec<DoubleDouble> = start.iter().map(|x| DoubleDouble::exact(*x)).collect();
    let mut residuals = Vec::new();
    for _ in 0..STEPS {
        // As doubles they are small and to all digits.
        let at_root = system.residuals(&system.variables(&place(&root)));
        let slope = |r: &Dual<DoubleDoubleBall>, k| r.derivative(k).mid().hi();
        let slopes = |r| (0..root.len()).map(|k| slope(r, k)).collect();
        residuals = at_root.iter().map(|r| Dual::new(r.value().mid().hi(), slopes(r))).collect();
        let steps = newton_step(&residuals)?;
        root.iter_mut().zip(steps).for_each(|(x, step)| *x = *x - DoubleDouble::exact(step));
    }
    let row = |r: &Dual<f64>| (0..root.len()).map(|k| r.derivative(k)).collect();
    let inverse = inverse(residuals.iter().map(row).collect())?;
    let is_finite = root.iter().all(|x| x.hi().is_finite());
    is_finite.then(|| Candidate { inverse, at: place(&root), root })
}
