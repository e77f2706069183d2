//! A root from a start in doubles: candidates for the witnesses of a certificate, of which nothing is certain.

use couplet_check::problem::Problem;
use couplet_number::number::{DoubleDouble, DoubleDoubleBall, Dual, Dyadic};

/// Newton steps: a start good to five digits needs three.
const STEPS: usize = 6;
/// The bits of the numbers in which they are made.
const BITS: u32 = 106;

/// Where a root seems to be, and an approximate inverse of the Jacobian there, row by row.
pub(crate) struct Candidate {
    pub(crate) root: Vec<DoubleDouble>,
    pub(crate) inverse: Vec<Vec<f64>>,
    /// What is known of the problem at the root.
    pub(crate) at: couplet_check::arch::Configuration<DoubleDoubleBall>,
}

/// Newton's method from a start; `None` where it meets a singular matrix, or leaves the doubles.
pub(crate) fn candidate(problem: &Problem, start: &[f64]) -> Option<Candidate> {
    let system = problem.system();
    let given = problem.given::<DoubleDoubleBall>(BITS);
    let mut root: Vec<DoubleDouble> = start.iter().map(|x| DoubleDouble::exact(*x)).collect();
    let place = |root: &[DoubleDouble]| {
        let values: Vec<_> = root.iter().map(|x| DoubleDoubleBall::exact(*x)).collect();
        system.place(given.clone(), &values)
    };
    let mut inverse = Vec::new();
    for _ in 0..STEPS {
        let residuals: Vec<Dual<DoubleDoubleBall>> =
            system.residuals(&system.variables(&place(&root)));
        let row = |residual: &Dual<DoubleDoubleBall>| {
            (0..root.len()).map(|k| residual.derivative(k).mid().hi()).collect()
        };
        inverse = inverted(residuals.iter().map(row).collect())?;
        let step = |row: &Vec<f64>| -> f64 {
            row.iter().zip(&residuals).map(|(x, residual)| x * residual.value().mid().hi()).sum()
        };
        let steps: Vec<f64> = inverse.iter().map(step).collect();
        root.iter_mut().zip(&steps).for_each(|(x, step)| *x = *x - DoubleDouble::exact(*step));
    }
    let is_finite = root.iter().all(|x| x.hi().is_finite());
    let at = place(&root);
    is_finite.then_some(Candidate { root, inverse, at })
}

/// The inverse of a square matrix, by elimination with the largest pivot of a column.
fn inverted(mut a: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = a.len();
    for (k, row) in a.iter_mut().enumerate() {
        row.extend((0..n).map(|j| f64::from(u8::from(j == k))));
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
        a.swap(k, pivot);
        let by = a[k][k];
        if !by.is_normal() {
            return None;
        }
        a[k].iter_mut().for_each(|x| *x /= by);
        let pivot = a[k].clone();
        for row in a.iter_mut().enumerate().filter(|(i, _)| *i != k).map(|(_, row)| row) {
            let factor = row[k];
            row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= factor * y);
        }
    }
    Some(a.into_iter().map(|row| row[n..].to_vec()).collect())
}

/// A number whose two parts are in the range of doubles, to 110 bits.
pub(crate) fn dyadic(x: DoubleDouble) -> Dyadic {
    if x.hi() == 0.0 {
        return Dyadic::new(false, Vec::new(), 0);
    }
    let exponent = x.hi().abs().log2().floor() as i32 - 110;
    let part = |x: f64| (x * (-exponent as f64).exp2()).round() as i128;
    let mantissa = part(x.hi()) + part(x.lo());
    let size = mantissa.unsigned_abs();
    let zeros = size.trailing_zeros() % 128;
    let size = size >> zeros;
    Dyadic::new(mantissa < 0, vec![size as u64, (size >> 64) as u64], exponent + zeros as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_double_is_written_exactly() {
        assert_eq!(dyadic(DoubleDouble::exact(0.75)).to_string(), "0x3p-2");
        assert_eq!(dyadic(DoubleDouble::exact(-1.0)).to_string(), "-0x1p0");
        assert_eq!(
            dyadic(DoubleDouble::sum(1.0, (-80f64).exp2())).to_string(),
            "0x100000000000000000001p-80"
        );
        assert_eq!(dyadic(DoubleDouble::ZERO).to_string(), "0x0p0");
    }

    #[test]
    fn a_matrix_times_its_inverse_is_one() {
        let found = inverted(vec![vec![0.0, 2.0], vec![4.0, 1.0]]).unwrap();
        assert_eq!(found, [[-0.125, 0.25], [0.5, 0.0]]);
        assert!(inverted(vec![vec![1.0, 2.0], vec![2.0, 4.0]]).is_none());
    }
}
