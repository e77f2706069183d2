//! Polynomials in the thickness, of the degree of a determinant of four conditions at most.

use crate::number::{DoubleBall, Field, Jet};

/// The determinant of four hinges: a column of degree zero, two of degree one, and the loads of degree two.
pub(super) const DEGREE: usize = 4;

/// `sum of terms[k] x^k` up to its degree; the terms above it are zero.
#[derive(Clone, Debug)]
pub(super) struct ShortPolynomial<T> {
    terms: [T; DEGREE + 1],
    degree: usize,
}

impl<T: Field> ShortPolynomial<T> {
    /// A number.
    pub(super) fn constant(value: T) -> Self {
        let zero = value.int(0);
        let mut terms = std::array::from_fn(|_| zero.clone());
        terms[0] = value;
        Self { terms, degree: 0 }
    }

    /// The first term alone.
    pub(super) fn first(&self) -> Self {
        Self::constant(self.terms[0].clone())
    }

    /// The polynomial of a jet about zero.
    pub(super) fn of(jet: &Jet<T>) -> Self {
        let degree = jet.coefficients().len() - 1;
        Self { terms: std::array::from_fn(|k| jet.coefficient(k)), degree }
    }

    /// `sum of sign a b`, the signs in turn, of factors whose degrees add up to [`DEGREE`] at most.
    pub(super) fn alternating(pairs: &[[&Self; 2]]) -> Self {
        let zero = pairs[0][0].terms[0].int(0);
        let mut sum = Self::constant(zero);
        for (n, [a, b]) in pairs.iter().enumerate() {
            sum.degree = sum.degree.max(a.degree + b.degree);
            for i in 0..=a.degree {
                for j in 0..=b.degree {
                    let product = a.terms[i].clone() * &b.terms[j];
                    let term = sum.terms[i + j].clone();
                    sum.terms[i + j] =
                        if n.is_multiple_of(2) { term + product } else { term - product };
                }
            }
        }
        sum
    }

    /// Minor of two rows by two of their columns.
    pub(super) fn minor([a, b]: [&[Self]; 2], [i, j]: [usize; 2]) -> Self {
        Self::alternating(&[[&a[i], &b[j]], [&a[j], &b[i]]])
    }

    /// The other sign.
    pub(super) fn negative(self) -> Self {
        Self { terms: self.terms.map(|x| -x), ..self }
    }

    /// The coefficients up to its degree, from that of one on.
    pub(super) fn coefficients(&self) -> &[T] {
        &self.terms[..=self.degree]
    }

    /// Value at a number.
    pub(super) fn at(&self, x: &T) -> T {
        self.coefficients().iter().rev().fold(x.int(0), |sum, term| sum * x + term)
    }

    /// Derivative of the polynomial.
    pub(super) fn derivative(&self) -> Self {
        let terms = std::array::from_fn(|k| match self.terms.get(k + 1) {
            Some(term) => term.int(k as i32 + 1) * term,
            None => self.terms[0].int(0),
        });
        Self { terms, degree: self.degree.saturating_sub(1) }
    }

    /// Polynomial in powers of the distance from a number.
    fn about(&self, centre: &T) -> Self {
        let mut terms = self.terms.clone();
        for first in 0..self.degree {
            for k in (first..self.degree).rev() {
                terms[k] = terms[k + 1].clone() * centre + &terms[k];
            }
        }
        Self { terms, degree: self.degree }
    }
}

impl ShortPolynomial<DoubleBall> {
    /// Values on a piece, given by its middle and what is around it.
    pub(super) fn on(&self, piece: &DoubleBall) -> DoubleBall {
        use crate::number::Enclosure;
        self.about(&piece.midpoint()).at(&piece.centred())
    }

    /// Tells whether the polynomial is exactly zero.
    pub(super) fn is_zero(&self) -> bool {
        self.terms.iter().all(|term| term.size() == 0.0)
    }

    /// Value in doubles.
    pub(super) fn near(&self, x: f64) -> f64 {
        self.coefficients().iter().rev().fold(0.0, |sum, term| sum * x + term.mid())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;
    use rug::Rational;

    fn of(terms: &[i32]) -> ShortPolynomial<Rational> {
        ShortPolynomial::of(&Jet::new(terms.iter().map(|n| Rational::from(*n)).collect(), DEGREE))
    }

    #[test]
    fn products_derivatives_and_shifts() {
        let (a, b) = (of(&[1, 2]), of(&[3, 0, 5]));
        let x = Rational::from((2, 7));
        let value = |of: &ShortPolynomial<Rational>| of.at(&x);
        let sum = ShortPolynomial::alternating(&[[&a, &b], [&b, &b], [&a, &a]]);
        let expected = value(&a) * value(&b) - value(&b) * value(&b) + value(&a) * value(&a);
        assert_eq!(value(&sum), expected);
        assert_ne!(value(&ShortPolynomial::alternating(&[[&a, &b], [&b, &b]])), expected);
        assert_eq!(value(&sum.clone().negative()), -expected);
        assert_eq!(of(&[7, 3, 0, 2, 1]).derivative().at(&x), of(&[3, 0, 6, 4]).at(&x));
        let centre = Rational::from((5, 3));
        let away = Rational::from(&x - &centre);
        assert_eq!(sum.about(&centre).at(&away), value(&sum));
    }

    /// The values on a piece hold those at its points, and little more on a short one.
    #[test]
    fn a_piece_holds_its_values() {
        let ball = |x: f64| DoubleBall::exact(x);
        let jet = Jet::new([0.3, -1.0, 0.5, 0.25, -2.0].map(ball).to_vec(), DEGREE);
        let polynomial = ShortPolynomial::of(&jet);
        let piece = DoubleBall::new(0.7, 1e-3);
        let values = polynomial.on(&piece);
        for x in [0.699, 0.6995, 0.7, 0.701] {
            assert!(polynomial.at(&ball(x)).lies_inside(&values));
            approx::assert_relative_eq!(polynomial.near(x), jet.at(&ball(x)).mid());
        }
        assert!(values.rad() < 0.01);
    }
}
