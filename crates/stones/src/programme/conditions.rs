//! The conditions of admissible forces at the joints of equal stones, and their motions, in doubles.

use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::jointed::limits_at_joint;
use crate::number::{Ball, DoubleBall, Enclosure, ExactNumber, Field};
use crate::problem::{Arch, Extent, JointLimit, Joints};
use crate::prover::arithmetic::Arithmetic;

/// Bits of what is given, before it is rounded to doubles.
const BITS: u32 = 106;

/// A condition `row . (x, 1) <= 0` and its motion.
pub(super) type MovingLimit = JointLimit<DoubleBall>;

/// Tells whether a condition follows from another one: the row of the forces is exactly the other's, and the load is
/// smaller, or that of the mirror image of its joint.
pub(super) fn follows(one: &MovingLimit, other: &MovingLimit) -> bool {
    let is_exact = |x: &DoubleBall| x.rad() == 0.0;
    let mut entries = one.row[..3].iter().zip(&other.row);
    let is_same = entries.all(|(a, b)| is_exact(a) && is_exact(b) && a.mid() == b.mid());
    let is_image = one.contact == other.contact && one.joint == -other.joint && one.joint < 0;
    is_same && (is_image || one.row[3].is_less_than(&other.row[3]).is_proved())
}

/// The conditions at all joints of so many equal stones, of a half arch without those of `v`.
pub(super) fn conditions(
    arch: &Arch,
    thickness: &ExactNumber,
    (stones, extent): (i32, Extent),
) -> Vec<MovingLimit> {
    let alpha: DoubleBall = arch.half_opening().enclosure(BITS);
    let grip: Grip<Ball> = arch.friction().grip(BITS);
    let grip = grip.map(|x| DoubleBall::from_ball(&x, BITS));
    let joints = Joints::new(arch.weight(), &thickness.enclosure(BITS), grip);
    let is_solid = thickness.is_rational() && thickness.to_rational() == 2;
    let count = limits_at_joint(arch);
    let limits = |joint| {
        let angle = Extent::angle(joint, stones, &alpha);
        joints.limits((joint, &angle), extent).into_iter().take(count)
    };
    let limits = extent.joints(stones).flat_map(limits);
    let exact = |limit: MovingLimit| match limit.contact {
        // The radius of the intrados is zero exactly, and so is what it multiplies.
        Contact::Intrados if is_solid => {
            let motion = [0, -1, 0].map(|n| alpha.int(n));
            let [h, p, v] = motion;
            MovingLimit { row: [h, p, v, limit.row[3]], motion, ..limit }
        }
        _ => limit,
    };
    limits.map(exact).collect()
}
