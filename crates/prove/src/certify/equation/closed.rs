//! The closed forms (9)–(11) in their real, trigonometric form.

use crate::arch::closed_form::ClosedForm;
use crate::arch::cubic;
use crate::number::{Angle, Ball, Field, Real, arctangent, worded};
use rug::Float;

worded! {
    /// The two real branches: upper signs for `alpha < alpha_sb`, lower beyond.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum RootBranch {
        /// `alpha < alpha_sb`.
        Upper = "upper",
        /// `alpha > alpha_sb`.
        Lower = "lower",
    }
    /// Both of them.
    pub const ALL;
    /// Name of the signs in files.
    pub fn name -> &'static str;
}

/// A real number with an angle and a cosine: what the trigonometric form needs.
pub trait Trigonometric: Real {
    /// The angle of the point `(x, y)`, with `self` as `y`; of an enclosure `y` has to be positive.
    fn angle(&self, x: &Self) -> Self;
}

impl Trigonometric for f64 {
    fn angle(&self, x: &Self) -> Self {
        self.atan2(*x)
    }
}

impl Trigonometric for Float {
    fn angle(&self, x: &Self) -> Self {
        self.clone().atan2(x)
    }
}

impl Trigonometric for Ball {
    /// Twice the angle whose tangent is `y/(r + x) = (r - x)/y`: of the two the one in which nothing cancels.
    fn angle(&self, x: &Self) -> Self {
        let radius = (self.square() + x.square()).sqrt();
        let tangent = match x.mid().is_sign_negative() {
            true => (radius - x) / self,
            false => self.clone() / (radius + x),
        };
        arctangent(&tangent) * self.int(2)
    }
}

/// The real form: with `q = i |q|` the cube root has the modulus `√P`, and the two terms are conjugate,
/// `2 √P cos(t/3 ∓ pi/3)` with `t` the angle of the cube. `joint` is `beta` in `(0, beta_sb]`.
pub fn trigonometric<T: Trigonometric>(
    form: ClosedForm,
    branch: RootBranch,
    joint: &Angle<T>,
) -> T {
    let at = cubic::abbreviations(joint);
    let (zero, one) = (joint.rad.int(0), joint.rad.int(1));
    let size = (-cubic::radicand(&at, &one)).sqrt();
    // The cube is linear in q: its real part at q = 0, its imaginary part the slope times |q|.
    let real = form.cube(&at, &zero);
    let imaginary = (form.cube(&at, &one) - &real) * &size;
    let third = imaginary.angle(&real) / joint.rad.int(3);
    let turn = joint.rad.pi() / joint.rad.int(3);
    // (10) is printed with the signs the other way round.
    let difference = (branch == RootBranch::Upper) != (form == ClosedForm::Thickness);
    let angle = if difference { third - turn } else { third + turn };
    let (_, cosine) = angle.sin_cos();
    form.of_terms(&at, form.product(&at).sqrt() * cosine * one.int(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    #[test]
    fn in_balls_an_angle_is_that_of_its_point() {
        let ball = |x: f64| Ball::exact(Float::with_val(128, x), 128);
        for (y, x) in [(1.0, 2.0), (1.0, -2.0), (1e-9, -3.0), (1e-9, 3.0), (2.0, 0.0)] {
            let found = ball(y).angle(&ball(x));
            let truth = Float::with_val(128, y).atan2(&Float::with_val(128, x));
            assert!(found.overlaps(&Ball::exact(truth, 128).widened(found.rad())), "{y} {x}");
            assert!(found.rad().to_float() < 1e-30, "{y} {x}");
        }
        assert!(!ball(-1.0).angle(&ball(1.0)).is_bounded(), "only above the axis");
    }
}
