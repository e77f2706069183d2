//! Double-doubles: the unevaluated sum of two doubles, about 106 bits.
//!
//! Every operation here is a published algorithm with a proved bound of its relative error, in which
//! `u = 2^-53`; none exceeds [`UNIT`](DoubleDouble::UNIT) `= 16 u²`:
//!
//! | operation | algorithm | relative error |
//! |---|---|---|
//! | sum, difference | AccurateDWPlusDW (6) | `3u² + 13u³` |
//! | product | DWTimesDW1 (10) | `7u²` |
//! | quotient | DWDivDW2 (17), with DWTimesFP1 (7) | `15u² + 56u³` |
//! | square root | SQRTDWtoDW | `25/8 u²` |
//!
//! (Joldes, Muller, Popescu, *Tight and rigorous error bounds for basic building blocks of double-word
//! arithmetic*, ACM TOMS 44, 2017, where the numbers are those of the algorithms; the root: Lefèvre, Louvet,
//! Muller, Picot, Rideau, *Accurate calculation of Euclidean norms using double-word arithmetic*, ACM TOMS 49,
//! 2023.) The bounds hold while nothing overflows or underflows; within `2^±220` nothing does.
//!
//! **Results do not depend on a fused multiplication.** The error of a product is exact, whichever [`Product`] finds
//! it; Rust never fuses by itself, and rounds each operation to nearest as IEEE 754 says.

use super::Field;
use super::product::{Dekker, Product};
use std::marker::PhantomData;

/// The sum `hi + lo`, where `hi` is the double nearest to it; the errors of its products are found by `P`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDoubleBy<P> {
    hi: f64,
    lo: f64,
    product: PhantomData<P>,
}

/// The sum of two doubles, in operations that every machine has.
pub type DoubleDouble = DoubleDoubleBy<Dekker>;

/// `a + b` and its rounding error, exactly (Knuth's TwoSum).
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let t = sum - a;
    (sum, (a - (sum - t)) + (b - t))
}

/// Sum of two doubles and its rounding error, for `|a| >= |b|` or `a = 0` (Dekker's Fast2Sum).
#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

impl<P: Product> DoubleDoubleBy<P> {
    /// Zero.
    pub const ZERO: Self = Self::constant(0.0, 0.0);

    /// Above the relative error of every operation: `2^-102`.
    pub const UNIT: f64 = 1.0 / (1u128 << 102) as f64;

    /// A constant from its two parts, of which the second is at most half a unit in the last place of the first.
    #[inline(always)]
    pub(super) const fn constant(hi: f64, lo: f64) -> Self {
        Self { hi, lo, product: PhantomData }
    }

    /// The double `x`.
    #[inline(always)]
    pub const fn exact(x: f64) -> Self {
        Self::constant(x, 0.0)
    }

    /// `a + b`, exactly.
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self::constant(hi, lo)
    }

    /// The double nearest to it.
    #[inline(always)]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// Rest that the nearest double leaves: at most half a unit in its last place.
    #[inline(always)]
    pub const fn lo(self) -> f64 {
        self.lo
    }

    /// The square root; NaN below zero.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return Self::ZERO;
        }
        let root = self.hi.sqrt();
        let (square, error) = P::two_product(root, root);
        // What a root leaves is a double (Lefèvre and others, section 4), so that both differences are exact.
        let rest = ((self.hi - square) - error) + self.lo;
        let (hi, lo) = quick_two_sum(root, rest / (2.0 * root));
        Self::constant(hi, lo)
    }
}

impl<P: Product> From<f64> for DoubleDoubleBy<P> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self::exact(x)
    }
}

impl<P: Product> Field for DoubleDoubleBy<P> {
    #[inline(always)]
    fn int(&self, n: i32) -> Self {
        Self::exact(f64::from(n))
    }
}

impl<P: Product> DoubleDoubleBy<P> {
    #[inline(always)]
    fn negated(self) -> Self {
        Self::constant(-self.hi, -self.lo)
    }

    #[inline(always)]
    fn plus(self, other: &Self) -> Self {
        let (high, error) = two_sum(self.hi, other.hi);
        let (low, last) = two_sum(self.lo, other.lo);
        let (high, low) = quick_two_sum(high, error + low);
        let (hi, lo) = quick_two_sum(high, last + low);
        Self::constant(hi, lo)
    }

    #[inline(always)]
    fn minus(self, other: &Self) -> Self {
        self + -*other
    }

    #[inline(always)]
    fn times(self, other: &Self) -> Self {
        let (high, error) = P::two_product(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(high, error + (self.hi * other.lo + self.lo * other.hi));
        Self::constant(hi, lo)
    }

    #[inline(always)]
    fn over(self, other: &Self) -> Self {
        let quotient = self.hi / other.hi;
        // DWTimesFP1: the divisor times the first quotient.
        let (high, error) = P::two_product(other.hi, quotient);
        let (high, low) = quick_two_sum(high, other.lo * quotient);
        let (high, low) = quick_two_sum(high, low + error);
        let rest = (self.hi - high) + (self.lo - low);
        let (hi, lo) = quick_two_sum(quotient, rest / other.hi);
        Self::constant(hi, lo)
    }
}

operators!([P: Product] DoubleDoubleBy<P>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Fused;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::{Float, Rational};

    /// Mantissas that carry, cancel and tie, exponents spread, low parts of every size.
    fn hard() -> impl Strategy<Value = DoubleDouble> {
        let mantissa = || {
            prop_oneof![Just(0u64), Just(1), Just((1 << 52) - 1), Just((1 << 52) - 2), any::<u64>()]
                .prop_map(|m| f64::from_bits(1023 << 52 | m & ((1 << 52) - 1)))
        };
        let near = -3i32..3;
        let exponent = prop_oneof![near, -100i32..100];
        let below = prop_oneof![Just(0), Just(1), 0i32..60, 60i32..500];
        (mantissa(), exponent, mantissa(), below, -1i32..=1, any::<bool>()).prop_map(
            |(high, exponent, low, below, sign, minus)| {
                let hi = high * 2f64.powi(exponent);
                let lo = f64::from(sign) * low * 2f64.powi(exponent - 53 - below);
                let x = DoubleDouble::sum(hi, lo);
                if minus { -x } else { x }
            },
        )
    }

    fn value(x: DoubleDouble) -> Rational {
        let part = |x: f64| Rational::from_f64(x).unwrap();
        part(x.hi) + part(x.lo)
    }

    /// Tells whether `found` is within `units` of `u²`, and as many of `8 u³`, of `truth`, relative to it.
    fn is_within(found: DoubleDouble, truth: &Rational, units: (u32, u32)) -> bool {
        let error = Rational::from(&value(found) - truth).abs();
        let bound = (Rational::from(units) >> 106u32) + (Rational::from(8 * units.0) >> 159u32);
        let normal = found.lo.abs() <= found.hi.abs() / 2f64.powi(53);
        normal && error <= bound * truth.clone().abs()
    }

    proptest! {
        #![proptest_config(config(20_000))]

        #[test]
        fn each_operation_keeps_its_bound(a in hard(), b in hard()) {
            let (x, y) = (value(a), value(b));
            prop_assert!(is_within(a + b, &Rational::from(&x + &y), (3, 1)));
            prop_assert!(is_within(a - b, &Rational::from(&x - &y), (3, 1)));
            prop_assert!(is_within(a * b, &Rational::from(&x * &y), (7, 1)));
            prop_assert!(is_within(a / b, &Rational::from(&x / &y), (15, 1)));
            let root = DoubleDouble::constant(a.hi.abs(), a.lo * a.hi.signum()).sqrt();
            let truth = Float::with_val(400, x.abs()).sqrt().to_rational().unwrap();
            prop_assert!(is_within(root, &truth, (25, 8)));
            for found in [a + b, a * b, a / b] {
                prop_assert!(found.hi == 0.0 || !is_within(found + DoubleDouble::exact(found.hi * 1e-30), &value(found), (7, 1)));
            }
        }

        #[test]
        fn a_sum_of_two_doubles_is_exact(a in hard(), b in hard()) {
            let sum = DoubleDouble::sum(a.hi, b.hi);
            prop_assert_eq!(value(sum), value(DoubleDouble::exact(a.hi)) + value(DoubleDouble::exact(b.hi)));
        }

        /// Whatever finds the error of a product, nothing else is found.
        #[test]
        fn a_fused_multiplication_finds_the_same(a in hard(), b in hard()) {
            let fused = |x: DoubleDouble| DoubleDoubleBy::<Fused>::constant(x.hi, x.lo);
            let (x, y) = (fused(a), fused(b));
            prop_assert_eq!(x * y, fused(a * b));
            prop_assert_eq!(x / y, fused(a / b));
            let [root, by_fused] = [a.sqrt().hi, x.sqrt().hi].map(f64::to_bits);
            prop_assert_eq!(root, by_fused);
        }
    }

    #[test]
    fn zero_has_a_root_and_what_is_below_has_none() {
        assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
        assert!(DoubleDouble::exact(-1.0).sqrt().hi().is_nan());
    }
}
