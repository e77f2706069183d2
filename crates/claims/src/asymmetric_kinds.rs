//! Asymmetric motions of the whole arch: none up to a half opening of 90°, and three kinds beyond.
//!
//! With a vertical force `v > 0` in the crown the line of thrust reaches the extrados on the right only and the
//! intrados on the left only, and each joint that moves does so upwards, but for the right springing of a horseshoe.

use super::letters::{forces, ring};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::statics;
use crate::arch::whole::{Forces, carried, margin, motion_row};
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol};

claims! {
    Ours("asymmetric-narrow", "Eq. (19), Sec. 5", narrow):
        "up to a half opening of 90° the whole arch has no asymmetric motion: where a vertical force works in the crown no \
         rates without dilatancy fit, whichever joints are at their limits, so that (19) has its solutions at the least \
         thickness alone, except at the friction of pure sliding";
    Ours("asymmetric-kinds", "Eq. (19), Sec. 5", kinds):
        "a solution of (19) with a vertical force in the crown has a half opening above 90°; its state, or the mirror \
         image of it, slides outwards at the right springing, touches the extrados at a joint inside the right half and \
         the intrados at a joint of the left half or, at eta = 2, in the crown, and its motion is a sum of those of the \
         three kinds of asymmetric-motion";
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
    lemmas(d, ["unique-thickness"])?;
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
    d.theorems(["Asymmetric.no_asymmetric_motion_up_to_the_right_angle"])?;
    d.conclude("Without such a force a motion and its mirror image add up to a symmetric one.")
}

fn kinds(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2, 0 <= mu < inf; a state that is admissible at each joint of [-alpha, alpha], v > 0");
    lemmas(d, ["asymmetric-narrow", "asymmetric-motion"])?;
    d.theorems(["Asymmetric.joints_of_a_motion"])?;
    let (joint, alpha) = (Symbol::joint(), Symbol::half_opening());
    let [across, _, up] = row(Contact::Outwards, &joint);
    let sine = alpha.sin.clone() * &joint.cos - alpha.cos.clone() * &joint.sin;
    d.identity(
        "what a joint that slides adds along the normal of the right springing, sin(alpha - beta): nothing at the springing",
        up * &alpha.sin - across * &alpha.cos,
        sine,
    )?;
    d.conclude(
        "Rates of one joint add up: five rates, none negative, meet three equations. Such motions are sums of those in \
         which one rate is zero: by the theorem that of the springing's hinge or of the inner slip. With one of them or \
         with neither they are the three kinds.",
    )
}
