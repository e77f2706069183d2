//! The product of two doubles with its rounding error, exactly.

use std::fmt::Debug;

/// A way to find the error of a product. All find the same, unless something overflows or the error is below the least
/// normal double.
pub trait Product: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// `a b` and its rounding error.
    fn two_product(a: f64, b: f64) -> (f64, f64);
}

/// Dekker's algorithm, of `+ - *` alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dekker;

/// A fused multiplication: quick where the machine has one, and many times slower elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fused;

/// Two halves of 26 bits whose sum is `a` (Veltkamp).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = ((1u64 << 27) + 1) as f64;
    let t = SPLITTER * a;
    let high = t - (t - a);
    (high, a - high)
}

impl Product for Dekker {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        let ((ah, al), (bh, bl)) = (split(a), split(b));
        (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
    }
}

impl Product for Fused {
    #[inline(always)]
    fn two_product(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        (product, a.mul_add(b, -product))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::Rational;

    proptest! {
        #![proptest_config(config(20_000))]

        #[test]
        fn the_error_is_exact(a in 1u64..1 << 53, b in 1u64..1 << 53, shift in -200i32..200) {
            let (a, b) = (a as f64, b as f64 * 2f64.powi(shift));
            let truth = Rational::from_f64(a).unwrap() * Rational::from_f64(b).unwrap();
            for (product, error) in [Dekker::two_product(a, b), Fused::two_product(a, b)] {
                prop_assert_eq!(product, a * b);
                let [product, error] = [product, error].map(|x| Rational::from_f64(x).unwrap());
                prop_assert_eq!(product + error, truth.clone());
            }
        }
    }
}
