//! The crown moments that fit a given thrust: from the one whose line of thrust touches the intrados to the one
//! that reaches the extrados.
//!
//! At a given thrust the line of thrust is fixed by the crown moment `p`, and lies higher for a larger one. It
//! touches the intrados where `L` is least: at the crown, at the shoulder, or where `L' = 0`, and there is one such
//! joint, since `beta cot(beta)` falls (see [`contact`]).

use crate::arch::{Configuration, SelfWeight, contact};
use crate::certify::Undecided;
use crate::number::{Angle, Ball, Enclosure, Field, Magnitude, Ternary};
use crate::prover::arithmetic::lesser;
use rug::Float;

/// The least and the largest crown moment.
pub(super) fn moments(
    weight: SelfWeight,
    at: &Configuration<Ball>,
) -> Result<[Ball; 2], Undecided> {
    let zero = at.thrust.int(0);
    let touch = nearest_joint(weight, at)?;
    // L with the moment left out.
    let lowest = -contact::intrados_margin(weight, &touch, at, &zero);
    let [crown, shoulder] = [contact::crown_moment(at), contact::shoulder_moment(weight, at)];
    Ok([lowest, lesser(crown, shoulder)])
}

/// The joint at which the moment about the intrados is least, whatever the crown moment.
pub(super) fn nearest_joint(
    weight: SelfWeight,
    at: &Configuration<Ball>,
) -> Result<Angle<Ball>, Undecided> {
    let crown = Angle::zero(&at.thrust);
    let sign = |slope: Ball| slope.is_positive();
    let open = || Undecided::new("where the moment about the intrados is least");
    match sign(contact::crown_slope(weight, at)) {
        Ternary::True => return Ok(crown),
        Ternary::Undecided => return Err(open()),
        Ternary::False => {}
    }
    let approach = |joint: &Angle<Ball>| contact::approach(weight, joint, at);
    match sign(approach(&at.half_opening)) {
        Ternary::False => return Ok(at.half_opening.clone()),
        Ternary::Undecided => return Err(open()),
        Ternary::True => {}
    }
    // Halved as long as the signs are certain.
    let prec = at.thrust.prec();
    let [mut low, mut high] = [Float::with_val(prec, 0), at.half_opening.rad.lower()];
    let half_of = |low: &Float, high: &Float| Float::with_val(prec, low + high) / 2u32;
    for _ in 0..prec {
        let middle: Float = half_of(&low, &high);
        match sign(approach(&Angle::new(Ball::exact(middle.clone(), prec)))) {
            Ternary::True => high = middle,
            Ternary::False => low = middle,
            Ternary::Undecided => break,
        }
    }
    let width = Float::with_val(prec, &high - &low);
    let ball = Ball::exact(half_of(&low, &high), prec).widened(Magnitude::upper(&width));
    Ok(Angle::new(ball))
}
