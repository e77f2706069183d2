//! A line of thrust well inside an arch, found in doubles: a candidate, as that of `couplet certify arch` for its own.

use couplet_check::arch::{Configuration, Ring, SelfWeight, Unknown, contact};
use couplet_check::problem::{Nearest, inward_friction, room_for_steepest, shoulder_friction};
use couplet_number::number::Angle;

/// A thrust and a crown moment that seem to be admissible.
pub(crate) struct Line {
    /// `h`.
    pub(crate) thrust: f64,
    /// `p`.
    pub(crate) moment: f64,
    /// Where the line comes nearest to the intrados.
    pub(crate) nearest: Nearest,
    /// The joint there, rad.
    pub(crate) joint: f64,
}

/// Halvings of a step, and of a joint.
const STEPS: i32 = 40;
const HALVINGS: u32 = 60;

/// A line for an arch with its thickness, next to the thrust of its least thickness: half of the largest step, of those
/// that are powers of two, that stays admissible.
pub(crate) fn line(
    weight: SelfWeight,
    given: &Configuration<f64>,
    is_limited: bool,
    thrust: f64,
) -> Option<Line> {
    let fit = |thrust: f64| fit(weight, given, is_limited, thrust);
    let room = thrust.min(1.0 - thrust);
    // At unlimited friction a state may have no thrust.
    let room = if room > 0.0 { room } else { 1.0 };
    let steps = (1..STEPS).flat_map(|k| [1.0, -1.0].map(|sign| sign * room * f64::from(-k).exp2()));
    steps.into_iter().find_map(|step| fit(thrust + step).and_then(|_| fit(thrust + step / 2.0)))
}

/// The line in the middle of those that fit a thrust; `None` if none does, or if a joint slides.
fn fit(
    weight: SelfWeight,
    given: &Configuration<f64>,
    is_limited: bool,
    thrust: f64,
) -> Option<Line> {
    let at = given.clone().with(Unknown::Thrust, thrust);
    // Where the steepest joint would lie beyond the shoulder, that slides inwards first.
    let slides = || {
        let inwards = inward_friction(&at, room_for_steepest(&at) > 0.0);
        at.friction <= shoulder_friction(&at) || at.friction <= inwards
    };
    if !(thrust > 0.0 && thrust < 1.0) || (is_limited && slides()) {
        return None;
    }
    let slope = contact::crown_slope(weight, &at);
    let (nearest, joint) = if slope > 0.0 {
        (Nearest::Crown, Angle::zero(&thrust))
    } else {
        let touching = touching(-slope / (Ring::new(weight, &at.thickness).intrados() / 2.0));
        match touching < at.half_opening.rad {
            true => (Nearest::Haunch, Angle::new(touching)),
            false => (Nearest::Shoulder, at.half_opening.clone()),
        }
    };
    let least = -contact::intrados_margin(weight, &joint, &at, &0.0);
    let most = contact::crown_moment(&at).min(contact::shoulder_moment(weight, &at));
    let moment = (least + most) / 2.0;
    (least < most).then_some(Line { thrust, moment, nearest, joint: joint.rad })
}

/// The joint where `beta cot(beta) = 1 - fall`: it falls from one.
fn touching(fall: f64) -> f64 {
    let (mut low, mut high) = (0.0, std::f64::consts::PI);
    for _ in 0..HALVINGS {
        let middle: f64 = (low + high) / 2.0;
        let (sin, cos) = middle.sin_cos();
        if middle * cos > (1.0 - fall) * sin { low = middle } else { high = middle }
    }
    (low + high) / 2.0
}
