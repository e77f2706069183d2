//! Arches of stones: what their joints ask for, (19), and its programme, (20).
//!
//! A stone between the joints `m - g` and `m + g` weighs `2 g`; its centroid lies on its bisector at the radius `fac
//! sin(g)/g`. So its moment about the centre is `2 fac sin(g) sin(m) = fac (cos(m - g) - cos(m + g))`, and the
//! moments of all stones above a joint add up to that of the continuous arch, whatever the number of stones.

use super::asymmetric_kinds::margin_at as whole_margin_at;
use super::contacts::{label, margin_at, slopes};
use super::letters::{ring, with};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::whole::motion_row;
use crate::arch::{Ring, thrust};
use crate::number::{Angle, Field};
use crate::symbolic::{Letters, Symbol};

claims! {
    Implicit("stones-sums", "Eq. (19)", sums):
        "the weights of stones at their true centroids add up, above each joint, to the force and the moment of the \
         continuous arch: an arch of stones stands wherever that with a joint at every angle does";
    Ours("stones-joints", "Eq. (19)", each_joint):
        "an arch of stones with a joint at the crown has one thrust at which each joint is judged by itself: that of \
         (4), or the next to it that friction allows. Its least thickness is the largest over its joints of the one \
         from which on the line of thrust is above the intrados there";
    AsPrinted("programme-zero", "Eq. (20)", programme):
        "where an arch of stones has an admissible state and rates that fit, the least value of (20) is attained and \
         not negative; it is zero exactly if (19) has a solution";
}

fn sums(d: &mut Derivation) -> Checked {
    let (middle, half, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let (g, two) = (&half.rad, half.rad.int(2));
    d.define("m, the bisector of a stone", &middle.rad);
    d.define("g, half of its angle", g);
    d.assume(
        "0 < g < pi; what lies at the radius S, off the bisector by x, has the area S dS dx and along the bisector the \
         moment S² cos(x) dS dx about the centre",
    );
    let eta = &ring.thickness;
    let [inner, outer] = [-1, 1].map(|side| eta.int(1) + eta.ratio(side, 2) * eta);
    let [area, moment] = [
        (outer.square() - inner.square()) * g,
        (outer.square() * &outer - inner.square() * &inner) * &half.sin * eta.ratio(2, 3),
    ];
    let factor = Ring::with_flag(&eta.int(1), eta).centroid_factor;
    let words = "the radius of the centroid of a stone, moment over area, delta_M = 1";
    d.identity(words, moment / area, factor * &half.sin / g)?;
    let radius = ring.centroid_factor.clone() * &half.sin / g;
    let moment = two.clone() * g * radius * &middle.sin;
    let cosines = [-1, 1].map(|side| {
        middle.cos.clone() * &half.cos - middle.sin.clone() * &half.sin * half.sin.int(side)
    });
    let [upper, lower] = cosines;
    let words = "its weight 2 g times its arm: fac (cos(m - g) - cos(m + g))";
    d.identity(words, moment, (upper - lower) * &ring.centroid_factor)?;
    d.conclude(
        "For Heyman's weight, an arc of radius 1, the radius of the centroid is sin(g)/g, fac = 1. The sums of stones \
         telescope, half a keystone being a stone too: above a joint at beta they weigh beta and have the moment fac \
         (1 - cos(beta)). So the conditions at the joints are those of the continuous arch at these joints.",
    )
}

fn each_joint(d: &mut Derivation) -> Checked {
    lemmas(d, ["stones-sums"])?;
    d.assume("0 < eta <= 2; joints at 0, at alpha < pi and between; a state is symmetric");
    let (joint, alpha, ring) = (Symbol::joint(), Symbol::half_opening(), ring());
    let h = Symbol::Thrust.number();
    let (crown, two) = (Angle::zero(&h), h.int(2));
    let [upper, last] = [&crown, &alpha].map(|at| margin_at(Contact::Extrados, at));
    let whole = thrust::whole(&alpha, &ring);
    let words = "U at the crown less U at the shoulder: of the sign of h - h_2";
    let expected = (h.clone() - whole.value()) * whole.denominator / &two;
    d.identity(words, upper.clone() - &last, expected)?;
    let lower = margin_at(Contact::Intrados, &joint);
    let [by_thrust, by_moment] = slopes(&(upper + &lower));
    let arm = joint.versine() + (h.int(1) + &joint.cos) * &ring.thickness / &two;
    d.identity("d/dh of U at the crown and L at a joint: positive", by_thrust, arm)?;
    d.identity("which are free of p", by_moment, h.int(0))?;
    let [by_thrust, by_moment] = slopes(&(last + &lower));
    let arm = (ring.intrados() * &joint.cos - ring.extrados() * &alpha.cos) / &two;
    d.identity("d/dh of U at the shoulder and L at a joint: -b", by_thrust, -arm)?;
    d.identity("which are free of p too", by_moment, h.int(0))?;
    let at_crown = margin_at(Contact::Extrados, &crown) + margin_at(Contact::Intrados, &crown);
    d.identity("U + L at the crown, so that h >= 0", at_crown, h.clone() * &ring.thickness)?;
    let free = |contact| with(&margin_at(contact, &joint), &[Symbol::CrownMoment], &h);
    for contact in [Contact::Inwards, Contact::Outwards] {
        let words = format!("{} is free of p", label(contact));
        d.identity(words, free(contact), margin_at(contact, &joint))?;
    }
    d.theorems(["Stones.nearest_thrust", "Stones.each_joint_by_itself"])?;
    d.theorems(["Stones.joint_alone_in_thicker", "Stones.least_thickness_of_stones"])
}

fn programme(d: &mut Derivation) -> Checked {
    lemmas(d, ["stones-sums"])?;
    d.assume(
        "joints at finitely many angles, and rates that fit: not negative, not all zero, so that they may add up to \
         one. With finite friction there are some. Without a limit of friction there may be none; then (19) has no \
         solution and (20) no value",
    );
    let joint = Symbol::joint();
    let eta = Symbol::Thickness.number();
    let motion = |contact| motion_row(contact, &joint, &eta, &eta.int(0));
    let [[across, _, up], [back, _, down]] = [Contact::Inwards, Contact::Outwards].map(motion);
    d.identity("equal rates of both slips of a joint fit: across", across, -back)?;
    d.identity("and up", up, -down)?;
    let forces = [Symbol::Thrust, Symbol::CrownMoment, Symbol::CrownShear];
    for contact in Contact::ALL {
        let phi = -whole_margin_at(contact, &joint);
        let load = with(&phi, &forces, &eta.int(0));
        let sum = forces.map(|force| phi.partial(force) * force.number()).into_iter();
        let words = format!("phi of {} is linear in h, p and a vertical force", label(contact));
        d.identity(words, &phi, sum.fold(load, |sum, term| sum + term))?;
    }
    d.theorems(["Programme.zero_if_complementary", "Programme.least_value_is_attained"])
}
