//! Letters of claims about arches of one rise, and what relieves a shoulder that slides.
//!
//! Divide the thickness and the centroids' radius by the radius of the extrados:
//!
//! ```text
//! tau = 2 eta/(2 + eta)      g = 2 fac/(2 + eta)      n = -dg/d tau, between 0 and 1/2
//! ```
//!
//! The thickness over the rise of the extrados is `tau/(1 - cos(alpha))`. The rate of a number where it is kept is `D`,
//! its slope to the logarithm of `1 - cos(alpha)`: with `A = alpha cot(alpha/2)` it is `-D A = alpha/sin(alpha) - 1`.

use super::contacts::margin_at;
use super::letters::{ring, with};
use super::sign::{AngleSigns, FromZero, NotNegative, Positive};
use super::{Checked, Derivation, claims};
use crate::arch::mechanism::Contact;
use crate::arch::{statics, thrust};
use crate::number::Field;
use crate::symbolic::{Fraction, Letters, Relations, Symbol, along_the_opening};

claims! {
    Ours("rise-relief", "Fig. 1", relieved):
        "up to a half circle a shoulder that slides has h >= 1 - alpha²/4 and, for h < 1, (alpha - h (1 - h)/alpha) \
         tan(alpha/2) more than [3 (1 - h) + (1 - h)²]/2";
}

/// Rate `D` where the thickness over the rise of the extrados is kept.
pub(super) fn along_the_rise(value: &Fraction) -> Fraction {
    let (ring, alpha) = (ring(), Symbol::half_opening());
    let by_thickness = value.partial(Symbol::Thickness) * &ring.thickness * ring.extrados();
    let by_opening = value.derivative(&along_the_opening()) * alpha.versine() / &alpha.sin;
    by_thickness / value.int(2) + by_opening
}

/// `tau`, the thickness over the radius of the extrados.
pub(super) fn slenderness() -> Fraction {
    let ring = ring();
    ring.thickness.int(2) * &ring.thickness / ring.extrados()
}

/// `g`, the radius of the centroids over that of the extrados.
pub(super) fn centroids() -> Fraction {
    let ring = ring();
    ring.thickness.int(2) * &ring.centroid_factor / ring.extrados()
}

/// The thrust that a haunch asks for, (2).
pub(super) fn thrust_of_haunch() -> Fraction {
    thrust::lower(&Symbol::joint(), &ring()).value()
}

/// `A` of the half opening.
pub(super) fn opening_variable() -> Fraction {
    thrust::opening_variable(&Symbol::half_opening()).value()
}

/// `X = (alpha - h (1 - h)/alpha) tan(alpha/2)`, by which the shoulder's friction is relieved.
pub(super) fn relief() -> Fraction {
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let rest = alpha.rad.square() - h.clone() * (h.int(1) - &h);
    rest * alpha.versine() / (alpha.rad * alpha.sin)
}

/// `alpha/sin(alpha) - 1`, by which `A` grows as the half opening falls.
pub(super) fn rate_of_opening(d: &mut Derivation) -> Checked<Fraction> {
    let alpha = Symbol::half_opening();
    let rate = (alpha.rad.clone() - &alpha.sin) / &alpha.sin;
    d.on_circle("-D A", -along_the_rise(&opening_variable()), &rate)?;
    Ok(rate)
}

/// The friction of a shoulder that slides, as the half opening falls and the thrust grows.
pub(super) fn sliding_shoulder(d: &mut Derivation) -> Checked {
    let (alpha, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let normal = statics::normal_force(&alpha, &h);
    let friction = -statics::shear_force(&alpha, &h) / &normal;
    let margin = margin_at(Contact::Outwards, &alpha);
    let at_limit = |slope: Fraction| with(&slope, &[Symbol::Friction], &friction) * &normal;
    let slope = at_limit(margin.derivative(&along_the_opening()));
    let expected = h.clone() * (h.int(1) - &h) - alpha.rad.square();
    d.on_circle("N d(mu N + T)/d alpha at the shoulder, where it slides", slope, expected)?;
    let slope = at_limit(margin.partial(Symbol::Thrust));
    d.on_circle("N d(mu N + T)/dh there", slope, -alpha.rad)?;
    let words = "X = (alpha - h (1 - h)/alpha) tan(alpha/2): N D(mu N + T) = -alpha (X + D h)";
    d.define(words, &relief());
    Ok(())
}

/// `2 (1 - cos(alpha)) - alpha sin(alpha)`, so that `A < 2`.
fn below_two(d: &mut Derivation, angle: &AngleSigns) -> Checked<Positive> {
    let alpha = Symbol::half_opening();
    let at_zero = |symbol| match symbol {
        Symbol::HalfOpening | Symbol::SineOfOpening => Some(0),
        Symbol::CosineOfOpening => Some(1),
        _ => None,
    };
    let (rules, relations) = (along_the_opening(), Relations::none());
    let range = &FromZero { rules: &rules, at_zero: &at_zero, relations: &relations };
    let turn = angle.rad.clone() * &angle.sin;
    let value = alpha.sin.clone() - alpha.rad.clone() * &alpha.cos;
    let turn = turn.is_slope_of(d, "sin(alpha) - alpha cos(alpha)", &value, range)?;
    let value = alpha.versine() * alpha.rad.int(2) - alpha.rad * alpha.sin;
    turn.is_slope_of(d, "2 (1 - cos(alpha)) - alpha sin(alpha)", &value, range)
}

/// The least thrust of a shoulder that slides, and what relieves it.
fn relieved(d: &mut Derivation) -> Checked {
    let (joint, h) = (Symbol::joint(), Symbol::Thrust.number());
    let [tangent, slope] = [joint.rad.clone() / &h, joint.sin.clone() / &joint.cos];
    let angle = (tangent.clone() - &slope) / (tangent.int(1) + tangent * &slope);
    let friction = statics::shear_force(&joint, &h) / statics::normal_force(&joint, &h);
    d.identity("T/N is the tangent of arctan(beta/h) - beta", &friction, angle)?;
    let alpha = Symbol::HalfOpening.number();
    let h = alpha.int(1) - alpha.square() / alpha.int(4);
    let turning = |x: Fraction| {
        let slope = x.partial(Symbol::HalfOpening);
        slope / (x.square() + x.int(1))
    };
    let sum = turning(alpha.clone() / (h.clone() * h.int(2))) + turning(alpha.clone() / &h);
    let fourth = alpha.square().square();
    let gain = fourth.int(3) * &fourth * (alpha.int(4) - alpha.square());
    let words = "the slope of arctan(alpha/(2 h)) + arctan(alpha/h) - 3 alpha/2 at h = 1 - alpha²/4: positive below 2";
    let below = (fourth.int(64) + fourth * alpha.square()) * alpha.int(2);
    d.identity(words, sum - alpha.ratio(3, 2), gain / below)?;
    d.conclude(
        "No inner joint slides, not that at alpha/2, while the shoulder does: the two arctangents are at most 3/2 \
         alpha. They fall as h grows, so that h >= 1 - alpha²/4.",
    )?;
    let (alpha, h) = (AngleSigns::of_half_opening(d)?, Symbol::Thrust.number());
    let lack = h.int(1) - &h;
    let [lack_sign] = Positive::given(d, "h < 1", [&lack]);
    let rest = Symbol::HalfOpening.number().square() - h.int(4) * &lack;
    let [more] = NotNegative::given(d, "h >= 1 - alpha²/4", [&rest]);
    let whole = (Positive::int(3) + &lack_sign) * &lack_sign + &more;
    let tangent = below_two(d, &alpha)? / &(Positive::int(2) * &alpha.sin);
    let sum = whole / &alpha.rad * &tangent + &(more / &Positive::int(2));
    let gain = (h.int(3) * &lack + lack.square()) / h.int(2);
    let words = "(alpha - h (1 - h)/alpha) tan(alpha/2) - [3 (1 - h) + (1 - h)²]/2";
    sum.is_on_circle(d, words, relief() - gain)?;
    Ok(())
}
