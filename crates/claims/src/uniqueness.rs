//! Among symmetric states the least thickness is unique, though friction is not associated.
//!
//! A joint that slides does so along itself, while its condition would have it open too. In the half arch only the
//! thrust works on it, so that the rate of the joint can be scaled: from a mechanism without dilatancy one with it is
//! made, by positive factors. For that one the sum of the rates times the margins is the same in all states, and the
//! usual argument of the static theorem holds. It needs the symmetry: where a vertical force in the crown works
//! too, no factor serves both. **Asymmetric mechanisms are not in question here.**

use super::contacts::{label, margin_at, row_at, slopes};
use super::letters::{ring, with};
use super::modes::pure_sliding_has_room;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::{statics, thrust};
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};

claims! {
    Ours("unique-mean", "Sec. 2, 4", symmetric_mean):
        "if the whole arch has an admissible state, asymmetric or not, it has a symmetric one: the mean of the state \
         and its mirror image";
    Ours("unique-work", "Sec. 4, 5", mechanism_bounds):
        "no thrust and crown moment leave a positive margin at all joints that move in a symmetric mechanism without \
         dilatancy: all these margins are zero, or one is negative";
    Ours("unique-thicker", "Sec. 4, 5", thicker_has_room):
        "a positive thrust that is admissible at one thickness is so at each larger one up to 2, with a line of \
         thrust off both faces at every joint";
    Ours("unique-attained", "Sec. 2, 5", limit_stands):
        "at a friction 0 < mu < inf the limit of arches that stand stands: the least thickness of an arch and the \
         widest half opening of a thickness are attained";
    Implicit("map-function", "Sec. 3, Fig. 5, 6", one_half_opening):
        "to each thickness 0 < eta <= 2 and each friction 0 < mu < inf belongs one half opening: narrower arches \
         stand, wider ones fall, and there alone a symmetric mechanism exists";
    AsPrinted("unique-thickness", "Sec. 5", one_thickness):
        "above its least thickness an arch has no mechanism without dilatancy that is symmetric: among symmetric \
         motions the static and the kinematic thickness are one. The only exception is the friction of pure sliding, \
         where [s,s] moves at each thickness that stands. Nothing is said of asymmetric mechanisms, which may move \
         thicker arches";
}

/// The state with the thrust and the crown moment zero.
fn without_forces(value: &Fraction) -> Fraction {
    with(value, &[Symbol::Thrust, Symbol::CrownMoment], &value.int(0))
}

fn symmetric_mean(d: &mut Derivation) -> Checked {
    let (joint, h, v) = (Symbol::joint(), Symbol::Thrust.number(), Symbol::CrownShear.number());
    let two = h.int(2);
    d.assume("a vertical force v in the crown carries v of the weight above each joint");
    let right = Angle { rad: joint.rad.clone() - &v, ..joint.clone() };
    let left = Angle { rad: -(joint.rad.clone() + &v), sin: -joint.sin.clone(), ..joint.clone() };
    let normal = |at| statics::normal_force(at, &h);
    let shear = |at| statics::shear_force(at, &h);
    let words = "half of N at beta and at -beta is N at beta with v = 0";
    d.identity(words, (normal(&right) + normal(&left)) / &two, normal(&joint))?;
    let words = "half of T at beta less T at -beta is T at beta with v = 0";
    d.identity(words, (shear(&right) - shear(&left)) / &two, shear(&joint))?;
    let moment =
        |at: &Angle<Fraction>| Symbol::CrownMoment.number() + at.versine() * ring().centroid_factor;
    d.identity("M is the same at both", moment(&left), moment(&joint))?;
    d.conclude(
        "What both sides of the arch satisfy, (1 - eta/2) N <= M <= (1 + eta/2) N and -mu N <= T, -T <= mu N, \
         their means satisfy, as each condition is linear: the state (h, p, 0).",
    )
}

fn mechanism_bounds(d: &mut Derivation) -> Checked {
    lemmas(d, ["modes-seven"])?;
    let (joint, h) = (Symbol::joint(), Symbol::Thrust.number());
    let p = Symbol::CrownMoment.number();
    for contact in Contact::ALL {
        let margin = margin_at(contact, &joint);
        let [by_thrust, by_moment] = slopes(&margin);
        let sum = without_forces(&margin) + by_thrust * &h + by_moment * &p;
        d.identity(format!("{} is linear in h and p", label(contact)), &margin, &sum)?;
    }
    let (shear, normal) = (statics::shear_force(&joint, &h), statics::normal_force(&joint, &h));
    for (contact, friction) in [(Contact::Inwards, shear.clone()), (Contact::Outwards, -shear)] {
        let [by_thrust, _] = slopes(&margin_at(contact, &joint));
        let at_limit = with(&by_thrust, &[Symbol::Friction], &(friction / &normal));
        let [row, _] = row_at(contact, &joint);
        let scaled = row * &joint.rad / (joint.sin.clone() * &normal);
        let words = format!(
            "d({})/dh at its limit is the work of h on the sliding joint times beta/(N sin(beta))",
            label(contact)
        );
        d.on_circle(words, &at_limit, &scaled)?;
    }
    d.conclude(
        "Divide the rates of sliding joints by this positive number, and leave those of the hinges: then the \
         sum of the rates times the margins is free of h and p. It is zero in the state in which the \
         mechanism moves, so in all: the margins with a rate are all zero, or one is negative.",
    )
}

fn thicker_has_room(d: &mut Derivation) -> Checked {
    d.assume("0 <= beta <= alpha, 0 < eta < 2, 0 <= delta_M <= 1, h > 0");
    lemmas(d, ["map-distances"])?;
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (h, eta, delta) = (Symbol::Thrust.number(), ring.thickness.clone(), Symbol::Flag.number());
    let two = h.int(2);
    let intrados = margin_at(Contact::Intrados, &joint);
    let crown = margin_at(Contact::Extrados, &Angle::zero(&h)) + &intrados;
    let normal = statics::normal_force(&joint, &h);
    let slope = (h.clone() + normal) / &two + delta.clone() * &eta * joint.versine() / h.int(6);
    let words =
        "what is left to p between the crown's extrados and a joint's intrados grows with eta";
    d.identity(words, crown.partial(Symbol::Thickness), &slope)?;
    let shoulder = margin_at(Contact::Extrados, &alpha) + intrados;
    let bend = shoulder.partial(Symbol::Thickness).partial(Symbol::Thickness);
    let expected = -(delta.clone() * (joint.cos.clone() - &alpha.cos) / h.int(6));
    let words =
        "what is left to it between the shoulder's extrados and a joint's intrados is concave";
    d.identity(words, &bend, &expected)?;
    let third = h.int(1) + delta.clone() / h.int(3);
    let normal = statics::normal_force(&alpha, &h);
    let margin = normal.clone() * &two - third.clone() * alpha.versine();
    let words = "at eta = 2 it is at least 2 N(alpha) - (1 + delta/3) (1 - cos(alpha))";
    d.identity(
        words,
        with(&shoulder, &[Symbol::Thickness], &two),
        margin.clone() + third * joint.versine(),
    )?;
    let held = ring.extrados() * normal - two.clone() * &ring.centroid_factor * alpha.versine();
    let gain = (two.clone() - &eta) * (h.int(3) - delta.clone() - delta * &eta) / h.int(6);
    let words =
        "and that, times 1 + eta/2, is 2 (p + U) of the shoulder at eta and a positive number";
    d.identity(words, margin * ring.extrados() / &two, held + gain * alpha.versine())?;
    d.theorems(["Mechanisms.thicker_arch_has_room"])?;
    d.conclude(
        "So each lower bound of p, from the intrados of a joint, is below both upper bounds, from the extrados of crown \
         and shoulder, and U, which is least at these two, is positive at every joint. Friction does not see the \
         thickness.",
    )
}

fn one_thickness(d: &mut Derivation) -> Checked {
    d.assume("0 < mu < inf, 0 < eta <= 2");
    lemmas(d, ["modes-contacts", "unique-work", "unique-thicker", "unique-attained"])?;
    lemmas(d, ["friction-slopes", "sliding-order"])?;
    d.theorems(["Attained.least_thickness_is_attained", "Attained.only_sliding_above_the_least"])?;
    d.theorems(["Modes.sliding_is_pure", "Attained.sliding_does_not_see_the_thickness"])?;
    pure_sliding_has_room(d, "the exception: ")?;
    d.theorems(["Room.thinner_arch_stands"])?;
    d.conclude("So thinner arches of half opening 1 stand at that friction, and yet [s,s] moves at thickness 1.")
}

/// Thrusts without bound leave room everywhere in their limit.
fn limit_stands(d: &mut Derivation) -> Checked {
    d.assume("0 < mu < inf; the limit has 0 < alpha <= pi, 0 <= eta <= 2");
    lemmas(d, ["alpha-one-to-one", "map-distances"])?;
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (h, mu, eta) = (Symbol::Thrust.number(), Symbol::Friction.number(), &ring.thickness);
    let (crown, two) = (Angle::zero(&h), h.int(2));
    let opening = thrust::opening_variable(&joint).value();
    let distance = margin_at(Contact::Extrados, &joint) - margin_at(Contact::Extrados, &crown);
    let expected = (opening.clone() - h.int(1) - &h) * joint.versine();
    let words = "U less U at the crown, at eta = 0: not zero at all joints, as A falls";
    d.identity(words, with(&distance, &[Symbol::Thickness], &h.int(0)), &expected)?;
    let outwards = (mu.clone() * &joint.cos - &joint.sin) * &h
        + (mu.clone() * &joint.sin + &joint.cos) * &joint.rad;
    d.identity("mu N + T", margin_at(Contact::Outwards, &joint), &outwards)?;
    let ends = margin_at(Contact::Intrados, &crown) + margin_at(Contact::Extrados, &alpha);
    let area = alpha.rad.clone() * &alpha.sin + &alpha.cos - h.int(1);
    let gain = (h.int(6) - Symbol::Flag.number() * eta) * eta / h.int(12);
    let expected = (ring.extrados() * &alpha.cos - ring.intrados()) * &h / &two
        + ring.extrados() * area / &two
        + alpha.versine() * gain;
    d.identity("L at the crown and U at the shoulder add up to", &ends, &expected)?;
    let area = joint.rad.clone() * &joint.sin + &joint.cos;
    let words = "d(x sin(x) + cos(x))/dx: positive, so that U > 0 at the shoulder";
    let slope = joint.rad.clone() * &joint.cos;
    d.identity(words, area.derivative(&along_the_joint()), &slope)?;
    let rise = margin_at(Contact::Intrados, &joint) - margin_at(Contact::Intrados, &crown);
    let expected =
        ((h.clone() - opening) * ring.intrados() / &two + &ring.centroid_factor) * joint.versine();
    d.identity("L less L at the crown: not negative, as A <= 2", &rise, &expected)?;
    let expected = mu * statics::normal_force(&joint, &h)
        + (h.clone() - h.int(1)) * &joint.sin
        + (joint.sin.clone() - slope);
    let words = "mu N - T: positive, as x cos(x) <= sin(x)";
    d.identity(words, margin_at(Contact::Inwards, &joint), &expected)?;
    d.theorems(["Attained.limit_of_arches_stands"])
}

fn one_half_opening(d: &mut Derivation) -> Checked {
    lemmas(d, ["unique-attained", "modes-contacts", "modes-seven", "unique-work"])?;
    let h = Symbol::Thrust.number();
    let (crown, one) = (Angle::zero(&h), h.int(1));
    let eta = ring().thickness;
    let cases = [
        (Contact::Extrados, eta.clone() / h.int(2)),
        (Contact::Intrados, eta / h.int(2)),
        (Contact::Inwards, Symbol::Friction.number()),
        (Contact::Outwards, Symbol::Friction.number()),
    ];
    for (contact, expected) in cases {
        let forces = [Symbol::Thrust, Symbol::CrownMoment];
        let margin = with(&margin_at(contact, &crown), &forces, &one);
        let words = format!("{} at the crown for h = p = 1: positive", label(contact));
        d.identity(words, &margin, &expected)?;
    }
    let flat = Angle { rad: Symbol::HalfOpening.number(), sin: h.int(0), cos: h.int(-1) };
    d.identity("N at pi", statics::normal_force(&flat, &h), -h)?;
    d.theorems(["Attained.one_half_angle"])
}
