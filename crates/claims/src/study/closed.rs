//! The closed forms (9)–(11): as printed, in complex doubles; and in their real, trigonometric form.

use crate::arch::closed_form;
use crate::arch::cubic::{self, Abbreviations};
use crate::number::{Angle, Field, Real, rational_like};
use ClosedForm::*;
use num_complex::Complex;
use rug::{Float, Rational};

/// Closed forms of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClosedForm {
    /// (9), `A`.
    OpeningVariable,
    /// (10), `eta`.
    Thickness,
    /// (11), `h`.
    Thrust,
}

impl ClosedForm {
    /// The cubic (7) of which it is a root.
    pub fn cubic<T: Field>(self, at: &Abbreviations<T>, flag: &T, x: &T) -> T {
        match self {
            Self::OpeningVariable => cubic::in_opening_variable(at, flag, x),
            Self::Thickness => cubic::in_thickness(at, flag, x),
            Self::Thrust => cubic::in_thrust(at, flag, x),
        }
    }
}

/// The two real branches: upper signs for `alpha < alpha_sb`, lower beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootBranch {
    /// `alpha < alpha_sb`.
    Upper,
    /// `alpha > alpha_sb`.
    Lower,
}

/// Closed form as printed, with complex square and cube roots in doubles; the real part.
pub fn printed(form: ClosedForm, branch: RootBranch, joint: f64) -> f64 {
    let real = cubic::abbreviations(&Angle::new(joint));
    let complex = |x: f64| Complex::new(x, 0.0);
    let at = Abbreviations { sin: complex(real.sin), f: complex(real.f), g: complex(real.g) };
    let q = complex(cubic::radicand(&real, &1.0)).sqrt();
    let sign = if branch == RootBranch::Upper { 1.0 } else { -1.0 };
    let k = Complex::new(0.0, sign * 3f64.sqrt());
    match form {
        OpeningVariable => {
            closed_form::opening_variable(&at, &closed_form::opening_cube(&at, &q).cbrt(), &k).re
        }
        Thickness => {
            closed_form::thickness(&at, &closed_form::thickness_cube(&at, &q).cbrt(), &k).re
        }
        Thrust => closed_form::thrust(&at, &closed_form::thrust_cube(&at, &q).cbrt(), &k).re,
    }
}

/// A real number with an angle and a cosine: what the trigonometric form needs.
pub trait Trigonometric: Real {
    /// The angle of the point `(x, y)`, with `self` as `y`.
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
    let parts = |cube: fn(&Abbreviations<T>, &T) -> T| {
        let real = cube(&at, &zero);
        let slope = cube(&at, &one) - &real;
        (real, slope * &size)
    };
    let ((real, imaginary), product) = match form {
        OpeningVariable => (parts(closed_form::opening_cube), closed_form::opening_product(&at)),
        Thickness => (parts(closed_form::thickness_cube), closed_form::thickness_product(&at)),
        Thrust => (parts(closed_form::thrust_cube), closed_form::thrust_product(&at)),
    };
    let third = imaginary.angle(&real) / joint.rad.int(3);
    let turn = joint.rad.pi() / joint.rad.int(3);
    // (10) is printed with the signs the other way round.
    let difference = (branch == RootBranch::Upper) != (form == Thickness);
    let angle = if difference { third - turn } else { third + turn };
    let (_, cosine) = angle.sin_cos();
    let terms = product.sqrt() * cosine * one.int(2);
    match form {
        OpeningVariable => closed_form::opening_variable_from(&at, terms),
        Thickness => closed_form::thickness_from(&at, terms),
        Thrust => closed_form::thrust_from(&at, terms),
    }
}

/// The real form in MPFR, at an exact joint.
pub fn trigonometric_at(
    form: ClosedForm,
    branch: RootBranch,
    joint: &Rational,
    bits: u32,
) -> Float {
    trigonometric(form, branch, &Angle::new(rational_like(&Float::new(bits), joint)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Ring, SelfWeight, overturning, thrust};

    /// Both branches at a joint below that of `sb`: the thicknesses are roots, and `h` and `A` belong to
    /// them.
    #[test]
    fn the_closed_forms_give_one_state_on_each_branch() {
        for joint in [0.3, 0.7, 1.0, 1.1] {
            for branch in [RootBranch::Upper, RootBranch::Lower] {
                let all = [Thickness, Thrust, OpeningVariable];
                let [eta, h, a] = all.map(|form| printed(form, branch, joint));
                let angle = Angle::new(joint);
                let ring = Ring::new(SelfWeight::Milankovitch, &eta);
                let thrust = thrust::tangency(&angle.times_cotangent(), &ring).value();
                let opening = h + overturning::opening_variable(&ring).value();
                approx::assert_relative_eq!(h, thrust, max_relative = 1e-9, epsilon = 1e-12);
                approx::assert_relative_eq!(a, opening, max_relative = 1e-9);
                let real = all.map(|form| trigonometric(form, branch, &angle));
                for (x, y) in [eta, h, a].into_iter().zip(real) {
                    approx::assert_relative_eq!(x, y, max_relative = 1e-8, epsilon = 1e-12);
                }
            }
        }
    }

    #[test]
    fn the_upper_branch_is_the_thinner() {
        let [upper, lower] =
            [RootBranch::Upper, RootBranch::Lower].map(|branch| printed(Thickness, branch, 0.9));
        assert!(0.0 < upper && upper < lower && lower < 2.0);
    }
}
