//! Hard arguments for property tests, and comparisons for every number type.
#![allow(dead_code, reason = "each test file uses its part")]

pub mod certificates;

use couplet::number::{AstroInterval, Ball, Dual, Enclosure, Field};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rug::{Float, Rational};

/// The same arguments in every run, and bounded shrinking: the arguments are hard, not many.
pub fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        max_shrink_iters: 1000,
        max_shrink_time: 20_000,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..Default::default()
    }
}

/// Rationals that uniform ranges never hit: neighbours of simple fractions, and any size.
pub fn hard_rational() -> impl Strategy<Value = Rational> {
    let simple = (-20i64..20, 1i64..12).prop_map(Rational::from);
    let hair = (any::<bool>(), 1u32..90).prop_map(|(up, shift)| {
        let hair = Rational::from((1, 1)) >> shift;
        if up { hair } else { -hair }
    });
    let any_size = (any::<i64>(), -80i32..20).prop_map(|(m, e)| Rational::from(m) << e);
    prop_oneof![simple.clone(), (simple, hair).prop_map(|(x, hair)| x + hair), any_size,]
}

/// A positive rational of ordinary size, next to a simple fraction or not.
pub fn positive_rational() -> impl Strategy<Value = Rational> {
    hard_rational().prop_filter_map("positive and of ordinary size", |x| {
        let x = x.abs();
        (x > Rational::from((1, 1_000_000)) && x < 1_000_000).then_some(x)
    })
}

/// A point of the unit circle with rational coordinates, from half its tangent.
pub fn circle_point() -> impl Strategy<Value = (Rational, Rational)> {
    positive_rational().prop_map(|t| {
        let square = Rational::from(t.square_ref());
        let norm = Rational::from(1) + &square;
        (t * 2 / &norm, (Rational::from(1) - square) / norm)
    })
}

/// How a number type is made from an exact value, and when two of its values may be the same.
pub trait Sample: Field {
    /// The value, as well as the type can hold it.
    fn sample(value: &Rational) -> Self;
    /// Whether two values can be the same number; for an exact type, whether they are.
    fn agrees(&self, other: &Self) -> bool;
    /// A value that is certainly another one, at any size: `x² + 1` is at least `2 |x|`.
    fn spoiled(&self) -> Self {
        self.clone() + self.square() + self.int(1)
    }
}

/// Precision of the samples in bits.
pub const BITS: u32 = 192;

impl Sample for f64 {
    fn sample(value: &Rational) -> Self {
        value.to_f64()
    }
    fn agrees(&self, other: &Self) -> bool {
        approx::relative_eq!(*self, *other, max_relative = 1e-9, epsilon = 1e-9)
    }
}

impl Sample for Float {
    fn sample(value: &Rational) -> Self {
        Float::with_val(BITS, value)
    }
    fn agrees(&self, other: &Self) -> bool {
        let difference = Float::with_val(BITS, self - other).abs();
        let scale = Float::with_val(BITS, 1).max(&self.clone().abs());
        difference <= scale >> 100
    }
}

impl Sample for Rational {
    fn sample(value: &Rational) -> Self {
        value.clone()
    }
    fn agrees(&self, other: &Self) -> bool {
        self == other
    }
}

impl Sample for Ball {
    fn sample(value: &Rational) -> Self {
        Ball::enclosing(value, BITS)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.overlaps(other)
    }
}

impl Sample for AstroInterval {
    fn sample(value: &Rational) -> Self {
        AstroInterval::enclosing(value, BITS as usize)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.overlaps(other)
    }
}

/// The first component of the gradient is a variable, so that derivatives take part.
impl<T: Sample> Sample for Dual<T> {
    fn sample(value: &Rational) -> Self {
        Dual::variable(T::sample(value), 0)
    }
    fn agrees(&self, other: &Self) -> bool {
        self.value().agrees(other.value()) && self.derivative(0).agrees(&other.derivative(0))
    }
}
