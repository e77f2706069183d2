//! The forces of a state, and of an end of a range of thrusts.

use super::range::moments;
use super::{Forces, Mark};
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, SelfWeight, contact};
use crate::certify::Undecided;
use crate::certify::state::{Limit, Touch};
use crate::number::{Ball, Field};
use crate::problem::Mode;
use crate::sketch::{joints_of, moment_of};

/// Forces of a state in a mode; the friction is unlimited if it is not.
pub(super) fn forces_of_mode(
    weight: SelfWeight,
    mode: Mode,
    at: &Configuration<Ball>,
    is_limited: bool,
) -> Result<Forces, Undecided> {
    let moments = match moment_of(weight, mode, at) {
        Some(moment) => vec![moment],
        None => moments(weight, at)?.to_vec(),
    };
    Ok(Forces::new(weight, (at, &[]), is_limited, &moments, joints_of(mode, at)))
}

/// Forces of an end of a range of thrusts, at least or at most so much; `None` where there is no bound.
pub(super) fn forces_of_limit(
    weight: SelfWeight,
    given: &Configuration<Ball>,
    is_limited: bool,
    limit: &Limit,
    is_least: bool,
) -> Result<Option<Forces>, Undecided> {
    let Some(thrust) = &limit.thrust else { return Ok(None) };
    let at = Configuration { thrust: thrust.clone(), ..given.clone() };
    let (zero, alpha) = (thrust.int(0), &at.half_opening.rad);
    let mark = |contact, at: &Ball| Mark { contact, at: at.clone() };
    let on_extrados = match is_least {
        true => mark(Contact::Extrados, &zero),
        false => mark(Contact::Extrados, alpha),
    };
    // On the extrados of the crown, or of the shoulder.
    let end = || match is_least {
        true => contact::crown_moment(&at),
        false => contact::shoulder_moment(weight, &at),
    };
    // Of several moments, the one whose line is the steepest or the flattest.
    let one = || -> Result<Ball, Undecided> {
        let [least, largest] = moments(weight, &at)?;
        Ok(if is_least { largest } else { least })
    };
    let (moment, marks) = match &limit.touch {
        Touch::Haunch(joint) => (end(), vec![on_extrados, mark(Contact::Intrados, joint)]),
        Touch::Crown => (end(), vec![on_extrados, mark(Contact::Intrados, &zero)]),
        Touch::Shoulder | Touch::AtShoulder => {
            (end(), vec![on_extrados, mark(Contact::Intrados, alpha)])
        }
        Touch::InnerSliding(joint) => (one()?, vec![mark(Contact::Inwards, joint)]),
        Touch::ShoulderSliding => (one()?, vec![mark(Contact::Outwards, alpha)]),
        Touch::ShoulderSlidingInwards => (one()?, vec![mark(Contact::Inwards, alpha)]),
        // Without thrust the crown moment is zero.
        Touch::Nothing => (contact::crown_moment(&at), Vec::new()),
    };
    let forces = Forces::new(weight, (&at, &[]), is_limited, &[moment], marks);
    Ok(Some(Forces { limited_by: Some(limit.touch.name().to_owned()), ..forces }))
}
