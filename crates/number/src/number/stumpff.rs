//! Stumpff's functions: sine and cosine of small angles, and what is left of them when their first
//! terms are taken away.
//!
//! ```text
//! c_n(u) = sum over k of (-u)^k / (2k + n)!
//! cos x = c_0(x²),  sin x = x c_1(x²),  1 - cos x = x² c_2(x²),  x - sin x = x³ c_3(x²), ...
//! u c_{n+2} = 1/n! - c_n,   dc_n/du = (n c_{n+2} - c_{n+1})/2
//! ```
//!
//! (Stumpff 1959; the universal variables of celestial mechanics.) A difference such as `sin x - x cos x`,
//! which loses two thirds of the digits of a small `x`, is `x³ (c_2 - c_3)`, which loses none.

#[cfg(feature = "mpfr")]
use super::Angle;
use super::{Dual, Field};

/// A number with Stumpff's functions.
pub trait Stumpff: Field {
    /// `c_0(u), ..., c_{count-1}(u)` for `-1 <= u <= 1`, with `count` at least 2. In an enclosure they are
    /// enclosed for every `u`; beyond 1 by the whole line.
    fn stumpff(&self, count: usize) -> Vec<Self>;
}

/// The functions from `terms` terms of the last two, the others by the recurrence, in which nothing
/// cancels for `|u| <= 1`. `tail` stands for what follows the terms, `1 - u/((m+1)(m+2)) (1 - ...)`.
pub(super) fn from_series<T: Field>(u: &T, count: usize, terms: i32, tail: &T) -> Vec<T> {
    let one = u.int(1);
    let last = |n: i32| {
        let series = (1..=terms).rev().fold(tail.clone(), |sum, k| {
            // Two divisors, as their product outgrows an `i32` before either does.
            one.clone() - sum * u / (u.int(2 * k + n) * u.int(2 * k + n - 1))
        });
        series * reciprocal_factorial(u, n)
    };
    let count = count as i32;
    // From the last down.
    let mut functions = vec![last(count - 1), last(count - 2)];
    for n in (0..count - 2).rev() {
        let above = functions[functions.len() - 2].clone();
        functions.push(reciprocal_factorial(u, n) - above * u);
    }
    functions.reverse();
    functions
}

/// The functions at `u = x²` from sine and cosine of `x`, by the recurrence, in which each step but the first two loses
/// as many digits as a small `u` has zeros.
#[cfg(feature = "mpfr")]
pub(super) fn from_angle<T: Field>(u: &T, x: &Angle<T>, count: usize) -> Vec<T> {
    let mut functions = vec![x.cos.clone(), x.sin.clone() / &x.rad];
    for n in 2..count {
        let rest = reciprocal_factorial(u, n as i32 - 2) - &functions[n - 2];
        functions.push(rest / u);
    }
    functions
}

/// Number of terms that is enough for `bits` bits where `|u| < 2^exponent`.
pub fn terms(bits: u32, exponent: i64) -> i32 {
    // The last term, over the first: u^k over at least (2k)!, and each factor of that is above k.
    let (mut terms, mut gained) = (1i32, 0);
    while gained < i64::from(bits) {
        terms += 1;
        gained += i64::from(2 * terms.ilog2()) + 2 - exponent.min(0);
    }
    terms
}

/// `1/n!`; beyond `12!`, the last that an `i32` holds, factor by factor.
fn reciprocal_factorial<T: Field>(like: &T, n: i32) -> T {
    let first = like.ratio(1, (1..=n.min(12)).product());
    (13..=n).fold(first, |rest, k| rest / like.int(k))
}

/// `dc_n/du` from the two functions after the one of number `n`.
pub(super) fn slope<T: Field>(functions: &[T], n: usize) -> T {
    let difference = functions[n + 2].int(n as i32) * &functions[n + 2] - &functions[n + 1];
    difference / functions[n].int(2)
}

impl Stumpff for f64 {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        from_series(self, count, terms(64, 0), &1.0)
    }
}

impl<T: Stumpff> Stumpff for Dual<T> {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let functions = self.value().stumpff(count + 2);
        let chained = |n: usize| self.chain(functions[n].clone(), &slope(&functions, n));
        (0..count).map(chained).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_sine_and_cosine_with_their_first_terms_taken_away() {
        let x = 0.7f64;
        let c = (x * x).stumpff(5);
        let (sin, cos) = x.sin_cos();
        let expected = [
            cos,
            sin / x,
            (1.0 - cos) / x.powi(2),
            (x - sin) / x.powi(3),
            (cos - 1.0 + x * x / 2.0) / x.powi(4),
        ];
        for (found, expected) in c.into_iter().zip(expected) {
            approx::assert_relative_eq!(found, expected, max_relative = 1e-13);
        }
    }

    #[test]
    fn at_zero_they_are_the_reciprocal_factorials() {
        assert_eq!(0.0.stumpff(5), [1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0]);
    }

    #[test]
    fn beyond_twelve_factors_nothing_overflows() {
        let last = 0.0.stumpff(16)[15];
        let factorial: f64 = (1..=15).map(f64::from).product();
        approx::assert_relative_eq!(last, factorial.recip(), max_relative = 1e-15);
    }

    #[test]
    fn the_derivative_is_that_of_the_series() {
        let u = Dual::variable(0.3f64, 0);
        let step = 1e-5;
        let [low, high] = [0.3 - step, 0.3 + step].map(|u: f64| u.stumpff(5));
        for (n, c) in u.stumpff(5).iter().enumerate() {
            let difference = (high[n] - low[n]) / (2.0 * step);
            approx::assert_relative_eq!(c.derivative(0), difference, max_relative = 1e-7);
        }
    }
}
