//! The cubic between two nodes that has their values and their slopes.

use crate::number::{Ball, Field};
use rug::Float;

/// Precision of the arithmetic, in bits. The data are doubles.
pub(super) const BITS: u32 = 64;

/// A double, exactly.
pub(super) fn exact(x: f64) -> Ball {
    Ball::exact(Float::with_val(53, x), BITS)
}

/// Hermite's cubic `a_0 + a_1 t + a_2 t² + a_3 t³`, with `t` from the middle of the piece.
#[derive(Clone, Debug)]
pub(super) struct Cubic {
    coefficients: [Ball; 4],
}

impl Cubic {
    /// The cubic with given values and slopes at the ends of a piece of half-length `r`.
    pub(super) fn new([x0, x1]: [f64; 2], [d0, d1]: [f64; 2], r: &Ball) -> Self {
        let [x0, x1, d0, d1] = [x0, x1, d0, d1].map(exact);
        let two = r.int(2);
        let secant = (x1.clone() - &x0) / (two.clone() * r);
        let slope = (d0.clone() + &d1) / &two;
        let a2 = (d1 - d0) / (r.int(4) * r);
        let a3 = (slope - &secant) / (two.clone() * r.square());
        let a1 = secant - a3.clone() * r.square();
        let a0 = (x0 + x1) / two - a2.clone() * r.square();
        Self { coefficients: [a0, a1, a2, a3] }
    }

    /// The coefficients about the middle.
    pub(super) fn about_middle(&self) -> Vec<Ball> {
        self.coefficients.to_vec()
    }

    /// The coefficients about `t`, or about each point of a set.
    pub(super) fn about(&self, t: &Ball) -> Vec<Ball> {
        let [a0, a1, a2, a3] = &self.coefficients;
        let (two, three) = (t.int(2), t.int(3));
        let value = ((a3.clone() * t + a2) * t + a1) * t + a0;
        let slope = (three.clone() * a3 * t + two * a2) * t + a1;
        let bend = three * a3 * t + a2;
        vec![value, slope, bend, a3.clone()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cubic_has_the_values_and_the_slopes_of_its_ends() {
        let r = exact(0.25);
        let cubic = Cubic::new([1.0, 3.0], [-2.0, 5.0], &r);
        for (t, value, slope) in [(-0.25, 1, -2), (0.25, 3, 5)] {
            let at = cubic.about(&exact(t));
            assert!(at[0].contains(&value.into()) && at[1].contains(&slope.into()));
            assert!(!at[0].contains(&(value + 1).into()), "false twin");
        }
        let middle = cubic.about(&exact(0.0));
        for (one, other) in middle.iter().zip(cubic.about_middle()) {
            assert_eq!(one.mid(), other.mid());
        }
    }
}
