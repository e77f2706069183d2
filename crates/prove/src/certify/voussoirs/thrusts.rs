//! The range of thrusts of an arch of voussoirs at a given thickness: it stands exactly if there is one.
//!
//! A joint that slides or opens bounds the thrust, and so do a hinge at the extrados and one at the intrados, whose
//! sum is free of the crown moment. **An end** is proved by such a bound and by a state there that is admissible at
//! all joints. **It falls** if one bound from below lies above one from above. The admissible thrusts and moments
//! are a convex set, so that all between two ends are admissible. A slip that is exactly at no thrust, which only
//! arithmetic tells, may hold with equality beside those that make the end: the conditions ask for no more.

use super::admissible::{is_admissible, is_open};
use super::joints::{StoneJoints, is_positive, is_zero, leave_no_thrust, require};
use crate::arch::Ring;
use crate::arch::joint::Row;
use crate::arch::mechanism::Contact;
use crate::number::{Ball, Field};
use crate::problem::stones::JointContact;
use crate::prover::Undecided;
use crate::solve::voussoir_thrust::{ThrustEnd, ThrustSide, moment_between, thrust_end};
use rug::Float;

/// An end of the range.
#[derive(Clone, Debug)]
pub(super) struct ProvedThrustEnd {
    /// `None` if there is no bound.
    pub thrust: Option<Ball>,
    /// The conditions that hold with equality there.
    pub contacts: Vec<JointContact>,
}

/// Range of thrusts of an arch, if it stands.
#[derive(Clone, Debug)]
pub(super) enum ThrustRange {
    /// Range from the first thrust to the second.
    Stands([ProvedThrustEnd; 2]),
    /// The first conditions ask for a larger thrust than the second allow.
    Falls([ProvedThrustEnd; 2]),
}

/// Ties: exact zeros that cannot be told from balls.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ties {
    /// The friction angle is the half opening: the shoulder never slides outwards.
    pub never_slides: bool,
    /// The thrust has no lever arm between the intrados of the crown and the extrados of the shoulder.
    pub has_no_arm: bool,
    /// The thickness is 2: the intrados is the centre, and no joint gives it a lever arm.
    pub is_solid: bool,
}

impl Ties {
    /// A semicircle of thickness 2: its shoulder is level and its intrados the centre, so that without limit of
    /// friction no thrust is too large.
    fn is_solid_semicircle(self) -> bool {
        self.is_solid && self.has_no_arm
    }
}

/// The range of thrusts at a thickness.
pub(super) fn range(
    joints: &StoneJoints<'_>,
    thickness: &Ball,
    ties: Ties,
) -> Result<ThrustRange, Undecided> {
    let near = Float::with_val(joints.bits, thickness.mid());
    let search = joints.search();
    let ring = Ring::new(joints.weight, thickness);
    let mut ends = Vec::new();
    for side in ThrustSide::BOTH {
        let is_free =
            side == ThrustSide::Largest && ties.is_solid_semicircle() && !joints.is_limited();
        let end = if is_free { ThrustEnd::Unbounded } else { thrust_end(&search, &near, side) };
        match end {
            ThrustEnd::Contradiction(both) => return falls(joints, &ring, both),
            found => ends.push(found),
        }
    }
    let bound = |end: &ThrustEnd| match end {
        ThrustEnd::At(contacts) => {
            Some((contacts.clone(), together(joints, contacts, &ring).ok()?.bound()))
        }
        _ => None,
    };
    if let (Some((least, lower)), Some((most, upper))) = (bound(&ends[0]), bound(&ends[1]))
        && is_positive(&(lower - upper))
    {
        return falls(joints, &ring, [least, most]);
    }
    let proved = |side, end: &ThrustEnd| match end {
        ThrustEnd::At(contacts) => {
            let thrust = reached(joints, &ring, side, contacts)?;
            Ok(ProvedThrustEnd { thrust: Some(thrust), contacts: contacts.clone() })
        }
        _ => unbounded(joints, &ring, side, ties),
    };
    let [least, most] =
        [proved(ThrustSide::Least, &ends[0])?, proved(ThrustSide::Largest, &ends[1])?];
    require(least.thrust.is_some() || most.thrust.is_some(), "whether any thrust is admissible")?;
    Ok(ThrustRange::Stands([least, most]))
}

/// Bound that a slip, or two hinges, set on the thrust: none, if they bind the crown moment too.
fn together(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact],
    ring: &Ring<Ball>,
) -> Result<Row<Ball>, Undecided> {
    let zero = ring.thickness.int(0);
    let none = Row { thrust: zero.clone(), moment: zero.clone(), load: zero };
    let row = contacts.iter().fold(none, |sum, contact| sum.plus(&joints.row(*contact, ring)));
    require(is_zero(&row.moment), "whether the thrust is bounded")?;
    Ok(row)
}

fn falls(
    joints: &StoneJoints<'_>,
    ring: &Ring<Ball>,
    contacts: [Vec<JointContact>; 2],
) -> Result<ThrustRange, Undecided> {
    let [lower, upper] = &contacts;
    let rows = [together(joints, lower, ring)?, together(joints, upper, ring)?];
    leave_no_thrust(rows.each_ref())?;
    let [least, most] = rows.map(|row| Some(row.bound()));
    let [lower, upper] = contacts;
    Ok(ThrustRange::Falls([
        ProvedThrustEnd { thrust: least, contacts: lower },
        ProvedThrustEnd { thrust: most, contacts: upper },
    ]))
}

/// The thrust of an end: a bound, and the thrust of an admissible state.
fn reached(
    joints: &StoneJoints<'_>,
    ring: &Ring<Ball>,
    side: ThrustSide,
    contacts: &[JointContact],
) -> Result<Ball, Undecided> {
    let row = together(joints, contacts, ring)?;
    let slope = match side {
        ThrustSide::Least => -row.thrust.clone(),
        ThrustSide::Largest => row.thrust.clone(),
    };
    require(is_positive(&slope), "whether the thrust is bounded")?;
    let thrust = row.bound();
    let moment = moment(joints, ring, contacts, &thrust);
    is_admissible(joints, contacts, &thrust, &moment, ring)?;
    Ok(thrust)
}

/// The crown moment of a state at an end: a hinge and an open joint have one, a slip leaves room.
fn moment(
    joints: &StoneJoints<'_>,
    ring: &Ring<Ball>,
    contacts: &[JointContact],
    thrust: &Ball,
) -> Ball {
    let (contact, joint) = contacts[0];
    if contact.is_hinge() {
        return joints.row(contacts[0], ring).moment_at(thrust);
    }
    if is_open(joints, contacts, joint) {
        return -(joints.angle(joint).versine() * &ring.centroid_factor);
    }
    let middle = |x: &Ball| Float::with_val(joints.bits, x.mid());
    let moment = moment_between(&joints.search(), &middle(thrust), &middle(&ring.thickness));
    Ball::exact(moment, joints.bits)
}

/// No thrust is too large: more of it, and as much more moment as between the intrados of the first joint and
/// the extrados of the shoulder, passes no condition.
fn unbounded(
    joints: &StoneJoints<'_>,
    ring: &Ring<Ball>,
    side: ThrustSide,
    ties: Ties,
) -> Result<ProvedThrustEnd, Undecided> {
    let question = "whether the thrust is bounded";
    require(side == ThrustSide::Largest, question)?;
    let last = joints.last();
    let hinges = together(joints, &[(Contact::Extrados, last), (Contact::Intrados, 0)], ring)?;
    let has_no_arm = ties.has_no_arm && (joints.stones.has_joint_at_crown() || ties.is_solid);
    require(has_no_arm || is_positive(&-hinges.thrust), question)?;
    let slip = joints.row((Contact::Outwards, last), ring);
    let never_slides = match joints.is_limited() {
        true => ties.never_slides,
        false => ties.is_solid_semicircle(),
    };
    require(never_slides || is_positive(&-slip.thrust), question)?;
    Ok(ProvedThrustEnd { thrust: None, contacts: Vec::new() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::stones::Stones;

    /// The conditions of two hinges are free of the crown moment only if they are at opposite faces.
    #[test]
    fn conditions_together_are_free_of_the_crown_moment_or_refused() {
        let stones = Stones::equal(8, "1".parse().unwrap()).unwrap();
        let friction = "0.5".parse().unwrap();
        let joints = StoneJoints::new(&stones, SelfWeight::Heyman, &friction, 100);
        let ring = Ring::new(joints.weight, &Ball::integer(1, 100));
        let free = |contacts: &[JointContact]| together(&joints, contacts, &ring).is_ok();
        assert!(free(&[(Contact::Extrados, 0), (Contact::Intrados, 3)]));
        assert!(free(&[(Contact::Inwards, 2)]) && free(&[(Contact::Outwards, 4)]));
        for contacts in [
            &[(Contact::Extrados, 0), (Contact::Extrados, 4)][..],
            &[(Contact::Intrados, 0), (Contact::Intrados, 4)],
            &[(Contact::Extrados, 0)],
            &[(Contact::Intrados, 2), (Contact::Inwards, 2)],
        ] {
            assert!(!free(contacts), "{contacts:?}");
        }
    }
}
