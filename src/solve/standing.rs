//! A candidate for a line of thrust well inside an arch.

use super::settle;
use super::zero::zero;
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact, thrust};
use crate::number::{Angle, Dual, Field};
use crate::problem::{Nearest, inner_friction, room_for_steepest, shoulder_friction};
use rug::Float;
use std::f64::consts::PI;

/// A thrust and a crown moment that seem to be admissible.
#[derive(Clone, Debug)]
pub struct StandingCandidate {
    /// `h`.
    pub thrust: Float,
    /// `p`.
    pub crown_moment: Float,
    /// Where the line of thrust comes nearest to the intrados.
    pub nearest: Nearest,
    /// The joint there, rad; zero at the crown.
    pub joint: Float,
}

/// Bits of a step, and of what is left for the crown moment, that are kept.
const KEPT: u32 = 32;
/// A joint where `1 - beta cot(beta)` is below this starts from the leading term.
const SMALL: f64 = 1e-3;

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
            let shoulder = shoulder_friction(&at);
            // Where the steepest joint would lie beyond the shoulder, that slides inwards first.
            let inwards = match room_for_steepest(&at) > 0 {
                true => inner_friction(&at),
                false => -shoulder.clone(),
            };
            at.friction <= shoulder || at.friction <= inwards
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
    let start = match fall.to_f64() {
        small if small < SMALL => Float::with_val(bits, fall * 3u32).sqrt(),
        fall => {
            let excess = |beta: f64| 1.0 - fall - beta / beta.tan();
            Float::with_val(bits, zero(SMALL, PI * (1.0 - 1e-15), excess))
        }
    };
    let constant = Dual::constant(Float::with_val(bits, fall - 1u32));
    let residual = |x: &[Float]| {
        let joint = Angle::new(x[0].clone()).variable(0);
        // Times the sine, which does not vanish.
        vec![joint.rad.clone() * &joint.cos + constant.clone() * &joint.sin]
    };
    settle(vec![start], residual)?.pop()
}

/// The widest half opening at which the physical limit of the thickness is enough at a thrust, rad.
pub fn widest(weight: SelfWeight, h: f64) -> f64 {
    let margin = |alpha: f64| {
        let at = Angle::new(alpha);
        let opening = thrust::opening_variable(&at).value();
        2.0 * (h * at.cos / at.versine() + opening) - 1.0 - f64::from(weight.flag()) / 3.0
    };
    zero(PI / 2.0, PI, margin)
}
