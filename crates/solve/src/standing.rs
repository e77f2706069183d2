//! A candidate for a line of thrust well inside an arch.

use super::settle;
use super::start::{Start, tangent_joint};
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact};
use crate::number::{Angle, Dual, ExactNumber};
use crate::problem::{Nearest, Standing, inward_friction, room_for_steepest, shoulder_friction};

/// A thrust and a crown moment that seem to be admissible.
#[derive(Clone, Debug)]
pub struct StandingCandidate<T> {
    /// `h`.
    pub thrust: T,
    /// `p`.
    pub crown_moment: T,
    /// Place where the moment about the intrados is least.
    pub nearest: Nearest,
    /// The joint there, rad; zero at the crown.
    pub joint: T,
}

impl<T: Start> StandingCandidate<T> {
    /// The state as the certificate of an arch of this thickness has it, and candidates for the unknowns there.
    pub fn stated(self, thickness: &ExactNumber) -> (Standing, Vec<T>) {
        let Self { thrust, crown_moment, nearest, joint } = self;
        let (thrust, crown_moment) = (thrust.exact(), crown_moment.exact());
        let unknowns = if nearest == Nearest::Haunch { vec![joint] } else { Vec::new() };
        (Standing { thickness: thickness.clone(), thrust, crown_moment, nearest }, unknowns)
    }
}

/// A candidate for an arch that stands: `given` has its half opening, friction and thickness, and a `thrust` next to
/// which an admissible one is, as that of its least thickness.
///
/// The largest step from that thrust is taken, of those that are powers of two, that stays admissible, and half of it
/// is gone. `None` if no step does.
pub fn standing<T: Start>(
    weight: SelfWeight,
    given: &Configuration<T>,
    is_limited: bool,
    thrust: &T,
) -> Option<StandingCandidate<T>> {
    let bits = thrust.bits();
    let fit = |thrust: &T| Fit::of(weight, given.clone(), is_limited, thrust);
    let room = smaller(thrust.clone(), thrust.int(1) - thrust);
    // At unlimited friction a state may have no thrust.
    let room = if room > 0.0 { room } else { thrust.int(1) };
    for k in 1..bits.saturating_sub(T::KEPT) {
        let step = room.clone().shifted(-i64::from(k));
        for step in [step.clone(), -step] {
            if fit(&(thrust.clone() + &step)).is_some() {
                let middle = thrust.clone() + step.shifted(-1);
                let lost = room.exponent_of_size().unwrap_or(0).min(0).unsigned_abs() as u32;
                let middle = middle.cut((k + T::KEPT + lost).min(bits));
                let exact = thrust.int(0) + &middle;
                return fit(&exact)?.candidate(middle);
            }
        }
    }
    None
}

fn smaller<T: Start>(x: T, y: T) -> T {
    if y < x { y } else { x }
}

/// The crown moments between which the line of thrust fits at a thrust.
struct Fit<T> {
    least: T,
    most: T,
    nearest: Nearest,
    joint: T,
}

impl<T: Start> Fit<T> {
    /// `None` if none fits, or if a joint slides.
    fn of(
        weight: SelfWeight,
        given: Configuration<T>,
        is_limited: bool,
        thrust: &T,
    ) -> Option<Self> {
        let at = given.with(Unknown::Thrust, thrust.clone());
        let h = &at.thrust;
        let is_possible = *h > 0.0 && *h < 1.0;
        let slides = || {
            // Where the steepest joint would lie beyond the shoulder, that slides inwards first.
            let inwards = inward_friction(&at, room_for_steepest(&at) > 0.0);
            at.friction <= shoulder_friction(&at) || at.friction <= inwards
        };
        if !is_possible || (is_limited && slides()) {
            return None;
        }
        let slope = contact::crown_slope(weight, &at);
        let (nearest, joint) = if slope > 0.0 {
            (Nearest::Crown, Angle::zero(h))
        } else {
            let intrados = Ring::new(weight, &at.thickness).intrados() / h.int(2);
            let joint = touching(&(-slope / intrados))?;
            match joint < at.half_opening.rad {
                true => (Nearest::Haunch, Angle::new(joint)),
                false => (Nearest::Shoulder, at.half_opening.clone()),
            }
        };
        let least = -contact::intrados_margin(weight, &joint, &at, &h.int(0));
        let most = smaller(contact::crown_moment(&at), contact::shoulder_moment(weight, &at));
        (least < most).then(|| Self { least, most, nearest, joint: joint.rad })
    }

    fn candidate(self, thrust: T) -> Option<StandingCandidate<T>> {
        let Self { least, most, nearest, joint } = self;
        let (size, room) = (most.exponent_of_size()?, most - &least);
        let left = room.exponent_of_size()?;
        let kept = (size.max(left) - left) as u32;
        let crown_moment = (least + room.shifted(-1)).cut(kept + T::KEPT);
        Some(StandingCandidate { thrust, crown_moment, nearest, joint })
    }
}

/// The joint where `beta cot(beta) = 1 - fall`.
fn touching<T: Start>(fall: &T) -> Option<T> {
    let start = tangent_joint(&(fall.int(1) - fall));
    let constant = Dual::constant(fall.clone() - fall.int(1));
    let residual = |x: &[T]| {
        let joint = Angle::new(x[0].clone()).variable(0);
        // Times the sine, which does not vanish.
        vec![joint.rad.clone() * &joint.cos + constant.clone() * &joint.sin]
    };
    settle(vec![start], residual)?.pop()
}
