//! The conditions and the motions of the joints of an arch, over any number that carries them.
//!
//! | number | what it is for |
//! |---|---|
//! | `f64`, `Float` | candidates |
//! | balls | proofs at a thickness |
//! | [`Joints::in_thickness`] | polynomials in the thickness |
//! | [`Joints::constant`] | series along the arch |

use super::Extent;
use crate::arch::joint::{Grip, Row};
use crate::arch::mechanism::Contact;
use crate::arch::tilt::{TiltedRow, row};
use crate::arch::whole::{motion_row, static_row};
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Field, Jet};

/// Properties that all joints of an arch share: the ring and the friction.
#[derive(Clone, Debug)]
pub struct Joints<T> {
    /// Thickness and weight.
    pub ring: Ring<T>,
    /// The friction, as a joint asks for it.
    pub grip: Grip<T>,
}

/// A joint between equal stones at one of its limits: a condition on the forces, and the motion that goes with it,
/// without dilatancy.
#[derive(Clone, Debug)]
pub struct JointLimit<T> {
    /// The limit, by its sign.
    pub contact: Contact,
    /// The joint: so many halves of a stone from the crown.
    pub joint: i32,
    /// The coefficients of `h, p, v` and one in what must not be positive.
    pub row: [T; 4],
    /// The horizontal velocity, the rotation clockwise and the vertical velocity at the rate one.
    pub motion: [T; 3],
}

impl<T: Field> Joints<T> {
    /// The joints of an arch of this thickness.
    pub fn new(weight: SelfWeight, thickness: &T, grip: Grip<T>) -> Self {
        Self { ring: Ring::new(weight, thickness), grip }
    }

    /// The joints over all thicknesses: polynomials up to an order.
    pub fn in_thickness(weight: SelfWeight, grip: Grip<T>, order: usize) -> Joints<Jet<T>> {
        let zero = grip.shear.int(0);
        let thickness = Jet::new(vec![zero.clone(), zero.int(1)], order);
        Joints::new(weight, &thickness, grip.map(|x| Jet::constant(x, order)))
    }

    /// The joints in another number.
    pub fn map<U>(&self, f: impl Fn(&T) -> U) -> Joints<U> {
        Joints { ring: self.ring.map(&f), grip: self.grip.clone().map(|x| f(&x)) }
    }

    /// The joints as constants among series of an order.
    pub fn constant(&self, order: usize) -> Joints<Jet<T>> {
        self.map(|x| Jet::constant(x.clone(), order))
    }

    /// Condition at a joint of the half arch: its left side must not be positive.
    pub fn row(&self, contact: Contact, at: &Angle<T>) -> Row<T> {
        contact.row(at, &self.ring, &self.grip)
    }

    /// Condition at a joint of the whole arch under a horizontal acceleration: its left side must not be positive.
    pub fn tilted(&self, contact: Contact, at: &Angle<T>) -> TiltedRow<T> {
        row(contact, at, &self.ring, &self.grip)
    }

    /// All limits of a joint of an arch of equal stones.
    pub fn limits(&self, (joint, at): (i32, &Angle<T>), extent: Extent) -> [JointLimit<T>; 4] {
        let Ring { thickness, .. } = &self.ring;
        Contact::ALL.map(|contact| {
            let [h, p, v] = extent.seen(static_row(contact, at, &self.ring, &self.grip));
            let motion = extent.seen(motion_row(contact, at, thickness, &thickness.int(0)));
            JointLimit { contact, joint, row: [h, p, v, self.row(contact, at).load], motion }
        })
    }
}

impl<T: Field> Joints<Jet<T>> {
    /// Condition at a joint of the half arch whose place is no series: its left side must not be positive.
    pub fn row_at(&self, contact: Contact, at: Angle<T>, order: usize) -> Row<Jet<T>> {
        self.row(contact, &at.map(|x| Jet::constant(x, order)))
    }
}
