//! A simple zero of a polynomial, to as many bits as are asked for.

use crate::number::{Ball, Dual, Field, Magnitude};
use crate::prover::root::precisions;
use rug::Float;

/// Steps of Newton's method at one precision; after the first one or two are enough.
const STEPS: usize = 20;
/// A step shorter than half the bits, but for so many, is the last one at its precision.
const SLACK: i64 = 8;

/// The value and the slope of the polynomial with these coefficients, in numbers of `bits` bits.
fn at(coefficients: &[Ball], x: &Float, bits: u32) -> Dual<Ball> {
    let x = Dual::variable(Ball::exact(x.clone(), bits), 0);
    let terms = coefficients.iter().rev().map(|term| Dual::constant(term.with_precision(bits)));
    terms.fold(x.int(0), |sum, term| sum * &x + term)
}

/// Two numbers on both sides of a zero of the polynomial with these coefficients, as near to each other as these and
/// the bits allow: a candidate, from one `near` it. Only a change of sign between them proves it.
pub(crate) fn around_zero(coefficients: &[Ball], near: &Float, bits: u32) -> [Ball; 2] {
    let mut x = near.clone();
    for bits in precisions(bits) {
        for _ in 0..STEPS {
            let there = at(coefficients, &x, bits);
            let step = Float::with_val(bits, there.value().mid() / there.derivative(0).mid());
            if !step.is_finite() {
                break;
            }
            x = Float::with_val(bits, &x - &step);
            let size = |x: &Float| Magnitude::upper(x).exponent();
            let is_last = |step| size(&x).is_none_or(|x| step < x + SLACK - i64::from(bits) / 2);
            if size(&step).is_none_or(is_last) {
                break;
            }
        }
    }
    let mut x = Float::with_val(bits, x);
    let there = at(coefficients, &x, bits);
    let last = Float::with_val(bits, there.value().mid() / there.derivative(0).mid());
    if last.is_finite() {
        x -= last;
    }
    // What the coefficients leave open, and a little more.
    let slope = Float::with_val(64, there.derivative(0).mid().abs_ref());
    let room = Float::with_val(64, there.value().rad().to_float() / slope) * 4u32;
    let least = Float::with_val(64, x.abs_ref()) >> (bits - 4);
    let room = if room.is_finite() && room > least { room } else { least };
    let beside = |offset: Float| Ball::exact(Float::with_val(bits + 64, &x + &offset), bits);
    [beside(-room.clone()), beside(room)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    fn polynomial(terms: &[i32], bits: u32) -> Vec<Ball> {
        terms.iter().map(|n| Ball::integer(*n, bits)).collect()
    }

    /// Between the two numbers the sign changes, whatever the bits; they are next to each other.
    #[test]
    fn the_numbers_are_beside_the_zero_and_near_each_other() {
        for bits in [64, 300, 513, 5000] {
            // The square root of two, and a small zero.
            for (terms, near) in [(vec![-2, 0, 1], 1.4), (vec![-1, 1_000_000_000, 7, -3], 1.1e-9)] {
                let terms = polynomial(&terms, bits);
                let [low, high] = around_zero(&terms, &Float::with_val(53, near), bits);
                let value = |x: &Ball| at(&terms, x.mid(), bits).value().clone();
                let [below, above] = [value(&low), value(&high)];
                assert!((-below).is_positive().is_proved() && above.is_positive().is_proved());
                let apart = Magnitude::upper((high.clone() - low).mid());
                assert!(
                    apart < Magnitude::upper(high.mid()).shifted(12 - i64::from(bits)),
                    "{bits}"
                );
            }
        }
    }

    /// Where there is no zero there is no change of sign.
    #[test]
    fn without_a_zero_no_sign_changes() {
        let terms = polynomial(&[1, 0, 1], 600);
        let ends = around_zero(&terms, &Float::with_val(53, 0.5), 600);
        assert!(ends.iter().all(|x| at(&terms, x.mid(), 600).value().is_positive().is_proved()));
    }
}
