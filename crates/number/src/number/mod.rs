//! Arithmetic: the traits every equation is written against, and the numbers that implement them.
//!
//! | type | what it is | traits |
//! |---|---|---|
//! | [`f64`] | a quick look | [`Field`], [`Real`] |
//! | [`DoubleDouble`] | the sum of two doubles, each operation with a proved bound of its error | [`Field`] |
//! | [`TripleWord`] | floating point of three machine words | [`Field`] |
//! | [`FloatBall`]: [`DoubleBall`], [`DoubleDoubleBall`], [`TripleWordBall`] | one of these and a radius: quick enclosures | [`Field`], [`Real`], [`Enclosure`] |
//! | [`rug::Float`] | MPFR, round to nearest: candidates | [`Field`], [`Real`] |
//! | [`Ball`] | MPFR midpoint and radius: enclosures | [`Field`], [`Real`], [`Enclosure`] |
//! | [`Complex`], [`ComplexBall`] | a pair: the closed forms with complex roots | [`Field`] |
//! | [`AstroInterval`] | two astro-float ends, rounded outward: the second arithmetic | [`Field`], [`Real`], [`Enclosure`] |
//! | [`rug::Rational`] | exact | [`Field`] |
//! | [`Surd`] | `a + b√d`, exact | [`Field`] |
//! | [`symbolic::Fraction`](crate::symbolic::Fraction) | a formula, exact | [`Field`] |
//! | [`symbolic::Known`](crate::symbolic::Known) | exact as long as it can be, a ball from there on | [`Real`] |
//! | [`Dual`] | a value and its gradient | as its component, up to [`Real`] |
//! | [`Gradient`] | the same without a heap | as its component, up to [`Real`] |
//! | [`Jet`] | the first terms of a Taylor series | as its component, up to [`Real`] |
//!
//! Precision travels inside a value: `x.int(3)` is a three "like `x`", so an equation needs no
//! context argument. **Comparisons live in [`Enclosure`] and nowhere else**, so an equation, which
//! asks for a [`Field`] or a [`Real`], cannot branch.

/// The operators of a number from its `plus`, `minus`, `times`, `over` and `negated`; a right-hand side may be owned.
#[doc(hidden)]
#[macro_export]
macro_rules! operators {
    (@ [$($generics:tt)*] $type:ty, $op:ident, $method:ident, $does:ident) => {
        impl<$($generics)*> std::ops::$op<&$type> for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: &Self) -> Self {
                self.$does(other)
            }
        }

        impl<$($generics)*> std::ops::$op for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.$does(&other)
            }
        }
    };
    ([$($generics:tt)*] $type:ty) => {
        $crate::operators!(@ [$($generics)*] $type, Add, add, plus);
        $crate::operators!(@ [$($generics)*] $type, Sub, sub, minus);
        $crate::operators!(@ [$($generics)*] $type, Mul, mul, times);
        $crate::operators!(@ [$($generics)*] $type, Div, div, over);

        impl<$($generics)*> std::ops::Neg for $type {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.negated()
            }
        }
    };
    ($type:ty) => {
        $crate::operators!([] $type);
    };
}

/// Operators with a reference on the left, of a number that has those of values.
#[cfg(feature = "mpfr")]
macro_rules! references {
    ($type:ty: $($op:ident $method:ident: $($right:ty),+;)+) => {$($(
        impl std::ops::$op<$right> for &$type {
            type Output = $type;
            fn $method(self, other: $right) -> $type {
                std::ops::$op::$method(self.clone(), other)
            }
        }
    )+)+};
}

mod angle;
mod as_text;
mod astro;
mod decimal;
mod derivatives;
mod digits;
mod double;
mod double_ball;
mod double_double;
mod double_double_ball;
mod double_sine;
mod double_sine_table;
mod drawable;
mod dual;
mod dyadic;
mod engine;
mod exact;
mod float_ball;
#[cfg(feature = "mpfr")]
mod gmp;
mod gradient;
mod halving;
mod interval;
mod jet;
mod product;
mod range;
mod says;
mod shown;
mod spelt;
mod stumpff;
mod tens;
mod ternary;
mod unit;
mod worded;
mod written;

pub use crate::{as_text, list, operators, says, shown_as_text, worded};
pub use angle::Angle;
pub use astro::{Astro, RoundingMode};
#[cfg(feature = "mpfr")]
pub use decimal::power_of_ten;
pub use decimal::{Decimal, ParseDecimalError};
pub use derivatives::Derivatives;
pub use double_ball::DoubleBall;
pub use double_double::{DoubleDouble, DoubleDoubleBy};
pub use double_double_ball::{BallColumn, DoubleDoubleBall};
pub use double_sine::{SinePoint, SinePoints};
pub use drawable::Drawable;
pub use dual::{Dual, gradient};
pub use dyadic::{Dyadic, MAX_EXPONENT, ParseDyadicError};
pub use engine::Engine;
pub use exact::{
    ExactNumber, Form, ParseExactError, rational_sine_and_cosine, root, sine_and_cosine,
};
pub use float_ball::{Branchless, Edge, FloatBall, Midpoint, Settled, power_of_two};
#[cfg(feature = "mpfr")]
pub use gmp::*;
pub use gradient::Gradient;
pub use interval::AstroInterval;
pub use jet::Jet;
pub use product::{Dekker, Fused, Product};
pub use range::{BETWEEN, PLUS_MINUS, TELL_OF_RANGES, is_range, spelt_range};
pub use shown::{shown, visible};
pub use spelt::{decimal, hexadecimal, is_plain, of_fortran, spelt};
pub use stumpff::Stumpff;
pub use stumpff::terms as stumpff_terms;
pub use tens::Tens;
pub use ternary::Ternary;
pub use unit::is_angle;
pub use written::Written;

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with `+ - * /` and small integers: enough for every algebraic statement.
///
/// Owned values combine with owned values and with references; a formula therefore starts each
/// product with a constant (`x.int(2) * y`) or with a clone.
pub trait Field:
    Clone
    + Debug
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
{
    /// The integer `n`, exactly, with the precision of `self`.
    fn int(&self, n: i32) -> Self;

    /// The fraction `n/d` with the precision of `self`; `d` must not be zero.
    fn ratio(&self, n: i32, d: i32) -> Self {
        self.int(n) / self.int(d)
    }

    /// `self * self`.
    #[inline(always)]
    fn square(&self) -> Self {
        self.clone() * self
    }
}

/// A field that recognises its zero: what a proof by normal form or an exact division needs.
pub trait ExactField: Field {
    /// Tells whether the number is exactly zero; `false` means that it is not.
    fn is_zero(&self) -> bool;
}

/// A field with pi, square roots, sines and cosines: what the statics of an arch need.
pub trait Real: Field {
    /// The constant `pi` with the precision of `self`.
    fn pi(&self) -> Self;

    /// The square root; below zero the answer is NaN or, for an enclosure, the whole line.
    fn sqrt(&self) -> Self;

    /// Sine and cosine of an angle in radians, in one go.
    fn sin_cos(&self) -> (Self, Self);
}

/// A set of real numbers that holds the true value.
///
/// The contract of every operation `F` for a function `f`: **for all `x` in `X`, `f(x)` is in
/// `F(X)`**. Outside the domain of `f` the answer is the whole line. A `true`, or a decided
/// [`Ternary`], is a proof; anything else says nothing.
pub trait Enclosure: Real {
    /// Is every number of the set positive (`True`), none (`False`), or can this not be told?
    fn is_positive(&self) -> Ternary;

    /// Is the set bounded?
    fn is_bounded(&self) -> bool;

    /// The set that holds only the midpoint of this one; zero where this one is unbounded.
    fn midpoint(&self) -> Self;

    /// The set symmetric about zero with the radius of this one: `X - mid(X)`.
    fn centred(&self) -> Self;

    /// Does this set lie in the interior of `outer`? `true` is a proof.
    fn lies_inside(&self, outer: &Self) -> bool;

    /// May the two sets have a number in common? `false` proves that they have none.
    fn overlaps(&self, other: &Self) -> bool;

    /// Is every number of this set below every number of `other` (`True`), none below any
    /// (`False`), or can this not be told?
    fn is_less_than(&self, other: &Self) -> Ternary {
        (other.clone() - self).is_positive()
    }

    /// Are all numbers of the set different from zero? `true` is a proof.
    fn excludes_zero(&self) -> bool {
        self.is_positive() == Ternary::True || (-self.clone()).is_positive() == Ternary::True
    }
}

/// Configurations of property tests.
#[cfg(any(test, feature = "proptest"))]
#[doc(hidden)]
pub mod test_config {
    use proptest::test_runner::{Config, RngSeed};
    use std::env::var_os;

    /// Configuration of every property test: the same arguments in every run, and bounded shrinking. `PROPTEST_CASES`
    /// asks for another number of cases, `PROPTEST_RNG_SEED` for other arguments (`make trial`).
    pub fn config(cases: u32) -> Config {
        let asked = Config::default();
        let mut config = fixed(cases);
        if var_os("PROPTEST_CASES").is_some() {
            config.cases = asked.cases;
        }
        if var_os("PROPTEST_RNG_SEED").is_some() {
            config.rng_seed = asked.rng_seed;
        }
        config
    }

    /// Configuration of a test that counts what is drawn, or shrinks it: the environment changes nothing.
    pub fn fixed(cases: u32) -> Config {
        Config {
            cases,
            max_shrink_iters: 1000,
            max_shrink_time: 20_000,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(0),
            ..Config::default()
        }
    }
}
