//! The conditions of admissible forces at the joints of equal stones, and their motions, in doubles.

use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Side, motion_row, static_row};
use crate::arch::{Ring, SelfWeight};
use crate::certify::arithmetic::Arithmetic;
use crate::certify::extent::Extent;
use crate::certify::vector::{Vector, dot};
use crate::certify::voussoirs::grip;
use crate::number::{Angle, DoubleBall, Enclosure, ExactNumber, Field};
use crate::problem::Arch;

/// Bits of what is given, before it is rounded to doubles.
const BITS: u32 = 106;

/// A condition `row . x + load <= 0` and its motion.
pub(super) struct Condition {
    pub(super) contact: Contact,
    /// So many halves of a stone from the crown.
    pub(super) joint: i32,
    pub(super) row: Vector,
    pub(super) load: DoubleBall,
    pub(super) motion: Vector,
}

impl Condition {
    pub(super) fn at(&self, forces: &Vector) -> DoubleBall {
        dot(&self.row, forces) + self.load
    }

    /// Whether it follows from another one: the same row, exactly, and a smaller load, or the same at the mirror image of its joint.
    pub(super) fn follows_from(&self, other: &Self) -> bool {
        let is_exact = |x: &DoubleBall| x.rad() == 0.0;
        let mut entries = self.row.iter().zip(&other.row);
        let is_same = entries.all(|(a, b)| is_exact(a) && is_exact(b) && a.mid() == b.mid());
        let is_image =
            self.contact == other.contact && self.joint == -other.joint && self.joint < 0;
        is_same && (is_image || self.load.is_less_than(&other.load).is_proved())
    }
}

/// The conditions at all joints of so many equal stones, of a half arch without those of `v`.
pub(super) fn conditions(
    arch: &Arch,
    thickness: &ExactNumber,
    (stones, extent): (i32, Extent),
) -> Vec<Condition> {
    let alpha: DoubleBall = arch.half_opening().enclosure(BITS);
    let eta: DoubleBall = thickness.enclosure(BITS);
    let weight: SelfWeight = arch.weight();
    let ring = Ring::new(weight, &eta);
    let grip: Grip<DoubleBall> =
        grip(arch.friction(), BITS).map(|x| DoubleBall::from_ball(&x, BITS));
    let none = eta.int(0);
    let is_solid = thickness.is_rational() && thickness.to_rational() == 2;
    let at = |k: i32| match k {
        0 => Angle::zero(&alpha),
        _ => {
            let side = if k < 0 { Side::Left } else { Side::Right };
            side.joint(&Angle::new(alpha * alpha.ratio(k.abs(), stones)))
        }
    };
    let seen = |[h, p, v]: Vector| match extent {
        Extent::Whole => [h, p, v],
        Extent::Half => [h, p, none],
    };
    let all = extent.joints(stones).flat_map(|joint| {
        let angle = at(joint);
        Contact::ALL.map(|contact| {
            let load = contact.row(&angle, &ring, &grip).load;
            // The radius of the intrados is zero exactly, and so is what it multiplies.
            if is_solid && contact == Contact::Intrados {
                let row = [none, none.int(-1), none];
                return Condition { contact, joint, row, load, motion: row };
            }
            let row = seen(static_row(contact, &angle, &ring, &grip));
            let motion = seen(motion_row(contact, &angle, &eta, &none));
            Condition { contact, joint, row, load, motion }
        })
    });
    all.collect()
}
