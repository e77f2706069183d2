//! Small, sparse systems of linear equations by Gauss–Jordan elimination with partial pivoting, in the
//! numbers and at the precision of their entries. Zeros are not computed with.

use crate::number::{Dual, Field};
use std::cmp::Ordering;

/// A number with a size, so that a pivot and a last step can be chosen.
pub trait Approximate: Field + PartialOrd {
    /// The exponent of its size in base two; very small for zero.
    fn exponent(&self) -> i64;

    /// The bits of the number.
    fn bits(&self) -> u32;
}

/// Several quotients by a number of more bits take longer than products with its reciprocal.
const LONG: u32 = 2_000;

impl Approximate for f64 {
    fn exponent(&self) -> i64 {
        if *self == 0.0 { i64::MIN } else { self.abs().log2().floor() as i64 }
    }

    fn bits(&self) -> u32 {
        Self::MANTISSA_DIGITS
    }
}

/// The approximate inverse of a square matrix. `None` where no pivot is left.
pub fn inverse<T: Approximate>(mut matrix: Vec<Vec<T>>) -> Option<Vec<Vec<T>>> {
    let n = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        let one = row.first()?.int(1);
        row.extend((0..n).map(|j| one.int(i32::from(i == j))));
    }
    eliminate(matrix)
}

/// The approximate inverse of a small square matrix of doubles, without a heap. `None` where no pivot is left.
pub fn invert<const N: usize>(mut matrix: [[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut inverse = [[0.0; N]; N];
    inverse.iter_mut().enumerate().for_each(|(i, row)| row[i] = 1.0);
    for column in 0..N {
        let size = |row: usize, matrix: &[[f64; N]; N]| matrix[row][column].abs();
        let larger = |a, b| if size(b, &matrix) > size(a, &matrix) { b } else { a };
        let pivot = (column..N).reduce(larger)?;
        matrix.swap(column, pivot);
        inverse.swap(column, pivot);
        let head = 1.0 / matrix[column][column];
        if !head.is_finite() {
            return None;
        }
        let (pivot_row, pivot_inverse) =
            (matrix[column].map(|x| x * head), inverse[column].map(|x| x * head));
        for row in 0..N {
            let factor = matrix[row][column];
            for k in 0..N {
                matrix[row][k] -= factor * pivot_row[k];
                inverse[row][k] -= factor * pivot_inverse[k];
            }
        }
        (matrix[column], inverse[column]) = (pivot_row, pivot_inverse);
    }
    Some(inverse)
}

/// The step of Newton's method, the inverse of the Jacobian times the residuals. `None` where no pivot is left.
pub fn newton_step<T: Approximate>(residuals: &[Dual<T>]) -> Option<Vec<T>> {
    let row = |r: &Dual<T>| {
        let slopes = (0..residuals.len()).map(|k| r.derivative(k));
        slopes.chain([r.value().clone()]).collect()
    };
    let solved = eliminate(residuals.iter().map(row).collect())?;
    Some(solved.into_iter().flatten().collect())
}

/// Matrix to the right of a square one when that has become the identity.
fn eliminate<T: Approximate>(mut rows: Vec<Vec<T>>) -> Option<Vec<Vec<T>>> {
    let n = rows.len();
    let is_zero = |x: &T| x.exponent() == i64::MIN;
    let size = |x: &T| if *x < x.int(0) { -x.clone() } else { x.clone() };
    for column in 0..n {
        let pivots = (column..n).filter(|&row| !is_zero(&rows[row][column]));
        let pivot = pivots.max_by(|&a, &b| {
            size(&rows[a][column]).partial_cmp(&size(&rows[b][column])).unwrap_or(Ordering::Equal)
        })?;
        rows.swap(column, pivot);
        let head = rows[column][column].clone();
        let pivot_row = std::mem::take(&mut rows[column]).into_iter();
        let reciprocal = (head.bits() > LONG).then(|| head.int(1) / &head);
        let over_head = |x: T| match &reciprocal {
            Some(reciprocal) => x * reciprocal,
            None => x / &head,
        };
        let pivot_row: Vec<T> =
            pivot_row.map(|x| if is_zero(&x) { x } else { over_head(x) }).collect();
        for row in rows.iter_mut().filter(|row| !row.is_empty()) {
            let zero = head.int(0);
            let factor = std::mem::replace(&mut row[column], zero);
            if is_zero(&factor) {
                continue;
            }
            let entries = std::mem::take(row).into_iter().zip(&pivot_row).enumerate();
            *row = entries
                .map(|(place, (x, y))| match place == column || is_zero(y) {
                    true => x,
                    false => x - factor.clone() * y,
                })
                .collect();
        }
        rows[column] = pivot_row;
    }
    Some(rows.into_iter().map(|row| row.into_iter().skip(n).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Float;

    fn matrix(rows: &[&[i32]]) -> Vec<Vec<Float>> {
        rows.iter().map(|row| row.iter().map(|&x| Float::with_val(80, x)).collect()).collect()
    }

    #[test]
    fn the_inverse_undoes_the_matrix() {
        let a = matrix(&[&[0, 2, 1], &[3, 0, 0], &[1, 0, 5]]);
        let b = inverse(a.clone()).unwrap();
        for (i, row) in a.iter().enumerate() {
            for j in 0..3 {
                let products = row.iter().zip(&b).map(|(x, column)| x.clone() * &column[j]);
                let entry = products.fold(Float::with_val(80, 0), |sum, product| sum + product);
                let expected = f64::from(u8::from(i == j));
                approx::assert_abs_diff_eq!(entry.to_f64(), expected, epsilon = 1e-20);
            }
        }
    }

    #[test]
    fn a_matrix_of_doubles_times_its_inverse_is_one() {
        let found = inverse(vec![vec![0.0, 2.0], vec![4.0, 1.0]]).unwrap();
        assert_eq!(found, [[-0.125, 0.25], [0.5, 0.0]]);
        assert!(inverse(vec![vec![1.0, 2.0], vec![2.0, 4.0]]).is_none());
    }

    #[test]
    fn a_singular_matrix_has_none() {
        assert!(inverse(matrix(&[&[1, 2], &[2, 4]])).is_none());
    }
}
