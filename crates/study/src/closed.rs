//! The closed forms (9)–(11): as printed, in complex doubles; and in their real, trigonometric form.

use crate::arch::cubic::{self, Abbreviations};
use crate::number::{Angle, rational_like};
use num_complex::Complex;
use rug::{Float, Rational};

pub use crate::certify::equation::{ClosedForm, RootBranch, trigonometric};

/// Closed form as printed, with complex square and cube roots in doubles; the real part.
pub fn printed(form: ClosedForm, branch: RootBranch, joint: f64) -> f64 {
    let real = cubic::abbreviations(&Angle::new(joint));
    let complex = |x: f64| Complex::new(x, 0.0);
    let at = Abbreviations { sin: complex(real.sin), f: complex(real.f), g: complex(real.g) };
    let q = complex(cubic::radicand(&real, &1.0)).sqrt();
    let sign = if branch == RootBranch::Upper { 1.0 } else { -1.0 };
    let k = Complex::new(0.0, sign * 3f64.sqrt());
    form.value(&at, &form.cube(&at, &q).cbrt(), &k).re
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
                let all = [ClosedForm::Thickness, ClosedForm::Thrust, ClosedForm::OpeningVariable];
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
        let [upper, lower] = [RootBranch::Upper, RootBranch::Lower]
            .map(|branch| printed(ClosedForm::Thickness, branch, 0.9));
        assert!(0.0 < upper && upper < lower && lower < 2.0);
    }
}
