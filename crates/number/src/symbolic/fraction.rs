//! Quotients of polynomials: the number over which the equations of the paper become formulas.

use super::{Polynomial, Relations, Symbol};
use crate::number::{ExactField, Field};
use rug::Rational;

/// A quotient of two polynomials, in lowest terms; the denominator has leading coefficient one.
///
/// Division by zero panics. As the representation is unique, two fractions are equal exactly when they
/// look alike. That is equality of rational functions of free indeterminates; what sine and cosine know of
/// each other is brought in by [`Fraction::vanishes`].
///
/// ```
/// use couplet_number::number::Field;
/// use couplet_number::symbolic::{Letters, Relations, Symbol};
/// // Zero because S² + C² = 1, and not without.
/// let joint = Symbol::joint();
/// let circle = joint.sin.square() + joint.cos.square() - joint.sin.int(1);
/// assert!(circle.vanishes(&Relations::trigonometric()));
/// assert!(!circle.vanishes(&Relations::none()));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl Fraction {
    /// `numerator / denominator`, reduced.
    ///
    /// # Panics
    /// If the denominator is the zero polynomial.
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Self {
        let common = match denominator.as_constant() {
            Some(_) => Polynomial::from(1),
            None => numerator.common_divisor(&denominator),
        };
        let (numerator, denominator) = match common.as_constant() {
            Some(_) => (numerator, denominator),
            None => (
                numerator.exact_quotient(&common).expect("a common divisor divides"),
                denominator.exact_quotient(&common).expect("a common divisor divides"),
            ),
        };
        let (_, head) = denominator.leading().expect("a denominator is not zero");
        let factor = head.clone().recip();
        Self { numerator: numerator.scaled(&factor), denominator: denominator.scaled(&factor) }
    }

    /// The numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// The fraction as a polynomial, if its denominator is a constant.
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.as_constant().map(|_| &self.numerator)
    }

    /// Tells whether the fraction is zero wherever the relations hold and the denominator does not vanish:
    /// the normal form of the numerator is zero.
    pub fn vanishes(&self, relations: &Relations) -> bool {
        relations.normal_form(&self.numerator).is_zero()
    }

    /// The fraction with numerator and denominator in normal form.
    ///
    /// # Panics
    /// If the denominator vanishes under the relations.
    pub fn reduced(&self, relations: &Relations) -> Self {
        Self::new(relations.normal_form(&self.numerator), relations.normal_form(&self.denominator))
    }

    /// The partial derivative: every other symbol is kept.
    pub fn partial(&self, symbol: Symbol) -> Self {
        self.derivative(&[(symbol, Polynomial::from(1))])
    }

    /// The derivation of [`Polynomial::derivative`], by the quotient rule.
    pub fn derivative(&self, rules: &[(Symbol, Polynomial)]) -> Self {
        let d = |p: &Polynomial| Self::from(p.derivative(rules));
        let (n, m) = (Self::from(self.numerator.clone()), Self::from(self.denominator.clone()));
        (d(&self.numerator) * &m - d(&self.denominator) * &n) / m.square()
    }

    /// The fraction with another number in place of each symbol. Where the denominator vanishes there the
    /// answer is that of the number's own division by zero.
    pub fn evaluate<T: Field>(&self, like: &T, value: impl Fn(Symbol) -> T) -> T {
        self.numerator.evaluate(like, &value) / self.denominator.evaluate(like, &value)
    }
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::from(1) }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        Self::from(Polynomial::constant(value))
    }
}

impl Field for Fraction {
    fn int(&self, n: i32) -> Self {
        Self::from(Polynomial::from(n))
    }
}

impl ExactField for Fraction {
    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl Fraction {
    fn combine(&self, other: &Self, sum: impl Fn(&Polynomial, &Polynomial) -> Polynomial) -> Self {
        if self.denominator == other.denominator {
            let numerator = sum(&self.numerator, &other.numerator);
            return Self::new(numerator, self.denominator.clone());
        }
        let left = &self.numerator * &other.denominator;
        let right = &other.numerator * &self.denominator;
        Self::new(sum(&left, &right), &self.denominator * &other.denominator)
    }

    fn negated(self) -> Self {
        Self { numerator: -self.numerator, denominator: self.denominator }
    }

    fn plus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a + b)
    }

    fn minus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a - b)
    }

    fn times(self, other: &Self) -> Self {
        Self::new(&self.numerator * &other.numerator, &self.denominator * &other.denominator)
    }

    /// Division by zero panics, as it does for a rational number.
    fn over(self, other: &Self) -> Self {
        Self::new(&self.numerator * &other.denominator, &self.denominator * &other.numerator)
    }
}

operators!(Fraction);

#[cfg(test)]
mod tests {
    use super::super::polynomial::strategies::{nonzero, polynomial};
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;

    fn fraction() -> impl Strategy<Value = Fraction> {
        (polynomial(), nonzero()).prop_map(|(a, b)| Fraction::new(a, b))
    }

    proptest! {
        #![proptest_config(config(40))]

        #[test]
        fn field_axioms(a in fraction(), b in fraction(), c in fraction()) {
            prop_assert_eq!(a.clone() + &b, b.clone() + &a);
            prop_assert_eq!((a.clone() * &b) * &c, a.clone() * (b.clone() * &c));
            prop_assert_eq!(a.clone() * (b.clone() + &c), a.clone() * &b + a.clone() * &c);
            prop_assert!((a.clone() - &a).is_zero());
            if !b.is_zero() {
                prop_assert_eq!(a.clone() / &b * &b, a.clone());
                prop_assert_eq!(b.clone() / &b, b.int(1));
            }
        }

        #[test]
        fn evaluation_is_a_homomorphism(a in fraction(), b in fraction()) {
            let point = |s: Symbol| Rational::from((3 * s as i32 + 1, 11));
            let at = |x: &Fraction| {
                let denominator = x.denominator().evaluate(&Rational::new(), point);
                (denominator != 0).then(|| x.evaluate(&Rational::new(), point))
            };
            if let (Some(x), Some(y)) = (at(&a), at(&b)) {
                prop_assert_eq!(at(&(a.clone() + &b)), Some(Rational::from(&x + &y)));
                prop_assert_eq!(at(&(a * &b)), Some(x * y));
            }
        }
    }
}
