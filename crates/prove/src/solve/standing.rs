//! A candidate for a line of thrust well inside an arch.

use super::{settle, start};
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact};
use crate::number::{Angle, Dual, Field};
use crate::problem::{Nearest, inward_friction, room_for_steepest, shoulder_friction};
use rug::Float;

/// A thrust and a crown moment that seem to be admissible.
#[derive(Clone, Debug)]
pub struct StandingCandidate {
    /// `h`.
    pub thrust: Float,
    /// `p`.
    pub crown_moment: Float,
    /// Place where the line of thrust comes nearest to the intrados.
    pub nearest: Nearest,
    /// The joint there, rad; zero at the crown.
    pub joint: Float,
}

/// Bits of a step, and of what is left for the crown moment, that are kept.
const KEPT: u32 = 32;

/// A candidate for an arch that stands: `given` has its half opening, friction and thickness, and a `thrust` next to
/// which an admissible one is, as that of its least thickness.
///
/// The largest step from that thrust is taken, of those that are powers of two, that stays admissible, and half of it
/// is gone. `None` if no step does.
pub fn standing(
    weight: SelfWeight,
    given: &Configuration<Float>,
    is_limited: bool,
    thrust: &Float,
) -> Option<StandingCandidate> {
    let bits = thrust.prec();
    let fit = |thrust: &Float| Fit::of(weight, given.clone(), is_limited, thrust);
    let rest = Float::with_val(bits, 1 - thrust);
    let room = Float::with_val(bits, thrust.min_ref(&rest));
    // At unlimited friction a state may have no thrust.
    let room = if room > 0 { room } else { Float::with_val(bits, 1) };
    for k in 1..bits.saturating_sub(KEPT) {
        let step = room.clone() >> k;
        for step in [step.clone(), -step] {
            if fit(&Float::with_val(bits, thrust + &step)).is_some() {
                let middle = Float::with_val(bits, thrust + step / 2u32);
                let lost = room.get_exp().unwrap_or(0).min(0).unsigned_abs();
                let middle = Float::with_val((k + KEPT + lost).min(bits), middle);
                let exact = Float::with_val(bits, &middle);
                return fit(&exact)?.candidate(middle);
            }
        }
    }
    None
}

/// The crown moments between which the line of thrust fits at a thrust.
struct Fit {
    least: Float,
    most: Float,
    nearest: Nearest,
    joint: Float,
}

impl Fit {
    /// `None` if none fits, or if a joint slides.
    fn of(
        weight: SelfWeight,
        given: Configuration<Float>,
        is_limited: bool,
        thrust: &Float,
    ) -> Option<Self> {
        let at = given.with(Unknown::Thrust, thrust.clone());
        let (h, bits) = (&at.thrust, thrust.prec());
        let is_possible = *h > 0 && *h < 1;
        let slides = || {
            // Where the steepest joint would lie beyond the shoulder, that slides inwards first.
            let inwards = inward_friction(&at, room_for_steepest(&at) > 0);
            at.friction <= shoulder_friction(&at) || at.friction <= inwards
        };
        if !is_possible || (is_limited && slides()) {
            return None;
        }
        let slope = contact::crown_slope(weight, &at);
        let (nearest, joint) = if slope > 0 {
            (Nearest::Crown, Angle::zero(h))
        } else {
            let intrados = Ring::new(weight, &at.thickness).intrados() / h.int(2);
            let joint = touching(&(-slope / intrados))?;
            match joint < at.half_opening.rad {
                true => (Nearest::Haunch, Angle::new(joint)),
                false => (Nearest::Shoulder, at.half_opening.clone()),
            }
        };
        let least = -contact::intrados_margin(weight, &joint, &at, &Float::new(bits));
        let extrados = [contact::crown_moment(&at), contact::shoulder_moment(weight, &at)];
        let [crown, shoulder] = extrados;
        let most = crown.min(&shoulder);
        (least < most).then(|| Self { least, most, nearest, joint: joint.rad })
    }

    fn candidate(self, thrust: Float) -> Option<StandingCandidate> {
        let Self { least, most, nearest, joint } = self;
        let room = Float::with_val(least.prec(), &most - &least);
        let kept = most.get_exp()?.max(room.get_exp()?) - room.get_exp()?;
        let middle = least + room / 2u32;
        let crown_moment = Float::with_val(kept.unsigned_abs() + KEPT, middle);
        Some(StandingCandidate { thrust, crown_moment, nearest, joint })
    }
}

/// The joint where `beta cot(beta) = 1 - fall`.
fn touching(fall: &Float) -> Option<Float> {
    let bits = fall.prec();
    let start = start::tangent_joint(&Float::with_val(bits, 1 - fall));
    let constant = Dual::constant(Float::with_val(bits, fall - 1u32));
    let residual = |x: &[Float]| {
        let joint = Angle::new(x[0].clone()).variable(0);
        // Times the sine, which does not vanish.
        vec![joint.rad.clone() * &joint.cos + constant.clone() * &joint.sin]
    };
    settle(vec![start], residual)?.pop()
}
