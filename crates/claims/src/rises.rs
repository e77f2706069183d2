//! Arches of one thickness and one rise, of which the longer stand more easily.
//!
//! Divide the thickness and the centroids' radius by the radius of the extrados:
//!
//! ```text
//! tau = 2 eta/(2 + eta)      g = 2 fac/(2 + eta)      n = -dg/d tau, between 0 and 1/2
//! ```
//!
//! The thickness over the rise of the extrados is `tau/(1 - cos(alpha))`. Where it is kept, `tau` falls with the half
//! opening, and each way in which an arch gives way is left behind: what its parts ask for falls faster than what they
//! have. The rate of a number is `D`, its slope to the logarithm of `1 - cos(alpha)`. All rests on one inequality,
//! Cusa's, `3 sin(x) < x (2 + cos(x))`: with `A = alpha cot(alpha/2)` it is `-D A = alpha/sin(alpha) - 1 > 2 - A`.

use super::contacts::{CONTACTS, margin_at};
use super::curve::{STATES_IN_ORDER, STATES_OF_ONE_THICKNESS};
use super::letters::{ring, with};
use super::rise_signs::{CusaSigns, HaunchSigns, ThickRingSigns, from_the_crown, ratio};
use super::sign::{AngleSigns, NotNegative, Positive};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{statics, thrust};
use crate::number::Field;
use crate::symbolic::{Fraction, Letters, Symbol, along_the_opening};

claims! {
    Implicit("rise-rotation", "Fig. 1", rotation):
        "where crown and shoulder are on the extrados and the haunch on the intrados, A less what the haunch asks of \
         it grows as the half opening falls and the thickness over the rise of the extrados is kept";
    Implicit("rise-overturning", "Fig. 1", overturning):
        "from a half circle on, where an inner joint slides, or without any thrust, the same way relieves the \
         shoulder's extrados";
    Implicit("rise-relief", "Fig. 1", relieved) as RELIEF:
        "up to a half circle a shoulder that slides has h >= 1 - alpha²/4 and, for h < 1, (alpha - h (1 - h)/alpha) \
         tan(alpha/2) more than [3 (1 - h) + (1 - h)²]/2";
    Implicit("rise-narrow", "Fig. 1", narrow):
        "up to a half circle, where the shoulder slides and the haunch is on the intrados, the same way relieves the \
         shoulder though it makes the thrust grow";
    Implicit("rise-wide", "Fig. 1", wide):
        "from a half circle on, where the shoulder slides and the haunch is on the intrados, the same way relieves the \
         shoulder though it makes the thrust grow";
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

fn rotation(d: &mut Derivation) -> Checked {
    lemmas(d, [&STATES_OF_ONE_THICKNESS])?;
    let ring = ThickRingSigns::of(d)?;
    let (haunch, alpha) = (HaunchSigns::of(d, &ring)?, CusaSigns::of_half_opening(d)?);
    let rate = rate_of_opening(d)?;
    let two = rate.int(2);
    let rest = rate - (two.clone() - opening_variable());
    (alpha.cusa / &alpha.angle.sin).is_on_circle(d, "-D A less 2 - A", rest)?;
    let h = thrust_of_haunch();
    let [thrust] = NotNegative::given(d, "h >= 0, h of (2)", [&h]);
    let asked = h + centroids();
    let value = two - &asked + along_the_rise(&asked);
    let versine = &haunch.signs.angle.versine;
    let first = haunch.signs.below_two / versine;
    let bracket = haunch.bulge / versine + &ratio(1, 2) + &ring.half_less_fall;
    let bracket = bracket + &(thrust * &haunch.cos / versine);
    let square = ring.slenderness.clone() * &ring.slenderness * &haunch.cos;
    let sum = first + &(square * &bracket / &haunch.arm);
    let words = "2 - a + D a, where a = h + 2 fac/(2 + eta), h of (2), is what a haunch asks of A";
    sum.is_on_circle(d, words, value)?;
    d.conclude(
        "Where A = a, D(A - a) = -(alpha/sin(alpha) - 1) + D a < -(2 - A) + (2 - a) = 0, at each haunch, so that the \
         joint need not be the same along the way.",
    )
}

/// `alpha/sin(alpha) - 1 - tau n` from a half circle on.
fn room_of_wide_arches(
    d: &mut Derivation,
    ring: &ThickRingSigns,
    alpha: &AngleSigns,
    rate: &Fraction,
) -> Checked<Positive> {
    let at = Symbol::half_opening();
    let [beyond] = Positive::given(d, "pi/2 <= alpha", [&(at.rad.clone() - at.rad.ratio(3, 2))]);
    let [rest] = NotNegative::given(d, "sin(alpha) <= 1", [&(at.sin.int(1) - &at.sin)]);
    let sum = beyond + &(rest * &alpha.rad / &alpha.sin) + &ring.half_of_rest;
    let sum = sum + &(ring.half_less_fall.clone() * &ring.slenderness);
    let value = rate.clone() + along_the_rise(&centroids());
    sum.is_on_circle(d, "D(g - A), where there is no thrust and g = A", value)
}

fn overturning(d: &mut Derivation) -> Checked {
    lemmas(d, [&CONTACTS])?;
    let ring = ThickRingSigns::of(d)?;
    let (joint, alpha) = (CusaSigns::of_joint(d)?, CusaSigns::of_half_opening(d)?);
    let rate = rate_of_opening(d)?;
    let room = room_of_wide_arches(d, &ring, &alpha.angle, &rate)?;
    let (haunch, shoulder) = (Symbol::joint(), Symbol::half_opening());
    let h = Symbol::Thrust.number();
    let sum = margin_at(Contact::Intrados, &haunch) + margin_at(Contact::Extrados, &shoulder);
    let margin = sum * h.int(2) / self::ring().extrados();
    let [above] = Positive::given(d, "beta < alpha", [&(haunch.cos - &shoulder.cos)]);
    let words = "h >= A - g: the crown's U is no less than the shoulder's";
    let [more] = NotNegative::given(d, words, [&(h + centroids() - opening_variable())]);
    let versine = &joint.angle.versine;
    let bracket = above * &room + &(alpha.cusa / &alpha.angle.sin * versine) + &joint.below_two;
    let words = "M - D M, where M = [L(beta) + U(alpha)]/(1 + eta/2) and h is kept";
    let value = margin.clone() - along_the_rise(&margin);
    (bracket + &(more * versine)).is_on_circle(d, words, value)?;
    d.conclude(
        "So M grows where it is zero, as the half opening falls: with the thrust that friction asks for, there is \
         room between haunch and shoulder. At the crown, beta = 0, the first term alone is left.",
    )
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

/// `1 - h + tau/2 + D h`, `h` of (2).
fn growth_of_thrust(
    d: &mut Derivation,
    ring: &ThickRingSigns,
    haunch: &HaunchSigns,
) -> Checked<Positive> {
    let h = thrust_of_haunch();
    let [rest] = Positive::given(d, "h < 1", [&(h.int(1) - &h)]);
    let versine = &haunch.signs.angle.versine;
    let slenderness = &ring.slenderness;
    let held = rest.clone() + &(slenderness.clone() / &Positive::int(2));
    let sum = haunch.signs.below_two.clone() + &(slenderness.clone() * &haunch.cos * &held);
    let sum = sum + &(ring.lift.clone() * versine);
    let sum = (sum + &(ring.fall.clone() * slenderness * versine)) / &haunch.arm;
    let value = h.int(1) - &h + self::slenderness() / h.int(2) + along_the_rise(&h);
    sum.is_on_circle(d, "1 - h + tau/2 + D h, h of (2)", value)?;
    Ok(rest)
}

fn wide(d: &mut Derivation) -> Checked {
    lemmas(d, [&STATES_OF_ONE_THICKNESS, &STATES_IN_ORDER])?;
    let ring = ThickRingSigns::of(d)?;
    let (haunch, alpha) = (HaunchSigns::of(d, &ring)?, AngleSigns::of_half_opening(d)?);
    sliding_shoulder(d)?;
    growth_of_thrust(d, &ring, &haunch)?;
    let (at, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let words = "pi/2 <= alpha";
    let [beyond] = Positive::given(d, words, [&(at.rad.clone() - at.rad.ratio(3, 2))]);
    let [falling] = NotNegative::given(d, "cos(alpha) <= 0", [&-at.cos.clone()]);
    let [flat] = NotNegative::given(d, "sin(alpha) <= 1", [&(at.sin.int(1) - &at.sin)]);
    let [thrust, rest] = NotNegative::given(d, "0 <= h <= 1", [&h, &(h.int(1) - &h)]);
    let over_rest = beyond.clone() + &ratio(1, 2) + &thrust;
    let level = beyond * &alpha.rad + &(thrust * &over_rest);
    let whole = level.clone() + &((rest.clone() + &ratio(1, 2)) * &alpha.rad);
    let steep = (flat + &falling) / &alpha.sin;
    let sum = level / &alpha.rad + &(steep * &whole / &alpha.rad) + &ring.half_of_rest;
    let value = relief() - (h.int(1) - &h) - slenderness() / h.int(2);
    sum.is_on_circle(d, "X - (1 - h) - tau/2", value)?;
    d.conclude(
        "So X + D h is positive: as the half opening falls mu N + T grows where it is zero, though h is the thrust of \
         the haunch.",
    )
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
    let (alpha, h) = (CusaSigns::of_half_opening(d)?, Symbol::Thrust.number());
    let lack = h.int(1) - &h;
    let [lack_sign] = Positive::given(d, "h < 1", [&lack]);
    let rest = Symbol::HalfOpening.number().square() - h.int(4) * &lack;
    let [more] = NotNegative::given(d, "h >= 1 - alpha²/4", [&rest]);
    let whole = (Positive::int(3) + &lack_sign) * &lack_sign + &more;
    let tangent = alpha.below_two / &(Positive::int(2) * &alpha.angle.sin);
    let sum = whole / &alpha.angle.rad * &tangent + &(more / &Positive::int(2));
    let gain = (h.int(3) * &lack + lack.square()) / h.int(2);
    let words = "(alpha - h (1 - h)/alpha) tan(alpha/2) - [3 (1 - h) + (1 - h)²]/2";
    sum.is_on_circle(d, words, relief() - gain)?;
    Ok(())
}

/// `3 (1 - h)²/4 - tau h`, `h` of (2): it is at least a square.
fn thin_if_thrust_is_large(
    d: &mut Derivation,
    ring: &ThickRingSigns,
    haunch: &HaunchSigns,
    rest: &Positive,
) -> Checked {
    let (joint, h) = (Symbol::joint(), thrust_of_haunch());
    let [thrust] = NotNegative::given(d, "h >= 0", [&h]);
    let CusaSigns { angle, cusa, .. } = &haunch.signs;
    let (versine, slenderness) = (&angle.versine, &ring.slenderness);
    let square = joint.rad.square();
    let value = square.clone() / h.int(2) - joint.versine();
    let sagging = from_the_crown(d, &angle.excess, "beta²/2 - (1 - cos(beta))", &value)?;
    let slope = angle.rad.clone() * &angle.rad * &angle.sin / &Positive::int(6);
    let (third, sixth) = (h.ratio(1, 3), h.ratio(1, 6));
    let value = (joint.rad.clone() * &joint.sin - joint.versine()) * &third
        - square.clone() * &joint.cos * &sixth;
    let words = "[beta sin(beta) - (1 - cos(beta))]/3 - beta² cos(beta)/6";
    let slope = from_the_crown(d, &slope, words, &value)?;
    let value = joint.sin.clone()
        - joint.rad.clone() * (joint.cos.int(2) * &joint.cos + h.int(1)) * &third
        - square.clone() * &joint.sin * &sixth;
    let words = "sin(beta) - beta (1 + 2 cos(beta))/3 - beta² sin(beta)/6";
    let slope = from_the_crown(d, &slope, words, &value)?;
    let value =
        (h.int(2) - square.clone() * &sixth) * joint.versine() - joint.rad.clone() * &joint.sin;
    let words = "(2 - beta²/6) (1 - cos(beta)) - beta sin(beta)";
    let below = from_the_crown(d, &slope, words, &value)?;
    let half = ratio(1, 2);
    let normal = haunch.bulge.clone() + &(half.clone() * versine) + &(thrust * &haunch.cos);
    let gap = normal * slenderness + &(ring.lift.clone() * versine);
    let value = joint.rad.clone() * &joint.sin - joint.versine() * (h.int(1) + &h);
    let words = "beta sin(beta) - (1 + h) (1 - cos(beta)), h of (2)";
    let gap = gap.is_on_circle(d, words, value)?;
    let two_and_cos = Positive::int(2) + &haunch.cos;
    let bulge = cusa.clone() * &angle.sin + &(ratio(3, 2) * versine * &haunch.cos);
    let value = joint.rad.clone() * &joint.sin - joint.versine() * h.ratio(3, 2);
    let words = "beta sin(beta) - 3/2 (1 - cos(beta))";
    let bulge = (bulge / &two_and_cos).is_on_circle(d, words, value)?;
    let sum = sagging * &gap / versine
        + &(half * &angle.rad * &angle.rad * &below / versine)
        + &(slenderness.clone() * &(bulge + &(rest.clone() * versine)))
        + &(ring.lift.clone() * versine);
    let lack = h.int(1) - &h;
    let nearest = (square - lack.int(3) * &lack).square() / h.int(12);
    let value = h.ratio(3, 4) * lack.square() - self::slenderness() * &h - nearest;
    let words = "3/4 (1 - h)² - tau h, h of (2), less the square of beta² - 3 (1 - h) over 12";
    sum.is_on_circle(d, words, value)?;
    Ok(())
}

fn narrow(d: &mut Derivation) -> Checked {
    lemmas(d, [&STATES_OF_ONE_THICKNESS, &STATES_IN_ORDER, &RELIEF])?;
    let ring = ThickRingSigns::of(d)?;
    let haunch = HaunchSigns::of(d, &ring)?;
    sliding_shoulder(d)?;
    let rest = growth_of_thrust(d, &ring, &haunch)?;
    thin_if_thrust_is_large(d, &ring, &haunch, &rest)?;
    let (at, h) = (Symbol::half_opening(), Symbol::Thrust.number());
    let lack = h.int(1) - &h;
    let square = at.rad.square();
    let [lack_sign] = Positive::given(d, "h < 1", [&lack]);
    let words = "alpha <= pi/2";
    let [room] = Positive::given(d, words, [&(at.rad.ratio(5, 2) - &square)]);
    let words = "h >= 1 - alpha²/4";
    let [more] = NotNegative::given(d, words, [&(square - h.int(4) * &lack)]);
    let gain = (lack.clone() + lack.square()) / h.int(2);
    let below = (room + &more) / &Positive::int(4);
    let sum = below * &(ratio(11, 2) + &(Positive::int(4) * &lack_sign)) + &ratio(9, 16);
    let sum = sum * &lack_sign / &Positive::int(8);
    let words = "h [(1 - h) + (1 - h)²]/2 - 3/8 (1 - h)²";
    sum.is(d, words, gain * &h - h.ratio(3, 8) * lack.square())?;
    d.conclude(
        "With 1 - h <= alpha²/4 < 5/8, h is positive; h (X + D h) >= h (X - (1 - h)) - tau h/2 is positive, and so is \
         X + D h: as the half opening falls mu N + T grows where it is zero, though h is the thrust of the haunch.",
    )
}
