//! Approximate inverses of small, sparse matrices.

use rug::Float;

/// The inverse of a square matrix by Gauss–Jordan elimination with partial pivoting, at the
/// precision of its entries; zeros are not computed with. `None` where no pivot is left.
pub fn inverse(mut matrix: Vec<Vec<Float>>) -> Option<Vec<Vec<Float>>> {
    let n = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        let prec = row.first()?.prec();
        row.extend((0..n).map(|j| Float::with_val(prec, u32::from(i == j))));
    }
    for column in 0..n {
        let pivot =
            (column..n).filter(|&row| matrix[row][column].is_normal()).max_by(|&a, &b| {
                let size = |row: usize| matrix[row][column].as_abs();
                size(a).total_cmp(&size(b))
            })?;
        matrix.swap(column, pivot);
        let mut pivot_row = matrix[column].clone();
        let head = pivot_row[column].clone();
        pivot_row.iter_mut().filter(|x| !x.is_zero()).for_each(|x| *x /= &head);
        for (index, row) in matrix.iter_mut().enumerate() {
            let factor = row[column].clone();
            if index == column || factor.is_zero() {
                continue;
            }
            for (x, y) in row.iter_mut().zip(&pivot_row).filter(|(_, y)| !y.is_zero()) {
                *x -= factor.clone() * y;
            }
            row[column] = Float::with_val(factor.prec(), 0);
        }
        matrix[column] = pivot_row;
    }
    Some(matrix.into_iter().map(|row| row.into_iter().skip(n).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn a_singular_matrix_has_none() {
        assert!(inverse(matrix(&[&[1, 2], &[2, 4]])).is_none());
    }
}
