//! The four ways in which a joint can be at its limit, as conditions on the thrust `h` and the crown moment `p`, and
//! which joints of an arch can be there.

use super::frictions::SLOPES_OF_FRICTION;
use super::letters::{ring, term, with};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::{Contact, Twist};
use crate::arch::{statics, thrust};
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};

claims! {
    Implicit("map-distances", "Sec. 2.1", distances_rise_and_fall) as DISTANCES_RISE_AND_FALL:
        "along an admissible arch the normal force N and the distance U from the extrados first grow and then fall";
    Implicit("modes-contacts", "Sec. 3, 4", contacts) as CONTACTS:
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

/// `U`, `L` at a joint, whose difference is known and whose directions change once.
fn contacts(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2; 0 < mu < inf, or h > 0 and mu = inf");
    lemmas(d, [&DISTANCES_RISE_AND_FALL, &SLOPES_OF_FRICTION])?;
    let (joint, alpha) = (Symbol::joint(), Symbol::half_opening());
    let (ring, h, mu) = (ring(), Symbol::Thrust.number(), Symbol::Friction.number());
    let two = h.int(2);
    let [upper, lower, inwards, _] = Contact::ALL.map(|contact| margin_at(contact, &joint));
    let rise = h.int(1) - &h + joint.times_cotangent();
    let slope = (ring.centroid_factor.clone() - ring.intrados() * rise / &two) * &joint.sin;
    let words = "dL/d beta, L = p + fac (1 - cos(beta)) - (1 - eta/2) N; the bracket grows or, at eta = 2, is fac";
    d.on_circle(words, lower.derivative(&along_the_joint()), &slope)?;
    let normal = statics::normal_force(&joint, &h);
    d.identity("U + L", upper.clone() + &lower, normal.clone() * &ring.thickness)?;
    let near = (mu * &joint.sin - &joint.cos) * &joint.rad;
    let words = "mu N - T without thrust: negative next to the crown, so that h > 0 if mu < inf";
    d.identity(words, with(&inwards, &[Symbol::Thrust], &h.int(0)), &near)?;
    let moment = Symbol::CrownMoment.number() + joint.versine() * &ring.centroid_factor;
    let words = "U where N = 0: negative, as p >= (1 - eta/2) h, so that N > 0";
    d.identity(words, upper - ring.extrados() * normal / &two, -moment)?;
    d.conclude(
        "With h > 0 and N > 0: U first grows and then falls, strictly, and L first falls and then grows. \
         Not negative at either end, U is positive between; L is zero at one joint at most. T/N \
         starts from 0 at the crown, grows up to beta_s and falls beyond: it is mu at one joint at most, at \
         beta_s or, in an arch that ends before, at the shoulder; it is -mu at the shoulder only, and then \
         beta_s < alpha. If h >= 1, there is no beta_s: T/N falls from 0, and no joint slides inwards.",
    )?;
    let crown = Angle::zero(&h);
    let distances = margin_at(Contact::Extrados, &crown) - margin_at(Contact::Extrados, &alpha);
    let opening = thrust::opening_variable(&alpha);
    let expected = ring.extrados() * (h.clone() * &opening.denominator - opening.numerator) / &two
        + alpha.versine() * &ring.centroid_factor;
    d.identity("U at the crown less U at the shoulder", &distances, &expected)?;
    let rest = (h.int(6) - Symbol::Flag.number() * &ring.thickness) * &ring.thickness / h.int(12);
    let words = "1 + eta/2 - fac: positive, so that h >= A - 1 if the shoulder is on the extrados";
    d.identity(words, ring.extrados() / &two - &ring.centroid_factor, &rest)?;
    let sine = term(1, 1, 1) - term(1, 6, 3);
    let versine = term(1, 2, 2) - term(1, 24, 4) + term(1, 720, 6);
    d.identity(
        "alpha sin - (2 - alpha²)(1 - cos) is at least this, positive for 0 < alpha <= 1/2",
        term(1, 1, 1) * sine - (term(2, 1, 0) - term(1, 1, 2)) * versine,
        term(5, 12, 4) - term(2, 45, 6) + term(1, 720, 8),
    )?;
    d.conclude(
        "So for h < 1 a shoulder on the extrados has 1 - h <= 2 - A < alpha² if alpha <= 1/2, and beta_s < alpha; \
         for alpha > 1/2 that is so anyway, as beta_s <= 1/2.",
    )
}
