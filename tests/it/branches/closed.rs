//! The closed forms (9)–(11) of rotation and (13)–(15) of overturning have one value and one slope at `l`: in exact
//! numbers at `l` itself, in balls on either side of it.
//!
//! Near `l` the joint is small. With `S`, `f`, `g` all divided by `beta` the closed forms are the same, as they are of
//! degree zero in these three, and analytic in `u = beta²`: at `u = 0` stands `l`.

use super::{BITS, Tangent, end};
use crate::hard::{config, weights};
use couplet::arch::cubic::{Abbreviations, abbreviations, in_thickness, radicand};
use couplet::arch::{Ring, SelfWeight, overturning, thrust};
use couplet::certify::equation::ClosedForm;
use couplet::number::{
    Angle, Ball, Complex, ComplexBall, Derivatives, Dual, Enclosure, ExactField, Field, Real, Surd,
};
use proptest::prelude::*;
use rug::{Rational, ops::Pow};

/// Roots in a field of complex numbers.
trait Roots: Field {
    fn square_root(&self) -> Self;
    fn cube_root(&self) -> Self;
    /// `-i√3`: the lower signs, of the states beyond the widest joint.
    fn lower_signs(&self) -> Self;
}

impl Roots for ComplexBall {
    fn square_root(&self) -> Self {
        assert!(self.im.contains(&Rational::new()), "the radicands are real");
        ComplexBall::root_of_real(&self.re).unwrap()
    }

    fn cube_root(&self) -> Self {
        ComplexBall::cube_root(self).unwrap()
    }

    fn lower_signs(&self) -> Self {
        Self { re: self.re.int(0), im: -self.re.int(3).sqrt() }
    }
}

/// Number of the field of `√3` and `i`.
type Exact = Complex<Surd>;

fn exact(re: (i32, i32), im: (i32, i32)) -> Exact {
    Exact { re: Surd::new(re.0, re.1, 3), im: Surd::new(im.0, im.1, 3) }
}

/// Principal root of a number whose value is one of the few that occur at `l`.
fn root(of: &Dual<Exact>, power: i32) -> Dual<Exact> {
    let known = [
        exact((12, 0), (0, 0)),
        exact((3, -1), (0, 0)),
        exact((0, 0), (8, 0)),
        exact((1, 1), (-1, 1)),
        exact((1, 2), (2, -1)),
        exact((1, 0), (0, 1)),
    ];
    let below = |x: &Exact| (2..power).fold(x.clone(), |product, _| product * x);
    let is_root = |x: &Exact| (below(x) * x - of.value()).is_zero();
    let value = known.into_iter().find(is_root).unwrap_or_else(|| panic!("no root of {of:?}"));
    let slope = of.derivative(0) / (value.int(power) * below(&value));
    Dual::with_derivative(value, 0, slope)
}

impl Roots for Dual<Exact> {
    fn square_root(&self) -> Self {
        root(self, 2)
    }

    fn cube_root(&self) -> Self {
        root(self, 3)
    }

    fn lower_signs(&self) -> Self {
        Self::constant(exact((0, 0), (0, -1)))
    }
}

/// `A`, `eta`, `h` of rotation, at the abbreviations of its joint: for Heyman's weight from the root of what is left
/// of the second cubic (7), for Milankovitch's by (9)–(11).
fn rotation<T: Roots>(weight: SelfWeight, at: &Abbreviations<T>) -> [T; 3] {
    let one = at.sin.int(1);
    if weight == SelfWeight::Milankovitch {
        let (q, k) = (radicand(at, &one).square_root(), one.lower_signs());
        return [ClosedForm::OpeningVariable, ClosedForm::Thickness, ClosedForm::Thrust]
            .map(|form| form.value(at, &form.cube(at, &q).cube_root(), &k));
    }
    let quadratic = |eta: i32| in_thickness(at, &one.int(0), &one.int(eta));
    let [below, c, above] = [-1, 0, 1].map(quadratic);
    let b = (above.clone() - &below) / one.int(2);
    let a = (above + below) / one.int(2) - &c;
    let root = (b.square() - one.int(4) * &a * &c).square_root();
    let eta = (root - b) / (one.int(2) * a);
    let ring = Ring::new(weight, &eta);
    let h = thrust::tangency(&((at.f.clone() - &at.sin) / &at.sin), &ring).value();
    [overturning::opening_variable(&ring).value() + &h, eta, h]
}

/// `eta` of overturning by (14) or (15).
fn overturned<T: Roots>(weight: SelfWeight, a: &T) -> T {
    match weight {
        SelfWeight::Heyman => overturning::heyman(a),
        SelfWeight::Milankovitch => {
            overturning::milankovitch(a, &overturning::radicand(a).square_root())
        }
    }
}

/// False twin of (14) and (15): the value at `l` is the same, the slope is a thousandth more.
fn turned<T: Roots>(weight: SelfWeight, a: &T, a_end: &T) -> T {
    overturned(weight, a) + (a.clone() - a_end) / a.int(1000)
}

#[test]
fn closed_forms_have_one_value_and_one_slope_at_l() {
    for weight in SelfWeight::ALL {
        let [a_end, eta_end, slope] = end(weight).map(Exact::from);
        let zero = slope.int(0);
        let square = Dual::variable(zero.clone(), 0);
        // sin(beta)/beta and cos(beta), to the first order in u.
        let [sin, cos] = [6, 2].map(|n| square.int(1) - square.clone() / square.int(n));
        let [a, eta, h] = rotation(weight, &abbreviations(&Angle { rad: square.int(1), sin, cos }));
        assert_eq!([a.value(), eta.value(), h.value()], [&a_end, &eta_end, &zero], "{weight:?}");
        let by_a = |x: &Dual<Exact>| x.derivative(0) / a.derivative(0);
        assert_eq!([by_a(&eta), by_a(&h)], [slope.clone(), zero.clone()], "{weight:?}");

        let a = Dual::variable(a_end.clone(), 0);
        let eta = overturned(weight, &a);
        assert_eq!([eta.value(), eta.slope(0).unwrap()], [&eta_end, &slope], "{weight:?}");
        // (13), their inverse.
        let back = overturning::opening_variable(&Ring::new(weight, &eta.map(|x| x.re))).value();
        assert_eq!([back.value().clone(), back.derivative(0)], [a_end.re.clone(), a_end.re.int(1)]);
        let twin = turned(weight, &a, &Dual::constant(a_end));
        assert_eq!(twin.value(), &eta_end, "the twin joins");
        assert_ne!(twin.derivative(0), slope, "with another slope");
    }
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn closed_forms_follow_one_tangent_on_either_side(
        weight in weights(), mantissa in 1i32..1000, places in 7u32..50,
    ) {
        let tangent = Tangent::at_end(weight);
        let size = Rational::from(mantissa) / rug::Integer::from(10).pow(places);
        let size = Ball::enclosing(&size, BITS);
        let Abbreviations { sin, f, g } = abbreviations(&Angle::new(size.sqrt()));
        let [sin, f, g] = [sin, f, g].map(ComplexBall::from);
        let state = rotation(weight, &Abbreviations { sin, f, g });
        for part in &state {
            prop_assert!(part.im.contains(&Rational::new()), "{:?}", part);
        }
        let [a, eta, h] = state.map(|x| x.re);
        prop_assert!((a.clone() - &tangent.a).is_positive().is_proved(), "less open than l");
        prop_assert!(tangent.holds(&a, &eta) && tangent.is_flat(&a, &h), "{:?}", tangent.gap(&a, &eta));

        let wide = tangent.a.clone() - &size;
        let [wide_complex, end] = [&wide, &tangent.a].map(|x| ComplexBall::from(x.clone()));
        let overturned = overturning::thickness(weight, &wide);
        prop_assert!(overturned.overlaps(&self::overturned(weight, &wide_complex).re));
        prop_assert!(tangent.holds(&wide, &overturned), "{:?}", tangent.gap(&wide, &overturned));
        if places > 10 {
            prop_assert!(!tangent.turned().holds(&a, &eta), "a slope off by a thousandth is seen");
            let twin = turned(weight, &wide_complex, &end).re;
            prop_assert!(!tangent.holds(&wide, &twin), "that of overturning too");
        }
    }
}
