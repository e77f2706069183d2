//! Products of vectors of three numbers: forces `(h, p, v)`, rows of conditions on them, motions.

use crate::number::DoubleBall;

pub(super) type Vector = [DoubleBall; 3];

pub(super) fn dot(a: &Vector, b: &Vector) -> DoubleBall {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
