//! Truncated power series in one variable, with exact coefficients.

use crate::number::{Dual, ExactField, Field};

/// `c_0 x^s + c_1 x^(s+1) + … + O(x^n)`: finitely many exact coefficients, and the order `n` from which
/// on nothing is known.
///
/// A field as far as it is known: a quotient loses as many terms as the divisor begins with zeros, and
/// may begin with a negative power. Division by a series of which no coefficient is known to differ from
/// zero panics. The equations of `arch` evaluate over it. What is not known is never shown: an operation
/// keeps the smaller order.
///
/// ```
/// use couplet_number::number::Field;
/// use couplet_number::symbolic::Series;
/// use rug::Rational;
/// let x = Series::variable(&Rational::new(), 4);
/// let geometric = x.int(1) / (x.int(1) - &x);
/// assert_eq!(geometric.coefficients(0), vec![1, 1, 1, 1]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Series<T> {
    /// The power of the first coefficient.
    start: i32,
    terms: Vec<T>,
    /// Number of terms that a constant is given.
    length: usize,
    zero: T,
}

impl<T: ExactField> Series<T> {
    /// The variable `x`, for work with `length` terms.
    pub fn variable(like: &T, length: usize) -> Self {
        Self::new(like, vec![like.int(0), like.int(1)], length)
    }

    /// The polynomial with the coefficients given, constant first, for work with `length` terms.
    pub fn new(like: &T, mut coefficients: Vec<T>, length: usize) -> Self {
        coefficients.resize(length, like.int(0));
        Self { start: 0, terms: coefficients, length, zero: like.int(0) }
    }

    /// `sin(x)/x` and `cos(x)` as series in `x²`.
    pub fn sine_quotient_and_cosine(like: &T, length: usize) -> (Self, Self) {
        // The coefficient of x^(2n) is (-1)^n / (2n)! for the cosine, / (2n+1)! for the quotient.
        let next = |last: &T, k: i32| -(last.clone() / like.int(k * (k + 1)));
        let (mut cosine, mut quotient) = (vec![like.int(1)], vec![like.int(1)]);
        for n in 1..length as i32 {
            cosine.push(next(&cosine[n as usize - 1], 2 * n - 1));
            quotient.push(next(&quotient[n as usize - 1], 2 * n));
        }
        (Self::new(like, quotient, length), Self::new(like, cosine, length))
    }

    /// Number of terms of a constant.
    pub fn length(&self) -> usize {
        self.length
    }

    /// The power from which on nothing is known.
    pub fn order(&self) -> i32 {
        self.start + self.terms.len() as i32
    }

    /// The power of the first coefficient that is not zero; the order, if all known ones are.
    pub fn valuation(&self) -> i32 {
        self.start + self.leading_zeros() as i32
    }

    fn leading_zeros(&self) -> usize {
        self.terms.iter().take_while(|c| c.is_zero()).count()
    }

    /// The known coefficients from the power `from` on, which must not be beyond the order.
    pub fn coefficients(&self, from: i32) -> Vec<T> {
        (from..self.order()).map(|power| self.coefficient(power)).collect()
    }

    /// The coefficient of a power below the order.
    ///
    /// # Panics
    /// If it is not known.
    pub fn coefficient(&self, power: i32) -> T {
        assert!(power < self.order(), "the coefficient of power {power} is not known");
        usize::try_from(power - self.start)
            .ok()
            .map_or_else(|| self.zero.clone(), |place| self.terms[place].clone())
    }

    /// Part of the series that is known below the power `order`.
    pub fn truncated(mut self, order: i32) -> Self {
        self.terms.truncate(usize::try_from(order - self.start).unwrap_or(0));
        self.start = self.start.min(order);
        self
    }

    fn trimmed(&self) -> Self {
        let zeros = self.leading_zeros();
        Self {
            start: self.start + zeros as i32,
            terms: self.terms[zeros..].to_vec(),
            ..self.clone()
        }
    }

    /// Series completed with zeros for what is not known: a guess, not a value.
    fn completed(mut self) -> Self {
        let missing = self.length as i32 - self.order();
        self.terms.resize(self.terms.len() + missing.max(0) as usize, self.zero.clone());
        self
    }

    /// Composes this series, which must have no negative powers, with `inner`, which must begin with a
    /// positive power, in place of the variable.
    pub fn compose(&self, inner: &Self) -> Self {
        let step = inner.valuation();
        assert!(step > 0 && self.start >= 0, "only a small series can be put into a power series");
        let sum = (0..self.order()).rev().fold(inner.int(0), |sum, power| {
            let mut constant = inner.int(0);
            constant.terms[0] = self.coefficient(power);
            sum * inner + constant
        });
        sum.truncated(self.order() * step)
    }

    /// The series `r` with `self(r(x)) = x`, for a series that begins with the first power: Lagrange's
    /// formula, in which the coefficient of `x^n` in `r` is that of `x^(n-1)` in `(x/self)^n`, over `n`.
    pub fn reversion(&self) -> Self {
        assert!(
            self.valuation() == 1,
            "only a series that begins with the first power has an inverse"
        );
        let quotient = Self::variable(&self.zero, self.length) / self;
        let mut power = self.int(1);
        let mut terms = vec![self.zero.clone()];
        for n in 1..self.order() {
            power = power * &quotient;
            terms.push(power.coefficient(n - 1) / self.zero.int(n));
        }
        Self { start: 0, terms, ..self.clone() }
    }

    /// The root of `f` that begins as `guess` does, by Newton's method; `None` if it does not settle.
    ///
    /// The answer is kept as far as it is proved: where `f = O(x^n)` and `f'` begins with `x^v`, a
    /// root differs by `O(x^(n-v))` if `n > 2v` (Hensel's lemma).
    pub fn root(guess: Self, f: impl Fn(&Dual<Self>) -> Dual<Self>) -> Option<Self> {
        let mut y = guess.completed();
        // Each step doubles the known terms; one more sees that nothing is left.
        for _ in 0..y.length.ilog2() + 3 {
            let value = f(&Dual::variable(y.clone(), 0));
            let (residual, slope) = (value.value().clone(), value.derivative(0));
            let (n, v) = (residual.valuation(), slope.valuation());
            if n > 2 * v && n == residual.order() {
                return Some(y.truncated(n - v));
            }
            if v == slope.order() {
                return None;
            }
            y = (y - residual / &slope).completed();
        }
        None
    }
}

impl<T: ExactField + ToString> Series<T> {
    /// The known terms, lowest first, in a variable called `name`, and the order.
    pub fn show(&self, name: &str) -> String {
        let power = |n: i32| match n {
            0 => String::new(),
            1 => format!(" {name}"),
            n => format!(" {name}^{n}"),
        };
        let known = (self.start..self.order()).filter(|n| !self.coefficient(*n).is_zero());
        let shown = known.map(|n| match (self.coefficient(n).to_string(), n) {
            (value, n) if n != 0 && is_sum(&value) => format!("({value}){}", power(n)),
            (value, n) => format!("{value}{}", power(n)),
        });
        let order = format!("O({})", power(self.order()).trim());
        shown.chain([order]).collect::<Vec<_>>().join(" + ").replace("+ -", "- ")
    }
}

/// Tells whether a text has a sign outside brackets and after its beginning.
fn is_sum(text: &str) -> bool {
    let mut depth = 0;
    text.chars().enumerate().any(|(place, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0 && place > 0 && matches!(c, '+' | '-' | '−')
    })
}

impl<T: ExactField> Field for Series<T> {
    fn int(&self, n: i32) -> Self {
        Self::new(&self.zero, vec![self.zero.int(n)], self.length)
    }
}

impl<T: ExactField> Series<T> {
    fn combine(&self, other: &Self, sum: impl Fn(T, &T) -> T) -> Self {
        let (start, order) = (self.start.min(other.start), self.order().min(other.order()));
        let terms =
            (start..order).map(|power| sum(self.coefficient(power), &other.coefficient(power)));
        Self { start, terms: terms.collect(), ..self.clone() }
    }

    fn negated(mut self) -> Self {
        self.terms = self.terms.into_iter().map(|c| -c).collect();
        self
    }

    fn plus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a + b)
    }

    fn minus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a - b)
    }

    fn times(self, other: &Self) -> Self {
        let (a, b) = (self.trimmed(), other.trimmed());
        let count = a.terms.len().min(b.terms.len());
        let term = |n: usize| {
            (0..=n).fold(self.zero.clone(), |sum, i| sum + a.terms[i].clone() * &b.terms[n - i])
        };
        Self { start: a.start + b.start, terms: (0..count).map(term).collect(), ..self }
    }

    /// Division by a series of which no coefficient is known to differ from zero panics.
    fn over(self, other: &Self) -> Self {
        let (a, b) = (self.trimmed(), other.trimmed());
        assert!(!b.terms.is_empty(), "division by zero");
        let count = a.terms.len().min(b.terms.len());
        let mut terms: Vec<T> = Vec::with_capacity(count);
        for n in 0..count {
            let known = (0..n)
                .fold(a.terms[n].clone(), |rest, i| rest - terms[i].clone() * &b.terms[n - i]);
            terms.push(known / &b.terms[0]);
        }
        Self { start: a.start - b.start, terms, ..self }
    }
}

operators!([T: ExactField] Series<T>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::Rational;

    fn series() -> impl Strategy<Value = Series<Rational>> {
        (prop::collection::vec((-5i32..6, 1i32..4), 1..6)).prop_map(|coefficients| {
            let terms = coefficients.into_iter().map(Rational::from).collect();
            Series::new(&Rational::new(), terms, 8)
        })
    }

    proptest! {
        #![proptest_config(config(100))]

        #[test]
        fn products_and_quotients_agree(a in series(), b in series()) {
            if b.valuation() < b.order() {
                let back = a.clone() / &b * &b;
                for power in 0..back.order() {
                    prop_assert_eq!(back.coefficient(power), a.coefficient(power));
                }
                prop_assert!(back.order() >= 8 - b.valuation() - a.valuation().max(0) || a.valuation() == 8);
            }
        }

        #[test]
        fn composition_is_a_homomorphism(a in series(), b in series(), c in series()) {
            let inner = c * &Series::variable(&Rational::new(), 8);
            prop_assume!(inner.valuation() < 8);
            let (left, right) = ((a.clone() * &b).compose(&inner), a.compose(&inner) * b.compose(&inner));
            for power in 0..left.order().min(right.order()) {
                prop_assert_eq!(left.coefficient(power), right.coefficient(power));
            }
        }
    }

    #[test]
    fn sine_and_cosine_lie_on_the_circle() {
        let (quotient, cosine) = Series::sine_quotient_and_cosine(&Rational::new(), 7);
        let x2 = Series::variable(&Rational::new(), 7);
        let circle = quotient.square() * x2 + cosine.square();
        assert_eq!(circle.coefficients(0), vec![1, 0, 0, 0, 0, 0, 0]);
        assert_eq!(quotient.coefficient(2), Rational::from((1, 120)));
    }

    #[test]
    fn a_reversion_undoes() {
        let x = Series::variable(&Rational::new(), 8);
        let f = x.int(3) * &x - x.square() / x.int(7) + x.square().square();
        let back = f.compose(&f.reversion());
        assert_eq!(back.coefficients(0), x.coefficients(0)[..back.order() as usize]);
        assert!(back.order() >= 7);
        // sin and its inverse: x + x³/6 + 3x⁵/40.
        let (quotient, _) = Series::sine_quotient_and_cosine(&Rational::new(), 4);
        let sine = quotient.compose(&x.square()) * &x;
        let arcsine = sine.reversion();
        assert_eq!(arcsine.coefficient(5), Rational::from((3, 40)));
    }

    #[test]
    fn a_square_root_is_found_to_the_order_known() {
        let x = Series::variable(&Rational::new(), 5);
        let inside = x.int(1) + &x;
        let root = Series::root(x.int(1), |y| y.square() - Dual::constant(inside.clone())).unwrap();
        let expected = [(1, 1), (1, 2), (-1, 8), (1, 16), (-5, 128)].map(Rational::from);
        assert_eq!(root.coefficients(0), expected);
        // A double root at x = 0: no guess settles, so there is no answer.
        assert!(Series::root(x.int(0), |y| y.square() - Dual::constant(x.clone())).is_none());
    }
}
