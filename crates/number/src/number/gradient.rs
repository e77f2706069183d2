//! A value with its gradient in an array: dual numbers without a heap.

use super::stumpff::slope;
use super::{Derivatives, Field, Real, Stumpff};
use std::array;

/// A value and its partial derivatives to `N` unknowns, for numbers that are copied. [`Dual`](super::Dual) is the
/// same for numbers that are expensive to copy: there a derivative that is zero costs nothing.
///
/// ```
/// use couplet_number::number::{Field, Gradient};
/// let [x, y] = Gradient::<f64, 2>::variables(&[3.0, 5.0]);
/// let product = x * y + x.square();
/// assert_eq!((product.value, product.slopes), (24.0, [11.0, 3.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<T, const N: usize> {
    /// The value.
    pub value: T,
    /// The derivatives, in the order of the unknowns.
    pub slopes: [T; N],
}

impl<T: Field + Copy, const N: usize> Gradient<T, N> {
    /// A constant.
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Self { value, slopes: [value.int(0); N] }
    }

    /// Variables: each value as an unknown, numbered in order. There may be fewer than slopes; more do not compile.
    pub fn variables<const K: usize>(values: &[T; K]) -> [Self; K] {
        const { assert!(K <= N) };
        array::from_fn(|index| {
            let mut variable = Self::constant(values[index]);
            variable.slopes[index] = variable.value.int(1);
            variable
        })
    }

    /// The number with `value` and the gradient of `self` scaled by `factor`.
    #[inline(always)]
    fn chain(&self, value: T, factor: T) -> Self {
        self.mapped(value, |slope| slope * factor)
    }

    /// The number with `value` and another slope for each.
    #[inline(always)]
    fn mapped(mut self, value: T, slope: impl Fn(T) -> T) -> Self {
        for own in &mut self.slopes {
            *own = slope(*own);
        }
        Self { value, ..self }
    }

    /// The number with `value` and the slopes of two. A plain loop: what is built for size calls the closures of
    /// [`array::from_fn`] one by one.
    #[inline(always)]
    fn joined(mut self, other: &Self, value: T, slope: impl Fn(T, T) -> T) -> Self {
        for k in 0..N {
            self.slopes[k] = slope(self.slopes[k], other.slopes[k]);
        }
        Self { value, ..self }
    }
}

impl<T, const N: usize> Derivatives<T> for Gradient<T, N> {
    fn slope(&self, index: usize) -> Option<&T> {
        self.slopes.get(index)
    }
}

impl<T: Field + Copy, const N: usize> Field for Gradient<T, N> {
    #[inline(always)]
    fn int(&self, n: i32) -> Self {
        Self::constant(self.value.int(n))
    }

    #[inline(always)]
    fn ratio(&self, n: i32, d: i32) -> Self {
        Self::constant(self.value.ratio(n, d))
    }

    #[inline]
    fn square(&self) -> Self {
        self.chain(self.value.square(), self.value.int(2) * self.value)
    }
}

impl<T: Real + Copy, const N: usize> Real for Gradient<T, N> {
    fn pi(&self) -> Self {
        Self::constant(self.value.pi())
    }

    #[inline]
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, root.ratio(1, 2) / root)
    }

    #[inline]
    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
}

impl<T: Stumpff + Copy, const N: usize> Stumpff for Gradient<T, N> {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let functions = self.value.stumpff(count + 2);
        (0..count).map(|n| self.chain(functions[n], slope(&functions, n))).collect()
    }
}

impl<T: Field + Copy, const N: usize> Gradient<T, N> {
    #[inline(always)]
    fn negated(self) -> Self {
        self.mapped(-self.value, |slope| -slope)
    }

    #[inline]
    fn plus(self, other: &Self) -> Self {
        self.joined(other, self.value + other.value, |a, b| a + b)
    }

    #[inline]
    fn minus(self, other: &Self) -> Self {
        self.joined(other, self.value - other.value, |a, b| a - b)
    }

    /// `p = a b` has `p' = a' b + b' a`.
    #[inline]
    fn times(self, other: &Self) -> Self {
        let (a, b) = (self.value, other.value);
        self.joined(other, a * b, |da, db| da * b + db * a)
    }

    /// `q = a/b` has `q' = (a' - q b')/b`.
    #[inline]
    fn over(self, other: &Self) -> Self {
        let value = self.value / other.value;
        self.joined(other, value, |da, db| (da - db * value) / other.value)
    }
}

operators!([T: Field + Copy, const N: usize] Gradient<T, N>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Dual;

    /// Something of everything that a gradient goes through.
    fn all<T: Real + Stumpff>(x: &T, y: &T) -> Vec<T> {
        let (sin, cos) = x.sin_cos();
        let quotient = (x.clone() * y - x.ratio(1, 3)) / (y.square() + x);
        let mut all = vec![sin * y - cos, quotient.clone(), -quotient, y.sqrt() + x.pi()];
        all.extend((x.clone() * y / x.int(8)).stumpff(4));
        all
    }

    #[test]
    fn the_gradient_is_that_of_dual_numbers() {
        for (x, y) in [(0.3, 2.5), (1.7, 0.01), (-0.9, 4.0)] {
            let [a, b] = Gradient::<f64, 2>::variables(&[x, y]);
            let dual = Dual::variables(&[x, y]);
            for (found, expected) in all(&a, &b).iter().zip(all(&dual[0], &dual[1])) {
                assert_eq!(found.value, *expected.value());
                for k in 0..2 {
                    let slope = expected.derivative(k);
                    approx::assert_relative_eq!(found.slopes[k], slope, max_relative = 1e-14);
                }
            }
        }
    }
}
