//! An asymmetric solution of (19) as a problem: its system, what has to be positive, and what can be stated of it.

use super::system::system;
use super::{Condition, Quantity, System};
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode, Place};
use crate::arch::mechanism::Contact;
use crate::arch::{Configuration, Ring, SelfWeight, Unknown};
use crate::number::Field;

/// The equations of a kind: its joints are at their limits.
pub(super) fn system(mode: AsymmetricMode, weight: SelfWeight) -> System {
    match mode {
        AsymmetricMode::InnerSliding => system! { weight;
            Thrust CrownMoment VerticalForce Thickness CrownHinge RotationJoint SlidingJoint;
            CrownHinge CrownTangency HaunchHinge HaunchTangency ShoulderSlides InnerSlides InnerSteepest;
        },
        AsymmetricMode::ShoulderOpening => system! { weight;
            Thrust CrownMoment VerticalForce Thickness CrownHinge RotationJoint;
            CrownHinge CrownTangency HaunchHinge HaunchTangency ShoulderSlides ShoulderOpens;
        },
        AsymmetricMode::ShoulderSliding => system! { weight;
            Thrust CrownMoment VerticalForce Thickness CrownHinge RotationJoint;
            CrownHinge CrownTangency HaunchHinge HaunchTangency ShoulderSlides Fits;
        },
    }
}

/// Conditions besides the margins on the whole arch: the ranges, the order of the joints, and the rates. The
/// two hinges turn by one, that at the haunch by as much more as the shoulder opens.
pub(super) fn conditions(mode: AsymmetricMode) -> Vec<Condition> {
    use {Condition as C, Unknown as U};
    let range = [
        C::Above(U::HalfOpening),
        C::Below(U::HalfOpening),
        C::Above(U::Thickness),
        C::Below(U::Thickness),
        C::Above(U::VerticalForce),
        C::Below(U::CrownHinge),
        C::HingesInOrder,
        C::Below(U::RotationJoint),
        C::SlidesTheRightWay,
    ];
    let own: &[C] = match mode {
        AsymmetricMode::InnerSliding => &[C::SlidesAboveHaunch, C::SlidesInwards],
        AsymmetricMode::ShoulderOpening => &[C::OpensAtShoulder],
        AsymmetricMode::ShoulderSliding => &[],
    };
    [&range[..], own].concat()
}

/// Margin of a condition, if it is one that an asymmetric solution sees in its own way.
pub(super) fn margin<T: Field>(
    mode: AsymmetricMode,
    condition: Condition,
    at: &Configuration<T>,
) -> Option<T> {
    let rate = |contact, place| rate(mode, contact, place, at);
    match condition {
        // The next joint to the left of the crown is the one that slides, if one does.
        Condition::HingesInOrder => {
            let next = match mode {
                AsymmetricMode::InnerSliding => &at.sliding_joint,
                _ => &at.rotation_joint,
            };
            Some(at.crown_hinge.rad.clone() + &next.rad)
        }
        Condition::SlidesTheRightWay => rate(Contact::Outwards, Place::Shoulder),
        Condition::OpensAtShoulder => rate(Contact::Extrados, Place::Shoulder),
        Condition::SlidesInwards => rate(Contact::Inwards, Place::Inner),
        _ => None,
    }
}

/// The rate of a joint that gives way, where the hinge next to the crown turns at the rate one.
fn rate<T: Field>(
    mode: AsymmetricMode,
    contact: Contact,
    place: Place,
    at: &Configuration<T>,
) -> Option<T> {
    let is_it = |&(own, _, at): &(Contact, _, Place)| (own, at) == (contact, place);
    let index = mode.contacts().iter().position(is_it)?;
    Some(Asymmetric::from(at).motion(mode).0.swap_remove(index).rate)
}

/// Tells whether a quantity can be stated of a solution: unknowns, what is made of them, and the motion.
pub(super) fn has(mode: AsymmetricMode, quantity: Quantity) -> bool {
    match quantity {
        Quantity::IntrinsicThrust | Quantity::ShoulderSlip | Quantity::Power => true,
        Quantity::InnerSlip => mode == AsymmetricMode::InnerSliding,
        Quantity::ShoulderOpening => mode == AsymmetricMode::ShoulderOpening,
        Quantity::OpeningVariable => false,
        _ => {
            let unknowns = system(mode, SelfWeight::Heyman).unknowns;
            quantity.variable().is_some_and(|unknown| unknowns.contains(&unknown))
        }
    }
}

/// A quantity of the motion.
pub(super) fn moving<T: Field>(
    mode: AsymmetricMode,
    weight: SelfWeight,
    quantity: Quantity,
    at: &Configuration<T>,
) -> Option<T> {
    match quantity {
        Quantity::ShoulderSlip => rate(mode, Contact::Outwards, Place::Shoulder, at),
        Quantity::ShoulderOpening => rate(mode, Contact::Extrados, Place::Shoulder, at),
        Quantity::InnerSlip => rate(mode, Contact::Inwards, Place::Inner, at),
        Quantity::Power => {
            let ring = Ring::new(weight, &at.thickness);
            Some(Asymmetric::from(at).motion(mode).power(&ring))
        }
        _ => None,
    }
}
