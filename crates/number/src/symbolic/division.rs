//! Exact division, greatest common divisors, square-free parts.
//!
//! Euclid's algorithm answers for one symbol. For several, its remainders grow beyond use; instead one
//! symbol is given numbers for values, the common divisors of the images are found, with one symbol
//! less, and the divisor is interpolated (Brown 1971; Geddes, Czapor, Labahn, *Algorithms for Computer
//! Algebra*, section 7.4). A value can make an image share **more** than the polynomials do, never
//! less, and what has been put together is accepted only if it divides both: the answer is proved.
//! Common divisors are determined up to a rational factor; here the leading coefficient is one.

use super::polynomial::Monomial;
use super::{Polynomial, Symbol};
use rug::Rational;
use std::collections::BTreeMap;

impl Polynomial {
    /// The quotient, if `divisor` divides this without remainder; `None` if it does not.
    ///
    /// # Panics
    /// If `divisor` is zero.
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (head, factor) = divisor.leading().expect("the divisor is not zero");
        let mut rest = self.clone();
        let mut quotient = Self::zero();
        // The leading terms fall, since the order of monomials is compatible with products.
        while let Some((monomial, value)) = rest.leading() {
            let term = Self::term(monomial.over(head)?, Rational::from(value / factor));
            rest = rest - &(&term * divisor);
            quotient = quotient + &term;
        }
        Some(quotient)
    }

    /// The polynomial with leading coefficient one; zero stays zero.
    fn monic(&self) -> Self {
        self.leading().map_or_else(Self::zero, |(_, value)| self.scaled(&value.clone().recip()))
    }

    /// The greatest common divisor, with leading coefficient one; zero for two zeros.
    ///
    /// ```
    /// use couplet_number::symbolic::{Letters, Symbol};
    /// let (f, g) = (Symbol::F.polynomial(), Symbol::G.polynomial());
    /// let (a, b) = (&(&f * &f) - &(&g * &g), &f * &f - &(&f * &g));
    /// assert_eq!(a.common_divisor(&b).to_string(), "f - g");
    /// ```
    pub fn common_divisor(&self, other: &Self) -> Self {
        if self.is_zero() || self == other {
            return other.monic();
        }
        if other.is_zero() {
            return self.monic();
        }
        if self.as_constant().is_some() || other.as_constant().is_some() {
            return Self::from(1);
        }
        let occurs = |s: &Symbol| self.degree(*s) > Some(0) || other.degree(*s) > Some(0);
        let symbols: Vec<Symbol> = Symbol::ALL.into_iter().filter(occurs).collect();
        match symbols[..] {
            [symbol] => self.euclid(other, symbol),
            [.., last] => self.interpolated_divisor(other, last),
            [] => unreachable!("neither is constant"),
        }
    }

    /// Euclid's algorithm for polynomials in `symbol` alone.
    fn euclid(&self, other: &Self, symbol: Symbol) -> Self {
        let (mut a, mut b) = (self.monic(), other.monic());
        while !b.is_zero() {
            let degree = b.degree(symbol);
            while let Some(excess) =
                a.degree(symbol).zip(degree).and_then(|(a, b)| a.checked_sub(b))
            {
                let (_, top) = a.leading().expect("a degree means a term");
                let top = top.clone();
                a = a - &b.scaled(&top).shifted(symbol, excess);
            }
            (a, b) = (b, a.monic());
        }
        a
    }

    /// The coefficients, polynomials in `symbol` alone, of the monomials in the other symbols.
    fn fibres(&self, symbol: Symbol) -> BTreeMap<Monomial, Self> {
        let mut fibres = BTreeMap::<Monomial, Self>::new();
        for (monomial, value) in &self.terms {
            let power = Monomial::ONE.with(symbol, monomial.exponent(symbol));
            let fibre = fibres.entry(monomial.with(symbol, 0)).or_default();
            fibre.add_term(power, value.clone());
        }
        fibres
    }

    /// The common divisor of the fibres over `symbol`.
    fn fibre_content(&self, symbol: Symbol) -> Self {
        self.fibres(symbol).values().fold(Self::zero(), |c, fibre| c.common_divisor(fibre))
    }

    fn interpolated_divisor(&self, other: &Self, symbol: Symbol) -> Self {
        let contents = [self.fibre_content(symbol), other.fibre_content(symbol)];
        let content = contents[0].common_divisor(&contents[1]);
        let primitive = |p: &Self, content: &Self| p.exact_quotient(content).expect("divides");
        let (a, b) = (primitive(self, &contents[0]), primitive(other, &contents[1]));
        let head = |p: &Self| p.fibres(symbol).pop_last().expect("not zero").1;
        let heads = [head(&a), head(&b)];
        // A multiple of the leading coefficient of the divisor sought.
        let scale = heads[0].common_divisor(&heads[1]);

        let mut sum = Self::zero();
        let mut nodes = Self::from(1);
        let mut shape: Option<Monomial> = None;
        for value in 1.. {
            let value = Rational::from(value);
            let at = |p: &Self| p.substitute(symbol, &Self::constant(value.clone()));
            if heads.iter().any(|head| at(head).is_zero()) {
                continue;
            }
            let image = at(&a).common_divisor(&at(&b));
            let (leading, _) = image.leading().expect("not zero");
            if image.as_constant().is_some() {
                return content;
            }
            match shape {
                // This value shares more than the polynomials do.
                Some(shape) if *leading > shape => continue,
                Some(shape) if *leading == shape => {}
                // The values before did.
                _ => (sum, nodes, shape) = (Self::zero(), Self::from(1), Some(*leading)),
            }
            // Newton's interpolation: correct the sum at this value without touching those before.
            let scaled = &image * &at(&scale);
            let gap = scaled - &at(&sum);
            let unit = at(&nodes).as_constant().expect("a polynomial in one symbol");
            let settled = gap.is_zero();
            sum = sum + &(&gap.scaled(&unit.recip()) * &nodes);
            nodes = nodes * &(Self::symbol(symbol) - &Self::constant(value));
            if settled {
                let found = primitive(&sum, &sum.fibre_content(symbol)).monic();
                let divides = |p: &Self| p.exact_quotient(&found).is_some();
                if divides(&a) && divides(&b) {
                    return (content * &found).monic();
                }
            }
        }
        unreachable!("only finitely many values are unlucky")
    }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::strategies::{nonzero, polynomial};
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(config(60))]

        #[test]
        fn a_product_can_be_divided(a in polynomial(), b in nonzero()) {
            prop_assert_eq!((&a * &b).exact_quotient(&b), Some(a.clone()));
            // A remainder of one is seen, unless everything divides.
            let spoiled = &(&a * &b) + &Polynomial::from(1);
            prop_assert_eq!(spoiled.exact_quotient(&b).is_some(), b.as_constant().is_some());
        }

        #[test]
        fn a_planted_common_divisor_is_found(a in nonzero(), b in nonzero(), c in nonzero()) {
            let (left, right) = (&a * &c, &b * &c);
            let common = left.common_divisor(&right);
            prop_assert!(common.exact_quotient(&c.clone()).is_some(), "c divides it");
            prop_assert!(left.exact_quotient(&common).is_some());
            prop_assert!(right.exact_quotient(&common).is_some());
            let (x, y) = (left.exact_quotient(&common).unwrap(), right.exact_quotient(&common).unwrap());
            prop_assert_eq!(x.common_divisor(&y), Polynomial::from(1), "and nothing more is shared");
        }
    }
}
