//! Polynomials in the thickness: their signs on an interval.

use crate::arch::joint::{Row, multipliers};
use crate::number::{Ball, Field, Jet};
use crate::prover::Undecided;
use crate::prover::decide::{ensure, is_positive};
use crate::solve::voussoirs::DEGREE;

/// The multipliers are positive at every thickness up to `most`.
pub(super) fn rates_are_positive(rows: &[Row<Jet<Ball>>; 3], most: &Ball) -> Result<(), Undecided> {
    let is_positive = multipliers(rows).iter().all(|rate| is_positive_up_to(rate, most));
    ensure(is_positive, "the rates of the mechanism")
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
