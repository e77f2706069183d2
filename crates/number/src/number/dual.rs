//! Dual numbers: a value with its gradient. Nobody types a derivative.

use super::{Derivatives, Field, Real};

/// A value and its partial derivatives. A missing derivative is exactly zero and costs nothing,
/// so the gradient of an equation that sees three of six unknowns has three entries.
///
/// ```
/// use couplet_number::number::{Dual, Field};
/// let x = Dual::variable(3.0, 0);
/// let square = x.square() + x.int(1);
/// assert_eq!((*square.value(), square.derivative(0)), (10.0, 6.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Dual<T> {
    value: T,
    gradient: Vec<Option<T>>,
}

impl<T: Field> Dual<T> {
    /// A constant.
    pub fn constant(value: T) -> Self {
        Self { value, gradient: Vec::new() }
    }

    /// Unknown number `index`.
    pub fn variable(value: T, index: usize) -> Self {
        let one = value.int(1);
        Self::with_derivative(value, index, one)
    }

    /// Variables: each value as an unknown, numbered in order.
    pub fn variables(values: &[T]) -> Vec<Self> {
        let values = values.iter().enumerate();
        values.map(|(index, value)| Self::variable(value.clone(), index)).collect()
    }

    /// A value whose only non-zero derivative, to unknown `index`, is `derivative`.
    pub fn with_derivative(value: T, index: usize, derivative: T) -> Self {
        let mut gradient = vec![None; index];
        gradient.push(Some(derivative));
        Self { value, gradient }
    }

    /// A value with all its derivatives.
    pub fn new(value: T, gradient: Vec<T>) -> Self {
        Self { value, gradient: gradient.into_iter().map(Some).collect() }
    }

    /// The value.
    pub fn value(&self) -> &T {
        &self.value
    }

    /// The derivative to unknown `index`.
    pub fn derivative(&self, index: usize) -> T {
        self.slope(index).cloned().unwrap_or_else(|| self.value.int(0))
    }

    /// The dual number with `value` and the gradient of `self` scaled by `factor`.
    pub(super) fn chain(&self, value: T, factor: &T) -> Self {
        let gradient = self.gradient.iter().map(|g| g.clone().map(|g| g * factor)).collect();
        Self { value, gradient }
    }

    /// The gradient `left(self') + right(other')`, in the place of that of `self`. One piece of code for all operators.
    fn combine(
        mut gradient: Vec<Option<T>>,
        other: &Self,
        left: &dyn Fn(T) -> T,
        right: &dyn Fn(&T) -> T,
    ) -> Vec<Option<T>> {
        gradient.resize(gradient.len().max(other.gradient.len()), None);
        for (index, slope) in gradient.iter_mut().enumerate() {
            *slope = match (slope.take(), other.slope(index)) {
                (None, None) => None,
                (Some(a), None) => Some(left(a)),
                (None, Some(b)) => Some(right(b)),
                (Some(a), Some(b)) => Some(left(a) + right(b)),
            };
        }
        gradient
    }
}

/// The value and the gradient of a function of some numbers.
///
/// ```
/// use couplet_number::number::{Field, gradient};
/// let (value, slopes) = gradient(&[3.0, 2.0], |x| x[0].square() * &x[1]);
/// assert_eq!((value, slopes), (18.0, vec![12.0, 9.0]));
/// ```
pub fn gradient<T: Field>(at: &[T], f: impl FnOnce(&[Dual<T>]) -> Dual<T>) -> (T, Vec<T>) {
    let found = f(&Dual::variables(at));
    let slopes = (0..at.len()).map(|index| found.derivative(index)).collect();
    (found.value, slopes)
}

impl<T> Dual<T> {
    /// The value and its derivatives in another number.
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Dual<U> {
        let gradient = self.gradient.into_iter().map(|slope| slope.map(&f)).collect();
        Dual { value: f(self.value), gradient }
    }
}

impl<T> Derivatives<T> for Dual<T> {
    fn slope(&self, index: usize) -> Option<&T> {
        self.gradient.get(index).and_then(Option::as_ref)
    }
}

impl<T: Field> Field for Dual<T> {
    fn int(&self, n: i32) -> Self {
        Self::constant(self.value.int(n))
    }

    fn square(&self) -> Self {
        self.chain(self.value.square(), &(self.value.int(2) * &self.value))
    }
}

impl<T: Real> Real for Dual<T> {
    fn pi(&self) -> Self {
        Self::constant(self.value.pi())
    }

    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        let slope = root.ratio(1, 2) / &root;
        self.chain(root, &slope)
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin.clone(), &cos), self.chain(cos, &-sin))
    }
}

impl<T: Field> Dual<T> {
    fn negated(self) -> Self {
        let gradient = self.gradient.into_iter().map(|g| g.map(|g| -g)).collect();
        Self { value: -self.value, gradient }
    }

    fn plus(self, other: &Self) -> Self {
        let gradient = Self::combine(self.gradient, other, &|a| a, &T::clone);
        Self { value: self.value + &other.value, gradient }
    }

    fn minus(self, other: &Self) -> Self {
        let gradient = Self::combine(self.gradient, other, &|a| a, &|b| -b.clone());
        Self { value: self.value - &other.value, gradient }
    }

    fn times(self, other: &Self) -> Self {
        let (value, slopes) = (self.value, self.gradient);
        let gradient = Self::combine(slopes, other, &|a| a * &other.value, &|b| b.clone() * &value);
        Self { value: value * &other.value, gradient }
    }

    /// `q = a/b` has `q' = (a' - q b')/b`.
    fn over(self, other: &Self) -> Self {
        let quotient = self.value / &other.value;
        let gradient = Self::combine(self.gradient, other, &|a| a / &other.value, &|b| {
            -(b.clone() * &quotient / &other.value)
        });
        Self { value: quotient, gradient }
    }
}

operators!([T: Field] Dual<T>);

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    #[test]
    fn derivatives_of_a_quotient_are_exact() {
        let x = Dual::variable(Rational::from((2, 3)), 0);
        let y = Dual::variable(Rational::from(5), 1);
        let q = (x.clone() * &y - x.int(1)) / y.square();
        // d/dx = 1/y, d/dy = (2 - x y) / y^3
        assert_eq!(q.derivative(0), Rational::from((1, 5)));
        assert_eq!(q.derivative(1), Rational::from((-4, 375)));
        assert_eq!(q.derivative(2), Rational::new());
    }

    #[test]
    fn a_gradient_has_an_entry_for_each_number() {
        let at = [(2, 3), (5, 1), (7, 1)].map(Rational::from);
        let (value, slopes) = gradient(&at, |x| x[0].clone() * &x[1]);
        assert_eq!(value, Rational::from((10, 3)));
        assert_eq!(slopes, [(5, 1), (2, 3), (0, 1)].map(Rational::from));
    }

    #[test]
    fn nesting_gives_second_derivatives() {
        let inner = Dual::variable(Rational::from(3), 0);
        let x = Dual::variable(inner, 0);
        let cube = x.square() * &x;
        assert_eq!(cube.derivative(0).derivative(0), Rational::from(18));
    }
}
