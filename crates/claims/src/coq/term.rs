//! Expressions: the number type that an equation is printed with.

use crate::number::{Angle, Field, operators};
use rug::Rational;
use std::fmt;
use std::rc::Rc;

/// A real expression in named variables.
///
/// An equation run over terms gives its own text, over [`crate::number::Dual`] terms that of its
/// derivatives. Terms simplify a little as they are built, so that the text stays as short as the
/// formula: constants are folded and pulled to the front of products, zeros and ones vanish, signs
/// move outwards.
///
/// ```
/// use couplet_check::arch::{Ring, SelfWeight};
/// use couplet_claims::coq::Term;
/// let ring = Ring::new(SelfWeight::Milankovitch, &Term::variable("eta"));
/// assert_eq!(ring.centroid_factor.to_string(), "1 + 1/12 * eta ^ 2");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Term(Rc<TermNode>);

#[derive(Debug, PartialEq)]
enum TermNode {
    Constant(Rational),
    Variable(&'static str),
    Sine(&'static str),
    Cosine(&'static str),
    Negation(Term),
    Sum(Term, Term),
    Difference(Term, Term),
    Product(Term, Term),
    Quotient(Term, Term),
    Square(Term),
}

use TermNode::*;

impl Term {
    /// A variable.
    pub fn variable(name: &'static str) -> Self {
        Self::new(Variable(name))
    }

    /// A variable that is an angle.
    pub fn angle(name: &'static str) -> Angle<Self> {
        Angle {
            rad: Self::variable(name),
            sin: Self::new(Sine(name)),
            cos: Self::new(Cosine(name)),
        }
    }

    /// A rational constant.
    pub fn constant(value: impl Into<Rational>) -> Self {
        Self::new(Constant(value.into()))
    }

    fn new(node: TermNode) -> Self {
        Self(Rc::new(node))
    }

    /// The value, where the term is a constant.
    pub fn as_constant(&self) -> Option<&Rational> {
        match &*self.0 {
            Constant(value) => Some(value),
            _ => None,
        }
    }

    fn is(&self, n: i32) -> bool {
        self.as_constant().is_some_and(|value| *value == n)
    }

    /// The value of the term in another number "like" `like`, where the variables have the values
    /// given; a variable that is no angle needs no sine and cosine.
    pub fn evaluate<T: Field>(&self, like: &T, value: &impl Fn(&'static str) -> Angle<T>) -> T {
        let of = |term: &Self| term.evaluate(like, value);
        match &*self.0 {
            Constant(constant) => rational(like, constant),
            Variable(name) => value(name).rad,
            Sine(name) => value(name).sin,
            Cosine(name) => value(name).cos,
            Negation(a) => -of(a),
            Sum(a, b) => of(a) + of(b),
            Difference(a, b) => of(a) - of(b),
            Product(a, b) => of(a) * of(b),
            Quotient(a, b) => of(a) / of(b),
            Square(a) => of(a).square(),
        }
    }

    /// A numerator and a denominator without quotients whose quotient is the term.
    pub fn fraction(&self) -> (Self, Self) {
        let one = || Self::constant(1);
        match &*self.0 {
            Constant(_) | Variable(_) | Sine(_) | Cosine(_) => (self.clone(), one()),
            Negation(a) => {
                let (n, d) = a.fraction();
                (-n, d)
            }
            Sum(a, b) => over_common(a, b, |a, b| a + b),
            Difference(a, b) => over_common(a, b, |a, b| a - b),
            Product(a, b) => {
                let ((n, d), (m, e)) = (a.fraction(), b.fraction());
                (n * m, d * e)
            }
            Quotient(a, b) => {
                let ((n, d), (m, e)) = (a.fraction(), b.fraction());
                (n * e, d * m)
            }
            Square(a) => {
                let (n, d) = a.fraction();
                (n.square(), d.square())
            }
        }
    }

    /// The term without its constant factor, and that factor.
    fn split(&self) -> (Rational, Self) {
        match &*self.0 {
            Constant(value) => (value.clone(), Self::constant(1)),
            Negation(a) => {
                let (factor, rest) = a.split();
                (-factor, rest)
            }
            Product(a, b) => match a.as_constant() {
                Some(factor) => (factor.clone(), b.clone()),
                None => (Rational::from(1), self.clone()),
            },
            _ => (Rational::from(1), self.clone()),
        }
    }

    /// A product with a constant factor.
    fn scaled(factor: Rational, rest: Self) -> Self {
        if factor == 0 || rest.is(1) {
            Self::constant(factor)
        } else if factor == 1 {
            rest
        } else if factor < 0 {
            Self::new(Negation(Self::scaled(-factor, rest)))
        } else {
            Self::new(Product(Self::constant(factor), rest))
        }
    }

    /// Strength with which the outermost operation binds, as Coq reads it.
    fn strength(&self) -> Strength {
        match &*self.0 {
            Sum(..) | Difference(..) => Strength::Sum,
            Product(..) | Quotient(..) => Strength::Product,
            Constant(value) if *value < 0 || !value.is_integer() => Strength::Product,
            Negation(_) => Strength::Product,
            Square(_) => Strength::Power,
            Sine(_) | Cosine(_) => Strength::Application,
            Constant(_) | Variable(_) => Strength::Atom,
        }
    }

    /// Writes the term, in parentheses if it binds less than `needed`.
    fn write(&self, f: &mut fmt::Formatter<'_>, needed: Strength) -> fmt::Result {
        if self.strength() < needed {
            f.write_str("(")?;
            self.write(f, Strength::Sum)?;
            return f.write_str(")");
        }
        let between = |f: &mut _, a: &Self, sign: &str, b: &Self, left, right| {
            a.write(f, left)?;
            f.write_str(sign)?;
            b.write(f, right)
        };
        match &*self.0 {
            Constant(value) => write!(f, "{value}"),
            Variable(name) => f.write_str(name),
            Sine(name) => write!(f, "sin {name}"),
            Cosine(name) => write!(f, "cos {name}"),
            Negation(a) => {
                f.write_str("- ")?;
                a.write(f, Strength::Power)
            }
            Sum(a, b) => between(f, a, " + ", b, Strength::Sum, Strength::Product),
            Difference(a, b) => between(f, a, " - ", b, Strength::Sum, Strength::Product),
            Product(a, b) => between(f, a, " * ", b, Strength::Product, Strength::Power),
            Quotient(a, b) => between(f, a, " / ", b, Strength::Product, Strength::Power),
            Square(a) => {
                a.write(f, Strength::Application)?;
                f.write_str(" ^ 2")
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Product,
    Power,
    Application,
    Atom,
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, Strength::Sum)
    }
}

fn over_common(a: &Term, b: &Term, join: impl Fn(Term, Term) -> Term) -> (Term, Term) {
    let ((n, d), (m, e)) = (a.fraction(), b.fraction());
    if d == e { (join(n, m), d) } else { (join(n * &e, m * &d), d * e) }
}

/// A rational number in another type, from integers of 15 bits.
fn rational<T: Field>(like: &T, value: &Rational) -> T {
    let integer = |n: &rug::Integer| {
        let digits = n.to_string_radix(32);
        let size = digits.trim_start_matches('-').chars();
        let size = size.fold(like.int(0), |sum, digit| {
            sum * like.int(32) + like.int(digit.to_digit(32).map_or(0, |d| d as i32))
        });
        if *n < 0 { -size } else { size }
    };
    if value.is_integer() {
        integer(value.numer())
    } else {
        integer(value.numer()) / integer(value.denom())
    }
}

impl Field for Term {
    fn int(&self, n: i32) -> Self {
        Self::constant(n)
    }

    fn square(&self) -> Self {
        match &*self.0 {
            Constant(value) => Self::constant(value.clone() * value),
            Negation(a) => a.square(),
            _ => Self::new(Square(self.clone())),
        }
    }
}

impl Term {
    fn negated(self) -> Self {
        match &*self.0 {
            Constant(value) => Self::constant(-value.clone()),
            Negation(a) => a.clone(),
            Difference(a, b) => b.clone() - a,
            _ => Self::new(Negation(self)),
        }
    }

    fn plus(self, other: &Self) -> Self {
        match (&*self.0, &*other.0) {
            (Constant(a), Constant(b)) => Self::constant(a.clone() + b),
            (Constant(zero), _) if *zero == 0 => other.clone(),
            (_, Constant(zero)) if *zero == 0 => self,
            (_, Constant(b)) if *b < 0 => self - Self::constant(-b.clone()),
            (_, Negation(b)) => self - b,
            (Negation(a), _) => other.clone() - a,
            _ => Self::new(Sum(self, other.clone())),
        }
    }

    fn minus(self, other: &Self) -> Self {
        match (&*self.0, &*other.0) {
            (Constant(a), Constant(b)) => Self::constant(a.clone() - b),
            (Constant(zero), _) if *zero == 0 => -other.clone(),
            (_, Constant(zero)) if *zero == 0 => self,
            (_, Constant(b)) if *b < 0 => self + Self::constant(-b.clone()),
            (_, Negation(b)) => self + b,
            (Negation(a), _) => -(a.clone() + other),
            _ => Self::new(Difference(self, other.clone())),
        }
    }

    fn times(self, other: &Self) -> Self {
        let ((a, x), (b, y)) = (self.split(), other.split());
        let rest = match (x.is(1), y.is(1)) {
            (true, _) => y,
            (_, true) => x,
            _ if x == y => x.square(),
            _ => Self::new(Product(x, y)),
        };
        Self::scaled(a * b, rest)
    }

    fn over(self, other: &Self) -> Self {
        match other.as_constant() {
            Some(divisor) if *divisor != 0 => {
                let (factor, rest) = self.split();
                Self::scaled(factor / divisor, rest)
            }
            _ if self.is(0) => self,
            _ => Self::new(Quotient(self, other.clone())),
        }
    }
}

operators!(Term);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Ring, SelfWeight, cubic, thrust};
    use crate::number::Dual;

    fn v(name: &'static str) -> Term {
        Term::variable(name)
    }

    #[test]
    fn parentheses_where_coq_needs_them() {
        let (x, y) = (v("x"), v("y"));
        let shown = |term: Term| term.to_string();
        assert_eq!(shown(x.clone() - (y.clone() - &x)), "x - (y - x)");
        assert_eq!(shown(x.clone() - &y - &x), "x - y - x");
        assert_eq!(shown((x.clone() + &y) * (x.clone() - &y)), "(x + y) * (x - y)");
        assert_eq!(shown(x.clone() * (y.clone() * &x)), "x * (y * x)");
        assert_eq!(shown(-(x.clone() * &y) * &y), "- (x * y * y)");
        assert_eq!(shown(x.clone() / (y.clone() / &x)), "x / (y / x)");
        assert_eq!(shown((x.clone() + &y).square()), "(x + y) ^ 2");
        let joint = Term::angle("x");
        assert_eq!(shown(joint.sin.square() * &joint.cos), "sin x ^ 2 * cos x");
    }

    #[test]
    fn constants_fold_and_come_first() {
        let (x, y) = (v("x"), v("y"));
        assert_eq!((x.clone() * x.int(2) * &y * x.ratio(3, 2)).to_string(), "3 * (x * y)");
        assert_eq!((x.clone() / x.int(2)).to_string(), "1/2 * x");
        assert_eq!((x.clone() * x.int(0) + x.int(1) * &y).to_string(), "y");
        assert_eq!((x.clone() + x.ratio(-1, 3)).to_string(), "x - 1/3");
        assert_eq!((x.clone() + (-y.clone())).to_string(), "x - y");
        assert_eq!((-(x.clone() - &y)).to_string(), "y - x");
        assert_eq!((x.int(0) - x.int(2) * &x).to_string(), "- (2 * x)");
    }

    #[test]
    fn a_term_and_its_derivative_have_the_values_of_the_equation() {
        let joint = Angle { rad: (7, 5).into(), sin: (3, 5).into(), cos: (4, 5).into() };
        let eta = Rational::from((3, 8));
        let weight = SelfWeight::Milankovitch;
        let term = thrust::lower(&Term::angle("b"), &Ring::new(weight, &v("e"))).value();
        let here = |name: &str| match name {
            "b" => joint.clone(),
            _ => Angle { rad: eta.clone(), ..Angle::zero(&eta) },
        };
        let direct = thrust::lower(&joint, &Ring::new(weight, &eta)).value();
        assert_eq!(term.evaluate(&eta, &here), direct);
        // The derivatives of the term as terms, against those of the equation as numbers.
        let dual = |name: &str| match name {
            "b" => Term::angle("b").variable(0),
            _ => Angle { rad: Dual::variable(v("e"), 1), ..Angle::zero(&Dual::constant(v("e"))) },
        };
        let slopes = term.evaluate(&Dual::constant(v("e")), &dual);
        let variable = Dual::variable(eta.clone(), 1);
        let numbers = thrust::lower(&joint.variable(0), &Ring::new(weight, &variable)).value();
        for index in 0..2 {
            let slope = slopes.derivative(index).evaluate(&eta, &here);
            assert_eq!(slope, numbers.derivative(index));
            assert_ne!(slope, numbers.derivative(1 - index), "false twin");
        }
    }

    #[test]
    fn a_fraction_has_no_quotients_and_the_same_value() {
        let joint = Term::angle("b");
        let term = (joint.times_cotangent() + v("e")) / (v("e") - &joint.cos);
        let (numerator, denominator) = term.fraction();
        assert!(!numerator.to_string().contains(" / ") && !denominator.to_string().contains(" / "));
        let at = Angle { rad: Rational::from((7, 5)), sin: (3, 5).into(), cos: (4, 5).into() };
        let here = |name: &str| match name {
            "b" => at.clone(),
            _ => Angle { rad: (2, 3).into(), ..Angle::zero(&at.rad) },
        };
        let of = |term: &Term| term.evaluate(&at.rad, &here);
        assert_eq!(of(&term), of(&numerator) / of(&denominator));
    }

    #[test]
    fn large_constants_survive_evaluation() {
        let large = Rational::from((-123_456_789_012_345_i64, 7));
        let none = |_: &str| unreachable!();
        assert_eq!(Term::constant(large.clone()).evaluate(&Rational::new(), &none), large);
    }

    #[test]
    fn the_radicand_prints_as_in_the_paper() {
        let radicand =
            cubic::radicand(&cubic::abbreviations(&Term::angle("b")), &Term::constant(0))
                .to_string();
        assert!(radicand.starts_with("- (3 * ("), "{radicand}");
    }
}
