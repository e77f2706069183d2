//! Arches under a horizontal acceleration, and what is proved of them; their record and their picture are beside.

use super::sizes::Sizes;
use super::understood::Understood;
use crate::arch::mechanism::Contact;
use crate::arch::whole::Side;
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::number::{Ball, Drawable, ExactNumber, arctangent, degrees};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Slope};
use couplet_stones::{LargestTilt, TiltDigits, TiltMechanism, TiltedJoint};

/// Digits of an angle among words.
const DIGITS: usize = 6;

/// A joint that gives way, by its side and its angle from the crown.
pub struct JointAtLimit<'a> {
    /// The joint as it is proved.
    pub of: &'a TiltedJoint,
    /// The half of the arch in which it is.
    pub side: Side,
    /// Angle from the crown, rad, without its sign.
    pub size: Ball,
    /// The joint between two stones, from the crown on.
    pub number: Option<u64>,
}

impl JointAtLimit<'_> {
    /// Tells whether it is the crown itself.
    pub fn is_crown(&self) -> bool {
        Drawable::is_zero(&self.size)
    }

    /// ` (54.12 deg)`; at the crown nothing.
    fn angle(&self, digits: usize) -> String {
        match self.is_crown() {
            true => String::new(),
            false => format!(" ({} deg)", self.degrees(digits.min(DIGITS))),
        }
    }

    /// Angle from the crown in degrees, correctly rounded.
    pub fn degrees(&self, digits: usize) -> String {
        super::numbers::rounded(&degrees(&self.size), digits)
    }
}

/// An arch of a given thickness under an acceleration, and what is proved of it.
#[derive(Debug)]
pub struct TiltedArch {
    /// Question as it is understood.
    pub asked: Understood,
    /// The arch.
    pub arch: Arch,
    /// The thickness as given.
    pub thickness: ExactNumber,
    /// The acceleration as given.
    pub tilt: Slope,
    /// Stones of the arch, where it has joints between these only.
    pub stones: Option<Stones>,
    /// Digits of what is proved.
    pub digits: usize,
    /// The command that makes it, for the caption of a picture.
    pub command: String,
    /// Result that is proved; `None` if the arch does not even stand without acceleration.
    pub found: Result<Option<TiltDigits>, Undecided>,
    /// Sizes of the arch, where it is measured, with the forces in its crown at the largest acceleration.
    pub sizes: Option<Sizes>,
}

impl TiltedArch {
    /// Tells whether there is an admissible state; `None` if that stays open.
    pub fn is_admissible(&self) -> Option<bool> {
        match &self.found {
            Ok(None) => Some(false),
            Ok(Some(found)) => found.is_admissible.as_ref().ok().copied(),
            Err(_) => None,
        }
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        match &self.found {
            Ok(None) => None,
            Ok(Some(found)) => found.is_admissible.as_ref().err().or(found.largest.as_ref().err()),
            Err(undecided) => Some(undecided),
        }
        .or_else(|| self.sizes.as_ref()?.found.as_ref().err())
    }

    /// Outcome in a word.
    pub(super) fn outcome(&self) -> &'static str {
        match self.is_admissible() {
            Some(true) => "stands",
            Some(false) => "collapses",
            None => "undecided",
        }
    }

    /// Tells whether an admissible state does not exclude a motion: joints that slide do not open.
    pub(super) fn may_move(&self) -> bool {
        self.arch.is_limited() && self.is_admissible() == Some(true)
    }

    /// The largest acceleration, where it is known.
    pub fn largest(&self) -> Option<&LargestTilt> {
        self.found.as_ref().ok()?.as_ref()?.largest.as_ref().ok()
    }

    /// Largest acceleration as a figure.
    pub fn figure(&self) -> Option<&Figure> {
        match self.largest()? {
            LargestTilt::Limited(figure, _) => Some(figure),
            LargestTilt::Unlimited => None,
        }
    }

    /// Largest acceleration as the angle of the ground, and thrust and vertical force in the crown there over `w r`.
    pub fn at_largest(&self) -> Vec<(&'static str, Figure)> {
        let Some(mechanism) = self.mechanism() else { return Vec::new() };
        let [thrust, _, vertical, tilt] = &mechanism.forces;
        let angle = degrees(&arctangent(tilt));
        let told =
            [("largest_tilt_degrees", &angle), ("thrust", thrust), ("vertical_force", vertical)];
        let figure = |(name, of)| Some((name, Figure::around(of, self.digits)?));
        told.into_iter().filter_map(figure).collect()
    }

    /// The joints that give way at the largest acceleration.
    pub fn mechanism(&self) -> Option<&TiltMechanism> {
        match self.largest()? {
            LargestTilt::Limited(_, mechanism) => Some(mechanism),
            LargestTilt::Unlimited => None,
        }
    }

    /// The joints that give way, with their sides and, between stones, their numbers.
    pub fn joints(&self) -> Vec<JointAtLimit<'_>> {
        self.mechanism().into_iter().flat_map(|all| &all.joints).map(|of| self.joint(of)).collect()
    }

    fn joint<'a>(&self, of: &'a TiltedJoint) -> JointAtLimit<'a> {
        let TiltedJoint { angle, .. } = of;
        let side = if *angle.mid() < 0 { Side::Left } else { Side::Right };
        let size = if side == Side::Left { -angle.clone() } else { angle.clone() };
        let nearest = |stones: &Stones| {
            let away = |joint: &u64| {
                let joint: Ball = stones.angle(*joint, size.prec()).rad;
                (joint.double() - size.double()).abs()
            };
            (0..stones.count()).min_by(|a, b| away(a).total_cmp(&away(b)))
        };
        let number = self.stones.as_ref().and_then(nearest);
        JointAtLimit { of, side, size, number }
    }

    /// Description of what a joint does, in words, by its condition on one side.
    pub fn happens(&self, side: Side, contact: Contact) -> &'static str {
        match side.contact(contact) {
            slip if !slip.is_hinge() && !self.arch.is_limited() => "opens",
            other => other.name(),
        }
    }

    /// Limits of the acceleration, in words, with the angles of the joints.
    pub(super) fn limits(&self) -> Vec<String> {
        let words = |joint: JointAtLimit<'_>| {
            let name = joint.side.name();
            let words = self.happens(joint.side, joint.of.contact);
            let place = match (joint.of.is_springing, joint.number.zip(self.stones.as_ref())) {
                (true, _) => format!("at the {name} springing"),
                (false, None) => format!("on the {name}"),
                (false, Some((0, stones))) if stones.has_joint_at_crown() => "at the crown".into(),
                (false, Some((number, stones))) => {
                    format!("at joint {} on the {name}", stones.from_crown(number))
                }
            };
            format!("{words} {place}{}", joint.angle(self.digits))
        };
        self.joints().into_iter().map(words).collect()
    }
}
