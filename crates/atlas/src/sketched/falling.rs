//! An arch that does not stand, as it falls: the joints that give way, proved by what contradicts there.
//!
//! Any joints would do, if their rates are positive and the weight drives them. Of those of each mode the ones are
//! shown whose line of thrust is the furthest beyond the faces: no line is beyond by less at all of its joints, so that
//! it is next to the line that leaves the arch least. Where the arch slides at any thickness they are those of the
//! purely sliding state.

use super::range::{moments, nearest_joint};
use super::stones;
use super::{Collapse, Forces};
use crate::arch::{Configuration, Ring, Unknown, beyond, joint, sliding, statics};
use crate::certify::Undecided;
use crate::certify::state::{
    Fall, Outcome, State, sliding_configuration, state_enclosed, steepest_configuration,
};
use crate::number::{Angle, Ball, Drawable, Enclosure, ExactNumber, Field, Ternary};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Mode};
use crate::sketch::{falling, furthest_haunch};

/// Mode of the collapse of an arch that falls, the place of its joints and, of a slip, the thrust.
type Falling = (Mode, Configuration<Ball>);
/// The joints with the forces and the mechanism.
pub(super) type Fallen = (Configuration<Ball>, Forces, Collapse);

/// The joints whose line is the furthest beyond the faces, of those that are proved to give way.
fn furthest(
    arch: &Arch,
    all: impl IntoIterator<Item = Result<Falling, Undecided>>,
    (joints, is_dilatant): (&[f64], bool),
    lines: impl Fn(&Configuration<Ball>) -> Result<Vec<Ball>, Undecided>,
) -> Result<Fallen, Undecided> {
    let fallen = |found: Result<Falling, Undecided>| -> Result<Fallen, Undecided> {
        let (mode, mut at) = found?;
        let lines = if mode == Mode::Sliding { lines(&at)? } else { Vec::new() };
        let of = (joints, arch.is_limited());
        let found = falling(arch.weight(), mode, &mut at, of, (&lines, is_dilatant));
        let (forces, collapse) = found.map_err(|open| Undecided::new(open.to_string()))?;
        Ok((at, forces, collapse))
    };
    let beyond = |(_, forces, _): &Fallen| forces.beyond.as_ref().map_or(0.0, Drawable::double);
    let better =
        |one: Result<Fallen, Undecided>, other: Result<Fallen, Undecided>| match (one, other) {
            (Ok(one), Ok(other)) => Ok(if beyond(&other) > beyond(&one) { other } else { one }),
            (one, other) => one.or(other),
        };
    let found = all.into_iter().map(fallen).reduce(better);
    found.unwrap_or_else(|| Err(Undecided::new("which joints give way")))
}

/// An arch that falls at a thickness.
pub(super) fn fallen(
    arch: &Arch,
    eta: &Ball,
    bits: u32,
    is_dilatant: bool,
) -> Result<Fallen, Undecided> {
    let all = joints(arch, eta, bits)?;
    furthest(arch, all, (&[], is_dilatant), |at| lines(arch, at))
}

/// The state at its least thickness as a configuration.
pub(super) fn configuration(arch: &Arch, state: &State, bits: u32) -> Configuration<Ball> {
    [Unknown::RotationJoint, Unknown::SlidingJoint, Unknown::Thickness, Unknown::Thrust]
        .into_iter()
        .filter_map(|unknown| Some((unknown, state.value(unknown)?.clone())))
        .fold(arch.given(bits), |at, (unknown, value)| at.with(unknown, value))
}

/// Joints of each mode, of an arch that falls at a thickness.
fn joints(
    arch: &Arch,
    eta: &Ball,
    bits: u32,
) -> Result<Vec<Result<Falling, Undecided>>, Undecided> {
    let weight = arch.weight();
    let given = arch.given::<Ball>(bits).with(Unknown::Thickness, eta.clone());
    if let Outcome::Falls(Fall::Sliding) = state_enclosed(arch, bits, false)? {
        let at = sliding_configuration(arch, bits)?;
        let (friction, thickness) = (given.friction, given.thickness);
        return Ok(vec![Ok((Mode::Sliding, Configuration { friction, thickness, ..at }))]);
    }
    // Next to its least thickness doubles do not tell the joint of an arch: there it is where the line touches.
    let haunches = |at: &Configuration<Ball>, mode| -> [Result<_, Undecided>; 2] {
        [nearest_joint(weight, at), Ok(furthest_haunch(weight, mode, at))]
            .map(|joint| Ok(Configuration { rotation_joint: joint?, ..at.clone() }))
    };
    let mut all = Vec::new();
    match state_enclosed(&arch.unlimited(), bits, false)? {
        Outcome::Stands(state) if state.mode == Mode::Rotational => {
            let at = given.clone().with(Unknown::RotationJoint, state.rotation_joint);
            let joint = furthest_haunch(weight, Mode::Rotational, &at);
            let further = Configuration { rotation_joint: joint, ..given.clone() };
            all.extend([at, further].map(|at| Ok((Mode::Rotational, at))));
        }
        _ if !arch.is_limited() => all.push(Ok((Mode::Overturning, given.clone()))),
        _ => {}
    }
    if arch.is_limited() {
        let shoulder = sliding::shoulder_thrust(&given.half_opening, &given.friction);
        if shoulder.denominator.is_positive() == Ternary::True {
            let at = given.with(Unknown::Thrust, shoulder.value());
            let haunches = haunches(&at, Mode::SlidingRotational);
            all.extend(haunches.map(|at| Ok((Mode::SlidingRotational, at?))));
        }
        let at = steepest_configuration(arch, bits)?.with(Unknown::Thickness, eta.clone());
        all.extend(haunches(&at, Mode::RotationalSliding).map(|at| {
            let at = at?;
            Ok((inner_mode(&at.rotation_joint, &at.sliding_joint)?, at))
        }));
    }
    Ok(all)
}

/// The mode of a haunch and an inner joint that slides.
fn inner_mode(haunch: &Angle<Ball>, slides: &Angle<Ball>) -> Result<Mode, Undecided> {
    if haunch.rad.is_zero() {
        return Ok(Mode::OverturningSliding);
    }
    match (haunch.rad.clone() - &slides.rad).is_positive() {
        Ternary::True => Ok(Mode::RotationalSliding),
        Ternary::False => Ok(Mode::RotationalSlidingRotational),
        Ternary::Undecided => {
            Err(Undecided::new("which of the haunch and the sliding joint is above"))
        }
    }
}

/// Crown moments of the lines that are drawn of an arch that slides: the ends of those that fit, or the one between
/// where none does.
fn lines(arch: &Arch, at: &Configuration<Ball>) -> Result<Vec<Ball>, Undecided> {
    let [least, largest] = moments(arch.weight(), at)?;
    Ok(fitting(least, largest))
}

fn fitting(least: Ball, largest: Ball) -> Vec<Ball> {
    match (largest.clone() - &least).is_positive() {
        Ternary::True => vec![least, largest],
        _ => vec![(least + largest.clone()) / largest.int(2)],
    }
}

/// A thickness with which an arch that stands at none is drawn: the physical limit, or for one that slides the
/// least of 2, 1, 0.5, 0.2, ... into which a line of thrust fits.
pub(super) fn shown_thickness(arch: &Arch, fall: Fall) -> Result<ExactNumber, Undecided> {
    let exact = |digit: u32, order: i32| {
        let text = match order {
            -4..0 => format!(
                "{:.*}",
                order.unsigned_abs() as usize,
                f64::from(digit) * 10f64.powi(order)
            ),
            _ => format!("{digit}e{order}"),
        };
        text.parse::<ExactNumber>().ok()
    };
    let series = (0..40).flat_map(|k| [(2, -k), (1, -k), (5, -k - 1)]);
    let limit = ExactNumber::from(2);
    if fall == Fall::Thickness {
        return Ok(limit);
    }
    let at = sliding_configuration(arch, BITS)?;
    let fits = |eta: &ExactNumber| {
        let at = at.clone().with(Unknown::Thickness, eta.enclosure(BITS));
        lines(arch, &at).is_ok_and(|all| all.len() > 1)
    };
    let all = series.filter_map(|(digit, order)| exact(digit, order));
    Ok(all.take_while(fits).last().unwrap_or(limit))
}

/// Bits in which a thickness is chosen.
const BITS: u32 = 256;

/// An arch of stones that falls at a thickness; `slides` if it does at any. `None` where no mechanism of a mode is
/// known.
pub(super) fn fallen_stones(
    (arch, all): (&Arch, &Stones),
    eta: &Ball,
    slides: bool,
    is_dilatant: bool,
) -> Result<Fallen, Undecided> {
    let given = arch.given(stones::BITS).with(Unknown::Thickness, eta.clone());
    let between = stones::joints(all);
    let open = || Undecided::new("which joints give way");
    let lines = |at: &Configuration<Ball>| {
        let [least, largest] = stones::moments((arch, all), at).ok_or_else(open)?;
        Ok(fitting(least, largest))
    };
    if slides {
        let at = sliding_stones(all, given).ok_or_else(open);
        let falling = at.map(|at| (Mode::Sliding, at));
        return furthest(arch, [falling], (&between, is_dilatant), lines);
    }
    let ring = Ring::new(arch.weight(), eta);
    let angles: Vec<Angle<Ball>> =
        (0..all.last()).map(|index| all.angle(index, stones::BITS)).collect();
    let crown_hinge = angles[0].clone();
    let at = Configuration { crown_hinge, ..given };
    // The haunch whose line is the furthest beyond.
    let haunch = |outer: &Angle<Ball>, thrust: &dyn Fn(&Angle<Ball>) -> Ball| {
        let radius =
            |joint: &&Angle<Ball>| beyond::radius(&ring, [outer, joint], &thrust(joint)).double();
        let not_nan = |joint: &&Angle<Ball>| !radius(joint).is_nan();
        let most = angles.iter().filter(not_nan).max_by(|a, b| radius(a).total_cmp(&radius(b)));
        most.cloned().ok_or_else(open)
    };
    let with = |rotation_joint: Angle<Ball>| Configuration { rotation_joint, ..at.clone() };
    let rotating =
        haunch(&at.crown_hinge, &|joint| beyond::thrust_of_rotation(&ring, &with(joint.clone())));
    let mut found = vec![rotating.map(|joint| (Mode::Rotational, with(joint)))];
    if arch.is_limited() {
        let grip = arch.friction().grip(stones::BITS);
        let row = joint::outwards(&at.half_opening, &grip);
        if row.thrust.is_positive() == Ternary::True {
            let thrust = row.bound();
            let joint = haunch(&at.crown_hinge, &|_| thrust.clone());
            found.push(joint.map(|joint| {
                (Mode::SlidingRotational, with(joint).with(Unknown::Thrust, thrust.clone()))
            }));
        }
        found.extend(steepest(&angles, &grip).map(|(sliding_joint, thrust)| {
            let rotation_joint = haunch(&at.half_opening, &|_| thrust.clone())?;
            let mode = inner_mode(&rotation_joint, &sliding_joint)?;
            let none = Angle::zero(&thrust);
            let at = with(rotation_joint);
            Ok((mode, Configuration { sliding_joint, thrust, crown_hinge: none, ..at }))
        }));
    }
    furthest(arch, found, (&between, is_dilatant), lines)
}

/// The joint that by sliding inwards asks for the largest thrust, and this thrust.
fn steepest(angles: &[Angle<Ball>], grip: &joint::Grip<Ball>) -> Option<(Angle<Ball>, Ball)> {
    let rows = angles.iter().map(|joint| (joint, joint::inwards(joint, grip)));
    // Further down a joint that slides inwards bounds the thrust from above.
    let least = rows.filter(|(_, row)| (-row.thrust.clone()).is_positive() == Ternary::True);
    let bounds = least.map(|(joint, row)| (joint.clone(), row.bound()));
    bounds.max_by(|(_, a), (_, b)| a.double().total_cmp(&b.double()))
}

/// The joint that slides together with the shoulder, at the thrust at which both ask for the same friction: the one
/// that asks for the most.
fn sliding_stones(all: &Stones, at: Configuration<Ball>) -> Option<Configuration<Ball>> {
    let asked = |index: u64| {
        let joint = all.angle(index, stones::BITS);
        let thrust = joint::even_thrust(&joint, &at.half_opening);
        let friction =
            statics::shear_force(&joint, &thrust) / statics::normal_force(&joint, &thrust);
        (joint, thrust, friction)
    };
    let inner = (0..all.last()).filter(|index| *index > 0 || !all.has_joint_at_crown());
    let most = inner.map(asked).reduce(|a, b| if b.2.double() > a.2.double() { b } else { a });
    let (sliding_joint, thrust, _) = most?;
    Some(Configuration { sliding_joint, thrust, ..at })
}
