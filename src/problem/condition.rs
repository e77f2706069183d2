//! What has to be positive for a state to be admissible everywhere and the thinnest there is.
//!
//! The lemma behind it, and the multipliers, are in [`crate::arch::contact`].

use crate::arch::{Configuration, SelfWeight, contact, sliding, statics};
use crate::number::{Angle, Enclosure, Ternary};
use crate::problem::{Equation, Mode, tally};

/// What has to be positive: the admissibility of the whole half arch, and the least thickness. What is
/// zero by the equations of the mode is not listed. Without `friction` it is taken as unlimited. `at` has
/// angles in radians, lengths in `r` and the thrust in `w r`; each margin comes with what it says.
pub fn conditions<E: Enclosure>(
    weight: SelfWeight,
    mode: Mode,
    at: &Configuration<E>,
    friction: Option<&E>,
) -> Vec<(E, &'static str)> {
    use Mode::*;
    let mut all = vec![
        (statics::normal_force(&at.half_opening, &at.thrust), "compression at the shoulder"),
        (at.thickness.clone(), "a positive thickness"),
        (at.thickness.int(2) - &at.thickness, "a thickness below the physical limit"),
    ];
    let mut needs = |margin: E, question| all.push((margin, question));
    let from_crown = matches!(mode, Rotational | SlidingRotational);
    if mode != Overturning {
        needs(at.thrust.clone(), "a positive thrust");
        needs(at.thrust.int(1) - &at.thrust, "a thrust below one");
    }
    // The line of thrust.
    if from_crown || matches!(mode, RotationalSliding | RotationalSlidingRotational) {
        needs(at.rotation_joint.rad.clone(), "a rotational joint below the crown");
        needs(
            at.half_opening.rad.clone() - &at.rotation_joint.rad,
            "a rotational joint above the shoulder",
        );
    } else {
        needs(
            contact::crown_slope(weight, at),
            "the line of thrust leaves the intrados at the crown",
        );
    }
    if mode == SlidingRotational {
        let moment = contact::crown_moment(at);
        needs(
            contact::extrados_margin_at_shoulder(weight, at, &moment),
            "the line of thrust inside the extrados at the shoulder",
        );
    }
    // At [r,s] the crown's pressure point is on the intrados, so not on the extrados.
    if matches!(mode, RotationalSliding | RotationalSlidingRotational) {
        let moment = contact::shoulder_moment(weight, at);
        needs(
            contact::crown_moment(at) - moment,
            "the line of thrust inside the extrados at the crown",
        );
    }
    needs(
        contact::margin_at_physical_limit(weight, at),
        "every thicker arch stands up to the physical limit",
    );
    // Friction, at the steepest joint, which has to be a joint of the arch.
    if let Some(friction) = friction {
        let room = match from_crown {
            true => room_for_steepest(at),
            false => at.half_opening.rad.clone() - &at.sliding_joint.rad,
        };
        needs(room, "the steepest joint above the shoulder");
        if mode != SlidingRotational {
            needs(friction.clone() - shoulder_friction(at), "friction enough at the shoulder");
        }
        if from_crown {
            needs(friction.clone() - inner_friction(at), "friction enough inside");
        }
    }
    // The least thickness.
    let rates = match mode {
        Rotational => contact::rates_of_rotation(at),
        SlidingRotational => contact::rates_of_shoulder_sliding(at),
        _ => contact::rates_of_inner_sliding(at),
    };
    if mode == Rotational {
        needs(rates.shoulder.clone(), "a mechanism that opens at the shoulder");
    } else {
        needs(rates.sliding.clone(), "a mechanism that slides the right way");
    }
    if let (SlidingRotational, Some(friction)) = (mode, friction) {
        needs(
            sliding::shoulder_thrust(&at.half_opening, friction).denominator,
            "a shoulder that bounds the thrust from above",
        );
    }
    // W is linear in the thrust: it is least at an end of what friction allows.
    let (base, slope) = (contact::weight_term(&rates, at), contact::thrust_coefficient(&rates, at));
    let mut thrusts = vec![at.thrust.int(0)];
    match (slope.is_positive(), friction) {
        (Ternary::True, _) => {}
        (_, Some(friction)) => {
            let bound = sliding::shoulder_thrust(&at.half_opening, friction);
            needs(bound.denominator.clone(), "a shoulder that bounds the thrust from above");
            thrusts.push(bound.value());
        }
        (_, None) => needs(slope.clone(), "a combination that grows with the thrust"),
    }
    for thrust in thrusts {
        let term = base.clone() + slope.clone() * thrust;
        needs(term.clone(), "a positive weight of the mechanism");
        needs(contact::growth(weight, &rates, at, &term), "no admissible state in a thinner arch");
    }
    tally::conditions(all.len());
    all
}

/// The friction that the shoulder asks for at the thrust of a state.
pub fn shoulder_friction<E: Enclosure>(at: &Configuration<E>) -> E {
    tally::equation(Equation::ShoulderSliding);
    sliding::shoulder(&at.half_opening, &at.thrust).value()
}

/// What is left between the shoulder and the joint that is steepest at the thrust of a state, rad.
pub fn room_for_steepest<E: Enclosure>(at: &Configuration<E>) -> E {
    let square = at.thrust.clone() * (at.thrust.int(1) - &at.thrust);
    at.half_opening.rad.clone() - square.sqrt()
}

/// The friction that the steepest joint asks for at the thrust of a state.
pub fn inner_friction<E: Enclosure>(at: &Configuration<E>) -> E {
    tally::equation(Equation::InnerSliding);
    let square = at.thrust.clone() * (at.thrust.int(1) - &at.thrust);
    sliding::inner(&Angle::new(square.sqrt()), &at.thrust).value()
}
