//! Polynomials in the thickness: their signs on an interval, and their roots.

use crate::arch::joint::{Row, multipliers};
use crate::number::{Ball, Field, Jet};
use crate::prover::Undecided;
use crate::prover::decide::{ensure, is_positive};
use crate::solve::voussoirs::DEGREE;
use rug::Float;

/// The multipliers are positive at every thickness up to `most`.
pub(super) fn rates_are_positive(rows: &[Row<Jet<Ball>>; 3], most: &Ball) -> Result<(), Undecided> {
    let is_positive = multipliers(rows).iter().all(|rate| is_positive_up_to(rate, most));
    ensure(is_positive, "the rates of the mechanism")
}

/// Two numbers about a root of a polynomial, as near to each other as the bits allow: a candidate that is refined.
pub(super) fn bracket(polynomial: &Jet<Ball>, near: &Float, bits: u32) -> [Ball; 2] {
    let mut x = Float::with_val(bits, near);
    let derivative = |x: &Float| {
        let terms = polynomial.coefficients().iter().enumerate().skip(1).rev();
        terms.fold(Float::with_val(bits, 0), |sum, (k, term)| {
            sum * x + Float::with_val(bits, term.mid() * k as u32)
        })
    };
    let steps = 2 + bits.ilog2();
    for _ in 0..steps {
        let at = polynomial.at(&Ball::exact(x.clone(), bits));
        let step = Float::with_val(bits, at.mid()) / derivative(&x);
        if step.is_finite() {
            x -= step;
        }
    }
    // What the coefficients leave open, and a little more.
    let at = polynomial.at(&Ball::exact(x.clone(), bits));
    let room = Float::with_val(64, at.rad().to_float() / derivative(&x).abs()) * 4u32;
    let least = Float::with_val(64, x.abs_ref()) >> (bits - 4);
    let room = if room.is_finite() && room > least { room } else { least };
    let beside = |offset: Float| Ball::exact(Float::with_val(bits + 64, &x + &offset), bits);
    [beside(-room.clone()), beside(room)]
}

/// Tells whether a polynomial of at most [`DEGREE`] is positive from 0 to `most`, by the coefficients of its
/// Bernstein form: `b_i = sum over k <= i of C(i,k)/C(n,k) c_k most^k`.
pub(super) fn is_positive_up_to(polynomial: &Jet<Ball>, most: &Ball) -> bool {
    const BINOMIALS: [[i32; DEGREE + 1]; DEGREE + 1] =
        [[1, 0, 0, 0], [1, 1, 0, 0], [1, 2, 1, 0], [1, 3, 3, 1]];
    let mut power = most.int(1);
    let term = |(k, count): (usize, &i32)| {
        let term = polynomial.coefficient(k) * &power / most.int(*count);
        power = power.clone() * most;
        term
    };
    let scaled: Vec<Ball> = BINOMIALS[DEGREE].iter().enumerate().map(term).collect();
    BINOMIALS.iter().all(|row| {
        let terms = scaled.iter().zip(row).filter(|(_, count)| **count > 0);
        let sum = terms.fold(most.int(0), |sum, (term, count)| sum + most.int(*count) * term);
        is_positive(&sum)
    })
}
