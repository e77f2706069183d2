//! Asymmetric motions of the whole arch: none up to a half opening of 90°, and three kinds beyond.
//!
//! With a vertical force `v > 0` in the crown the line of thrust reaches the extrados on the right only and the
//! intrados on the left only, and each joint that slides moves what is left of it upwards, but for the right
//! springing of a horseshoe.

use super::asymmetric::ASYMMETRIC_MOTION;
use super::letters::ring;
use super::uniqueness::ONE_THICKNESS;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::statics;
use crate::arch::whole::{Forces, Side, carried, margin, motion_row};
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};

claims! {
    Implicit("asymmetric-narrow", "Eq. (19), Sec. 5", narrow) as NARROW:
        "up to a half opening of 90° the whole arch has no asymmetric motion: where a vertical force works in the crown no \
         rates without dilatancy fit, whichever joints are at their limits, so that (19) has its solutions at the least \
         thickness alone, except at the friction of pure sliding";
    Implicit("asymmetric-kinds", "Eq. (19), Sec. 5", kinds) as KINDS:
        "a solution of (19) with a vertical force in the crown has a half opening above 90°; its state, or the mirror \
         image of it, slides outwards at the right springing, touches the extrados at a joint inside the right half and \
         the intrados at a joint of the left half or, at eta = 2, in the crown, and its motion is a sum of those of the \
         three kinds of asymmetric-motion";
}

/// The forces as letters.
fn forces() -> Forces<Fraction> {
    let [thrust, moment, vertical] =
        [Symbol::Thrust, Symbol::CrownMoment, Symbol::CrownShear].map(Symbol::number);
    Forces { thrust, moment, vertical }
}

/// The margin of a joint of the whole arch.
pub(super) fn margin_at(contact: Contact, joint: &Angle<Fraction>) -> Fraction {
    let mu = Symbol::Friction.number();
    let grip = Grip { shear: mu.int(1), normal: mu };
    margin(contact, joint, &ring(), &grip, &forces())
}

/// The normal and the shear force on a joint.
pub(super) fn borne(joint: &Angle<Fraction>) -> [Fraction; 2] {
    let Forces { thrust, vertical, .. } = forces();
    let joint = carried(joint, &vertical);
    [statics::normal_force(&joint, &thrust), statics::shear_force(&joint, &thrust)]
}

/// The row of a joint without dilatancy: what it adds to the right, as a rotation and upwards.
fn row(contact: Contact, joint: &Angle<Fraction>) -> [Fraction; 3] {
    let eta = ring().thickness;
    motion_row(contact, joint, &eta, &eta.int(0))
}

fn narrow(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha <= 90°, 0 < eta <= 2, 0 <= mu < inf; a state that is admissible at each joint of [-alpha, alpha]");
    lemmas(d, [&ONE_THICKNESS])?;
    let joint = Symbol::joint();
    let two = joint.cos.int(2);
    for (contact, words, expected) in [
        (Contact::Extrados, "a hinge at the extrados", ring().extrados() * &joint.sin / &two),
        (Contact::Intrados, "a hinge at the intrados", -(ring().intrados() * &joint.sin / &two)),
        (Contact::Outwards, "a joint with T = -mu N", joint.cos.clone()),
    ] {
        let [_, _, up] = row(contact, &joint);
        d.identity(format!("what {words} adds upwards"), up, expected)?;
    }
    d.theorem(
        "Asymmetric.no_asymmetric_motion_up_to_the_right_angle",
        "up to a half-angle of 90° no motion without dilatancy fits in a state with a vertical force in the crown, \
         whichever joints are at their limits",
    )?;
    d.conclude("Without such a force a motion and its mirror image add up to a symmetric one.")
}

/// Slopes along the halves, and the angle of the force.
fn places(d: &mut Derivation) -> Checked {
    let (joint, v, h) = (Symbol::joint(), Symbol::CrownShear.number(), Symbol::Thrust.number());
    let (ring, rules) = (ring(), along_the_joint());
    let two = h.int(2);
    let arm = joint.rad.clone() - &v;
    let bow = h.clone() - h.int(1) + two.clone() * &ring.centroid_factor / ring.extrados();
    let slope = (arm.clone() * &joint.cos - bow * &joint.sin) * ring.extrados() / &two;
    let words = "dU/d beta; c = h - 1 + 2 fac/(2 + eta) in the bracket";
    d.on_circle(words, margin_at(Contact::Extrados, &joint).derivative(&rules), slope)?;
    let left = margin_at(Contact::Intrados, &Side::Left.joint(&joint));
    let bow = (h.clone() - h.int(1)) * ring.intrados() / &two + &ring.centroid_factor;
    let slope = bow * &joint.sin - (joint.rad.clone() + &v) * &joint.cos * ring.intrados() / &two;
    d.on_circle("dL/d beta on the left, at -beta", left.derivative(&rules), slope)?;
    d.conclude(
        "v < 90°, as N > 0 at 90° in a horseshoe. On the right U falls from the crown; up to 90° the bracket over cos(beta) is beta - v - c \
         tan(beta), concave or growing, so that U is least at one joint b0 inside at the most, and beyond 90° it falls, or \
         grows and then falls: U is zero at b0 and at the springing only. On the left L falls and then grows, as beta + v - c \
         tan(beta) is concave: it is zero at one joint -b1 only, before -90°.",
    )?;
    let [normal, shear] = borne(&joint);
    let turns = shear.derivative(&rules) * &normal - normal.derivative(&rules) * &shear;
    d.on_circle("T' N - T N'", turns, h.clone() - h.square() - arm.square())?;
    d.on_circle("N² + T²", normal.square() + shear.square(), h.square() + arm.square())
}

fn kinds(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2, 0 <= mu < inf; a state that is admissible at each joint of [-alpha, alpha], v > 0");
    lemmas(d, [&NARROW, &ASYMMETRIC_MOTION])?;
    d.theorem(
        "Asymmetric.extrados_on_the_right",
        "with v > 0 in the crown the line of thrust reaches the extrados on the right or in the crown alone",
    )?;
    d.theorem(
        "Asymmetric.intrados_on_the_left",
        "with v > 0 it reaches the intrados on the left or in the crown alone, and at eta = 2 in the crown",
    )?;
    d.theorem("Asymmetric.normal_positive", "with v > 0 every joint is compressed")?;
    d.theorem(
        "Asymmetric.nothing_slides_inwards",
        "with v > 0 no joint slides inwards, as seen on the right",
    )?;
    places(d)?;
    d.argue(
        "With y = beta - v the angle of T/N is g(y) - v, g(y) = atan(y/h) - y, which is odd, and at least -phi; g' = (h - h² - \
         y²)/(h² + y²) > -1. It is -phi where g is least: at the right springing, and at beta = v - s, s² = h - h², if h < 1; \
         as g(-s) >= v - phi, v < phi there and cos(v - s) > 0.",
    )?;
    along_the_normal(d)?;
    d.argue(
        "The last is positive where both joints slide: alpha - beta is then the sum of two arcs of tangents, as g is the same \
         at both. The haunch turns as the hinges at the extrados do together, and the springing's with the haunch gives 1 + \
         eta/2 - (1 - eta/2) cos(alpha + b1) > 0. So b0 has a rate, or nothing has; and b1 then. Upwards only the springing \
         of a horseshoe moves down: it slides. These three with neither the springing's hinge nor the inner slip, with one \
         of them or with both are all motions; a motion with both is a sum of motions with one, as its five rates meet three \
         equations.",
    )
}

/// Parts of a motion along the normal of the right springing: what each of its joints adds.
fn along_the_normal(d: &mut Derivation) -> Checked {
    let (joint, alpha) = (Symbol::joint(), Symbol::half_opening());
    let against = |contact: Contact, joint: &Angle<Fraction>| {
        let [across, _, up] = row(contact, joint);
        up * &alpha.sin - across * &alpha.cos
    };
    let two = alpha.sin.int(2);
    let zero = alpha.sin.int(0);
    d.identity(
        "along the normal of the right springing its slip adds",
        against(Contact::Outwards, &alpha),
        &zero,
    )?;
    let cosine = alpha.cos.clone() * &joint.cos + alpha.sin.clone() * &joint.sin;
    let sum = alpha.cos.clone() * &joint.cos - alpha.sin.clone() * &joint.sin;
    let above = ring().extrados() / &two;
    d.identity(
        "a hinge at the extrados of beta, (1 + eta/2) cos(alpha - beta)",
        against(Contact::Extrados, &joint),
        above.clone() * cosine,
    )?;
    d.on_circle("and of the springing", against(Contact::Extrados, &alpha), above)?;
    let below = ring().intrados() / &two;
    d.identity(
        "a hinge at the intrados of -beta, -(1 - eta/2) cos(alpha + beta)",
        against(Contact::Intrados, &Side::Left.joint(&joint)),
        -(below * sum),
    )?;
    let sine = alpha.sin.clone() * &joint.cos - alpha.cos.clone() * &joint.sin;
    d.identity(
        "and a joint beta with T = -mu N, sin(alpha - beta)",
        against(Contact::Outwards, &joint),
        sine,
    )
}
