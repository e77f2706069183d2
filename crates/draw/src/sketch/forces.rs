//! A thrust with the lines that belong to it.

use super::line::{SketchedLine, centreline};
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, Ring, SelfWeight, contact, statics};
use crate::number::Drawable;
use crate::problem::Mode;

/// A thrust with its lines.
#[derive(Clone, Debug)]
pub struct Forces<T> {
    /// `h`.
    pub thrust: T,
    /// The least and the largest crown moment that fit it; the same where one does.
    pub moments: [T; 2],
    /// The line of thrust of each of these: one where they are the same.
    pub thrust_lines: Vec<SketchedLine>,
    /// The line of friction.
    pub friction_line: SketchedLine,
    /// Limit of the thrust, in words, if it is an end of a range.
    pub limited_by: Option<String>,
    /// Distance by which the line of thrust of an arch that falls is beyond the faces at its hinges, in units of `r`.
    pub beyond: Option<T>,
    /// The joints at their limits.
    pub marks: Vec<Mark<T>>,
}

/// The lines of a thrust.
#[derive(Clone, Copy, Debug)]
pub struct Lines<'a> {
    /// Lines of thrust: one, or the two between which all others are.
    pub thrust: &'a [SketchedLine],
    /// Line of friction.
    pub friction: &'a SketchedLine,
}

impl<'a> Lines<'a> {
    /// All of them.
    pub fn all(self) -> impl Iterator<Item = &'a SketchedLine> {
        self.thrust.iter().chain([self.friction])
    }
}

/// A joint at its limit.
#[derive(Clone, Debug)]
pub struct Mark<T> {
    /// Limit that is reached.
    pub contact: Contact,
    /// The joint, rad.
    pub at: T,
}

impl<T: Drawable> Mark<T> {
    /// The limit and the joint, rad.
    pub fn place(&self) -> (Contact, f64) {
        (self.contact, self.at.double())
    }
}

impl<T: Drawable> Forces<T> {
    /// Forces of the thrust of a configuration with one crown moment or, where two are given, between two;
    /// the friction is unlimited if it is not. Of an arch of stones the joints between them, from the crown
    /// on; of another there are none.
    pub fn new(
        weight: SelfWeight,
        (at, joints): (&Configuration<T>, &[f64]),
        is_limited: bool,
        moments: &[T],
        marks: Vec<Mark<T>>,
    ) -> Self {
        let (first, last) = match moments {
            [first, .., last] => (first.clone(), last.clone()),
            [one] => (one.clone(), one.clone()),
            [] => (at.thrust.int(0), at.thrust.int(0)),
        };
        Self {
            thrust: at.thrust.clone(),
            moments: [first, last],
            thrust_lines: moments.iter().map(|p| thrust_line(weight, (at, joints), p)).collect(),
            friction_line: friction_line((at, joints), is_limited),
            limited_by: None,
            beyond: None,
            marks,
        }
    }

    /// The lines of the thrust.
    pub fn lines(&self) -> Lines<'_> {
        Lines { thrust: &self.thrust_lines, friction: &self.friction_line }
    }
}

/// The crown moment of a state in a mode; `None` where it leaves several.
pub fn moment_of<T: Drawable>(weight: SelfWeight, mode: Mode, at: &Configuration<T>) -> Option<T> {
    match mode {
        // The line of thrust is on the extrados of the crown.
        Mode::Rotational | Mode::SlidingRotational | Mode::Overturning => {
            Some(contact::crown_moment(at))
        }
        // It is on that of the shoulder.
        Mode::RotationalSliding | Mode::RotationalSlidingRotational | Mode::OverturningSliding => {
            Some(contact::shoulder_moment(weight, at))
        }
        Mode::Sliding => None,
    }
}

/// The joints that give way in a mode.
pub fn joints_of<T: Drawable>(mode: Mode, at: &Configuration<T>) -> Vec<Mark<T>> {
    let mechanism = mode.mechanism(at, &at.thrust.int(0));
    let joints = mechanism.joints.iter().chain(mechanism.crown_hinge());
    joints.map(|joint| Mark { contact: joint.contact, at: joint.at.rad.clone() }).collect()
}

/// The locus of the pressure points.
fn thrust_line<T: Drawable>(
    weight: SelfWeight,
    (at, joints): (&Configuration<T>, &[f64]),
    moment: &T,
) -> SketchedLine {
    let fac = Ring::new(weight, &at.thickness).centroid_factor;
    let without_thrust = at.thrust.is_zero();
    SketchedLine::new([&at.half_opening.rad, &at.thickness], joints, |joint| match without_thrust {
        true if joint.rad.is_zero() => fac.ratio(1, 2) * &fac,
        true => statics::radius_without_thrust(joint, &fac),
        false => statics::pressure_radius(joint, &at.thrust, moment, &fac),
    })
}

/// Points at the offset `(eta/2) T/(mu N)` from the centreline.
fn friction_line<T: Drawable>(
    (at, joints): (&Configuration<T>, &[f64]),
    is_limited: bool,
) -> SketchedLine {
    if !is_limited {
        return centreline(&at.half_opening.rad, &at.thickness);
    }
    SketchedLine::new([&at.half_opening.rad, &at.thickness], joints, |joint| {
        statics::friction_radius(joint, [&at.thrust, &at.friction, &at.thickness])
    })
}
