//! States that are proved many at a time, in digits: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. The digits are the same either way.

use super::digits::{Answer, Digits};
use super::enough::Enough;
use super::state::{Fall, Frictions};
use crate::arch::SelfWeight;
use crate::lanes::{FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneState, Lanes};
use crate::number::{DoubleDoubleBall, Enclosure};
use crate::prover::figure::{Figure, Figured, optional};

/// Frictions that are asked for with the states of arches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithFrictions {
    /// No friction.
    None,
    /// Frictions at which the mode changes; of an arch that falls the one below which nothing stands.
    OfModes,
    /// Frictions at which the mode changes, and what would be enough for an arch that falls, which lanes do not
    /// know.
    AndRemedies,
}

/// The answers to arches of a weight, in their order, to `digits` digits, at most 17; `None` where lanes leave anything
/// open.
pub fn states_in_lanes(
    (weight, arches): (SelfWeight, &[LaneArch]),
    digits: usize,
    with: WithFrictions,
) -> Vec<Option<Answer>> {
    let lanes = Lanes::of(weight);
    let answers = lanes.states(arches);
    let needs = |answer: &Option<LaneAnswer>| match answer {
        Some(LaneAnswer::Stands(_)) => with != WithFrictions::None,
        Some(LaneAnswer::Falls) => with != WithFrictions::AndRemedies,
        None => false,
    };
    let asking = answers.iter().zip(arches).filter(|(answer, _)| needs(answer));
    let half_openings: Vec<_> = asking.map(|(_, (half_opening, _))| *half_opening).collect();
    let mut frictions = lanes.frictions(&half_openings).into_iter();
    let answer = |(answer, (_, friction)): (&Option<LaneAnswer>, &LaneArch)| {
        let frictions = if needs(answer) { frictions.next() } else { None };
        match answer.as_ref()? {
            LaneAnswer::Stands(state) => stands(state, frictions.as_ref(), digits),
            LaneAnswer::Falls => falls(friction.as_ref(), &frictions?, (digits, with)),
        }
    };
    answers.iter().zip(arches).map(answer).collect()
}

/// A state in digits, with the frictions at which its mode changes if they are given, if all of it is decided.
fn stands(state: &LaneState, frictions: Option<&LaneFrictions>, digits: usize) -> Option<Answer> {
    let rounded = |x: &DoubleDoubleBall| x.figure(digits);
    let frictions = optional(frictions, |both| {
        let rotational = match both.rotational.as_ref()? {
            FromFriction::From(friction) => Some(rounded(friction)?),
            FromFriction::Never => None,
        };
        Some(Frictions { sliding: rounded(both.sliding.as_ref()?)?, rotational })
    })?;
    Some(Answer::Stands(Box::new(Digits {
        mode: state.mode,
        thickness: rounded(&state.thickness)?,
        thrust: rounded(&state.thrust)?,
        intrinsic_thrust: rounded(&state.intrinsic_thrust)?,
        rotation_joint: rounded(&state.rotation_joint)?,
        sliding_joint: optional(state.sliding_joint.as_ref(), rounded)?,
        frictions,
    })))
}

/// An arch that falls, and why: too little friction comes before any other reason.
fn falls(
    friction: Option<&DoubleDoubleBall>,
    of_opening: &LaneFrictions,
    (digits, with): (usize, WithFrictions),
) -> Option<Answer> {
    let sliding = of_opening.sliding.as_ref();
    let fall = match friction {
        None => Fall::Thickness,
        Some(mu) if mu.is_less_than(sliding?).is_proved() => Fall::Sliding,
        Some(mu) if sliding?.is_less_than(mu).is_proved() => Fall::Thickness,
        Some(_) => return None,
    };
    let enough = |sliding: Figure| Enough {
        sliding_friction: Some(sliding),
        friction: None,
        half_opening: None,
    };
    let enough = match with {
        WithFrictions::None => None,
        _ => Some(Box::new(enough(sliding?.figure(digits)?))),
    };
    Some(Answer::Falls { fall, enough })
}
