//! The closed forms (9)–(11), the radicand (12) under their root, and which sign belongs to which
//! states.
//!
//! Cardano's formula with a negative radicand `q² < 0`: with `q = i |q|` the cube is
//! `u³ = X + i c |q|`, and its norm `X² - c² q²` turns out to be `P³`. So `u = √P e^(i t/3)` with `t` in
//! `(0, pi)` where `c > 0`, and `(1 ± k)/2 = e^(±i pi/3)` makes the two terms conjugate:
//!
//! ```text
//! (1 ± k)/2 P/u + 2/(1 ± k) u = 2 √P cos(t/3 ∓ pi/3)
//! ```
//!
//! Both values are real and above the third root, `-2 √P cos(t/3)`; that with the difference of the
//! angles is the larger. Which sign belongs to which states is thereby decided without a number.

use super::along::landmark;
use super::cubics::letters;
use super::landmarks::certain_if;
use super::{Checked, Derivation, Support, claims, lemmas};
use crate::arch::closed_form::{ClosedForm, opening_root_factor};
use crate::arch::cubic::Abbreviations;
use crate::arch::{Ring, SelfWeight, cubic, overturning};
use crate::certify::between;
use crate::number::{Angle, Ball, Dual, Enclosure, Field, Real};
use crate::problem::Landmark;
use crate::symbolic::{Fraction, Letters, Polynomial, Relations, Symbol, discriminant};
use rug::Rational;

claims! {
    AsPrinted("eq-9", "Eq. (9)", |d| solves(d, ClosedForm::OpeningVariable)):
        "A_M of (9), with either sign, is a root of the first cubic (7)";
    AsPrinted("eq-10", "Eq. (10)", |d| solves(d, ClosedForm::Thickness)):
        "eta_M of (10), with either sign, is a root of the second cubic (7)";
    AsPrinted("eq-11", "Eq. (11)", |d| solves(d, ClosedForm::Thrust)):
        "h_M of (11), with either sign, is a root of the third cubic (7)";
    AsPrinted("eq-12", "Eq. (12)", radicand_is_the_discriminant):
        "the radicand of (12) is the discriminant of each cubic (7), up to a negative number and a square";
    AsPrinted("eq-9-11-signs", "Eq. (9)-(11)", signs_of_the_branches):
        "the same sign stands in both terms, or the value is not real: with principal roots the upper signs give the \
         states with alpha < alpha_sb, the lower signs those with alpha > alpha_sb, the same in all three";
    AsPrinted("eq-12-range", "Eq. (12)", radicand_in_the_range_of_interest):
        "the term under the square root is negative in the range of interest until it vanishes at beta_sb";
}

/// `u³` as given, `q²` the radicand (12), `k² = -3`.
fn relations(cube: &Fraction) -> Relations {
    let at = letters();
    let radicand = cubic::radicand(&at, &at.sin.int(1));
    Relations::none()
        .with(Symbol::CubeRoot, 3, cube.numerator().clone())
        .with(Symbol::SquareRoot, 2, radicand.numerator().clone())
        .with(Symbol::RootOfMinusThree, 2, Polynomial::from(-3))
}

/// A closed form in `u` and `k` put into its cubic, with both signs.
fn solves(d: &mut Derivation, form: ClosedForm) -> Checked {
    let (words, nonzero) = match form {
        ClosedForm::OpeningVariable => ("u³, half the bracket", "S, 3g - 2S and u are not zero"),
        _ => ("u³, the bracket", "S and u are not zero"),
    };
    let [u, q, k] =
        [Symbol::CubeRoot, Symbol::SquareRoot, Symbol::RootOfMinusThree].map(Symbol::number);
    let at = letters();
    let cube = form.cube(&at, &q);
    d.define(words, &cube);
    d.assume(nonzero);
    d.assume("u has the cube given, q² is the radicand (12), k² = -3");
    for (sign, k) in [("upper", k.clone()), ("lower", -k)] {
        let words = format!("the cubic at its closed form, {sign} signs");
        let value = form.cubic(&at, &k.int(1), &form.value(&at, &u, &k));
        d.identity_under(words, value, k.int(0), &relations(&cube))?;
    }
    Ok(())
}

fn radicand_is_the_discriminant(d: &mut Derivation) -> Checked {
    let at = letters();
    let (one, delta) = (at.sin.int(1), Symbol::Flag.number());
    let of = |cubic: Fraction, x| Fraction::from(discriminant(cubic.numerator(), x));
    let radicand = cubic::radicand(&at, &one);
    d.identity(
        "the discriminant of the cubic in eta, any delta_M",
        of(cubic::in_thickness(&at, &delta, &Symbol::Thickness.number()), Symbol::Thickness),
        one.int(-432) * cubic::radicand(&at, &delta),
    )?;
    let Abbreviations { sin, f, g } = &at;
    d.identity(
        "the discriminant of the cubic in A",
        of(
            cubic::in_opening_variable(&at, &at.sin.int(1), &Symbol::OpeningVariable.number()),
            Symbol::OpeningVariable,
        ),
        one.int(-27) * (g.square() * g * sin).square() * &radicand,
    )?;
    d.identity(
        "the discriminant of the cubic in h",
        of(cubic::in_thrust(&at, &at.sin.int(1), &Symbol::Thrust.number()), Symbol::Thrust),
        one.int(-27) * ((g.clone() - f) * sin).square() * radicand,
    )?;
    let heyman = f.square() - g.int(2) * g * sin + sin.square();
    d.identity(
        "for delta_M = 0 it is the discriminant of a quadratic times a square",
        cubic::radicand(&at, &one.int(0)),
        heyman * (f.clone() + g).square() * one.int(-3),
    )?;
    d.conclude(
        "Where (12) is negative, and f + g is not zero, each cubic has only simple real roots.",
    )
}

fn widest_joint(weight: SelfWeight) -> Checked<Ball> {
    Ok(landmark(Landmark::WidestJoint, weight)?.rotation_joint.rad)
}

fn signs_of_the_branches(d: &mut Derivation) -> Checked {
    lemmas(d, ["eq-12", "curve-thicknesses", "curve-order"])?;
    // The cubic in eta is linear in g: its points are (eta, f, S), free.
    let Abbreviations { sin, f, .. } = letters();
    let eta = Symbol::Thickness.number();
    let ring = Ring::with_flag(&eta.int(1), &eta);
    let rest = sin.clone() * eta.square() * &eta
        + f.int(3) * &f * eta.square()
        + eta.int(12) * &sin * &eta
        - f.int(12) * &f;
    let g = -(rest / (eta.int(3) * ring.intrados().square()));
    let at = Abbreviations { sin: sin.clone(), f: f.clone(), g };
    let zero = eta.int(0);
    d.identity("g from the cubic in eta", cubic::in_thickness(&at, &eta.int(1), &eta), &zero)?;
    // beta cot(beta) = (f - S)/S.
    let thrust = crate::arch::thrust::tangency(&((f - &sin) / &sin), &ring).value();
    let words = "(5) there is a root of the cubic in h";
    d.identity(words, cubic::in_thrust(&at, &at.sin.int(1), &thrust), &zero)?;
    let opening = thrust + overturning::opening_variable(&ring).value();
    let words = "(4) there is a root of the cubic in A";
    d.identity(words, cubic::in_opening_variable(&at, &at.sin.int(1), &opening), &zero)?;
    d.conclude(
        "For beta < beta_sb let eta_1 < eta_2 be the two thicknesses. Their states have alpha_1 < \
         alpha_sb < alpha_2, A_1 > A_2 > 0 and h_1 > h_2 > 0. In each cubic the product of the roots, \
         -(constant)/(leading coefficient), is negative, so that the third root is negative: the two \
         of the states are the two largest.",
    )?;

    let at = letters();
    let (q, no_root) = (Symbol::SquareRoot.number(), at.sin.int(0));
    let relations = relations(&ClosedForm::Thickness.cube(&at, &q));
    let forms = [
        ("(9)", ClosedForm::OpeningVariable, opening_root_factor(&at) / at.sin.int(2)),
        ("(10)", ClosedForm::Thickness, at.sin.int(2) * &at.sin),
        ("(11)", ClosedForm::Thrust, at.sin.int(3) * (at.g.clone() - &at.f)),
    ];
    for (name, form, _) in &forms {
        let (norm, product) = (form.cube(&at, &q) * form.cube(&at, &-q.clone()), form.product(&at));
        let words = format!("the norm of u³ in {name} is P³");
        d.identity_under(words, norm, product.square() * product, &relations)?;
    }
    for (name, form, factor) in forms {
        let words = format!("c, the factor of q in u³ of {name}");
        d.identity(words, (form.cube(&at, &q) - form.cube(&at, &no_root)) / &q, factor)?;
    }
    let joint = Symbol::joint();
    let wide = cubic::abbreviations(&joint);
    let excess = joint.rad.clone() - &joint.sin;
    let positive =
        excess.int(3) * &excess + joint.sin.int(3) * &joint.sin * &joint.cos + &joint.sin;
    let words = "3g - 2S, a sum of positive parts for beta < pi/2";
    d.identity(words, opening_root_factor(&wide), &positive)?;
    d.identity("g - f, a product of positive factors", wide.g - &wide.f, excess * joint.versine())?;
    for weight in SelfWeight::ALL {
        let joint = widest_joint(weight)?;
        let right = joint.pi() / joint.int(2);
        d.less(format!("beta_sb < pi/2, {weight} weight"), [&joint, &right])?;
    }
    let (k, free) = (Symbol::RootOfMinusThree.number(), Relations::none());
    let minus_three = free.with(Symbol::RootOfMinusThree, 2, Polynomial::from(-3));
    let words = "2/(1 - k), the second factor of the other sign, is (1 + k)/2, the first of this";
    let [other, this] = [k.int(2) / (k.int(1) - &k), (k.int(1) + &k) / k.int(2)];
    d.identity_under(words, &other, &this, &minus_three)?;
    d.conclude(
        "For beta < beta_sb the cubic has three simple real roots, so that (12) is negative; each c is positive; the \
         norm of u³ is P³ > 0. So u, the principal cube root, is √P e^(i t/3) with 0 < t < pi, and the two terms are \
         2 √P cos(t/3 - pi/3) for (1 + k)/2 and 2 √P cos(t/3 + pi/3) for (1 - k)/2, where k = i√3; the third root has \
         -2 √P cos(t/3). As t/3 < pi/3, the first is the largest and the second the middle one; scale and shift, with \
         positive scales, keep that order. The upper sign is (1 + k)/2 in (9) and (11), which takes the larger A and \
         h, and (1 - k)/2 in (10), which takes the smaller eta of the two: all belong to alpha_1. The lower sign \
         belongs to alpha_2.",
    )?;
    d.conclude(
        "With one sign in the first term and the other in the second both have the factor (1 + k)/2, or both (1 - \
         k)/2: their sum is that times 2 √P cos(t/3), which is positive, and so it is not real.",
    )
}

/// Sign changes of the radicand: ends of intervals that hold `beta_sb` and the next zero.
fn sign_changes(weight: SelfWeight) -> [(i32, i32); 2] {
    match weight {
        SelfWeight::Heyman => [(112, 114), (250, 251)],
        SelfWeight::Milankovitch => [(111, 113), (271, 272)],
    }
}

fn radicand_in_the_range_of_interest(d: &mut Derivation) -> Checked {
    lemmas(d, ["eq-12", "curve-thicknesses"])?;
    d.conclude(
        "For 0 < beta < beta_sb the roots are real and simple, so the discriminant is positive and (12) \
         negative (for delta_M = 0 the quadratic has two, and f + g = (beta + S)(1 + C) > 0). At \
         beta_sb there is a double root and (12) vanishes.",
    )?;
    for weight in SelfWeight::ALL {
        let hundredths = |n: i32| Rational::from((n, 100));
        let [first, second] = sign_changes(weight).map(|(a, b)| (hundredths(a), hundredths(b)));
        let radicand = |x: &Ball| {
            cubic::radicand(&cubic::abbreviations(&Angle::new(x.clone())), &x.int(weight.flag()))
        };
        let slope = |x: &Ball| {
            let joint = Angle::new(x.clone()).variable(0);
            cubic::radicand(&cubic::abbreviations(&joint), &Dual::constant(x.int(weight.flag())))
                .derivative(0)
        };
        let joint = widest_joint(weight)?;
        let words = format!("beta_sb lies in the first range, {weight}");
        d.certain(Support::Balls, words, [&first, &second], |(low, high)| {
            Ok(certain_if(joint.lies_inside(&between(low, high))))
        })?;
        d.positive(&format!("the slope of (12), {weight},"), (&first.0, &first.1), slope)?;
        d.positive(&format!("(12), {weight},"), (&first.1, &second.0), radicand)?;
        let words = format!("(12) is negative again at {}, {weight}", second.1);
        let fall = |joint: &Rational| -radicand(&between(joint, joint));
        d.above_zero(words, [&fall(&second.1), &fall(&second.0)])?;
    }
    d.conclude(
        "So (12) is negative before beta_sb, zero there with a positive slope, and positive after it up \
         to 5/2 (Heyman) and 271/100 (Milankovitch). It vanishes once more before 251/100 and 68/25; \
         there the roots of the cubic lie outside of (0, 2]. The range of interest has to end before.",
    )
}
