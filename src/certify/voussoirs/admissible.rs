//! Whether a state of an arch of voussoirs is admissible at all of its joints, by signs at a few.
//!
//! On `(0, pi)`, at any thrust, the distance from the extrados first grows and then falls, that from the intrados falls and
//! then grows, and where `N > 0` so does the room for inward sliding ([`contact`](crate::arch::contact)). So the joints beside the
//! one that touches the intrados, or that slides, speak for all, and the first and the last joint for the extrados, for
//! outward sliding and for `N`.

use super::joints::{Joints, is_positive, require};
use crate::arch::Ring;
use crate::arch::mechanism::Contact;
use crate::arch::statics::normal_force;
use crate::certify::Undecided;
use crate::number::{Ball, Field};
use crate::problem::stones::JointContact;

/// The line of thrust is inside the arch at all joints.
pub(super) fn line_is_inside(
    joints: &Joints<'_>,
    contacts: &[JointContact],
    thrust: &Ball,
    moment: &Ball,
    ring: &Ring<Ball>,
) -> Result<(), Undecided> {
    let haunch = contacts[1].1;
    let ends = [0, joints.last()].map(|joint| (Contact::Extrados, joint));
    let above = haunch.checked_sub(1);
    let below = Some(haunch + 1).filter(|below| *below <= joints.last());
    let beside = above.into_iter().chain(below).map(|joint| (Contact::Intrados, joint));
    // In a joint that is open there is no normal force, and no moment.
    let is_open = contacts[0] == (Contact::Inwards, haunch)
        && joints.stones.may_open(haunch, joints.is_limited);
    let ends = ends.into_iter().filter(|end| !(is_open && end.1 == haunch));
    for contact in ends.into_iter().chain(beside).filter(|contact| !contacts.contains(contact)) {
        let margin = -joints.row(contact, ring).at(thrust, moment);
        require(is_positive(&margin), "whether the line of thrust is inside the arch")?;
    }
    Ok(())
}

/// Nothing slides, and every normal force is positive.
pub(super) fn friction_holds(
    joints: &Joints<'_>,
    contacts: &[JointContact],
    thrust: &Ball,
    moment: &Ball,
    ring: &Ring<Ball>,
) -> Result<(), Undecided> {
    let last = joints.last();
    let holds = |contact: JointContact| -> bool {
        contacts.contains(&contact) || is_positive(&-joints.row(contact, ring).at(thrust, moment))
    };
    // A joint that is open has no normal force.
    let is_open = |joint: u64| {
        contacts.contains(&(Contact::Inwards, joint))
            && joints.stones.may_open(joint, joints.is_limited)
    };
    for joint in [0, last].into_iter().filter(|joint| !is_open(*joint)) {
        let normal = normal_force(&joints.angle(joint), thrust);
        require(is_positive(&normal), "whether a joint opens")?;
        let outwards = (Contact::Outwards, joint);
        require(!joints.is_limited || holds(outwards), "whether the shoulder slides")?;
    }
    if !joints.is_limited {
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

/// Two joints next to each other, or one, that have between them `sqrt(h (1 - h))`, where the shear over the normal force is
/// largest; at `h` outside `(0, 1)` it falls from the crown on.
fn around_steepest(joints: &Joints<'_>, thrust: &Ball) -> Result<[u64; 2], Undecided> {
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
