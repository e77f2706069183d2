//! A thrust with the lines that belong to it.

use super::line::{Line, centreline, double};
use super::range::moments;
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, Ring, SelfWeight, contact, statics};
use crate::certify::Undecided;
use crate::certify::state::{Limit, Touch};
use crate::number::{Angle, Ball, Field};
use crate::problem::Mode;

/// A thrust with its lines.
#[derive(Clone, Debug)]
pub struct Forces {
    /// `h`.
    pub thrust: Ball,
    /// The least and the largest crown moment that fit it; the same where one does.
    pub moments: [Ball; 2],
    /// The line of thrust of each of these: one where they are the same.
    pub thrust_lines: Vec<Line>,
    /// The line of friction.
    pub friction_line: Line,
    /// What limits the thrust, in words, if it is an end of a range.
    pub limited_by: Option<&'static str>,
    /// The joints at their limits.
    pub marks: Vec<Mark>,
}

/// A joint at its limit.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Which limit.
    pub contact: Contact,
    /// The joint, rad.
    pub at: Ball,
}

impl Mark {
    /// The limit and the joint, rad.
    pub fn place(&self) -> (Contact, f64) {
        (self.contact, double(&self.at))
    }
}

/// Which crown moment belongs to a thrust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Moment {
    /// The line of thrust is on the extrados of the crown.
    Crown,
    /// It is on that of the shoulder.
    Shoulder,
    /// Any that fits.
    Any,
}

impl Forces {
    /// Those of a state in a mode; the friction is unlimited if it is not.
    pub(super) fn of_mode(
        weight: SelfWeight,
        mode: Mode,
        at: &Configuration<Ball>,
        is_limited: bool,
    ) -> Result<Self, Undecided> {
        let moment = match mode {
            Mode::Rotational | Mode::SlidingRotational | Mode::Overturning => Moment::Crown,
            Mode::RotationalSliding
            | Mode::RotationalSlidingRotational
            | Mode::OverturningSliding => Moment::Shoulder,
            Mode::Sliding => Moment::Any,
        };
        Self::new(weight, at, is_limited, moment, joints_of(mode, at))
    }

    /// Those of an end of a range of thrusts, at least or at most so much; `None` where there is no bound.
    pub(super) fn of_limit(
        weight: SelfWeight,
        given: &Configuration<Ball>,
        is_limited: bool,
        limit: &Limit,
        is_least: bool,
    ) -> Result<Option<Self>, Undecided> {
        let Some(thrust) = &limit.thrust else { return Ok(None) };
        let at = Configuration { thrust: thrust.clone(), ..given.clone() };
        let (zero, alpha) = (thrust.int(0), &at.half_opening.rad);
        let mark = |contact, at: &Ball| Mark { contact, at: at.clone() };
        let on_extrados = match is_least {
            true => mark(Contact::Extrados, &zero),
            false => mark(Contact::Extrados, alpha),
        };
        let end = if is_least { Moment::Crown } else { Moment::Shoulder };
        let (moment, marks) = match &limit.touch {
            Touch::Haunch(joint) => (end, vec![on_extrados, mark(Contact::Intrados, joint)]),
            Touch::Crown => (end, vec![on_extrados, mark(Contact::Intrados, &zero)]),
            Touch::Shoulder | Touch::AtShoulder => {
                (end, vec![on_extrados, mark(Contact::Intrados, alpha)])
            }
            Touch::InnerSliding(joint) => (Moment::Any, vec![mark(Contact::Inwards, joint)]),
            Touch::ShoulderSliding => (Moment::Any, vec![mark(Contact::Outwards, alpha)]),
            Touch::ShoulderSlidingInwards => (Moment::Any, vec![mark(Contact::Inwards, alpha)]),
            // Without thrust the crown moment is zero.
            Touch::Nothing => (Moment::Crown, Vec::new()),
        };
        let mut forces = Self::new(weight, &at, is_limited, moment, marks)?;
        forces.limited_by = Some(limit.touch.name());
        if forces.thrust_lines.len() > 1 {
            // Of several, the one that is the steepest or the flattest.
            let kept = usize::from(is_least);
            forces.thrust_lines = vec![forces.thrust_lines.swap_remove(kept)];
            forces.moments = [forces.moments[kept].clone(), forces.moments[kept].clone()];
        }
        Ok(Some(forces))
    }

    fn new(
        weight: SelfWeight,
        at: &Configuration<Ball>,
        is_limited: bool,
        moment: Moment,
        marks: Vec<Mark>,
    ) -> Result<Self, Undecided> {
        let both = |moment: Ball| [moment.clone(), moment];
        let moments = match moment {
            Moment::Crown => both(contact::crown_moment(at)),
            Moment::Shoulder => both(contact::shoulder_moment(weight, at)),
            Moment::Any => moments(weight, at)?,
        };
        let count = if moment == Moment::Any { 2 } else { 1 };
        let thrust_lines = moments.iter().take(count).map(|p| thrust_line(weight, at, p));
        Ok(Self {
            thrust: at.thrust.clone(),
            thrust_lines: thrust_lines.collect(),
            moments,
            friction_line: friction_line(at, is_limited),
            limited_by: None,
            marks,
        })
    }
}

/// The joints that give way in a mode.
pub(super) fn joints_of(mode: Mode, at: &Configuration<Ball>) -> Vec<Mark> {
    let mechanism = mode.mechanism(at, &at.thrust.int(0));
    let joints = mechanism.joints.iter().chain(mechanism.crown_hinge());
    joints.map(|joint| Mark { contact: joint.contact, at: joint.at.rad.clone() }).collect()
}

pub(super) fn is_zero(x: &Ball) -> bool {
    x.mid().is_zero() && x.rad().is_zero()
}

/// The locus of the pressure points.
fn thrust_line(weight: SelfWeight, at: &Configuration<Ball>, moment: &Ball) -> Line {
    let fac = Ring::new(weight, &at.thickness).centroid_factor;
    let without_thrust = is_zero(&at.thrust);
    Line::new([&at.half_opening.rad, &at.thickness], |joint| match without_thrust {
        true if is_zero(&joint.rad) => fac.ratio(1, 2) * &fac,
        true => statics::radius_without_thrust(joint, &fac),
        false => statics::pressure_radius(joint, &at.thrust, moment, &fac),
    })
}

/// At the offset `(eta/2) T/(mu N)` from the centreline.
fn friction_line(at: &Configuration<Ball>, is_limited: bool) -> Line {
    if !is_limited {
        return centreline(&at.half_opening.rad, &at.thickness);
    }
    Line::new([&at.half_opening.rad, &at.thickness], |joint: &Angle<Ball>| {
        statics::friction_radius(joint, [&at.thrust, &at.friction, &at.thickness])
    })
}
