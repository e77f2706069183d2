//! Exact numbers `a + b√d` with rational `a`, `b`: where the closed-form landmark values live.

use super::{Ball, ExactField, Field, Real};
use rug::{Integer, Rational};
use std::fmt;

/// `rational + factor * √radicand`, exactly. The radicand is a positive integer that is not a
/// square; numbers of different radicands cannot meet unless one of them is rational. Division by zero
/// panics.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Surd {
    rational: Rational,
    factor: Rational,
    radicand: u32,
}

impl Surd {
    /// `rational + factor * √radicand`.
    ///
    /// # Panics
    /// If the radicand is a perfect square (zero and one included): the representation would not
    /// be unique and a zero would not be recognised.
    pub fn new(rational: impl Into<Rational>, factor: impl Into<Rational>, radicand: u32) -> Self {
        assert!(radicand.isqrt().pow(2) != radicand, "the radicand must not be a square");
        Self { rational: rational.into(), factor: factor.into(), radicand }
    }

    /// The rational number `value`, able to meet multiples of `√radicand`.
    pub fn rational(value: impl Into<Rational>, radicand: u32) -> Self {
        Self::new(value, 0, radicand)
    }

    /// The rational part, the factor of the root, and the radicand.
    pub fn parts(&self) -> (&Rational, &Rational, u32) {
        (&self.rational, &self.factor, self.radicand)
    }

    /// A ball of `prec` bits that holds it.
    pub fn enclosure(&self, prec: u32) -> Ball {
        let root = Ball::from_integer(&Integer::from(self.radicand), prec).sqrt();
        Ball::enclosing(&self.rational, prec) + Ball::enclosing(&self.factor, prec) * root
    }

    fn map2(self, other: &Self, f: impl Fn(&Rational, &Rational) -> Rational) -> Self {
        self.meets(other);
        Self {
            rational: f(&self.rational, &other.rational),
            factor: f(&self.factor, &other.factor),
            radicand: self.radicand,
        }
    }

    fn meets(&self, other: &Self) {
        assert_eq!(self.radicand, other.radicand, "two different quadratic fields");
    }
}

impl Field for Surd {
    fn int(&self, n: i32) -> Self {
        Self { rational: Rational::from(n), factor: Rational::new(), radicand: self.radicand }
    }
}

impl ExactField for Surd {
    fn is_zero(&self) -> bool {
        self.rational.is_zero() && self.factor.is_zero()
    }
}

impl Surd {
    fn negated(self) -> Self {
        Self { rational: -self.rational, factor: -self.factor, radicand: self.radicand }
    }

    fn plus(self, other: &Self) -> Self {
        self.map2(other, |x, y| Rational::from(x + y))
    }

    fn minus(self, other: &Self) -> Self {
        self.map2(other, |x, y| Rational::from(x - y))
    }

    fn times(self, other: &Self) -> Self {
        self.meets(other);
        let roots = Rational::from(&self.factor * &other.factor) * self.radicand;
        Self {
            rational: Rational::from(&self.rational * &other.rational) + roots,
            factor: Rational::from(&self.rational * &other.factor)
                + Rational::from(&self.factor * &other.rational),
            radicand: self.radicand,
        }
    }

    /// Division by zero panics, as it does for a rational number.
    fn over(self, other: &Self) -> Self {
        self.meets(other);
        let conjugate = Self { factor: -other.factor.clone(), ..other.clone() };
        let norm = (other.clone() * &conjugate).rational;
        let product = self * &conjugate;
        Self {
            rational: product.rational / &norm,
            factor: product.factor / norm,
            radicand: product.radicand,
        }
    }
}

operators!(Surd);

impl fmt::Display for Surd {
    /// Writes the number as a mathematician would write it: `2/3`, `√3−1`, `2(2√3−3)`, a positive term first
    /// and a common factor before the bracket. The minus inside is the typographic one.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.factor.is_zero() {
            return write!(f, "{}", self.rational);
        }
        let root = |factor: &Rational| match *factor == 1 {
            true => format!("√{}", self.radicand),
            false => format!("{factor}√{}", self.radicand),
        };
        if self.rational.is_zero() {
            return match self.factor < 0 {
                true => write!(f, "−{}", root(&self.factor.clone().abs())),
                false => write!(f, "{}", root(&self.factor)),
            };
        }
        // The greatest number of which both parts are integer multiples.
        let common = Rational::from((
            self.rational.numer().clone().gcd(self.factor.numer()),
            self.rational.denom().clone().lcm(self.factor.denom()),
        ));
        let (rational, factor) =
            (Rational::from(&self.rational / &common), Rational::from(&self.factor / &common));
        let (plain, rooted) = (rational.clone().abs().to_string(), root(&factor.clone().abs()));
        let inner = match (rational < 0, factor < 0) {
            (false, false) => format!("{plain}+{rooted}"),
            (false, true) => format!("{plain}−{rooted}"),
            (true, false) => format!("{rooted}−{plain}"),
            (true, true) => format!("−{plain}−{rooted}"),
        };
        if common == 1 { f.write_str(&inner) } else { write!(f, "{common}({inner})") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_is_exact() {
        let root = Surd::new(0, 1, 3);
        assert_eq!(root.square(), root.int(3));
        let x = Surd::new(-6, 4, 3);
        assert!((x.clone() / &x - x.int(1)).is_zero());
        assert!(!(x.square() - x.int(1)).is_zero(), "and a false twin is seen");
        assert_eq!(x.to_string(), "2(2√3−3)");
        assert_eq!(Surd::new(-1, 1, 3).to_string(), "√3−1");
        assert_eq!(Surd::rational((2, 3), 3).to_string(), "2/3");
        assert_eq!((-root).to_string(), "−√3");
    }

    #[test]
    #[should_panic(expected = "must not be a square")]
    fn a_square_radicand_is_refused() {
        Surd::new(1, 1, 4);
    }
}
