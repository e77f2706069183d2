//! Polynomials in several indeterminates over the rationals.
//!
//! Sparse: a map from monomials to their non-zero coefficients, so that two polynomials are equal
//! exactly when the maps are, and a polynomial is zero exactly when the map is empty. Monomials are
//! ordered lexicographically by the order of the [`Symbol`]s.

use super::Symbol;
use crate::number::{Field, rational_like};
use rug::Rational;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ops::Neg;

/// A product of powers of the symbols: the exponents, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Monomial(pub [u16; Symbol::COUNT]);

impl Monomial {
    pub(super) const ONE: Self = Self([0; Symbol::COUNT]);

    pub(super) fn exponent(&self, symbol: Symbol) -> u16 {
        self.0[symbol as usize]
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    /// The quotient, if `other` divides this.
    pub(super) fn over(&self, other: &Self) -> Option<Self> {
        let mut quotient = Self::ONE;
        for (q, (a, b)) in quotient.0.iter_mut().zip(self.0.iter().zip(&other.0)) {
            *q = a.checked_sub(*b)?;
        }
        Some(quotient)
    }

    pub(super) fn with(mut self, symbol: Symbol, exponent: u16) -> Self {
        self.0[symbol as usize] = exponent;
        self
    }
}

/// A polynomial with rational coefficients.
///
/// ```
/// use couplet_number::symbolic::{Letters, Polynomial, Symbol};
/// let (f, g) = (Symbol::F.polynomial(), Symbol::G.polynomial());
/// let square = (&f + &g) * &(&f + &g);
/// assert_eq!(square.to_string(), "f^2 + 2 f g + g^2");
/// assert_eq!(square.degree(Symbol::F), Some(2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Polynomial {
    pub(super) terms: BTreeMap<Monomial, Rational>,
}

impl Polynomial {
    /// The polynomial without terms.
    pub fn zero() -> Self {
        Self::default()
    }

    /// A constant.
    pub fn constant(value: impl Into<Rational>) -> Self {
        Self::term(Monomial::ONE, value.into())
    }

    /// An indeterminate.
    pub fn symbol(symbol: Symbol) -> Self {
        Self::term(Monomial::ONE.with(symbol, 1), Rational::from(1))
    }

    pub(super) fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let mut sum = Self::zero();
        sum.add_term(monomial, coefficient);
        sum
    }

    pub(super) fn add_term(&mut self, monomial: Monomial, coefficient: Rational) {
        match self.terms.entry(monomial) {
            Entry::Vacant(place) => {
                if coefficient != 0 {
                    place.insert(coefficient);
                }
            }
            Entry::Occupied(mut place) => {
                *place.get_mut() += coefficient;
                if *place.get() == 0 {
                    place.remove();
                }
            }
        }
    }

    /// Tells whether the polynomial has no terms. This is exact: the representation is unique.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, if no indeterminate occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.first_key_value() {
            None => Some(Rational::new()),
            Some((monomial, value)) if self.terms.len() == 1 && *monomial == Monomial::ONE => {
                Some(value.clone())
            }
            Some(_) => None,
        }
    }

    /// Number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Tells whether the polynomial has no terms, as [`Polynomial::is_zero`].
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The term that comes first in the lexicographic order.
    pub(super) fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.last_key_value()
    }

    /// The first symbol that occurs.
    pub fn main_symbol(&self) -> Option<Symbol> {
        Symbol::ALL.into_iter().find(|symbol| self.degree(*symbol).is_some_and(|degree| degree > 0))
    }

    /// The degree in one symbol; `None` for the zero polynomial.
    pub fn degree(&self, symbol: Symbol) -> Option<usize> {
        self.terms.keys().map(|monomial| usize::from(monomial.exponent(symbol))).max()
    }

    /// The coefficients with respect to one symbol, constant first, up to the degree; empty for zero.
    pub fn coefficients(&self, symbol: Symbol) -> Vec<Self> {
        let length = self.degree(symbol).map_or(0, |degree| degree + 1);
        let mut coefficients = vec![Self::zero(); length];
        for (monomial, value) in &self.terms {
            let place = usize::from(monomial.exponent(symbol));
            coefficients[place].terms.insert(monomial.with(symbol, 0), value.clone());
        }
        coefficients
    }

    /// The coefficient of the highest power of a symbol; zero for zero.
    pub fn leading_coefficient(&self, symbol: Symbol) -> Self {
        self.coefficients(symbol).pop().unwrap_or_default()
    }

    /// The polynomial times a power of a symbol.
    pub fn shifted(&self, symbol: Symbol, power: usize) -> Self {
        let shift =
            |monomial: &Monomial| monomial.with(symbol, monomial.exponent(symbol) + power as u16);
        Self { terms: self.terms.iter().map(|(m, value)| (shift(m), value.clone())).collect() }
    }

    /// The polynomial times a rational number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        if *factor == 0 {
            return Self::zero();
        }
        let terms = self.terms.iter().map(|(m, value)| (*m, Rational::from(value * factor)));
        Self { terms: terms.collect() }
    }

    /// The `n`th power.
    pub fn power(&self, n: usize) -> Self {
        (0..n).fold(Self::constant(1), |product, _| &product * self)
    }

    /// The polynomial with its leading coefficient raised by one or, if that would make it vanish, by
    /// two; one for zero: a false twin.
    pub fn with_changed_coefficient(&self) -> Self {
        let Some((monomial, value)) = self.leading() else { return Self::from(1) };
        let step = if *value == -1 { 2 } else { 1 };
        self.clone() + &Self::term(*monomial, Rational::from(step))
    }

    /// The partial derivative to one symbol.
    pub fn partial(&self, symbol: Symbol) -> Self {
        let mut sum = Self::zero();
        for (monomial, value) in &self.terms {
            let exponent = monomial.exponent(symbol);
            if exponent > 0 {
                sum.add_term(monomial.with(symbol, exponent - 1), Rational::from(value * exponent));
            }
        }
        sum
    }

    /// The derivation that takes each symbol listed to the polynomial beside it and every other
    /// symbol to zero. With the rules of [`along_the_joint`](super::along_the_joint) it is `d/d beta`.
    pub fn derivative(&self, rules: &[(Symbol, Self)]) -> Self {
        rules
            .iter()
            .fold(Self::zero(), |sum, (symbol, slope)| sum + &(&self.partial(*symbol) * slope))
    }

    /// The value where each symbol has the value given: the homomorphism that sends indeterminates
    /// there. Every number will do: a rational, a ball, a fraction, a series.
    pub fn evaluate<T: Field>(&self, like: &T, value: impl Fn(Symbol) -> T) -> T {
        let mut powers: [Vec<T>; Symbol::COUNT] = std::array::from_fn(|_| Vec::new());
        let mut sum = like.int(0);
        for (monomial, coefficient) in &self.terms {
            let mut product = rational_like(like, coefficient);
            for symbol in Symbol::ALL {
                let known = &mut powers[symbol as usize];
                let exponent = usize::from(monomial.exponent(symbol));
                while known.len() < exponent {
                    let next = match known.last() {
                        None => value(symbol),
                        Some(last) => last.clone() * &known[0],
                    };
                    known.push(next);
                }
                if exponent > 0 {
                    product = product * &known[exponent - 1];
                }
            }
            sum = sum + product;
        }
        sum
    }

    /// The polynomial with a polynomial put in place of a symbol.
    pub fn substitute(&self, symbol: Symbol, value: &Self) -> Self {
        let coefficients = self.coefficients(symbol);
        coefficients.iter().rev().fold(Self::zero(), |sum, c| &(&sum * value) + c)
    }
}

impl From<i32> for Polynomial {
    fn from(n: i32) -> Self {
        Self::constant(n)
    }
}

impl Polynomial {
    fn plus(mut self, other: &Self) -> Self {
        other.terms.iter().for_each(|(monomial, value)| self.add_term(*monomial, value.clone()));
        self
    }

    fn minus(mut self, other: &Self) -> Self {
        for (monomial, value) in &other.terms {
            self.add_term(*monomial, Rational::from(-value));
        }
        self
    }

    fn times(self, other: &Self) -> Self {
        let mut sum = Self::zero();
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                sum.add_term(left.times(right), Rational::from(a * b));
            }
        }
        sum
    }
}

operators!(@ [] Polynomial, Add, add, plus);
operators!(@ [] Polynomial, Sub, sub, minus);
operators!(@ [] Polynomial, Mul, mul, times);

references! { Polynomial:
    Add add: &Polynomial;
    Sub sub: &Polynomial;
    Mul mul: &Polynomial;
}

impl Neg for Polynomial {
    type Output = Self;
    fn neg(self) -> Self {
        self.scaled(&Rational::from(-1))
    }
}

#[cfg(test)]
pub(super) mod strategies {
    use super::*;
    use proptest::prelude::*;

    /// Small polynomials in `f`, `g`, `S`, with awkward cases on purpose: zero, constants, repeated
    /// monomials that cancel.
    pub(crate) fn polynomial() -> impl Strategy<Value = Polynomial> {
        let term = (0u16..3, 0u16..3, 0u16..3, -4i32..5, 1i32..4);
        prop::collection::vec(term, 0..5).prop_map(|terms| {
            let mut sum = Polynomial::zero();
            for (a, b, c, n, d) in terms {
                let monomial =
                    Monomial::ONE.with(Symbol::F, a).with(Symbol::G, b).with(Symbol::Sine, c);
                sum.add_term(monomial, Rational::from((n, d)));
            }
            sum
        })
    }

    pub(crate) fn nonzero() -> impl Strategy<Value = Polynomial> {
        polynomial().prop_filter("zero", |p| !p.is_zero())
    }
}

#[cfg(test)]
mod tests {
    use super::strategies::polynomial;
    use super::*;
    use crate::number::Ball;
    use crate::number::test_config::config;
    use crate::symbolic::Letters;
    use proptest::prelude::*;

    fn point(symbol: Symbol) -> Rational {
        Rational::from((2 * symbol as i32 - 19, 7))
    }

    fn at(p: &Polynomial) -> Rational {
        p.evaluate(&Rational::new(), point)
    }

    proptest! {
        #![proptest_config(config(200))]

        #[test]
        fn ring_axioms(a in polynomial(), b in polynomial(), c in polynomial()) {
            prop_assert_eq!(&a + &b, &b + &a);
            prop_assert_eq!(&a * &b, &b * &a);
            prop_assert_eq!(&a + &b + &c, a.clone() + &(&b + &c));
            prop_assert_eq!(&a * &b * &c, a.clone() * &(&b * &c));
            prop_assert_eq!(&a * &(&b + &c), &(&a * &b) + &(&a * &c));
            prop_assert!((&a - &a).is_zero() && (&a + &-a.clone()).is_zero());
            prop_assert_eq!(&a * &Polynomial::from(1), a.clone());
            prop_assert!((&a * &Polynomial::zero()).is_zero());
            prop_assert_eq!((&a * &b).is_zero(), a.is_zero() || b.is_zero(), "no zero divisors");
        }

        #[test]
        fn evaluation_is_a_homomorphism(a in polynomial(), b in polynomial()) {
            prop_assert_eq!(at(&(&a + &b)), at(&a) + at(&b));
            prop_assert_eq!(at(&(&a * &b)), at(&a) * at(&b));
            prop_assert_eq!(at(&(&a - &b)), at(&a) - at(&b));
            let one = Ball::integer(1, 64);
            let ball = a.evaluate(&one, |s| Ball::enclosing(&point(s), 64));
            prop_assert!(ball.contains(&at(&a)));
        }

        #[test]
        fn the_derivative_of_a_product(a in polynomial(), b in polynomial()) {
            let d = |p: &Polynomial| p.partial(Symbol::G);
            prop_assert_eq!(d(&(&a * &b)), &(&d(&a) * &b) + &(&a * &d(&b)));
        }

        #[test]
        fn coefficients_put_together_again(a in polynomial()) {
            let parts = a.coefficients(Symbol::F);
            let sum = parts.iter().enumerate().fold(Polynomial::zero(), |sum, (n, c)| {
                sum + &c.shifted(Symbol::F, n)
            });
            prop_assert_eq!(sum, a.clone());
            prop_assert_eq!(a.substitute(Symbol::F, &Symbol::F.polynomial()), a);
        }
    }
}
