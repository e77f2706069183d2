//! An arch that does not stand: a line of thrust that leaves it, and the mechanism that its weight drives.

use super::collapse::{Collapse, NoCollapse};
use super::forces::{Forces, joints_of};
use crate::arch::{Configuration, Ring, SelfWeight, beyond, statics};
use crate::number::{Angle, Drawable};
use crate::problem::Mode;

/// Distance beyond the faces up to which lines are drawn, in units of `r`: where a joint is under tension they are
/// anywhere.
const FAR: f64 = 0.8;

/// Forces and mechanism of an arch that falls in a mode, with the joints of a configuration and the thrust at which
/// one of them slides. The mechanism proves that it falls. The line of thrust is one of many: it is as far beyond the
/// faces at every hinge. Where it slides alone, `moments` are those of the lines that are drawn. Of an arch of stones
/// `joints` are those between them, from the crown on.
pub fn falling<T: Drawable>(
    weight: SelfWeight,
    mode: Mode,
    at: &mut Configuration<T>,
    (joints, is_limited): (&[f64], bool),
    (moments, is_dilatant): (&[T], bool),
) -> Result<(Forces<T>, Collapse<T>), NoCollapse> {
    let ring = Ring::new(weight, &at.thickness);
    if mode == Mode::Rotational {
        at.thrust = beyond::thrust_of_rotation(&ring, at);
    }
    let outer = match mode {
        Mode::Rotational | Mode::SlidingRotational => &at.crown_hinge,
        _ => &at.half_opening,
    };
    let (pair, face) = ([outer, &at.rotation_joint], ring.extrados() / at.thrust.int(2));
    let (one, away) = match mode {
        Mode::Sliding => (None, None),
        // Without thrust the crown bears nothing.
        Mode::Overturning => {
            let radius = statics::radius_without_thrust(outer, &ring.centroid_factor);
            (Some(at.thrust.int(0)), Some(radius))
        }
        _ => {
            let moment = beyond::crown_moment(&ring, pair, &at.thrust);
            (Some(moment), Some(beyond::radius(&ring, pair, &at.thrust)))
        }
    };
    let collapse = Collapse::driven(weight, mode, at, is_dilatant)?;
    let marks = joints_of(mode, at);
    let moments = one.as_ref().map_or(moments, std::slice::from_ref);
    let forces = Forces::new(weight, (at, joints), is_limited, moments, marks);
    let lines = forces.thrust_lines.into_iter().map(|line| line.within(FAR));
    let (thrust_lines, friction_line) = (lines.collect(), forces.friction_line.within(FAR));
    let beyond = away.map(|radius| radius - face);
    Ok((Forces { beyond, thrust_lines, friction_line, ..forces }, collapse))
}

/// Joints that are looked at for the furthest, and halvings of the way between two of them.
const JOINTS: u32 = 200;
const HALVINGS: u32 = 40;

/// The haunch of a mode whose line of thrust is the furthest beyond the faces, as far as doubles tell. That the weight
/// drives the arch is proved of any.
pub fn furthest_haunch<T: Drawable>(
    weight: SelfWeight,
    mode: Mode,
    at: &Configuration<T>,
) -> Angle<T> {
    let ring = Ring::new(weight, &at.thickness).map(T::double);
    let place = at.map_ref(T::double);
    let alpha = place.half_opening.rad;
    let radius = |joint: f64| {
        let at = Configuration { rotation_joint: Angle::new(joint), ..place.clone() };
        let thrust = match mode {
            Mode::Rotational => beyond::thrust_of_rotation(&ring, &at),
            _ => at.thrust,
        };
        let outer = match mode {
            Mode::SlidingRotational => &at.crown_hinge,
            _ => &at.half_opening,
        };
        let radius = beyond::radius(&ring, [outer, &at.rotation_joint], &thrust);
        if radius.is_finite() { radius } else { f64::MIN }
    };
    let step = alpha / f64::from(JOINTS);
    let joints = (0..JOINTS).map(|k| f64::from(k) * step);
    let best = joints.max_by(|a, b| radius(*a).total_cmp(&radius(*b))).unwrap_or(0.0);
    let (mut low, mut high) = ((best - step).max(0.0), (best + step).min(alpha));
    for _ in 0..HALVINGS {
        let [a, b] = [1.0, 2.0].map(|third| low + third * (high - low) / 3.0);
        if radius(a) < radius(b) { low = a } else { high = b }
    }
    match low == 0.0 {
        true => Angle::zero(&at.thickness),
        false => Angle::new(at.thickness.of_double((low + high) / 2.0)),
    }
}
