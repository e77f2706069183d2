//! Polynomials and fractions as text and as LaTeX.

use super::{Fraction, Polynomial, Symbol};
use rug::Rational;
use std::fmt;

/// Notation of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Notation {
    /// Text for a terminal: `3 S eta^2`.
    Text,
    /// Text for a document: `3 S \eta^{2}`.
    Latex,
}

impl Notation {
    fn symbol(self, symbol: Symbol) -> &'static str {
        let (text, latex) = symbol.names();
        if self == Self::Text { text } else { latex }
    }

    fn power(self, symbol: Symbol, exponent: u16) -> String {
        match (self, exponent) {
            (_, 1) => self.symbol(symbol).to_owned(),
            (Self::Text, n) => format!("{}^{n}", self.symbol(symbol)),
            (Self::Latex, n) => format!("{{{}}}^{{{n}}}", self.symbol(symbol)),
        }
    }

    fn rational(self, value: &Rational) -> String {
        match (self, value.is_integer()) {
            (Self::Latex, false) => format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom()),
            _ => value.to_string(),
        }
    }
}

impl Polynomial {
    /// The terms, highest first.
    pub fn show(&self, notation: Notation) -> String {
        let mut text = String::new();
        for (monomial, value) in self.terms.iter().rev() {
            let letters = Symbol::ALL
                .into_iter()
                .filter(|symbol| monomial.exponent(*symbol) > 0)
                .map(|symbol| notation.power(symbol, monomial.exponent(symbol)))
                .collect::<Vec<_>>()
                .join(" ");
            push_signed(&mut text, *value < 0);
            let size = value.clone().abs();
            match (size == 1, letters.is_empty()) {
                (true, false) => text += &letters,
                (_, true) => text += &notation.rational(&size),
                (false, false) => text += &format!("{} {letters}", notation.rational(&size)),
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// The polynomial sorted by powers of one symbol, each coefficient in brackets with its common
    /// factors taken out, as the paper prints its cubics.
    ///
    /// ```
    /// use couplet_number::symbolic::{Letters, Notation, Symbol};
    /// let [f, g, eta] = [Symbol::F, Symbol::G, Symbol::Thickness].map(Symbol::polynomial);
    /// let p = (&f + &g) * &eta.power(2) - &eta;
    /// assert_eq!(p.show_by(Symbol::Thickness, Notation::Text), "(f + g) eta^2 - eta");
    /// ```
    pub fn show_by(&self, symbol: Symbol, notation: Notation) -> String {
        let mut text = String::new();
        for (power, coefficient) in self.coefficients(symbol).iter().enumerate().rev() {
            if coefficient.is_zero() {
                continue;
            }
            let negative = coefficient.leading().is_some_and(|(_, value)| *value < 0);
            push_signed(&mut text, negative);
            let positive = if negative { -coefficient.clone() } else { coefficient.clone() };
            let factor = positive.show_factored(notation);
            match (power, factor.as_str()) {
                (0, factor) => text += factor,
                (power, "1") => text += &notation.power(symbol, power as u16),
                (power, factor) => {
                    text += &format!("{factor} {}", notation.power(symbol, power as u16));
                }
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// Shows the polynomial with the rational factor and the powers of symbols that all terms share before a bracket.
    pub fn show_factored(&self, notation: Notation) -> String {
        let Some((first, _)) = self.leading() else { return "0".to_owned() };
        let mut shared = *first;
        for monomial in self.terms.keys() {
            shared.0.iter_mut().zip(&monomial.0).for_each(|(a, b)| *a = (*a).min(*b));
        }
        let number = self.common_factor();
        let front = Self::term(shared, number);
        let rest = self.exact_quotient(&front).expect("a shared factor divides");
        if rest.len() == 1 {
            return self.show(notation);
        }
        let inner = format!("({})", rest.show(notation));
        match front.show(notation).as_str() {
            "1" => inner,
            front => format!("{front} {inner}"),
        }
    }

    /// The greatest rational number of which all coefficients are integer multiples, with the sign of
    /// the leading one.
    fn common_factor(&self) -> Rational {
        let parts = self.terms.values().map(|v| (v.numer().clone(), v.denom().clone()));
        let (numerator, denominator) = parts
            .reduce(|(n, d), (m, e)| (n.gcd(&m), d.lcm(&e)))
            .unwrap_or_else(|| (1.into(), 1.into()));
        let size = Rational::from((numerator, denominator)).abs();
        match self.leading() {
            Some((_, value)) if *value < 0 => -size,
            _ => size,
        }
    }
}

fn push_signed(text: &mut String, negative: bool) {
    *text += match (text.is_empty(), negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    };
}

impl Fraction {
    /// Numerator over denominator, or the numerator alone where nothing is divided.
    pub fn show(&self, notation: Notation) -> String {
        let numerator = self.numerator().show_factored(notation);
        if self.as_polynomial().is_some() {
            return self.numerator().show(notation);
        }
        let denominator = self.denominator().show_factored(notation);
        match notation {
            // A long numerator stays in the line, where it can be broken.
            Notation::Latex if self.numerator().len() > 4 => {
                format!("{numerator} \\big/ \\bigl[{denominator}\\bigr]")
            }
            Notation::Latex => format!("\\frac{{{numerator}}}{{{denominator}}}"),
            Notation::Text if self.denominator().len() == 1 && !denominator.contains(' ') => {
                format!("{numerator}/{denominator}")
            }
            Notation::Text => format!("{numerator} / [{denominator}]"),
        }
    }
}

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.show(Notation::Text))
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.show(Notation::Text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;
    use crate::symbolic::Letters;

    #[test]
    fn fractions_and_numbers() {
        let eta = Symbol::Thickness.number();
        let x = (eta.int(1) + &eta) / (eta.int(2) - &eta) / eta.int(3);
        assert_eq!(x.to_string(), "-1/3 (eta + 1) / [(eta - 2)]");
        assert_eq!((eta.ratio(2, 3) / &eta).to_string(), "2/3/eta");
        assert_eq!(eta.int(0).to_string(), "0");
        assert_eq!((eta.int(1) / &eta).show(Notation::Latex), r"\frac{1}{\eta}");
    }
}
