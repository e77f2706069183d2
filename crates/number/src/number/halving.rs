//! Sine and cosine by products: the angle is halved until it is small, its versine `v = 1 - cos` summed as a
//! series, and doubled again.
//!
//! ```text
//! v(y) = t/2 (1 - t/(3·4) (1 - t/(5·6) (…))),  t = y²        v(2y) = 4 v - 2 v²        sin = √(v (2 - v))
//! ```
//!
//! All of it is done in enclosures, so that only the tail needs a bound of its own: it is at most the first term left
//! out, as the terms alternate and fall. A doubling quadruples an error, for which there are more bits. Of
//! the products those by powers of `t` are shared by several terms (Paterson and Stockmeyer 1973).

use super::Enclosure;

/// Way to compute sine and cosine of an angle between zero and pi.
pub(super) struct Halving {
    /// Number of times that the angle is halved.
    pub halvings: usize,
    /// The bits to work in.
    pub bits: usize,
    terms: usize,
    /// The series lacks less than `2^-tail`.
    pub tail: usize,
}

/// Bits beyond those of the result.
const GUARD: usize = 64;
/// The most terms: the divisors of more would not fit an `i32`.
const TERMS: usize = 20_000;

impl Halving {
    /// Halving for results of about `prec` bits; `None` if there are too many.
    pub(super) fn new(prec: usize) -> Option<Self> {
        // The angle is below four.
        let small = prec.isqrt() / 6 + 8;
        let halvings = small + 2;
        let bits = prec + 2 * halvings + GUARD;
        let term = |k: usize| 2 * small + (2 * k - 1).ilog2() as usize + (2 * k).ilog2() as usize;
        let (mut terms, mut tail) = (0, term(1));
        while tail < bits {
            terms += 1;
            tail += term(terms + 1);
        }
        (terms <= TERMS).then_some(Self { halvings, bits, terms, tail })
    }

    /// Sine and cosine of an angle from `y`, the angle halved so often, and `error`, a set about zero that holds
    /// all numbers up to `2^-tail`.
    pub(super) fn sin_cos<E: Enclosure>(&self, y: &E, error: &E) -> (E, E) {
        let mut versine = self.series(&y.square()) + error;
        for _ in 0..self.halvings {
            let half = versine.clone() + &versine - versine.square();
            versine = half.clone() + half;
        }
        let sin = (versine.int(2) - &versine) * &versine;
        (sin.sqrt(), versine.int(1) - versine)
    }

    /// The terms of `1 - cos y` for `t = y²`, from the last to the first.
    fn series<E: Enclosure>(&self, t: &E) -> E {
        let together = self.terms.isqrt().max(1);
        let mut powers = vec![t.int(1)];
        for k in 0..together {
            powers.push(powers[k].clone() * t);
        }
        // The sum so far stands relative to the first term of its block.
        let sum = (1..=self.terms).rev().fold(t.int(0), |sum, k| {
            let place = (k - 1) % together;
            let sum = if place + 1 == together { sum * &powers[together] } else { sum };
            (powers[place].clone() - sum) / t.int((2 * k * (2 * k - 1)) as i32)
        });
        sum * t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Field, Real};

    /// Against the identity of the three angles that add up to pi, and against the functions of the arithmetic.
    #[test]
    fn sines_and_cosines_are_those() {
        for prec in [64, 400, 1000, 3000] {
            let plan = Halving::new(prec).unwrap();
            let scale = AstroInterval::dyadic(false, &[1], -(plan.halvings as i32), 64);
            let error = AstroInterval::dyadic(false, &[1], -(plan.tail as i32), 64).symmetric();
            for (n, d) in [(1, 8), (1, 3), (1, 1), (11, 7), (2, 1), (3, 1)] {
                let x = AstroInterval::integer(0, plan.bits).ratio(n, d);
                let (sin, cos) = plan.sin_cos(&(x.clone() * &scale), &error);
                let one = sin.square() + cos.square();
                assert!(one.overlaps(&x.int(1)) && sin.is_positive().is_proved(), "{prec} {n}/{d}");
                let narrow = AstroInterval::dyadic(false, &[1], -(prec as i32) - 8, 64).symmetric();
                for (ours, theirs) in [(sin, x.sin_cos().0), (cos, x.sin_cos().1)] {
                    assert!(ours.overlaps(&theirs), "{prec} {n}/{d}");
                    assert!(ours.centred().lies_inside(&narrow), "wide: {prec} {n}/{d}");
                }
            }
        }
    }

    /// Without the tail, or with a term less, it is another number.
    #[test]
    fn what_is_left_out_counts() {
        let plan = Halving::new(400).unwrap();
        let scale = AstroInterval::dyadic(false, &[1], -(plan.halvings as i32), 64);
        let (x, none) = (AstroInterval::integer(2, plan.bits), AstroInterval::integer(0, 64));
        let (sin, _) = plan.sin_cos(&(x.clone() * &scale), &none);
        let short = Halving { terms: plan.terms - 2, ..plan };
        let (other, _) = short.sin_cos(&(x * &scale), &none);
        assert!(!sin.overlaps(&other));
    }
}
