//! Proof that a state of an arch of voussoirs is admissible at all of its joints, by signs at a few.
//!
//! On `(0, pi)`, at any thrust, the distance from the extrados first grows and then falls, that from the intrados
//! falls and then grows, and where `N > 0` so does the room for inward sliding ([`contact`](crate::arch::contact)).
//! So the joints beside the one that touches the intrados, or that slides, speak for all, and the first and the
//! last joint for the extrados, for outward sliding and for `N`.

use super::joints::{StoneJoints, is_positive, is_zero, require};
use crate::arch::Ring;
use crate::arch::mechanism::Contact;
use crate::arch::statics::normal_force;
use crate::number::{Ball, Field};
use crate::problem::stones::JointContact;
use crate::prover::Undecided;

/// The line of thrust is inside the arch at all joints.
pub(super) fn line_is_inside(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact],
    thrust: &Ball,
    moment: &Ball,
    ring: &Ring<Ball>,
) -> Result<(), Undecided> {
    let haunch = contacts[1].1;
    let above = haunch.checked_sub(1);
    let below = Some(haunch + 1).filter(|below| *below <= joints.last());
    let beside = above.into_iter().chain(below);
    // In a joint that is open there is no normal force, and no moment.
    let is_open = contacts[0] == (Contact::Inwards, haunch)
        && joints.stones.may_open(haunch, joints.is_limited());
    let is_open = |joint| is_open && joint == haunch;
    inside_at(joints, beside, is_open, contacts, |contact| {
        joints.row(contact, ring).at(thrust, moment)
    })
}

/// The line of thrust is inside the arch at the first and the last joint and above the intrados at these, but for
/// its contacts and joints that are open; `beyond` is how far it is outside.
fn inside_at(
    joints: &StoneJoints<'_>,
    beside: impl Iterator<Item = u64>,
    is_open: impl Fn(u64) -> bool,
    contacts: &[JointContact],
    beyond: impl Fn(JointContact) -> Ball,
) -> Result<(), Undecided> {
    let ends = [0, joints.last()].map(|joint| (Contact::Extrados, joint));
    let beside = beside.map(|joint| (Contact::Intrados, joint));
    let is_strict = |contact: &JointContact| !contacts.contains(contact) && !is_open(contact.1);
    for contact in ends.into_iter().chain(beside).filter(is_strict) {
        require(is_positive(&-beyond(contact)), "whether the line of thrust is inside the arch")?;
    }
    Ok(())
}

/// Tells whether a joint is open: it has no normal force, and no moment.
pub(super) fn is_open(joints: &StoneJoints<'_>, contacts: &[JointContact], joint: u64) -> bool {
    let slides = |contact| contacts.contains(&(contact, joint));
    joints.stones.may_open(joint, joints.is_limited())
        && (slides(Contact::Inwards) || slides(Contact::Outwards) && !joints.is_limited())
}

/// The state is admissible, and its contacts are the only conditions that hold with equality, but for slips at no
/// thrust.
pub(super) fn is_admissible(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact],
    thrust: &Ball,
    moment: &Ball,
    ring: &Ring<Ball>,
) -> Result<(), Undecided> {
    no_slip_is_passed(joints, contacts, (thrust, moment), ring, is_zero)?;
    let [from, to] = around_lowest(joints, thrust, ring)?;
    let is_open = |joint| is_open(joints, contacts, joint);
    inside_at(joints, from..=to, is_open, contacts, |contact| {
        joints.row(contact, ring).at(thrust, moment)
    })
}

/// The joints, at most three, that have between them the angle at which the line of thrust comes nearest to the
/// intrados: where `fac sin beta - (1 - eta/2) [(1 - h) sin beta + beta cos beta]` changes its sign.
fn around_lowest(
    joints: &StoneJoints<'_>,
    thrust: &Ball,
    ring: &Ring<Ball>,
) -> Result<[u64; 2], Undecided> {
    let radius = ring.intrados() / thrust.int(2);
    let leaves = |joint: u64| {
        let at = joints.angle(joint);
        let rise = (thrust.int(1) - thrust) * &at.sin + at.rad * at.cos;
        ring.centroid_factor.clone() * at.sin - radius.clone() * rise
    };
    let is_above = |joint: u64| is_positive(&-leaves(joint));
    let is_below = |joint: u64| is_positive(&leaves(joint));
    let (mut low, mut high) = (0, joints.last());
    if is_below(low) {
        return Ok([low, low]);
    }
    if is_above(high) {
        return Ok([high, high]);
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        match is_above(middle) {
            true => low = middle,
            false => high = middle,
        }
    }
    // A joint may lie where it changes.
    let next = (high + 1).min(joints.last());
    match is_below(high) || high == joints.last() {
        true => Ok([low, high]),
        false if is_below(next) || next == joints.last() => Ok([low, next]),
        false => Err(Undecided::new("where the line of thrust comes nearest to the intrados")),
    }
}

/// Checks that nothing slides, nor is about to but for the contacts, and every normal force is positive.
pub(super) fn friction_holds(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact],
    thrust: &Ball,
    moment: &Ball,
    ring: &Ring<Ball>,
) -> Result<(), Undecided> {
    no_slip_is_passed(joints, contacts, (thrust, moment), ring, |_| false)
}

/// Checks that no slip is passed, where a slip that is no contact may be at its limit if this says that it is
/// exactly there.
fn no_slip_is_passed(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact],
    (thrust, moment): (&Ball, &Ball),
    ring: &Ring<Ball>,
    is_at_limit: impl Fn(&Ball) -> bool,
) -> Result<(), Undecided> {
    let last = joints.last();
    let holds = |contact: JointContact| -> bool {
        if contacts.contains(&contact) {
            return true;
        }
        let beyond = joints.row(contact, ring).at(thrust, moment);
        is_at_limit(&beyond) || is_positive(&-beyond)
    };
    let is_open = |joint: u64| is_open(joints, contacts, joint);
    for joint in [0, last].into_iter().filter(|joint| !is_open(*joint)) {
        let normal = normal_force(&joints.angle(joint), thrust);
        require(is_positive(&normal), "whether a joint opens")?;
        let outwards = (Contact::Outwards, joint);
        require(!joints.is_limited() || holds(outwards), "whether the shoulder slides")?;
    }
    if !joints.is_limited() {
        return Ok(());
    }
    let slides = contacts.iter().find_map(|contact| match contact {
        (Contact::Inwards, joint) => Some(*joint),
        _ => None,
    });
    // The shear over the normal force is largest beside this joint, or at it.
    let [from, to] = match slides {
        Some(joint) => [joint.saturating_sub(1), joint + 1],
        None => around_steepest(joints, thrust)?,
    };
    for joint in from..=to.min(last) {
        require(holds((Contact::Inwards, joint)), "whether an inner joint slides")?;
    }
    Ok(())
}

/// Two joints next to each other, or one, that have between them `sqrt(h (1 - h))`, where the shear over the normal
/// force is largest; at `h` outside `(0, 1)` it falls from the crown on.
fn around_steepest(joints: &StoneJoints<'_>, thrust: &Ball) -> Result<[u64; 2], Undecided> {
    let square = (thrust.int(1) - thrust) * thrust;
    let beyond = |joint: u64| joints.angle(joint).rad.square() - &square;
    let is_below = |joint: u64| is_positive(&-beyond(joint));
    let is_above = |joint: u64| is_positive(&beyond(joint));
    let (mut low, mut high) = (0, joints.last());
    if is_above(low) {
        return Ok([low, low]);
    }
    if !is_below(low) {
        high = 1;
    }
    if high == joints.last() && is_below(high) {
        return Ok([high, high]);
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        match is_below(middle) {
            true => low = middle,
            false => high = middle,
        }
    }
    require(is_above(high), "where the joints slide most easily")?;
    Ok([low, high])
}
