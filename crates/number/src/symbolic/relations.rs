//! Relations between the indeterminates: `S² + C² = 1`, `q² =` a radicand.

use super::{Polynomial, Symbol};
use std::fmt;

/// Rules that replace a power of a symbol by a polynomial.
///
/// A polynomial whose [normal form](Relations::normal_form) is zero vanishes at **every** point where
/// the relations hold: it is a combination of them. The converse is not claimed for relations in
/// general, so that a non-zero normal form refutes nothing by itself; a refutation needs a point where
/// the relations hold and the value is not zero.
#[derive(Clone, Debug, Default)]
pub struct Relations(Vec<Rule>);

#[derive(Clone, Debug)]
struct Rule {
    symbol: Symbol,
    power: u16,
    value: Polynomial,
}

impl Relations {
    /// No relations: free indeterminates.
    pub fn none() -> Self {
        Self::default()
    }

    /// `C² = 1 - S²` for `beta` and for `alpha`.
    pub fn trigonometric() -> Self {
        let square = |sine: Symbol| Polynomial::from(1) - &Polynomial::symbol(sine).power(2);
        Self::none().with(Symbol::Cosine, 2, square(Symbol::Sine)).with(
            Symbol::CosineOfOpening,
            2,
            square(Symbol::SineOfOpening),
        )
    }

    /// Adds the rule `symbol^power = value`. The value must have a smaller degree than `power` in `symbol`,
    /// and contain no symbol whose rule, applied to it, would bring `symbol` back: else a normal form would
    /// not be reached.
    pub fn with(mut self, symbol: Symbol, power: u16, value: Polynomial) -> Self {
        assert!(value.degree(symbol).unwrap_or(0) < usize::from(power), "the rule must reduce");
        self.0.push(Rule { symbol, power, value });
        self
    }

    /// The polynomial with every rule applied as often as it can be.
    pub fn normal_form(&self, polynomial: &Polynomial) -> Polynomial {
        let mut reduced = polynomial.clone();
        loop {
            let rule = self.0.iter().find(|rule| {
                reduced.degree(rule.symbol).is_some_and(|d| d >= usize::from(rule.power))
            });
            let Some(rule) = rule else { return reduced };
            let mut sum = Polynomial::zero();
            for (monomial, value) in &reduced.terms {
                let exponent = monomial.exponent(rule.symbol);
                if exponent < rule.power {
                    sum.add_term(*monomial, value.clone());
                } else {
                    let rest = monomial.with(rule.symbol, exponent - rule.power);
                    sum = sum + &(&Polynomial::term(rest, value.clone()) * &rule.value);
                }
            }
            reduced = sum;
        }
    }
}

impl fmt::Display for Relations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, Rule { symbol, power, value }) in self.0.iter().enumerate() {
            let comma = if place > 0 { ", " } else { "" };
            write!(f, "{comma}{}^{power} = {value}", symbol.names().0)?;
        }
        Ok(())
    }
}

/// The rules of `d/d beta`: `beta' = 1`, `S' = C`, `C' = -S`.
pub fn along_the_joint() -> [(Symbol, Polynomial); 3] {
    along(Symbol::Joint, Symbol::Sine, Symbol::Cosine)
}

/// The rules of `d/d alpha`.
pub fn along_the_opening() -> [(Symbol, Polynomial); 3] {
    along(Symbol::HalfOpening, Symbol::SineOfOpening, Symbol::CosineOfOpening)
}

fn along(rad: Symbol, sin: Symbol, cos: Symbol) -> [(Symbol, Polynomial); 3] {
    let [slope_of_cos, slope_of_sin] = [-Polynomial::symbol(sin), Polynomial::symbol(cos)];
    [(rad, Polynomial::from(1)), (sin, slope_of_sin), (cos, slope_of_cos)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;
    use crate::symbolic::Letters;

    #[test]
    fn the_circle_is_known_and_nothing_else() {
        let circle = Relations::trigonometric();
        let (s, c) = (Symbol::Sine.polynomial(), Symbol::Cosine.polynomial());
        let one = &s.power(2) + &c.power(2) - &Polynomial::from(1);
        assert!(circle.normal_form(&one).is_zero());
        assert!(circle.normal_form(&(&one * &(&s + &c)).power(3)).is_zero());
        let twin = &s.power(2) - &c.power(2) - &Polynomial::from(1);
        assert!(!circle.normal_form(&twin).is_zero(), "false twin");
        let mixed = &s.power(2) + &Symbol::CosineOfOpening.polynomial().power(2);
        assert!(!circle.normal_form(&(mixed - &Polynomial::from(1))).is_zero(), "two angles");
    }

    #[test]
    fn the_derivative_along_the_joint() {
        let rules = along_the_joint();
        let product = &Symbol::Joint.polynomial() * &Symbol::Sine.polynomial();
        assert_eq!(product.derivative(&rules).to_string(), "beta C + S");
        let circle = &Symbol::Sine.polynomial().power(2) + &Symbol::Cosine.polynomial().power(2);
        assert!(circle.derivative(&rules).is_zero());
        let cotangent = Symbol::joint().cos / Symbol::joint().sin;
        let slope = cotangent.derivative(&rules);
        let expected = -(slope.int(1) / Symbol::Sine.number().square());
        assert!((slope - expected).vanishes(&Relations::trigonometric()));
    }

    #[test]
    #[should_panic(expected = "must reduce")]
    fn a_rule_that_does_not_reduce_is_refused() {
        let s = Symbol::Sine.polynomial();
        let _ = Relations::none().with(Symbol::Sine, 1, s);
    }
}
