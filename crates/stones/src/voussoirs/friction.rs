//! The least friction with which an arch of voussoirs stands at a given thickness.
//!
//! As the thrust grows the shoulder asks for more friction and every other joint for less: `d(T/N)/dh = -beta/N²`.
//! So the least is at the thrust at which an inner joint and the shoulder ask for the same, or, where that is not
//! in the range of thrusts with unlimited friction, at the nearer end of it. Two stones have no inner joint: none
//! asks for any where the shoulder bears no shear force.

use super::admissible::StoneLine;
use super::joints::StoneJoints;
use super::thrusts::ProvedThrustEnd;
use crate::arch::Ring;
use crate::arch::joint::{Grip, even_thrust};
use crate::arch::mechanism::Contact;
use crate::arch::statics::{normal_force, shear_force};
use crate::number::{Angle, Ball, Field};
use crate::prover::Undecided;
use crate::prover::decide::{ensure, is_positive};
use crate::solve::voussoir_thrust::{Needed, Searches};

/// The least friction, for the range of thrusts with unlimited friction and the joints that a search finds.
pub(super) fn required(
    joints: &StoneJoints<'_>,
    ring: &Ring<Ball>,
    ends: &[ProvedThrustEnd; 2],
    search: &dyn Searches,
) -> Result<Ball, Undecided> {
    let question = "which joint the friction is needed for";
    let thrusts = ends.each_ref().map(|end| end.thrust.as_ref());
    let is_within = |thrust: &Ball, [least, most]: [Option<&Ball>; 2]| {
        least.is_none_or(|least| is_positive(&(thrust.clone() - least)))
            && most.is_none_or(|most| is_positive(&(most.clone() - thrust)))
    };
    let last = joints.last();
    let shoulder = (Contact::Outwards, last);
    if last == 1 && joints.stones.has_joint_at_crown() {
        let Angle { rad, sin, cos } = joints.angle(last);
        let thrust = rad * cos / sin;
        // There N(alpha) = alpha/sin(alpha), and N = h at the crown.
        if is_within(&thrust, thrusts) && is_positive(&thrust) {
            return Ok(thrust.int(0));
        }
    }
    let (thrust, contacts) = match (search.needed(thrusts), thrusts) {
        (Needed::Even(joint), _) => {
            let thrust = even_thrust(&joints.angle(joint), &joints.angle(last));
            ensure(is_within(&thrust, thrusts), question)?;
            (thrust, vec![(Contact::Inwards, joint), shoulder])
        }
        (Needed::AtLeast, [Some(least), _]) => {
            // A crown that bears nothing asks for no friction.
            let open = ends[0].contacts.iter().copied().filter(|contact| !contact.0.is_hinge());
            (least.clone(), [shoulder].into_iter().chain(open).collect())
        }
        (Needed::AtLargest(joint), [_, Some(most)]) => {
            (most.clone(), vec![(Contact::Inwards, joint)])
        }
        _ => return Err(Undecided::new(question)),
    };
    let (contact, joint) = contacts[0];
    let at = joints.angle(joint);
    let ratio = shear_force(&at, &thrust) / normal_force(&at, &thrust);
    let friction = if contact == Contact::Outwards { -ratio } else { ratio };
    ensure(is_positive(&friction), question)?;
    // With so much no other joint slides.
    let grip = Grip { shear: friction.int(1), normal: friction.clone() };
    let with_it = StoneJoints { grip, friction: None, ..joints.clone() };
    let (joints, moment) = (&with_it, &thrust.int(0));
    StoneLine { joints, ring, contacts: &contacts, thrust: &thrust, moment }.friction_holds()?;
    Ok(friction)
}
