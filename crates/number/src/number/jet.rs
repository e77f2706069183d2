//! Jets: a function of one variable by the first terms of its Taylor series.

use super::{Field, Real, Stumpff};

/// The coefficients of `1, t, t², …` up to an order; what is missing at the end is exactly zero.
///
/// Over enclosures the coefficients of a jet about a set hold those about each of its points, so that the
/// last one of a jet about `X` bounds what Taylor's theorem leaves over all of `X`.
///
/// ```
/// use couplet_number::number::{Field, Jet};
/// let x = Jet::new(vec![2.0, 1.0], 3);
/// let inverse = x.int(1) / &x;
/// assert_eq!(inverse.coefficients(), [0.5, -0.25, 0.125, -0.0625]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Jet<T> {
    coefficients: Vec<T>,
    order: usize,
}

impl<T: Field> Jet<T> {
    /// A function from its coefficients, at least one of them, known up to `order`.
    pub fn new(mut coefficients: Vec<T>, order: usize) -> Self {
        coefficients.truncate(order + 1);
        Self { coefficients, order }
    }

    /// A constant, in jets of an order.
    pub fn constant(value: T, order: usize) -> Self {
        Self { coefficients: vec![value], order }
    }

    /// The coefficients, without zeros that are known to be so at the end.
    pub fn coefficients(&self) -> &[T] {
        &self.coefficients
    }

    /// The value.
    pub fn value(&self) -> &T {
        &self.coefficients[0]
    }

    /// The coefficient of `t^k`.
    pub fn coefficient(&self, k: usize) -> T {
        self.coefficients.get(k).cloned().unwrap_or_else(|| self.value().int(0))
    }

    /// The polynomial of its coefficients at `t`.
    pub fn at(&self, t: &T) -> T {
        self.coefficients.iter().rev().fold(t.int(0), |sum, term| sum * t + term)
    }

    /// The coefficients up to the longer of two jets, each from the pair at its place.
    fn combine(&self, other: &Self, both: impl Fn(&T, &T) -> T, right: impl Fn(&T) -> T) -> Self {
        let count = self.coefficients.len().max(other.coefficients.len());
        let at = |k: usize| match (self.coefficients.get(k), other.coefficients.get(k)) {
            (Some(a), Some(b)) => both(a, b),
            (Some(a), None) => a.clone(),
            (None, b) => right(b.unwrap_or_else(|| self.value())),
        };
        Self { coefficients: (0..count).map(at).collect(), order: self.order.max(other.order) }
    }

    /// `sum of a_j b_(k-j)` over `first <= j <= last`, where both are known not to be zero.
    fn convolution(a: &[T], b: &[T], k: usize, first: usize, last: usize) -> Option<T> {
        let product = |j: usize| Some(a.get(j)?.clone() * b.get(k.checked_sub(j)?)?);
        (first..=last).filter_map(product).reduce(|sum, term| sum + term)
    }

    /// `sum of j a_j b_(k-j) / k`, the coefficient of `t^k` in the integral of `a' b`.
    fn integrated(a: &[T], b: &[T], k: usize) -> T {
        let product = |j: usize| Some(a[j].int(j as i32) * &a[j] * b.get(k - j)?);
        let terms = (1..=k.min(a.len() - 1)).filter_map(product);
        let sum = terms.fold(a[0].int(0), |sum, term| sum + term);
        sum / a[0].int(k as i32)
    }

    /// The length of what a transcendental function makes of the jet.
    fn length(&self) -> usize {
        if self.coefficients.len() == 1 { 1 } else { self.order + 1 }
    }
}

impl<T: Field> Field for Jet<T> {
    fn int(&self, n: i32) -> Self {
        Self::constant(self.value().int(n), self.order)
    }

    fn ratio(&self, n: i32, d: i32) -> Self {
        Self::constant(self.value().ratio(n, d), self.order)
    }
}

impl<T: Real> Real for Jet<T> {
    fn pi(&self) -> Self {
        Self::constant(self.value().pi(), self.order)
    }

    fn sqrt(&self) -> Self {
        let mut root = vec![self.value().sqrt()];
        let twice = root[0].int(2) * &root[0];
        for k in 1..self.length() {
            let inner = Self::convolution(&root, &root, k, 1, k - 1);
            let rest = self.coefficient(k);
            root.push(inner.map_or(rest.clone(), |inner| rest - inner) / &twice);
        }
        Self::new(root, self.order)
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value().sin_cos();
        let (mut sin, mut cos) = (vec![sin], vec![cos]);
        for k in 1..self.length() {
            let next = Self::integrated(&self.coefficients, &cos, k);
            cos.push(-Self::integrated(&self.coefficients, &sin, k));
            sin.push(next);
        }
        (Self::new(sin, self.order), Self::new(cos, self.order))
    }
}

impl<T: Stumpff> Stumpff for Jet<T> {
    /// Derivatives by `2 dc_n/du = n c_(n+2) - c_(n+1)`: each order needs two functions more of the order before.
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let more = self.length() - 1;
        let mut functions: Vec<Vec<T>> =
            self.value().stumpff(count + 2 * more).into_iter().map(|c| vec![c]).collect();
        for k in 1..=more {
            let known = count + 2 * (more - k);
            let slope = |n: usize| -> Vec<T> {
                let pairs = functions[n + 2].iter().zip(&functions[n + 1]);
                pairs.map(|(a, b)| (a.int(n as i32) * a - b) / a.int(2)).collect()
            };
            let next: Vec<T> =
                (0..known).map(|n| Self::integrated(&self.coefficients, &slope(n), k)).collect();
            functions.truncate(known);
            functions.iter_mut().zip(next).for_each(|(c, next)| c.push(next));
        }
        functions.into_iter().map(|c| Self::new(c, self.order)).collect()
    }
}

impl<T: Field> Jet<T> {
    fn negated(self) -> Self {
        let coefficients = self.coefficients.into_iter().map(|c| -c).collect();
        Self { coefficients, ..self }
    }

    fn plus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a.clone() + b, T::clone)
    }

    fn minus(self, other: &Self) -> Self {
        self.combine(other, |a, b| a.clone() - b, |b| -b.clone())
    }

    fn times(self, other: &Self) -> Self {
        let order = self.order.max(other.order);
        let (a, b) = (&self.coefficients, &other.coefficients);
        let count = (a.len() + b.len() - 1).min(order + 1);
        let at = |k| Self::convolution(a, b, k, 0, k).unwrap_or_else(|| a[0].int(0));
        Self { coefficients: (0..count).map(at).collect(), order }
    }

    fn over(self, other: &Self) -> Self {
        let order = self.order.max(other.order);
        let divisor = &other.coefficients;
        let count = if divisor.len() == 1 { self.coefficients.len() } else { order + 1 };
        let mut quotient: Vec<T> = Vec::with_capacity(count);
        for k in 0..count {
            let known = match k {
                0 => None,
                k => Self::convolution(&quotient, divisor, k, 0, k - 1),
            };
            let rest = self.coefficient(k);
            quotient.push(known.map_or(rest.clone(), |known| rest - known) / &divisor[0]);
        }
        Self { coefficients: quotient, order }
    }
}

operators!([T: Field] Jet<T>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, Enclosure};
    use rug::Rational;

    fn exact(coefficients: &[(i32, i32)], order: usize) -> Jet<Rational> {
        Jet::new(coefficients.iter().map(|&x| Rational::from(x)).collect(), order)
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        let (a, b) = (exact(&[(1, 2), (3, 1), (-2, 7)], 5), exact(&[(2, 3), (-1, 5), (4, 1)], 5));
        let quotient = a.clone() / &b;
        assert_eq!(quotient.coefficients().len(), 6);
        let back = quotient * &b - &a;
        assert!(back.coefficients().iter().all(|c| *c == 0), "{back:?}");
        // A constant divides each coefficient.
        assert_eq!((a.clone() / a.int(2)).coefficients().len(), 3);
    }

    /// The functions of a jet are those of its numbers, as the sums of the series tell.
    #[test]
    fn functions_of_a_jet_are_functions_of_its_sum() {
        let order = 12;
        let jet = Jet::new(vec![0.4, 0.8, -0.3], order);
        let t = 0.05;
        let sum = |jet: &Jet<f64>| jet.coefficients().iter().rev().fold(0.0, |s, c| s * t + c);
        let x = sum(&jet);
        let close = |found: &Jet<f64>, expected: f64| {
            approx::assert_relative_eq!(sum(found), expected, max_relative = 1e-11);
        };
        let (sin, cos) = jet.sin_cos();
        close(&sin, x.sin());
        close(&cos, x.cos());
        close(&jet.sqrt(), x.sqrt());
        close(&(jet.int(1) / &jet), 1.0 / x);
        for (found, expected) in jet.stumpff(3).iter().zip(x.stumpff(3)) {
            close(found, expected);
        }
    }

    /// Over a wide ball each coefficient holds that about any of its points.
    #[test]
    fn a_jet_about_a_set_holds_those_about_its_points() {
        let about = |x: Ball| {
            let one = x.int(1);
            let (sin, cos) = Jet::new(vec![x.clone(), one.clone()], 4).sin_cos();
            let c = Jet::new(vec![x, one], 4).stumpff(4).swap_remove(3);
            [sin.sqrt(), cos / c]
        };
        let like = Ball::integer(0, 64);
        let set = like.ratio(1, 2).hull(&like.ratio(3, 4));
        for n in 4..=6 {
            let point = about(like.ratio(n, 8));
            for (wide, narrow) in about(set.clone()).iter().zip(&point) {
                for k in 0..=4 {
                    assert!(narrow.coefficient(k).lies_inside(&wide.coefficient(k)), "{n} {k}");
                }
            }
        }
        let outside = about(like.ratio(9, 8));
        assert!(
            !outside[0].coefficient(0).lies_inside(&about(set)[0].coefficient(0)),
            "false twin"
        );
    }
}
