//! The velocity of a rigid block.

use crate::number::{Angle, Field};

/// The velocity field of a rigid block, `v(X) = velocity + rotation J X` with `J (x, y) = (-y, x)`.
#[derive(Clone, Debug)]
pub struct Twist<T> {
    /// The rate of rotation, counter-clockwise.
    pub rotation: T,
    /// The velocity at the centre of the arch, to the right and up.
    pub velocity: [T; 2],
}

impl<T: Field> Twist<T> {
    /// No motion, "like" `like`.
    pub fn zero(like: &T) -> Self {
        Self { rotation: like.int(0), velocity: [like.int(0), like.int(0)] }
    }

    /// A translation.
    pub fn translation(velocity: [T; 2]) -> Self {
        Self { rotation: velocity[0].int(0), velocity }
    }

    /// A rotation about a point.
    pub fn about([x, y]: &[T; 2], rotation: T) -> Self {
        let velocity = [rotation.clone() * y, -(rotation.clone() * x)];
        Self { rotation, velocity }
    }

    /// Sum of both motions.
    pub fn plus(&self, other: &Self) -> Self {
        let [x, y] = [0, 1].map(|k| self.velocity[k].clone() + &other.velocity[k]);
        Self { rotation: self.rotation.clone() + &other.rotation, velocity: [x, y] }
    }

    /// The velocity of a point.
    pub fn at(&self, [x, y]: &[T; 2]) -> [T; 2] {
        let [across, up] = &self.velocity;
        [across.clone() - self.rotation.clone() * y, up.clone() + self.rotation.clone() * x]
    }

    /// The power of the weight of the arch between two joints, with its centroids at the radius `fac`, in units of
    /// `w r` times a velocity: `-(u_y (beta_2 - beta_1) + omega fac (cos beta_1 - cos beta_2))`.
    pub fn power(&self, [upper, lower]: [&Angle<T>; 2], centroid_factor: &T) -> T {
        let weight = lower.rad.clone() - &upper.rad;
        let arm = centroid_factor.clone() * (upper.cos.clone() - &lower.cos);
        -(self.velocity[1].clone() * weight + self.rotation.clone() * arm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_turns_about_a_point_leaves_it_where_it_is() {
        let twist = Twist::about(&[2.0, 3.0], 0.5);
        assert_eq!(twist.at(&[2.0, 3.0]), [0.0, 0.0]);
        // Counter-clockwise: a point to the right goes up.
        assert_eq!(twist.at(&[4.0, 3.0]), [0.0, 1.0]);
    }

    /// The weight of thin slices, each with its own velocity.
    #[test]
    fn the_power_is_that_of_all_slices() {
        let twist = Twist { rotation: 0.7, velocity: [0.2, -0.4] };
        let (from, to, radius, slices) = (0.3, 1.9, 1.1, 4000);
        let width = (to - from) / f64::from(slices);
        let slice = |k: i32| {
            let (sin, cos) = (from + (f64::from(k) + 0.5) * width).sin_cos();
            -twist.at(&[radius * sin, radius * cos])[1] * width
        };
        let sum: f64 = (0..slices).map(slice).sum();
        let power = twist.power([&Angle::new(from), &Angle::new(to)], &radius);
        approx::assert_relative_eq!(power, sum, epsilon = 1e-7);
    }
}
