//! Resultants and discriminants: what is left when a symbol is eliminated.
//!
//! The resultant of `p` and `q` with respect to `x` is the determinant of their Sylvester matrix. It
//! is zero exactly when they have a common root in `x` (in an algebraic closure) or both leading
//! coefficients vanish. The same determinant with its last column replaced by `x^k p` and `x^k q`
//! shows it as a combination, `resultant = u p + v q`: anybody can check it by multiplying out.

use super::{Polynomial, Symbol};

/// `resultant = u p + v q`.
#[derive(Clone, Debug)]
pub struct Elimination {
    /// Free of the symbol eliminated.
    pub resultant: Polynomial,
    /// The cofactor of the first polynomial.
    pub u: Polynomial,
    /// The cofactor of the second polynomial.
    pub v: Polynomial,
}

/// Eliminates `symbol` from `p = 0` and `q = 0`. Both must contain it.
///
/// ```
/// use couplet_number::symbolic::{Letters, Polynomial, Symbol, eliminate};
/// // x = eta: eta² = g and eta = f leave f² - g.
/// let (eta, f, g) = (Symbol::Thickness, Symbol::F.polynomial(), Symbol::G.polynomial());
/// let (p, q) = (eta.polynomial().power(2) - &g, eta.polynomial() - &f);
/// let found = eliminate(&p, &q, eta);
/// assert_eq!(found.resultant.to_string(), "f^2 - g");
/// assert_eq!(found.resultant, &found.u * &p + &(&found.v * &q));
/// ```
pub fn eliminate(p: &Polynomial, q: &Polynomial, symbol: Symbol) -> Elimination {
    let (a, b) = (p.coefficients(symbol), q.coefficients(symbol));
    let (m, n) = (a.len().saturating_sub(1), b.len().saturating_sub(1));
    assert!(m > 0 && n > 0, "both polynomials must contain {symbol:?}");
    let size = m + n;
    // Row i < n is x^(n-1-i) p, row n + j is x^(m-1-j) q; column c belongs to x^(size-1-c).
    let row = |coefficients: &[Polynomial], shift: usize| -> Vec<Polynomial> {
        let entry = |column: usize| {
            let power = size - 1 - column;
            power.checked_sub(shift).and_then(|k| coefficients.get(k)).cloned().unwrap_or_default()
        };
        (0..size).map(entry).collect()
    };
    let rows: Vec<Vec<Polynomial>> =
        (0..n).map(|i| row(&a, n - 1 - i)).chain((0..m).map(|j| row(&b, m - 1 - j))).collect();
    let cofactor = |index: usize| {
        let minor = rows
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index)
            .map(|(_, row)| row[..size - 1].to_vec())
            .collect();
        let minor = determinant(minor);
        if (index + size - 1).is_multiple_of(2) { minor } else { -minor }
    };
    let cofactors: Vec<Polynomial> = (0..size).map(cofactor).collect();
    let combine = |part: &[Polynomial]| {
        let top = part.len() - 1;
        part.iter()
            .enumerate()
            .fold(Polynomial::zero(), |sum, (i, c)| sum + &c.shifted(symbol, top - i))
    };
    let (u, v) = (combine(&cofactors[..n]), combine(&cofactors[n..]));
    let resultant = &u * p + &(&v * q);
    Elimination { resultant, u, v }
}

/// The discriminant with respect to `symbol`: `(-1)^(n(n-1)/2) Res(p, p') / lc(p)` for degree `n`,
/// at least one.
pub fn discriminant(p: &Polynomial, symbol: Symbol) -> Polynomial {
    let n = p.degree(symbol).unwrap_or(0);
    assert!(n > 0, "the polynomial must contain {symbol:?}");
    if n == 1 {
        return Polynomial::from(1);
    }
    let resultant = eliminate(p, &p.partial(symbol), symbol).resultant;
    let quotient = resultant
        .exact_quotient(&p.leading_coefficient(symbol))
        .expect("the first column of the Sylvester matrix is divisible");
    if (n * (n - 1) / 2).is_multiple_of(2) { quotient } else { -quotient }
}

/// The determinant of a square matrix, by Bareiss' elimination without fractions: each division is
/// exact, by the pivot before.
fn determinant(mut rows: Vec<Vec<Polynomial>>) -> Polynomial {
    let size = rows.len();
    let mut previous = Polynomial::from(1);
    let mut negative = false;
    for k in 0..size {
        let Some(pivot) = (k..size).find(|&i| !rows[i][k].is_zero()) else {
            return Polynomial::zero();
        };
        if pivot != k {
            rows.swap(pivot, k);
            negative = !negative;
        }
        for i in k + 1..size {
            for j in k + 1..size {
                let cross = &rows[k][k] * &rows[i][j] - &(&rows[i][k] * &rows[k][j]);
                rows[i][j] = cross.exact_quotient(&previous).expect("Bareiss' division is exact");
            }
        }
        previous = rows[k][k].clone();
    }
    if negative { -previous } else { previous }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::strategies::{nonzero, polynomial};
    use super::*;
    use crate::number::test_config::config;
    use crate::symbolic::Letters;
    use proptest::prelude::*;

    const X: Symbol = Symbol::Thickness;

    /// A polynomial of degree one or two in `x` with polynomial coefficients.
    fn in_x() -> impl Strategy<Value = Polynomial> {
        (polynomial(), polynomial(), nonzero(), 1usize..3)
            .prop_map(|(a, b, c, degree)| &a + &b.shifted(X, 1) + &c.shifted(X, degree))
            .prop_filter("constant", |p| p.degree(X) > Some(0))
    }

    proptest! {
        #![proptest_config(config(12))]

        #[test]
        fn the_resultant_is_a_combination_free_of_the_symbol(p in in_x(), q in in_x()) {
            let found = eliminate(&p, &q, X);
            prop_assert_eq!(found.resultant.degree(X).unwrap_or(0), 0);
            prop_assert_eq!(&found.u * &p + &(&found.v * &q), found.resultant.clone());
            // A common root is a common divisor that contains x.
            let common = p.common_divisor(&q).degree(X) > Some(0);
            prop_assert_eq!(found.resultant.is_zero(), common);
        }

        #[test]
        fn a_planted_common_root_makes_it_zero(p in in_x(), q in in_x(), root in polynomial()) {
            let factor = X.polynomial() - &root;
            let (p, q) = (&p * &factor, &q * &factor);
            prop_assert!(eliminate(&p, &q, X).resultant.is_zero());
            prop_assert!(discriminant(&(&p * &factor), X).is_zero(), "a planted double root");
        }
    }

    #[test]
    fn the_discriminants_of_the_textbook() {
        let [a, b, c] = [Symbol::F, Symbol::G, Symbol::Sine].map(Symbol::polynomial);
        let quadratic = a.shifted(X, 2) + &b.shifted(X, 1) + &c;
        assert_eq!(discriminant(&quadratic, X).to_string(), "-4 f S + g^2");
        let depressed = X.polynomial().power(3) + &b.shifted(X, 1) + &c;
        assert_eq!(discriminant(&depressed, X).to_string(), "-4 g^3 - 27 S^2");
    }
}
