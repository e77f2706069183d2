//! Proof that a state of an arch of voussoirs is admissible at all of its joints, by signs at a few.
//!
//! On `(0, pi)`, at any thrust, the distance from the extrados first grows and then falls, that from the intrados
//! falls and then grows, and where `N > 0` so does the room for inward sliding ([`contact`](crate::arch::contact)).
//! So the joints beside the one that touches the intrados, or that slides, speak for all, and the first and the
//! last joint for the extrados, for outward sliding and for `N`.

use super::joints::StoneJoints;
use crate::arch::Ring;
use crate::arch::mechanism::Contact;
use crate::arch::statics::normal_force;
use crate::number::{Ball, Drawable, Field};
use crate::problem::Friction;
use crate::problem::stones::JointContact;
use crate::prover::Undecided;
use crate::prover::decide::{ensure, is_positive};

/// A line of thrust in an arch of voussoirs, with the conditions that hold with equality there.
pub(super) struct StoneLine<'a> {
    pub joints: &'a StoneJoints<'a>,
    pub ring: &'a Ring<Ball>,
    pub contacts: &'a [JointContact],
    pub thrust: &'a Ball,
    pub moment: &'a Ball,
}

impl StoneLine<'_> {
    /// Distance by which a condition is passed.
    fn beyond(&self, contact: JointContact) -> Ball {
        self.joints.row(contact, self.ring).at(self.thrust, self.moment)
    }

    /// The proof in few bits, if these are enough, or else in all.
    fn proved(
        &self,
        proof: impl Fn(&StoneLine<'_>) -> Result<(), Undecided>,
    ) -> Result<(), Undecided> {
        let Self { contacts, .. } = *self;
        let in_few = |joints: StoneJoints<'_>| {
            let [thrust, moment] =
                [self.thrust, self.moment].map(|x| x.with_precision(joints.bits));
            let ring = &self.ring.map(|x| x.with_precision(joints.bits));
            let (joints, thrust, moment) = (&joints, &thrust, &moment);
            proof(&StoneLine { joints, ring, contacts, thrust, moment })
        };
        match self.joints.in_few().map(in_few) {
            Some(Ok(())) => Ok(()),
            _ => proof(self),
        }
    }

    /// The line of thrust is inside the arch at all joints.
    pub(super) fn is_inside(&self) -> Result<(), Undecided> {
        let Self { joints, contacts, .. } = *self;
        let haunch = contacts[1].1;
        let above = haunch.checked_sub(1);
        let below = Some(haunch + 1).filter(|below| *below <= joints.last());
        // In a joint that is open there is no normal force, and no moment.
        let is_open = contacts[0] == (Contact::Inwards, haunch)
            && joints.stones.may_open(haunch, joints.is_limited());
        self.proved(|line| {
            let beside = above.into_iter().chain(below);
            line.is_inside_at(beside, |joint| is_open && joint == haunch)
        })
    }

    /// The line of thrust is inside the arch at the first and the last joint and above the intrados at these, but for
    /// its contacts and joints that are open.
    fn is_inside_at(
        &self,
        beside: impl Iterator<Item = u64>,
        is_open: impl Fn(u64) -> bool,
    ) -> Result<(), Undecided> {
        let ends = [0, self.joints.last()].map(|joint| (Contact::Extrados, joint));
        let beside = beside.map(|joint| (Contact::Intrados, joint));
        let is_strict =
            |contact: &JointContact| !self.contacts.contains(contact) && !is_open(contact.1);
        ends.into_iter().chain(beside).filter(is_strict).try_for_each(|contact| {
            let is_inside = is_positive(&-self.beyond(contact));
            ensure(is_inside, "whether the line of thrust is inside the arch")
        })
    }

    /// The state is admissible, and its contacts are the only conditions that hold with equality, but for slips at no
    /// thrust.
    pub(super) fn is_admissible(&self) -> Result<(), Undecided> {
        self.proved(|line| {
            line.no_slip_is_passed(Ball::is_zero)?;
            let [from, to] = line.around_lowest()?;
            line.is_inside_at(from..=to, |joint| line.joints.is_open(line.contacts, joint))
        })
    }

    /// The joints, at most three, that have between them the angle at which the moment about the intrados is least:
    /// where `fac sin beta - (1 - eta/2) [(1 - h) sin beta + beta cos beta]` changes its sign.
    fn around_lowest(&self) -> Result<[u64; 2], Undecided> {
        let Self { joints, ring, thrust, .. } = *self;
        let radius = ring.intrados() / thrust.int(2);
        let leaves = |joint: u64| {
            let at = joints.angle(joint);
            let rise = (thrust.int(1) - thrust) * &at.sin + at.rad * at.cos;
            ring.centroid_factor.clone() * at.sin - radius.clone() * rise
        };
        let is_above = |joint: u64| is_positive(&-leaves(joint));
        let is_below = |joint: u64| is_positive(&leaves(joint));
        let last = joints.last();
        if is_below(0) {
            return Ok([0, 0]);
        }
        if is_above(last) {
            return Ok([last, last]);
        }
        let [low, high] = halved([0, last], is_above);
        // A joint may lie where it changes.
        let next = (high + 1).min(last);
        match is_below(high) || high == last {
            true => Ok([low, high]),
            false if is_below(next) || next == last => Ok([low, next]),
            false => Err(Undecided::new("where the moment about the intrados is least")),
        }
    }

    /// Checks that nothing slides, nor is about to but for the contacts, and every normal force is positive.
    pub(super) fn friction_holds(&self) -> Result<(), Undecided> {
        self.proved(|line| line.no_slip_is_passed(|_| false))
    }

    /// Checks that no slip is passed, where a slip that is no contact may be at its limit if this says that it is
    /// exactly there.
    fn no_slip_is_passed(&self, is_at_limit: impl Fn(&Ball) -> bool) -> Result<(), Undecided> {
        let Self { joints, contacts, .. } = *self;
        let last = joints.last();
        // Without friction both slips of a joint ask for the same, and those of the crown for nothing.
        let has_no_friction = joints.friction.as_ref().is_some_and(Friction::is_zero);
        let has_crown = joints.stones.has_joint_at_crown();
        let follows = |joint: u64| {
            let slides = |of: &JointContact| of.1 == joint && !of.0.is_hinge();
            has_no_friction && (joint == 0 && has_crown || contacts.iter().any(slides))
        };
        let holds = |contact: JointContact| -> bool {
            if contacts.contains(&contact) || follows(contact.1) {
                return true;
            }
            let beyond = self.beyond(contact);
            is_at_limit(&beyond) || is_positive(&-beyond)
        };
        for joint in [0, last].into_iter().filter(|joint| !joints.is_open(contacts, *joint)) {
            let normal = normal_force(&joints.angle(joint), self.thrust);
            ensure(is_positive(&normal), "whether a joint opens")?;
            let outwards = (Contact::Outwards, joint);
            ensure(!joints.is_limited() || holds(outwards), "whether the shoulder slides")?;
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
            None => self.around_steepest()?,
        };
        (from..=to.min(last)).try_for_each(|joint| {
            ensure(holds((Contact::Inwards, joint)), "whether an inner joint slides")
        })
    }

    /// Two joints next to each other, or one, that have between them `sqrt(h (1 - h))`, where the shear over the
    /// normal force is largest; at `h` outside `(0, 1)` it falls from the crown on.
    fn around_steepest(&self) -> Result<[u64; 2], Undecided> {
        let Self { joints, thrust, .. } = *self;
        let square = (thrust.int(1) - thrust) * thrust;
        let beyond = |joint: u64| joints.angle(joint).rad.square() - &square;
        let is_below = |joint: u64| is_positive(&-beyond(joint));
        let is_above = |joint: u64| is_positive(&beyond(joint));
        let near = joints.near(square.mid().to_f64().sqrt());
        if near < joints.last() && is_below(near) && is_above(near + 1) {
            return Ok([near, near + 1]);
        }
        if is_above(0) {
            return Ok([0, 0]);
        }
        let last = if is_below(0) { joints.last() } else { 1 };
        if last == joints.last() && is_below(last) {
            return Ok([last, last]);
        }
        let [low, high] = halved([0, last], is_below);
        ensure(is_above(high), "where the joints slide most easily")?;
        Ok([low, high])
    }
}

/// Two joints next to each other between these, the last that is before something and the first that is not.
fn halved([mut low, mut high]: [u64; 2], is_before: impl Fn(u64) -> bool) -> [u64; 2] {
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        match is_before(middle) {
            true => low = middle,
            false => high = middle,
        }
    }
    [low, high]
}
