//! `num_complex::Complex<f64>`: the closed forms (9)–(11) as they are printed, in doubles.

use crate::number::Field;
use num_complex::Complex;

impl Field for Complex<f64> {
    fn int(&self, n: i32) -> Self {
        Self::from(f64::from(n))
    }
}
