//! Admissible at every joint of the whole arch: no margin of [`whole`](crate::arch::whole) is negative on
//! `[-alpha, alpha]`.
//!
//! The stretch from -4 to 4, which holds every arch, is cut into pieces, and these are halved until on each of them
//!
//! - the margin is positive, by Taylor's theorem: its value and slope in the middle, its curvature on all of the
//!   piece; or
//! - the piece lies next to a joint that is at its limit. Inside the arch the margin and its slope are zero there,
//!   and its curvature is positive around it; at the right springing the margin is zero, and falls towards it; or
//! - the piece is beyond the springings.
//!
//! What is zero at a joint is so by the equations of the claim: that is not looked at here.

use crate::arch::asymmetric::{Asymmetric, AsymmetricMode, Place};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Forces, margin_along};
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Dyadic, Engine, Jet};

/// The state of a whole arch, in numbers of few bits.
pub(crate) struct Whole<E> {
    half_opening: E,
    ring: Ring<E>,
    grip: Grip<E>,
    forces: Forces<E>,
}

/// A joint at its limit, by the sign of its condition.
struct Touching<E> {
    contact: Contact,
    /// Part where the curvature of the margin is positive, or at the right springing its slope negative.
    near: E,
}

/// Bits in which a piece is looked at.
const BITS: usize = 96;
/// The first pieces have this radius, `2^-3`.
const FIRST: u32 = 3;
/// The last ones.
const LAST: u32 = 30;
/// The neighbourhood of a joint at its limit has a radius from `2^-2` down.
const NEIGHBOURHOODS: std::ops::Range<u32> = 2..24;
/// More pieces are not looked at: known arches take about a hundred.
const PIECES: usize = 10_000;

/// `m 2^-k`.
fn binary(m: i64, k: u32) -> Dyadic {
    Dyadic::new(m < 0, vec![m.unsigned_abs()], -(k as i32))
}

/// First margin of an asymmetric solution that is not shown not to be negative.
pub fn first_failure<E: Engine>(
    mode: AsymmetricMode,
    weight: SelfWeight,
    at: &Asymmetric<E>,
) -> Option<Contact> {
    let joints: Vec<(Contact, Option<E>)> = mode
        .contacts()
        .iter()
        .map(|&(contact, side, place)| {
            let joint = match place {
                Place::Shoulder => None,
                inside => Some(side.joint(at.angle(inside)).rad),
            };
            (side.contact(contact), joint)
        })
        .collect();
    Whole::new(weight, at).first_failure(&joints)
}

/// Condition on a margin, in words.
pub fn label(contact: Contact) -> &'static str {
    match contact {
        Contact::Extrados => "the line of thrust inside the extrados on the whole arch",
        Contact::Intrados => "the line of thrust inside the intrados on the whole arch",
        Contact::Inwards => "mu N - T not negative on the whole arch",
        Contact::Outwards => "mu N + T not negative on the whole arch",
    }
}

impl<E: Engine> Whole<E> {
    pub(crate) fn new(weight: SelfWeight, at: &Asymmetric<E>) -> Self {
        let few = |x: &E| x.with_bits(BITS);
        let Forces { thrust, moment, vertical } = &at.forces;
        Self {
            half_opening: few(&at.half_opening.rad),
            ring: Ring::new(weight, &few(&at.thickness)),
            grip: Grip { shear: few(&at.grip.shear), normal: few(&at.grip.normal) },
            forces: Forces { thrust: few(thrust), moment: few(moment), vertical: few(vertical) },
        }
    }

    /// The first margin that is not shown to be nowhere negative. Where one is zero is given: inside the arch,
    /// where its slope is zero too, or, without a joint, at the right springing.
    pub(crate) fn first_failure(&self, joints: &[(Contact, Option<E>)]) -> Option<Contact> {
        let mut touching = Vec::new();
        for (contact, joint) in joints {
            let Some(near) = self.neighbourhood(*contact, joint.as_ref()) else {
                return Some(*contact);
            };
            touching.push(Touching { contact: *contact, near });
        }
        let mut pieces = 0;
        let most = 4 << FIRST;
        // The middles of intervals of twice the radius.
        let first = (0..most).map(|i| 2 * i + 1 - most);
        let mut open: Vec<(i64, u32, Vec<Contact>)> =
            first.map(|m| (m, FIRST, Contact::ALL.to_vec())).collect();
        while let Some((m, k, mut contacts)) = open.pop() {
            pieces += 1;
            self.settle(&binary(m, k), &binary(1, k), &touching, &mut contacts);
            let Some(first) = contacts.first() else { continue };
            if k == LAST || pieces == PIECES {
                return Some(*first);
            }
            open.extend([2 * m - 1, 2 * m + 1].map(|m| (m, k + 1, contacts.clone())));
        }
        None
    }

    /// The largest set around a joint at its limit on which the margin is shown not to be negative inside the arch.
    fn neighbourhood(&self, contact: Contact, joint: Option<&E>) -> Option<E> {
        NEIGHBOURHOODS.into_iter().find_map(|k| {
            let near = joint.unwrap_or(&self.half_opening).with_bits(BITS);
            let near = near.widened_by(&binary(1, k));
            let along = self.series(contact, &Angle::new(near.clone()));
            let bends_away = match joint {
                Some(_) => along.coefficient(2),
                None => -along.coefficient(1),
            };
            bends_away.is_positive().is_proved().then_some(near)
        })
    }

    /// Leaves of some contacts those whose margin may be negative on a piece.
    fn settle(
        &self,
        centre: &Dyadic,
        radius: &Dyadic,
        touching: &[Touching<E>],
        contacts: &mut Vec<Contact>,
    ) {
        let middle = E::exact(centre, BITS);
        let piece = middle.widened_by(radius);
        let beyond = |end: E| (end - &self.half_opening).is_positive().is_proved();
        if beyond(piece.clone()) || beyond(-piece.clone()) {
            return contacts.clear();
        }
        contacts.retain(|contact| {
            let own = touching.iter().filter(|touching| touching.contact == *contact);
            !own.into_iter().any(|touching| piece.lies_inside(&touching.near))
        });
        if contacts.is_empty() {
            return;
        }
        let middle = Angle::new(middle);
        // Sine and cosine are on the piece within its radius of those in the middle.
        let Angle { sin, cos, .. } = &middle;
        let on_piece =
            Angle { rad: piece, sin: sin.widened_by(radius), cos: cos.widened_by(radius) };
        let offset = E::zero(BITS).widened_by(radius);
        contacts.retain(|contact| {
            let along = self.series(*contact, &middle);
            let bend = self.series(*contact, &on_piece).coefficient(2);
            let least = along.coefficient(1) * &offset + along.value() + bend * offset.square();
            !least.is_positive().is_proved()
        });
    }

    fn series(&self, contact: Contact, joint: &Angle<E>) -> Jet<E> {
        margin_along(contact, joint, &self.ring, &self.grip, &self.forces)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Field};

    /// A semicircle well above its least thickness, in a state with room everywhere, and states of it that have none.
    #[test]
    fn a_state_with_room_is_admissible_and_its_twins_are_not() {
        let like = AstroInterval::integer(0, 128);
        let failure = |moment: (i32, i32), friction: (i32, i32), vertical: (i32, i32)| {
            let ratio = |(n, d): (i32, i32)| like.ratio(n, d);
            let whole = Whole {
                half_opening: like.ratio(11, 7),
                ring: Ring::new(SelfWeight::Heyman, &like.ratio(1, 4)),
                grip: Grip { shear: like.int(1), normal: ratio(friction) },
                forces: Forces {
                    thrust: ratio((62, 100)),
                    moment: ratio(moment),
                    vertical: ratio(vertical),
                },
            };
            whole.first_failure(&[])
        };
        assert_eq!(failure((62, 100), (1, 1), (0, 1)), None);
        assert_eq!(failure((62, 100), (1, 1), (1, 50)), None, "a little vertical force");
        assert_eq!(failure((54, 100), (1, 1), (0, 1)), Some(Contact::Intrados), "at the crown");
        assert_eq!(failure((70, 100), (1, 1), (0, 1)), Some(Contact::Extrados), "at the crown");
        assert!(failure((62, 100), (1, 3), (0, 1)).is_some(), "the shoulders slide");
        assert!(failure((62, 100), (1, 1), (1, 2)).is_some(), "too much vertical force");
    }

    /// Next to a joint at its limit a margin of the wrong bend is not taken for granted.
    #[test]
    fn a_joint_that_is_none_has_no_neighbourhood() {
        let like = AstroInterval::integer(0, 128);
        let whole = Whole {
            half_opening: like.ratio(11, 7),
            ring: Ring::new(SelfWeight::Heyman, &like.ratio(1, 4)),
            grip: Grip { shear: like.int(1), normal: like.int(1) },
            forces: Forces {
                thrust: like.ratio(62, 100),
                moment: like.ratio(62, 100),
                vertical: like.int(0),
            },
        };
        let haunch = like.ratio(-1, 1);
        assert!(whole.neighbourhood(Contact::Intrados, Some(&haunch)).is_some());
        assert!(whole.neighbourhood(Contact::Extrados, Some(&haunch)).is_none());
        assert!(whole.neighbourhood(Contact::Inwards, None).is_none(), "it grows there");
    }
}
