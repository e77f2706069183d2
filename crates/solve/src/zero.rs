//! Zeros of functions of one variable, in doubles and without derivatives.

use crate::number::Field;

/// Evaluations after which a search is given up.
const STEPS: usize = 100;
/// The zero is known to this part of it at the end.
const SHORT: f64 = 1e-14;

/// A zero of `f` between two places, by inverse quadratic interpolation where that is safe and by halving where
/// it is not (Chandrupatla, Advances in Engineering Software 28, 1997).
///
/// It is assumed that `f` is continuous and has different signs at the two places; then the answer lies
/// between them, next to a change of sign, to about fourteen digits of what doubles know of `f`. If the signs
/// are equal, the answer is the place where `f` is nearer to zero.
pub(super) fn zero(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = ((low, f(low)), (high, f(high)));
    let nearest = |a: (f64, f64), b: (f64, f64)| if a.1.abs() < b.1.abs() { a.0 } else { b.0 };
    if a.1 * b.1 > 0.0 {
        return nearest(a, b);
    }
    let mut part = 0.5;
    for _ in 0..STEPS {
        // Rounding does not lead out of the range.
        let x = (a.0 + part * (b.0 - a.0)).clamp(low.min(high), low.max(high));
        let value = f(x);
        // The zero is between `a`, the newest place, and `b`; `c` is the one that they replace.
        let c = if (value < 0.0) == (a.1 < 0.0) { a } else { std::mem::replace(&mut b, a) };
        a = (x, value);
        let short = SHORT * nearest(a, b).abs() / (b.0 - a.0).abs();
        if value == 0.0 || short > 0.5 {
            break;
        }
        let (xi, phi) = ((a.0 - b.0) / (c.0 - b.0), (a.1 - b.1) / (c.1 - b.1));
        let is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        let interpolated = || {
            a.1 / (b.1 - a.1) * c.1 / (b.1 - c.1)
                + (c.0 - a.0) / (b.0 - a.0) * a.1 / (c.1 - a.1) * b.1 / (c.1 - b.1)
        };
        part = if is_safe { interpolated().clamp(short, 1.0 - short) } else { 0.5 };
    }
    nearest(a, b)
}

/// The zero nearer to 0 of a function that is a polynomial of degree two at most, from its values at 0, 1
/// and 2; where it has none, the place of its extremum.
pub(super) fn quadratic_zero(f: impl Fn(f64) -> f64) -> f64 {
    let [constant, one, two] = [0.0, 1.0, 2.0].map(f);
    let square = 0.5 * (two + constant) - one;
    let linear = one - constant - square;
    let root = (linear * linear - 4.0 * square * constant).max(0.0).sqrt();
    -2.0 * constant / (linear + root.copysign(linear))
}

/// The zero of a linear function, from its values at 0 and 1.
pub(super) fn linear_zero<T: Field>(like: &T, f: impl Fn(T) -> T) -> T {
    let constant = f(like.int(0));
    let slope = f(like.int(1)) - &constant;
    -constant / slope
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_is_found_to_all_digits() {
        for power in [1, 2, 5, 20] {
            let root = zero(0.0, 2.0, |t| t.powi(power) - 3.0 / 7.0);
            let expected = (3.0f64 / 7.0).powf(1.0 / f64::from(power));
            approx::assert_relative_eq!(root, expected, max_relative = 1e-13);
        }
        let pi = zero(1.0, 4.0, |t| -t.sin());
        approx::assert_relative_eq!(pi, std::f64::consts::PI, max_relative = 1e-13);
    }

    #[test]
    fn no_place_is_outside_the_range() {
        let low = 1e-18;
        let f = |t: f64| {
            assert!((low..=2.4).contains(&t), "{t}");
            6.9e-18 - t
        };
        assert!(zero(low, 2.4, f) >= low);
    }

    #[test]
    fn without_a_change_of_sign_the_answer_is_the_nearer_end() {
        assert_eq!(zero(1.0, 2.0, |t| t), 1.0);
        assert_eq!(zero(1.0, 2.0, |t| 1.0 / t), 2.0);
    }

    #[test]
    fn polynomials_are_known_by_their_values() {
        for (small, large) in [(0.25, 3.0), (-1e-9, 5.0), (1e-7, -2.0)] {
            let found = quadratic_zero(|x| (x - small) * (x - large));
            approx::assert_relative_eq!(found, small, max_relative = 1e-6);
        }
        assert_eq!(quadratic_zero(|x| 3.0 - 4.0 * x), 0.75);
        assert_eq!(linear_zero(&1.0, |x| 3.0 - 4.0 * x), 0.75);
    }
}
