//! The four ways in which a joint can be at its limit, as conditions on the thrust `h` and the crown moment `p`, and
//! which joints of an arch can be there.

use super::letters::ring;
use super::{Checked, Derivation, claims};
use crate::arch::mechanism::{Contact, Twist};
use crate::arch::statics;
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};

claims! {
    Ours("map-distances", "Sec. 2.1", distances_rise_and_fall):
        "along an admissible arch the normal force N and the distance U from the extrados first grow and then fall";
    Ours("modes-contacts", "Sec. 3, 4", contacts):
        "in an admissible state the line of thrust reaches the extrados at the crown and at the shoulder only, and \
         the intrados at one joint only; friction is used up inwards at one joint only, above a shoulder at its \
         limit, and outwards at the shoulder only";
}

/// Margin at a joint, which must not be negative.
pub(super) fn margin_at(contact: Contact, joint: &Angle<Fraction>) -> Fraction {
    let [h, p, mu] =
        [Symbol::Thrust, Symbol::CrownMoment, Symbol::Friction].map(|symbol| symbol.number());
    contact.margin(joint, &ring(), [&h, &p, &mu])
}

/// The work of a unit thrust and of a unit crown moment on the motion of the joint: the contact gives way by
/// itself, so a hinge turns about its face, and a joint slides along itself, without dilatancy.
pub(super) fn row_at(contact: Contact, joint: &Angle<Fraction>) -> [Fraction; 2] {
    let (eta, none) = (ring().thickness, joint.cos.int(0));
    let Twist { rotation, velocity: [across, _] } = contact.twist(joint, &eta, &none);
    [-across, rotation]
}

/// The letters of a margin.
pub(super) fn label(contact: Contact) -> &'static str {
    match contact {
        Contact::Extrados => "U",
        Contact::Intrados => "L",
        Contact::Inwards => "mu N - T",
        Contact::Outwards => "mu N + T",
    }
}

/// `d/dh` and `d/dp` of a condition.
pub(super) fn slopes(condition: &Fraction) -> [Fraction; 2] {
    [Symbol::Thrust, Symbol::CrownMoment].map(|symbol| condition.partial(symbol))
}

/// `beta cot(beta)` falls.
pub(super) fn cotangent_falls(d: &mut Derivation) -> Checked {
    let joint = Symbol::joint();
    let bow = joint.rad.clone() - joint.sin.clone() * &joint.cos;
    let slope = joint.times_cotangent().derivative(&along_the_joint());
    d.on_circle("d(beta cot(beta))/d beta, negative", slope, -(bow / joint.sin.square()))
}

/// `N` and `U` along an arch first grow and then fall.
fn distances_rise_and_fall(d: &mut Derivation) -> Checked {
    let (joint, h, ring) = (Symbol::joint(), Symbol::Thrust.number(), ring());
    let rules = along_the_joint();
    let normal = statics::normal_force(&joint, &h);
    let rise = h.int(1) - &h + joint.times_cotangent();
    d.on_circle("dN/d beta", normal.derivative(&rules), joint.sin.clone() * &rise)?;
    let distance = ring.extrados() * &normal / h.int(2) - joint.versine() * &ring.centroid_factor;
    let slope = ring.extrados() * rise / h.int(2) - &ring.centroid_factor;
    let words = "dU/d beta, U = (1 + eta/2) N - p - fac (1 - cos(beta))";
    d.on_circle(words, distance.derivative(&rules), slope * &joint.sin)?;
    cotangent_falls(d)?;
    d.conclude(
        "As beta cot(beta) falls, either slope changes its sign at most once, from + to -: N and U are \
         positive between two joints where they are.",
    )
}

/// The limits of a state, by the theorem; without a limit of friction there is one that is more than enough.
fn contacts(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2; 0 < mu < inf, or h > 0 and mu = inf");
    d.theorems(["Modes.limits_of_a_state"])?;
    let (joint, ring, h) = (Symbol::joint(), ring(), Symbol::Thrust.number());
    let normal = statics::normal_force(&joint, &h);
    let upper = margin_at(Contact::Extrados, &joint);
    let moment = Symbol::CrownMoment.number() + joint.versine() * &ring.centroid_factor;
    let words = "U where N = 0: negative, as p >= (1 - eta/2) h, so that N > 0";
    d.identity(words, upper - ring.extrados() * normal / h.int(2), -moment)?;
    d.conclude(
        "As h > 0 and N > 0 at every joint, some finite friction is more than enough where there is no limit: the line of \
         thrust is the same.",
    )
}
