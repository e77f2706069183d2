//! The curve of purely rotational states, for both self-weights: to each thickness below that of `l`
//! belongs one joint, one thrust and one half opening.
//!
//! Let `p` be the cubic (7) in `eta` with `delta_M` kept, `S`, `C` the sine and cosine of `beta`. All
//! follows from one identity, on `0 < beta < pi`:
//!
//! ```text
//! d(p/S)/d beta = 3 (2 - eta) (2 + eta - (2 - eta) C) (beta - S C) / S²
//! ```
//!
//! For `0 < eta < 2` every factor is positive, so that **`p/S` grows with `beta`**: from
//! `eta (delta_M eta² + 12 eta - 12)` at the crown, which is negative exactly below `eta_l`, to `+inf`
//! at `pi`. So `p = 0` has one root `beta(eta)` if `eta < eta_l`, and none if `eta_l <= eta < 2`.
//!
//! In the other direction, at a fixed joint, `p` is convex in `eta > 0` and positive at 0 and at 2, so
//! that it has two roots in `(0, 2)`, a double one or none. As `p/S` grows, it is two for
//! `beta < beta_sb`, the double one at `beta_sb`, and none beyond.

use super::letters::ring;
use super::sign::{AngleSigns, Positive, RingSigns};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::{Ring, cubic, overturning, thrust};
use crate::number::{Angle, Ball, Dual, Field, Real};
use crate::problem::Mode;
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint, along_the_opening};
use rug::Rational;

claims! {
    Implicit("curve-joint", "Sec. 2.1", one_joint_for_each_thickness):
        "for each thickness below eta_l the line of thrust can touch the intrados at exactly one joint beta(eta), \
         and for none from eta_l up to 2; p/S, where p is the cubic (7) in eta, grows with beta";
    AsPrinted("curve-thicknesses", "Eq. (7), (10)", two_thicknesses_for_each_joint):
        "two real branches are meaningful: for each joint beta < beta_sb the cubic in eta has exactly two roots \
         between 0 and 2, a double one at beta_sb and none beyond; the third, for delta_M = 1, is negative";
    AsPrinted("curve-order", "Sec. 2.1, Fig. 2", states_in_order):
        "along the purely rotational states the half opening grows from 0 to alpha_l and the thrust falls from 1 to \
         0 as the thickness grows from 0 to eta_l; to each half opening below alpha_l belongs exactly one state";
    Ours("curve-weights", "Sec. 3", states_of_one_thickness):
        "at the same thickness the purely rotational state of Milankovitch's weight has a smaller half opening and a \
         smaller thrust than that of Heyman's, and the purely overturning one a smaller half opening; its rotational \
         joint is the smaller one, and below a right angle";
    AsPrinted("curve-widest", "Sec. 2.1", widest_joint):
        "beta_r(alpha) is stationary where (12) vanishes, and widest there";
}

/// The cubic (7) in `eta`.
pub(super) fn cubic_of<T: Field>(joint: &Angle<T>, delta: &T, eta: &T) -> T {
    cubic::in_thickness(&cubic::abbreviations(joint), delta, eta)
}

/// The cubic (7) in `eta`, with `beta`, `S`, `C`, `delta_M` as letters.
fn cubic_in_thickness() -> Fraction {
    cubic_of(&Symbol::joint(), &Symbol::Flag.number(), &Symbol::Thickness.number())
}

fn one_joint_for_each_thickness(d: &mut Derivation) -> Checked {
    let (joint, ring) = (Symbol::joint(), ring());
    let (eta, delta, p) = (&ring.thickness, Symbol::Flag.number(), cubic_in_thickness());
    let (angle, signs) = (AngleSigns::of_joint(d)?, RingSigns::of(d)?);
    let lever = signs.lever_arm(d, &angle)?;
    let gap =
        thrust::lower(&joint, &ring).difference(&thrust::tangency(&joint.times_cotangent(), &ring));
    let words = "(2) = (5) is the cubic: 3 S times their difference, cleared of denominators";
    d.on_circle(words, gap * &joint.sin * p.int(3), &p)?;
    let slope = (p.clone() / &joint.sin).derivative(&along_the_joint());
    let rise = Positive::int(3) * &signs.intrados * &lever * &angle.bow;
    (rise / &(angle.sin.clone() * &angle.sin)).is_on_circle(d, "d(p/S)/d beta", &slope)?;
    let crown = Angle { rad: p.int(1), sin: p.int(1), cos: p.int(1) };
    let at_crown = (delta.clone() * eta.square() + eta.int(12) * eta - eta.int(12)) * eta;
    let words = "p/beta in the limit beta -> 0, where S/beta and C are 1";
    d.identity(words, cubic_of(&crown, &delta, eta), &at_crown)?;
    let flat = Angle { rad: joint.rad.clone(), sin: p.int(0), cos: p.int(-1) };
    (Positive::int(12) * &signs.intrados * &angle.rad).is(
        d,
        "p at beta = pi, where S = 0 and C = -1",
        cubic_of(&flat, &delta, eta),
    )?;
    (signs.flag.clone() * &signs.thickness * &Positive::int(2) + &Positive::int(12)).is(
        d,
        "the slope to eta of (p/beta)/eta at the crown",
        (at_crown.clone() / eta).partial(Symbol::Thickness),
    )?;
    d.identity(
        "what is negative at the crown is the condition behind (16), so eta_l is where it changes sign",
        at_crown / eta,
        overturning::end_of_rotation(&ring) * p.int(-12),
    )?;
    d.conclude(
        "p/S grows with beta on (0, pi), from eta (delta_M eta^2 + 12 eta - 12) to +inf. The bracket \
         grows with eta and vanishes at eta_l. So p = 0 has exactly one root beta(eta) if eta < eta_l and none if \
         eta_l <= eta < 2; beta(eta) is analytic, since the slope is not zero.",
    )
}

fn two_thicknesses_for_each_joint(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-joint"])?;
    let joint = Symbol::joint();
    let (angle, signs) = (AngleSigns::of_joint(d)?, RingSigns::of(d)?);
    let (p, delta) = (cubic_in_thickness(), Symbol::Flag.number());
    let at = |eta: i32| cubic_of(&joint, &delta, &p.int(eta));
    let thin = Positive::int(12) * &angle.excess * &angle.versine;
    thin.is(d, "p at eta = 0", at(0))?;
    let thick = Positive::int(8) * &angle.sin * &(signs.flag.clone() + &Positive::int(3));
    thick.is(d, "p at eta = 2", at(2))?;
    let bend = p.partial(Symbol::Thickness).partial(Symbol::Thickness);
    let flat = signs.flag.clone() * &signs.thickness * &angle.sin * &Positive::int(6);
    let sum = (angle.rad.clone() + &angle.sin) * &angle.coversine * &Positive::int(6);
    (flat + &sum).is(d, "d²p/d eta²", &bend)?;
    let leading = p.numerator().leading_coefficient(Symbol::Thickness);
    d.identity("the coefficient of eta³", Fraction::from(leading), delta * &joint.sin)?;
    d.conclude(
        "At a fixed joint p is strictly convex in eta >= 0 and positive at 0 and at 2: it has two \
         roots in (0, 2), a double one, or none. For delta_M = 1 it falls to -inf for eta -> -inf, so \
         that the third root is negative. Let beta_sb be the largest beta(eta), taken at eta_sb (it \
         exists, as beta(eta) -> 0 for eta -> 0, where p > 0, and for eta -> eta_l). For beta < \
         beta_sb, p(eta_sb) < 0, since p/S grows with beta: two roots, one on each side of eta_sb. At \
         beta_sb, p >= 0 and eta_sb is a double root. Beyond, p > 0 on [0, 2].",
    )
}

/// Thicker states are wider and carry less thrust.
fn states_in_order(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-joint"])?;
    let (joint, ring) = (Symbol::joint(), ring());
    let (angle, signs) = (AngleSigns::of_joint(d)?, RingSigns::of(d)?);
    let wide = AngleSigns::of_half_opening(d)?;
    let (eta, delta) = (ring.thickness.clone(), Symbol::Flag.number());
    let arm = signs.lever_arm(d, &angle)?;
    let lower = thrust::lower(&joint, &ring);
    let (lever, h_lower) = (lower.denominator.clone(), lower.value());
    let one = eta.int(1);
    d.on_circle(
        "h_L of (2) is stationary in beta where p = 0",
        h_lower.derivative(&along_the_joint()),
        -(cubic_in_thickness() / (one.int(3) * lever.square())),
    )?;
    let loss = Positive::int(4) * &angle.sin * &angle.excess
        + &(Positive::int(2) * &angle.sin * &angle.sin * &signs.unfactored)
        + &(signs.flag.clone() * &signs.thickness * &angle.versine * &arm / &Positive::int(3));
    let words = "the fall of h_L with eta";
    (loss / &(arm.clone() * &arm)).is_on_circle(d, words, -h_lower.partial(Symbol::Thickness))?;
    let rest = overturning::opening_variable(&ring).value();
    let six = Positive::int(6) + &signs.thickness;
    let four = Positive::int(4) + &signs.thickness;
    let fall = six * &signs.intrados + &(signs.unflagged.clone() * &signs.thickness * &four);
    (fall / &(Positive::int(6) * &signs.extrados * &signs.extrados)).is(
        d,
        "the fall of 2 fac/(2 + eta) with eta",
        -rest.partial(Symbol::Thickness),
    )?;
    let opening = thrust::opening_variable(&Symbol::half_opening()).value();
    (wide.excess / &wide.versine).is_on_circle(
        d,
        "the fall of A with alpha",
        -opening.derivative(&along_the_opening()),
    )?;
    let straight = Angle { rad: one.int(0), sin: one.int(0), cos: one.clone() };
    let words = "at beta = 0 (2) gives no thrust, so h -> 0 for eta -> eta_l";
    d.identity(words, thrust::lower(&straight, &ring).value(), one.int(0))?;
    let words = "at beta = 0 and eta = 0 (5) gives h = 1, so h -> 1 and A -> 2 for eta -> 0";
    d.identity(words, thrust::tangency(&one, &Ring::with_flag(&delta, &one.int(0))).value(), &one)?;
    d.conclude(
        "Along the curve dh/d eta is the partial derivative of h_L, which is negative, and with (4) \
         dA/d eta is negative too, so that d alpha/d eta > 0: eta, alpha and -h \
         grow together. (4) with 0 <= alpha < alpha_l is then met exactly once.",
    )?;
    d.conclude(format!(
        "So the equations of {} have exactly one solution with 0 < beta < pi and 0 < eta < 2 for each \
         alpha < alpha_l, and none from alpha_l on.",
        Mode::Rotational.label()
    ))
}

/// At one thickness a larger `delta_M` means a smaller half opening and a smaller thrust.
fn states_of_one_thickness(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-order"])?;
    let (joint, ring) = (Symbol::joint(), ring());
    let (angle, signs) = (AngleSigns::of_joint(d)?, RingSigns::of(d)?);
    let [cosine] = Positive::given(d, "beta < pi/2, which is shown below", [&joint.cos]);
    let arm = signs.lever_arm(d, &angle)?;
    let square = signs.thickness.clone() * &signs.thickness / &Positive::int(6);
    let h_lower = thrust::lower(&joint, &ring).value();
    let rest = overturning::opening_variable(&ring).value();
    let words =
        "the derivative of A = h_L + 2 fac/(2 + eta) to delta_M, at a fixed joint and thickness";
    (Positive::int(2) * &square * &signs.thickness * &cosine / &(arm.clone() * &signs.extrados))
        .is(d, words, (h_lower.clone() + &rest).partial(Symbol::Flag))?;
    (square.clone() * &angle.versine / &arm).is(
        d,
        "the fall of h_L with delta_M",
        -h_lower.partial(Symbol::Flag),
    )?;
    let words = "the derivative of (13) to delta_M";
    (square / &signs.extrados).is(d, words, rest.partial(Symbol::Flag))?;
    (angle.sin * &signs.thickness * &signs.thickness * &signs.thickness).is(
        d,
        "the derivative of p to delta_M",
        cubic_in_thickness().partial(Symbol::Flag),
    )?;
    let at_right_angle = |eta: &Ball| {
        let half = eta.pi() / eta.int(2);
        let right = Angle { rad: half, sin: eta.int(1), cos: eta.int(0) };
        cubic_of(&right, &eta.int(0), eta)
    };
    let range = (&Rational::new(), &Rational::from(2));
    d.positive("p at beta = pi/2 with delta_M = 0, in eta,", range, at_right_angle)?;
    d.conclude(
        "p grows with delta_M, and with beta over S: beta(eta) falls with delta_M. At pi/2 p is positive, so that \
         every beta(eta) is smaller, cos(beta) > 0. As h_L is stationary in beta, the partial derivatives are those \
         along the states of one thickness: A grows with delta_M, so that alpha falls, and h falls. Where the state \
         is overturning, A = 2 fac/(2 + eta) grows too.",
    )
}

/// `d beta/d alpha = 0` exactly at the double root, which is the widest joint.
fn widest_joint(d: &mut Derivation) -> Checked {
    lemmas(d, ["curve-joint", "curve-thicknesses", "curve-order"])?;
    // The two equations that define the landmark `sb` besides (4): p and its derivative, up to 3 S.
    let (joint, ring) = (Symbol::joint(), ring());
    let eta = Dual::variable(ring.thickness.clone(), 0);
    let dual = joint.clone().map(Dual::constant);
    let dual_ring = Ring::with_flag(&Dual::constant(Symbol::Flag.number()), &eta);
    let gap = thrust::lower(&dual, &dual_ring)
        .difference(&thrust::tangency(&dual.times_cotangent(), &dual_ring));
    let p = cubic_in_thickness();
    let words = "the derivative of the cleared (2) = (5) to eta is that of p over 3 S";
    d.on_circle(words, gap.derivative(0) * p.int(3) * &joint.sin, p.partial(Symbol::Thickness))?;
    d.conclude(
        "d beta/d eta = -(dp/d eta)/(dp/d beta), and d alpha/d eta > 0: beta_r(alpha) is stationary \
         exactly where dp/d eta = 0, at a double root of the cubic, where its discriminant, and with it \
         (12), is zero. With p convex in eta this is a maximum of beta(eta); so there is only one, it is \
         the widest joint of all, and it is the root of the system of sb.",
    )
}
