//! The rotational joint as (2)–(5) see it: through functions that are even in its angle.
//!
//! By the square of the angle, `b = beta_r²`, they are analytic at the crown, `b = 0`, and beyond it: where a
//! line of states reaches the crown nothing is singular, though `beta_r` itself has a root there.

use super::{Quotient, Ring};
use crate::number::{Angle, Field, Real, Stumpff};

/// Terms of the equations in the rotational joint.
#[derive(Clone, Debug)]
pub struct Haunch<T> {
    /// `cos(beta)`.
    pub cosine: T,
    /// `beta sin(beta)`.
    pub times_sine: T,
    /// `beta cot(beta)`.
    pub times_cotangent: T,
    /// `1 - cos(beta)`.
    pub versine: T,
    /// `beta/sin(beta) - 1`.
    pub excess: T,
}

impl<T: Field> Haunch<T> {
    /// Haunch at the crown, "like" `like`.
    pub fn crown(like: &T) -> Self {
        let (zero, one) = (like.int(0), like.int(1));
        Self {
            cosine: one.clone(),
            times_sine: zero.clone(),
            times_cotangent: one,
            versine: zero.clone(),
            excess: zero,
        }
    }
}

impl<T: Field> From<&Angle<T>> for Haunch<T> {
    /// The joint by its angle, which is not zero.
    fn from(joint: &Angle<T>) -> Self {
        Self {
            cosine: joint.cos.clone(),
            times_sine: joint.rad.clone() * &joint.sin,
            times_cotangent: joint.times_cotangent(),
            versine: joint.versine(),
            excess: (joint.rad.clone() - &joint.sin) / &joint.sin,
        }
    }
}

impl<T: Stumpff> Haunch<T> {
    /// The joint by the square of its angle, whose functions are in the range of
    /// [Stumpff's](crate::number::Stumpff).
    pub fn at_square(square: &T) -> Self {
        Self::from_functions(square, &square.stumpff(4))
    }
}

impl<T: Field> Haunch<T> {
    /// Haunch from `c_0, …, c_3` at the square of the angle.
    pub fn from_functions(square: &T, c: &[T]) -> Self {
        Self {
            cosine: c[0].clone(),
            times_sine: square.clone() * &c[1],
            times_cotangent: square.int(1) - (c[2].clone() - &c[3]) * square / &c[1],
            versine: square.clone() * &c[2],
            excess: square.clone() * &c[3] / &c[1],
        }
    }
}

/// `A(alpha) = alpha cot(alpha/2)` from `c_0`, `c_1` at `alpha²/4`: `2 c_0/c_1`, regular at `alpha = 0`.
pub fn opening_variable_at_half<T: Field>(c: &[T]) -> Quotient<T> {
    Quotient { numerator: c[0].int(2) * &c[0], denominator: c[1].clone() }
}

/// The square root of [`touching`](super::thrust::touching), `√h √(2 eta) = b √((2 - eta) c_2 c_3/c_1)` with
/// `b = beta²`, as the left side less the right: regular at the end of rotation, where `h` falls like `b²`.
///
/// `thrust_root` is `√h`, `eta` in `(0, 2)`; below the crown's angle, `b < 0`, the root of `h` is negative.
pub fn touching_root<T: Real + Stumpff>(thrust_root: &T, square: &T, ring: &Ring<T>) -> T {
    let c = square.stumpff(4);
    let bow = (ring.intrados() * &c[2] * &c[3] / &c[1]).sqrt();
    (ring.thickness.int(2) * &ring.thickness).sqrt() * thrust_root - bow * square
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{SelfWeight, thrust};

    #[test]
    fn by_its_square_the_joint_is_the_same() {
        let joint = Angle::new(0.9f64);
        let (one, other) = (Haunch::from(&joint), Haunch::at_square(&joint.rad.square()));
        let values =
            |h: Haunch<f64>| [h.cosine, h.times_sine, h.times_cotangent, h.versine, h.excess];
        for (one, other) in values(one).into_iter().zip(values(other)) {
            approx::assert_relative_eq!(one, other, max_relative = 1e-14);
        }
        let crown = values(Haunch::at_square(&0.0));
        assert_eq!(crown, values(Haunch::crown(&0.0)));
    }

    #[test]
    fn the_root_form_vanishes_where_the_thrust_is_that_of_touching() {
        let (ring, joint) = (Ring::new(SelfWeight::Heyman, &0.4f64), Angle::new(0.8f64));
        let haunch = Haunch::from(&joint);
        let h = thrust::touching(&haunch.versine, &haunch.excess, &ring).value();
        let root = |h: f64| touching_root(&h.sqrt(), &joint.rad.square(), &ring);
        approx::assert_abs_diff_eq!(root(h), 0.0, epsilon = 1e-15);
        assert!(root(1.01 * h).abs() > 1e-4, "false twin");
    }
}
