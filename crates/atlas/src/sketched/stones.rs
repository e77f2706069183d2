//! An arch of stones: its joints are between them and nowhere else, and so are its conditions.

use super::stability::{ball, limited_by};
use super::{Forces, Mark};
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, Ring, Unknown};
use crate::number::{Ball, Drawable};
use crate::problem::Arch;
use crate::problem::stones::{JointContact, Stones};
use crate::prover::arithmetic::larger;
use couplet_stones::{VoussoirDigits, VoussoirLimit};

/// Bits of a configuration, and digits of what is proved: more than a picture needs.
pub(super) const BITS: u32 = 256;
pub(super) const DIGITS: usize = 40;

/// The joints of the right half but for the shoulder, from the crown, rad.
pub(super) fn joints(stones: &Stones) -> Vec<f64> {
    (0..stones.last()).map(|index| stones.angle::<Ball>(index, BITS).rad.double()).collect()
}

/// Configuration of an arch of stones at its least thickness: the hinge at the intrados is the rotational
/// joint, that of a keystone the hinge of the crown.
pub(super) fn state(arch: &Arch, stones: &Stones, found: &VoussoirDigits) -> Configuration<Ball> {
    let [first, haunch, _] = found.contacts.map(|(_, joint)| stones.angle(joint, BITS));
    let at = arch.given(BITS).with(Unknown::Thickness, ball(&found.thickness));
    let at = at.with(Unknown::Thrust, ball(&found.thrust));
    let at = Configuration { rotation_joint: haunch, ..at };
    match found.mode {
        mode if mode.slides_inside() => Configuration { sliding_joint: first, ..at },
        mode if mode.has_haunch() => Configuration { crown_hinge: first, ..at },
        _ => at,
    }
}

/// The crown moment of a hinge, for the thrust of a configuration.
pub(super) fn moment(
    (arch, stones): (&Arch, &Stones),
    at: &Configuration<Ball>,
    (contact, joint): JointContact,
) -> Option<Ball> {
    let ring = Ring::new(arch.weight(), &at.thickness);
    let at_joint = stones.angle(joint, BITS);
    let row = match contact {
        Contact::Extrados => crate::arch::joint::extrados(&at_joint, &ring),
        Contact::Intrados => crate::arch::joint::intrados(&at_joint, &ring),
        Contact::Inwards | Contact::Outwards => return None,
    };
    Some(row.moment_at(&at.thrust))
}

/// The least and the largest crown moment with which the line of thrust is within the arch at every joint.
pub(super) fn moments(of: (&Arch, &Stones), at: &Configuration<Ball>) -> Option<[Ball; 2]> {
    let joints = || 0..of.1.count();
    let all = |contact| joints().filter_map(move |joint| moment(of, at, (contact, joint)));
    let least = all(Contact::Intrados).reduce(larger)?;
    let largest = all(Contact::Extrados).map(|p| -p).reduce(larger)?;
    Some([least, -largest])
}

/// The forces at an end of the range of thrusts; `None` where there is no bound.
pub(super) fn forces(
    (arch, stones): (&Arch, &Stones),
    at: &Configuration<Ball>,
    limit: &VoussoirLimit,
    is_least: bool,
) -> Option<Forces> {
    let at = at.clone().with(Unknown::Thrust, ball(limit.thrust.as_ref()?));
    let is_limited = arch.is_limited();
    let of = (arch, stones);
    // Where friction is the limit, the steepest line or the flattest.
    let free = || moments(of, &at).map(|[least, largest]| if is_least { largest } else { least });
    let hinge = limit.contacts.iter().find_map(|contact| moment(of, &at, *contact));
    let moment = hinge.or_else(free)?;
    let slips = |(contact, joint): &JointContact| {
        contact.is_hinge() || !stones.may_open(*joint, is_limited)
    };
    let mark = |(contact, joint): &JointContact| Mark {
        contact: *contact,
        at: stones.angle(*joint, BITS).rad,
    };
    let marks = limit.contacts.iter().filter(|contact| slips(contact)).map(mark).collect();
    let forces = Forces::new(arch.weight(), (&at, &joints(stones)), is_limited, &[moment], marks);
    Some(Forces { limited_by: Some(limited_by((stones, is_limited), limit)), ..forces })
}
