//! The range of thrusts of an arch of voussoirs at a given thickness: it stands exactly if there is one.
//!
//! A joint that slides or opens bounds the thrust, and so do a hinge at the extrados and one at the intrados, whose
//! sum is free of the crown moment. **An end** is proved by such a bound and by a state there that is admissible at
//! all joints. **It falls** if one bound from below lies above one from above. The admissible thrusts and moments
//! are a convex set, so that all between two ends are admissible. A slip that is exactly at no thrust, which only
//! arithmetic tells, may hold with equality beside those that make the end: the conditions ask for no more.

use super::admissible::StoneLine;
use super::joints::{StoneJoints, leave_no_thrust};
use crate::arch::Ring;
use crate::arch::joint::Row;
use crate::arch::mechanism::Contact;
use crate::number::{Ball, Drawable, ExactNumber, Field};
use crate::problem::Arch;
use crate::problem::stones::JointContact;
use crate::prover::decide::{ensure, is_positive};
use crate::prover::ties::{friction_angle_is_half_opening, has_no_arm_at_crown};
use crate::prover::{Figure, Undecided};
use crate::solve::voussoir_thrust::{Searches, ThrustEnd, ThrustSide};

/// A bound of the thrust.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct VoussoirLimit {
    /// The thrust; `None` if there is no bound.
    pub thrust: Option<Figure>,
    /// Contacts that limit it: a joint that slides or opens, or a hinge at the extrados and one at the intrados.
    pub contacts: Vec<JointContact>,
    /// The angles of their joints, rad.
    pub joints: Vec<Figure>,
}

/// Verdict on whether an arch of voussoirs of a given thickness stands, with the ends of its range of thrusts.
#[derive(Clone, Debug)]
pub enum VoussoirStanding<E = VoussoirLimit> {
    /// The arch stands, with thrusts from the first to the second.
    Stands([E; 2]),
    /// The arch does not stand: no thrust is as large as the first asks for and as small as the second allows.
    Falls([E; 2]),
}

/// An end of the range.
#[derive(Clone, Debug)]
pub(super) struct ProvedThrustEnd {
    /// `None` if there is no bound.
    pub thrust: Option<Ball>,
    /// The conditions that hold with equality there.
    pub contacts: Vec<JointContact>,
}

/// Range of thrusts of an arch, if it stands.
pub(super) type ThrustRange = VoussoirStanding<ProvedThrustEnd>;

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
    /// Ties of an arch of a thickness.
    pub(super) fn of(arch: &Arch, thickness: &ExactNumber) -> Self {
        Self {
            never_slides: friction_angle_is_half_opening(arch),
            has_no_arm: has_no_arm_at_crown(arch, thickness),
            is_solid: thickness.is_rational() && thickness.to_rational() == 2,
        }
    }

    /// A semicircle of thickness 2: its shoulder is level and its intrados the centre, so that without limit of
    /// friction no thrust is too large.
    fn is_solid_semicircle(self) -> bool {
        self.is_solid && self.has_no_arm
    }
}

/// An arch of voussoirs of a thickness, whose range of thrusts is asked.
pub(super) struct ThickStones<'a> {
    joints: &'a StoneJoints<'a>,
    ring: Ring<Ball>,
    ties: Ties,
}

impl<'a> ThickStones<'a> {
    /// Arch with these joints at a thickness.
    pub(super) fn new(joints: &'a StoneJoints<'a>, thickness: &Ball, ties: Ties) -> Self {
        Self { joints, ring: Ring::new(joints.weight, thickness), ties }
    }

    /// The range of thrusts.
    pub(super) fn range(&self) -> Result<ThrustRange, Undecided> {
        self.joints.searched(|search| self.range_found(search))
    }

    /// Range of thrusts whose ends a search finds.
    fn range_found(&self, search: &dyn Searches) -> Result<ThrustRange, Undecided> {
        let is_free = self.ties.is_solid_semicircle() && !self.joints.is_limited();
        let mut ends = Vec::new();
        for side in ThrustSide::BOTH {
            let end = match side == ThrustSide::Largest && is_free {
                true => ThrustEnd::Unbounded,
                false => search.thrust_end(&self.ring.thickness, side),
            };
            match end {
                ThrustEnd::Contradiction(both) => return self.falls(both),
                found => ends.push(found),
            }
        }
        let bound = |end: &ThrustEnd| match end {
            ThrustEnd::At(contacts) => {
                Some((contacts.clone(), self.together(contacts).ok()?.bound()))
            }
            _ => None,
        };
        if let (Some((least, lower)), Some((most, upper))) = (bound(&ends[0]), bound(&ends[1]))
            && is_positive(&(lower - upper))
        {
            return self.falls([least, most]);
        }
        let proved = |side, end: &ThrustEnd| match end {
            ThrustEnd::At(contacts) => {
                let thrust = self.reached(search, side, contacts)?;
                Ok(ProvedThrustEnd { thrust: Some(thrust), contacts: contacts.clone() })
            }
            _ => self.unbounded(side),
        };
        let [least, most] =
            [proved(ThrustSide::Least, &ends[0])?, proved(ThrustSide::Largest, &ends[1])?];
        let is_bounded = least.thrust.is_some() || most.thrust.is_some();
        ensure(is_bounded, "whether any thrust is admissible")?;
        Ok(ThrustRange::Stands([least, most]))
    }

    /// Bound that a slip, or two hinges, set on the thrust: none, if they bind the crown moment too.
    fn together(&self, contacts: &[JointContact]) -> Result<Row<Ball>, Undecided> {
        let zero = self.ring.thickness.int(0);
        let none = Row { thrust: zero.clone(), moment: zero.clone(), load: zero };
        let rows = contacts.iter().map(|contact| self.joints.row(*contact, &self.ring));
        let row = rows.fold(none, |sum, row| sum.plus(&row));
        ensure(row.moment.is_zero(), "whether the thrust is bounded")?;
        Ok(row)
    }

    fn falls(&self, [lower, upper]: [Vec<JointContact>; 2]) -> Result<ThrustRange, Undecided> {
        let rows = [self.together(&lower)?, self.together(&upper)?];
        leave_no_thrust(rows.each_ref())?;
        let [least, most] = rows.map(|row| Some(row.bound()));
        Ok(ThrustRange::Falls([
            ProvedThrustEnd { thrust: least, contacts: lower },
            ProvedThrustEnd { thrust: most, contacts: upper },
        ]))
    }

    /// The thrust of an end: a bound, and the thrust of an admissible state.
    fn reached(
        &self,
        search: &dyn Searches,
        side: ThrustSide,
        contacts: &[JointContact],
    ) -> Result<Ball, Undecided> {
        let row = self.together(contacts)?;
        let slope = match side {
            ThrustSide::Least => -row.thrust.clone(),
            ThrustSide::Largest => row.thrust.clone(),
        };
        ensure(is_positive(&slope), "whether the thrust is bounded")?;
        let thrust = row.bound();
        let moment = self.moment(search, contacts, &thrust);
        let Self { joints, ring, .. } = self;
        StoneLine { joints, ring, contacts, thrust: &thrust, moment: &moment }.is_admissible()?;
        Ok(thrust)
    }

    /// The crown moment of a state at an end: a hinge and an open joint have one, a slip leaves room.
    fn moment(&self, search: &dyn Searches, contacts: &[JointContact], thrust: &Ball) -> Ball {
        let (contact, joint) = contacts[0];
        if contact.is_hinge() {
            return self.joints.row(contacts[0], &self.ring).moment_at(thrust);
        }
        if self.joints.is_open(contacts, joint) {
            return -(self.joints.angle(joint).versine() * &self.ring.centroid_factor);
        }
        Ball::exact(search.moment_between(thrust, &self.ring.thickness), self.joints.bits)
    }

    /// No thrust is too large: more of it, and as much more moment as between the intrados of the first joint and
    /// the extrados of the shoulder, passes no condition. Or none is too small: where all joints are beyond a right
    /// angle less of it presses them, with a moment between the intrados of the shoulder and the extrados of the first
    /// joint, which slides inwards before the others do.
    fn unbounded(&self, side: ThrustSide) -> Result<ProvedThrustEnd, Undecided> {
        let Self { joints, ring, ties } = self;
        let question = "whether the thrust is bounded";
        let last = joints.last();
        if side == ThrustSide::Least {
            let hinges = self.together(&[(Contact::Extrados, 0), (Contact::Intrados, last)])?;
            let slip = joints.row((Contact::Inwards, 0), ring);
            ensure(is_positive(&hinges.thrust) && is_positive(&slip.thrust), question)?;
            return Ok(ProvedThrustEnd { thrust: None, contacts: Vec::new() });
        }
        let hinges = self.together(&[(Contact::Extrados, last), (Contact::Intrados, 0)])?;
        let has_no_arm = ties.has_no_arm && (joints.stones.has_joint_at_crown() || ties.is_solid);
        ensure(has_no_arm || is_positive(&-hinges.thrust), question)?;
        let slip = joints.row((Contact::Outwards, last), ring);
        let never_slides = match joints.is_limited() {
            true => ties.never_slides,
            false => ties.is_solid_semicircle(),
        };
        ensure(never_slides || is_positive(&-slip.thrust), question)?;
        Ok(ProvedThrustEnd { thrust: None, contacts: Vec::new() })
    }
}

#[cfg(test)]
mod tests {
    use super::super::joints::StoneAngles;
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::stones::Stones;

    /// The conditions of two hinges are free of the crown moment only if they are at opposite faces.
    #[test]
    fn conditions_together_are_free_of_the_crown_moment_or_refused() {
        let stones = Stones::equal(8, "1".parse().unwrap()).unwrap();
        let friction = "0.5".parse().unwrap();
        let angles = StoneAngles::new(&stones);
        let joints = StoneJoints::new(&angles, SelfWeight::Heyman, &friction, 100);
        let thick = ThickStones::new(&joints, &Ball::integer(1, 100), Ties::default());
        let free = |contacts: &[JointContact]| thick.together(contacts).is_ok();
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
