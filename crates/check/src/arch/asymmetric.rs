//! Asymmetric solutions of Eq. (19) on the whole arch: three kinds of states, their equations and their rates.
//!
//! One shoulder slides outwards, which is meant to be the right one; the mirror image is a solution as well. The
//! line of thrust touches the extrados on the right of the crown, at `b0`, and the intrados at the left haunch,
//! `b1` from the crown. What is to the left of the haunch stays at rest. A third joint closes the motion:
//!
//! | kind | beside the two hinges and the right shoulder | unknowns |
//! |---|---|---|
//! | `InnerSliding` | a joint of the left half slides inwards, at `b2` | `h, p, v, eta, b0, b1, b2` |
//! | `ShoulderOpening` | the right shoulder opens too, about its extrados | `h, p, v, eta, b0, b1` |
//! | `ShoulderSliding` | none: the two hinges and the shoulder fit, `(2 - eta) cos(b1 + alpha) = (2 + eta) cos(alpha - b0)` | `h, p, v, eta, b0, b1` |
//!
//! All are positive. At a hinge inside the arch, and at the inner joint that slides, the margin is zero and so is
//! its slope; at the shoulder the margin is zero.

use super::joint::Grip;
use super::mechanism::{Contact, Joint};
use super::whole::{Forces, Side, WholeMotion, margin, margin_along, motion_row};
use super::{Configuration, Ring, SelfWeight};
use crate::number::{Angle, Field, Real, worded};
use std::fmt;

worded! {
    /// Way in which an asymmetric mechanism closes.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum AsymmetricMode {
        /// An inner joint slides on the other side.
        InnerSliding = "inner_sliding",
        /// The shoulder that slides opens too.
        ShoulderOpening = "shoulder_opening",
        /// Two hinges and the shoulder close it alone.
        ShoulderSliding = "shoulder_sliding",
    }
    /// All three kinds.
    pub const ALL;
    /// The name in files.
    pub fn name -> &'static str;
}

impl AsymmetricMode {
    /// The joints that give way, from the right springing to the left, each as it does on its side.
    pub fn contacts(self) -> &'static [(Contact, Side, Place)] {
        use Contact::{Extrados, Intrados, Inwards, Outwards};
        use Place::{Crown, Haunch, Inner, Shoulder};
        use Side::{Left, Right};
        match self {
            Self::InnerSliding => &[
                (Outwards, Right, Shoulder),
                (Extrados, Right, Crown),
                (Inwards, Left, Inner),
                (Intrados, Left, Haunch),
            ],
            Self::ShoulderOpening => &[
                (Outwards, Right, Shoulder),
                (Extrados, Right, Shoulder),
                (Extrados, Right, Crown),
                (Intrados, Left, Haunch),
            ],
            Self::ShoulderSliding => {
                &[(Outwards, Right, Shoulder), (Extrados, Right, Crown), (Intrados, Left, Haunch)]
            }
        }
    }
}

impl fmt::Display for AsymmetricMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

worded! {
    /// Place of a joint that gives way.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Place {
        /// The springing.
        Shoulder = "shoulder",
        /// Next to the crown, at `b0`.
        Crown = "crown",
        /// The haunch, at `b1`.
        Haunch = "haunch",
        /// Between them, at `b2`.
        Inner = "inner",
    }
    /// All of them, in order.
    pub const ALL;
    /// The name in files.
    pub fn name -> &'static str;
}

/// The variables of a state.
#[derive(Clone, Debug)]
pub struct Asymmetric<T> {
    /// `alpha`.
    pub half_opening: Angle<T>,
    /// Friction.
    pub grip: Grip<T>,
    /// `eta`.
    pub thickness: T,
    /// `h`, `p` and `v`.
    pub forces: Forces<T>,
    /// `b0`, right of the crown.
    pub crown_hinge: Angle<T>,
    /// `b1`, left of it.
    pub haunch: Angle<T>,
    /// `b2`, left of it; of no use where no inner joint slides.
    pub sliding_joint: Angle<T>,
}

impl<T: Real> Asymmetric<T> {
    /// The variables from the unknowns `h, p, v, eta, b0, b1` and `b2`, where there is one.
    pub fn from_unknowns(half_opening: &T, grip: Grip<T>, unknowns: &[T]) -> Option<Self> {
        let [thrust, moment, vertical, thickness, crown, haunch, rest @ ..] = unknowns else {
            return None;
        };
        let angle = |rad: &T| Angle::new(rad.clone());
        Some(Self {
            half_opening: angle(half_opening),
            grip,
            thickness: thickness.clone(),
            forces: Forces {
                thrust: thrust.clone(),
                moment: moment.clone(),
                vertical: vertical.clone(),
            },
            crown_hinge: angle(crown),
            haunch: angle(haunch),
            sliding_joint: rest.first().map_or_else(|| Angle::zero(thrust), angle),
        })
    }
}

impl<T: Field> From<&Configuration<T>> for Asymmetric<T> {
    /// Variables of a symmetric state as those of an asymmetric one: the haunch is the rotational joint. A
    /// friction that is unlimited has no such form.
    fn from(at: &Configuration<T>) -> Self {
        Self {
            half_opening: at.half_opening.clone(),
            grip: Grip { shear: at.friction.int(1), normal: at.friction.clone() },
            thickness: at.thickness.clone(),
            forces: Forces {
                thrust: at.thrust.clone(),
                moment: at.crown_moment.clone(),
                vertical: at.vertical_force.clone(),
            },
            crown_hinge: at.crown_hinge.clone(),
            haunch: at.rotation_joint.clone(),
            sliding_joint: at.sliding_joint.clone(),
        }
    }
}

impl<T: Field> Asymmetric<T> {
    /// The joint of a place by its angle from the crown.
    pub fn angle(&self, place: Place) -> &Angle<T> {
        match place {
            Place::Shoulder => &self.half_opening,
            Place::Crown => &self.crown_hinge,
            Place::Haunch => &self.haunch,
            Place::Inner => &self.sliding_joint,
        }
    }

    /// The margin and its slope along the arch.
    fn touching(&self, (contact, side, place): (Contact, Side, Place), ring: &Ring<T>) -> [T; 2] {
        let joint = side.joint(self.angle(place));
        let along = margin_along(side.contact(contact), &joint, ring, &self.grip, &self.forces);
        [0, 1].map(|k| along.coefficient(k))
    }

    fn at_limit(&self, (contact, side, place): (Contact, Side, Place), ring: &Ring<T>) -> T {
        let joint = side.joint(self.angle(place));
        margin(side.contact(contact), &joint, ring, &self.grip, &self.forces)
    }

    /// The line of thrust touches the extrados at the hinge next to the crown: the margin there, and its slope.
    pub fn crown(&self, ring: &Ring<T>) -> [T; 2] {
        self.touching((Contact::Extrados, Side::Right, Place::Crown), ring)
    }

    /// The line of thrust touches the intrados at the haunch: the margin there, and its slope.
    pub fn haunch(&self, ring: &Ring<T>) -> [T; 2] {
        self.touching((Contact::Intrados, Side::Left, Place::Haunch), ring)
    }

    /// The right shoulder slides outwards: the margin there.
    pub fn shoulder_slides(&self, ring: &Ring<T>) -> T {
        self.at_limit((Contact::Outwards, Side::Right, Place::Shoulder), ring)
    }

    /// The right shoulder opens about its extrados: the margin there.
    pub fn shoulder_opens(&self, ring: &Ring<T>) -> T {
        self.at_limit((Contact::Extrados, Side::Right, Place::Shoulder), ring)
    }

    /// The inner joint slides inwards: the margin there, and its slope.
    pub fn inner_slides(&self, ring: &Ring<T>) -> [T; 2] {
        self.touching((Contact::Inwards, Side::Left, Place::Inner), ring)
    }

    /// Equations of all three kinds: the two hinges touch, and the right shoulder slides. Five equations.
    pub fn common(&self, weight: SelfWeight) -> Vec<T> {
        let ring = Ring::new(weight, &self.thickness);
        let touching = self.crown(&ring).into_iter().chain(self.haunch(&ring));
        touching.chain([self.shoulder_slides(&ring)]).collect()
    }

    /// Equations that the kind adds: as many equations as it has unknowns beyond four, all of them zero in a state.
    pub fn closing(&self, mode: AsymmetricMode, weight: SelfWeight) -> Vec<T> {
        let ring = Ring::new(weight, &self.thickness);
        match mode {
            AsymmetricMode::InnerSliding => self.inner_slides(&ring).into(),
            AsymmetricMode::ShoulderOpening => vec![self.shoulder_opens(&ring)],
            AsymmetricMode::ShoulderSliding => vec![self.misfit(&ring)],
        }
    }

    /// All equations of the kind: as many as unknowns.
    pub fn residuals(&self, mode: AsymmetricMode, weight: SelfWeight) -> Vec<T> {
        self.common(weight).into_iter().chain(self.closing(mode, weight)).collect()
    }

    /// `(2 - eta) cos(b1 + alpha) - (2 + eta) cos(alpha - b0)`: by how much the hinges and the shoulder alone do
    /// not fit.
    pub fn misfit(&self, ring: &Ring<T>) -> T {
        let Self { half_opening: alpha, crown_hinge: crown, haunch, .. } = self;
        let below = haunch.cos.clone() * &alpha.cos - haunch.sin.clone() * &alpha.sin;
        let above = crown.cos.clone() * &alpha.cos + crown.sin.clone() * &alpha.sin;
        ring.intrados() * below - ring.extrados() * above
    }

    /// Motion of the blocks, with the rotation one at the hinge next to the crown. It fits for the first two
    /// kinds whatever the variables are, and for the third where [`closing`](Self::closing) is zero.
    /// Undefined where the two joints that close the motion do the same.
    pub fn motion(&self, mode: AsymmetricMode) -> WholeMotion<T> {
        let (eta, none) = (&self.thickness, self.thickness.int(0));
        let one = eta.int(1);
        let row = |(contact, side, place): (Contact, Side, Place)| {
            let joint = side.joint(self.angle(place));
            motion_row(side.contact(contact), &joint, eta, &none)
        };
        let plus = |a: &[T; 3], b: &[T; 3]| [0, 1, 2].map(|k: usize| a[k].clone() + &b[k]);
        let shoulder = row((Contact::Outwards, Side::Right, Place::Shoulder));
        let haunch = row((Contact::Intrados, Side::Left, Place::Haunch));
        let gap = plus(&row((Contact::Extrados, Side::Right, Place::Crown)), &haunch);
        // The haunch turns back what the hinges turn, so that two velocities are left to close.
        let closed = |other: &[T; 3]| {
            let cross = |a: &[T; 3], b: &[T; 3]| a[0].clone() * &b[2] - a[2].clone() * &b[0];
            let whole = cross(&shoulder, other);
            [-cross(&gap, other) / &whole, -cross(&shoulder, &gap) / &whole]
        };
        let rates = match mode {
            AsymmetricMode::InnerSliding => {
                let inner = row((Contact::Inwards, Side::Left, Place::Inner));
                let [slip, other] = closed(&inner);
                vec![slip, one.clone(), other, one]
            }
            AsymmetricMode::ShoulderOpening => {
                let opening = row((Contact::Extrados, Side::Right, Place::Shoulder));
                let [slip, other] = closed(&plus(&opening, &haunch));
                vec![slip, other.clone(), one.clone(), one + other]
            }
            AsymmetricMode::ShoulderSliding => {
                let [across, ..] = &gap;
                vec![-across.clone() / &shoulder[0], one.clone(), one]
            }
        };
        let joint = |(&(contact, side, place), rate): (&(Contact, Side, Place), T)| Joint {
            contact: side.contact(contact),
            at: side.joint(self.angle(place)),
            rate,
            dilatancy: none.clone(),
        };
        WholeMotion(mode.contacts().iter().zip(rates).map(joint).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    fn angle(rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)) -> Angle<Rational> {
        Angle { rad: rad.into(), sin: sin.into(), cos: cos.into() }
    }

    fn at() -> Asymmetric<Rational> {
        Asymmetric {
            half_opening: angle((9, 4), (4, 5), (-3, 5)),
            grip: Grip { shear: 1.into(), normal: (21, 20).into() },
            thickness: (3, 5).into(),
            forces: Forces {
                thrust: (1, 6).into(),
                moment: (1, 4).into(),
                vertical: (1, 16).into(),
            },
            crown_hinge: angle((1, 16), (16, 65), (63, 65)),
            haunch: angle((1, 1), (20, 29), (21, 29)),
            sliding_joint: angle((1, 3), (5, 13), (12, 13)),
        }
    }

    const NONE: [i32; 3] = [0, 0, 0];

    #[test]
    fn the_motion_fits_and_a_false_twin_does_not() {
        for mode in [AsymmetricMode::InnerSliding, AsymmetricMode::ShoulderOpening] {
            let motion = at().motion(mode);
            assert_eq!(motion.gap(&at().thickness), NONE.map(Rational::from), "{mode:?}");
            for place in 0..motion.0.len() {
                let mut twin = motion.clone();
                twin.0[place].rate = -twin.0[place].rate.clone();
                assert_ne!(twin.gap(&at().thickness), NONE.map(Rational::from), "{mode:?} {place}");
            }
            let mut moved = motion;
            moved.0[1].at = angle((1, 4), (7, 25), (24, 25));
            assert_ne!(moved.gap(&at().thickness), NONE.map(Rational::from), "a hinge moved");
        }
    }

    /// The third kind leaves its condition, over twice the sine of the shoulder.
    #[test]
    fn the_third_kind_fits_where_its_condition_holds() {
        let mode = AsymmetricMode::ShoulderSliding;
        let [across, turn, up] = at().motion(mode).gap(&at().thickness);
        assert_eq!((across, turn), (0.into(), 0.into()));
        let [misfit] = &at().closing(mode, SelfWeight::Heyman)[..] else { panic!() };
        assert_ne!(*misfit, 0);
        assert_eq!(up, -misfit.clone() / (at().half_opening.sin * 2));
    }

    /// Each kind has as many equations as unknowns, and the mechanism moves where they put joints at their limits.
    #[test]
    fn equations_are_as_many_as_unknowns() {
        for (mode, unknowns) in AsymmetricMode::ALL.into_iter().zip([7, 6, 6]) {
            assert_eq!(at().residuals(mode, SelfWeight::Milankovitch).len(), unknowns);
            let ring = Ring::new(SelfWeight::Milankovitch, &at().thickness);
            let residuals = at().residuals(mode, SelfWeight::Milankovitch);
            let terms = at().motion(mode).complementarity(&ring, &at().grip, &at().forces);
            for (term, joint) in terms.iter().zip(&at().motion(mode).0) {
                let is_one = |r: &Rational| *term == r.clone() * joint.rate.clone();
                assert!(residuals.iter().any(is_one), "{mode:?} {:?}", joint.contact);
            }
        }
    }
}
