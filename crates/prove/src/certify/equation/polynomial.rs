//! The polynomials (7) at one joint, and all of their real roots.

use crate::arch::SelfWeight;
use crate::arch::closed_form::ClosedForm;
use crate::arch::cubic::Abbreviations;
use crate::number::{Ball, Enclosure, Field, Jet, Real, Stumpff};
use crate::prover::Undecided;
use crate::prover::root::{Form, root_near};
use crate::symbolic::Known;
use rug::float::Constant;
use rug::{Float, Rational};

/// Degree of the cubics.
const DEGREE: usize = 3;

/// Coefficients of a polynomial (7), that of the highest power first: cubics for Milankovitch's weight, for Heyman's
/// the quadratics that are left without the factor that has no root above zero.
pub(super) fn coefficients<T: Field>(
    form: ClosedForm,
    weight: SelfWeight,
    at: &Abbreviations<T>,
) -> Vec<T> {
    let jet = |x: &T| Jet::constant(x.clone(), DEGREE);
    let like = &at.sin;
    let variable = Jet::new(vec![like.int(0), like.int(1)], DEGREE);
    let of = Abbreviations { sin: jet(&at.sin), f: jet(&at.f), g: jet(&at.g) };
    let polynomial = match (weight, form) {
        (SelfWeight::Heyman, ClosedForm::OpeningVariable) => {
            heyman_opening_variable(&of, &variable)
        }
        (SelfWeight::Heyman, ClosedForm::Thrust) => heyman_thrust(&of, &variable),
        _ => form.cubic(&of, &variable.int(weight.flag()), &variable),
    };
    let degree = match weight {
        SelfWeight::Heyman => DEGREE - 1,
        SelfWeight::Milankovitch => DEGREE,
    };
    (0..=degree).rev().map(|k| polynomial.coefficient(k)).collect()
}

/// `S (2g - S) A² - 2 f g A + g²`: the first cubic (7) at `delta_M = 0` over `3/2 (S A + g)`.
fn heyman_opening_variable<T: Field>(at: &Abbreviations<T>, a: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    let square = (g.int(2) * g - sin) * sin;
    (square * a - f.int(2) * f * g) * a + g.square()
}

/// `2 S h² - 2 (f - S) h + g - f`: the third cubic (7) at `delta_M = 0` over `3/2 (2 S h + g - f)`.
fn heyman_thrust<T: Field>(at: &Abbreviations<T>, h: &T) -> T {
    let Abbreviations { sin, f, g } = at;
    (sin.int(2) * sin * h - f.int(2) * (f.clone() - sin)) * h + (g.clone() - f)
}

/// Tells whether a rational number in a box with one root is that root, exactly.
pub(super) fn is_root(coefficients: &[Known], x: &Rational) -> bool {
    coefficients.first().is_some_and(|first| value(coefficients, &first.like(x)).is_zero())
}

/// A polynomial in the size of its unknown, which has a sign.
struct PolynomialForm<'a> {
    coefficients: &'a [Ball],
    is_negative: bool,
}

impl Form<Ball> for PolynomialForm<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let x = if self.is_negative { -x[0].clone() } else { x[0].clone() };
        let zero = x.int(0);
        vec![self.coefficients.iter().fold(zero, |sum, term| sum * &x + number(term))]
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, _: &[T]) -> bool {
        true
    }
}

/// The value of a polynomial.
pub(super) fn value<T: Field>(coefficients: &[T], x: &T) -> T {
    coefficients.iter().fold(x.int(0), |sum, term| sum * x + term)
}

/// All real roots in their order, `count` of them, as a discriminant tells: each alone in a box, the boxes apart.
pub(super) fn real_roots(
    coefficients: &[Ball],
    count: usize,
    bits: u32,
) -> Result<Vec<Ball>, Undecided> {
    let open = || Undecided::root("the real roots of a polynomial (7), which are not told apart");
    let root = |start: Float| {
        let is_negative = start.is_sign_negative();
        let form = PolynomialForm { coefficients, is_negative };
        let size = root_near(&form, bits, vec![Float::with_val(bits, start.abs())])?.remove(0);
        Ok(if is_negative { -size } else { size })
    };
    let from = |starts: Vec<Float>| {
        if starts.len() != count {
            return Err(open());
        }
        let roots = starts.into_iter().map(root).collect::<Result<_, Undecided>>();
        let mut roots: Vec<Ball> = roots?;
        roots.sort_by(|a, b| a.mid().total_cmp(b.mid()));
        let apart = roots.windows(2).all(|pair| !pair[0].overlaps(&pair[1]));
        if apart { Ok(roots) } else { Err(open()) }
    };
    // Roots next to each other are told apart by candidates of as many bits alone.
    let few = from(candidates(coefficients, bits.min(FEW)));
    few.or_else(|open| if bits > FEW { from(candidates(coefficients, bits)) } else { Err(open) })
}

/// Bits of candidates, mostly.
const FEW: u32 = 256;

/// Candidates of the real roots of a quadratic or a cubic, by its formula.
fn candidates(coefficients: &[Ball], bits: u32) -> Vec<Float> {
    let number = |x: &Ball| Float::with_val(bits, x.mid());
    match coefficients {
        [a, b, c] => {
            let [a, b, c] = [a, b, c].map(number);
            let discriminant = b.clone() * &b - a.clone() * &c * 4u32;
            if discriminant < 0 {
                return Vec::new();
            }
            let root = discriminant.sqrt();
            let sum = if b.is_sign_negative() { b - root } else { b + root } / -2i32;
            vec![c / &sum, sum / a]
        }
        [a, b, c, d] => {
            let lead = number(a);
            let [b, c, d] = [b, c, d].map(|x| number(x) / &lead);
            let shift = b.clone() / 3u32;
            let p = c.clone() - b.clone() * &shift;
            let q = shift.clone() * &shift * &shift * 2u32 - shift.clone() * &c + d;
            let half = q.clone() / 2u32;
            let third = p.clone() / 3u32;
            let discriminant = half.clone() * &half + third.clone() * &third * &third;
            if discriminant > 0 {
                let root = discriminant.sqrt();
                let u = if q.is_sign_negative() { root - half } else { -half - root }.cbrt();
                return vec![u.clone() - third / u - shift];
            }
            let size = (-third).sqrt();
            let cosine = -half / (size.clone() * &size * &size);
            let angle = cosine.clamp(&-1, &1).acos() / 3u32;
            let turn = Float::with_val(bits, Constant::Pi) * 2u32 / 3u32;
            let root = |k: u32| (angle.clone() - turn.clone() * k).cos() * &size * 2u32 - &shift;
            (0..3).map(root).collect()
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::cubic;
    use crate::number::Angle;

    fn at(joint: f64) -> Abbreviations<Ball> {
        let joint = Ball::exact(Float::with_val(256, joint), 256);
        cubic::abbreviations(&Angle::new(joint))
    }

    #[test]
    fn the_quadratics_are_the_cubics_without_a_factor() {
        let rational = |n: i32, d: i32| Rational::from((n, d));
        let (sin, f, g) = (rational(20, 29), rational(9, 7), rational(8, 5));
        let (x, zero) = (rational(3, 4), rational(0, 1));
        let at = Abbreviations { sin: sin.clone(), f: f.clone(), g: g.clone() };
        let factors =
            [sin.clone() * &x + &g, sin * &x * 2 + (g - f)].map(|of| of * Rational::from((3, 2)));
        let quadratics = [heyman_opening_variable(&at, &x), heyman_thrust(&at, &x)];
        let cubics = [ClosedForm::OpeningVariable, ClosedForm::Thrust]
            .map(|form| form.cubic(&at, &zero, &x));
        for ((factor, quadratic), cubic) in factors.iter().zip(&quadratics).zip(&cubics) {
            assert_eq!(quadratic.clone() * factor, *cubic);
            assert_ne!((quadratic.clone() + 1) * factor, *cubic, "false twin");
        }
    }

    #[test]
    fn all_real_roots_are_found_below_the_widest_joint_and_beyond() {
        for (weight, below, beyond) in
            [(SelfWeight::Heyman, 2, 0), (SelfWeight::Milankovitch, 3, 1)]
        {
            for form in ClosedForm::ALL {
                for (joint, count) in [(0.01, below), (1.0, below), (1.2, beyond), (2.0, beyond)] {
                    let polynomial = coefficients(form, weight, &at(joint));
                    let roots = real_roots(&polynomial, count, 256).unwrap();
                    assert_eq!(roots.len(), count, "{weight:?} {form:?} {joint}");
                    for root in &roots {
                        assert!(!value(&polynomial, root).excludes_zero());
                        let moved = root.clone() * root.ratio(1001, 1000);
                        assert!(value(&polynomial, &moved).excludes_zero(), "false twin");
                    }
                }
                let polynomial = coefficients(form, weight, &at(1.0));
                assert!(real_roots(&polynomial, below - 1, 256).is_err(), "a wrong count");
            }
        }
    }
}
