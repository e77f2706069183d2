//! An arch of voussoirs of a given thickness: does it stand, with what safety, and how much may it thrust?

use super::friction::required;
use super::joints::{StoneAngles, StoneJoints};
use super::thickness::{LeastOutcome, least};
use super::thrusts::{
    ProvedThrustEnd, ThickStones, ThrustRange, Ties, VoussoirLimit, VoussoirStanding,
};
use crate::arch::Ring;
use crate::arch::joint::Grip;
use crate::number::{Ball, Enclosure, ExactNumber};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Friction};
use crate::prover::figure::optional;
use crate::prover::{Answered, Figure, Undecided, raise};

/// Certain answers about an arch of voussoirs of a given thickness, each answer with a reason where it stays open.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct VoussoirAssessment {
    /// Tells whether the arch stands.
    pub standing: Result<VoussoirStanding, Undecided>,
    /// The thickness over the least thickness; `None` if there is none.
    pub geometric_safety: Answered<Figure>,
    /// The least friction with which it stands; `None` if none is enough.
    pub required_friction: Answered<Figure>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Answered<Figure>,
}

impl VoussoirAssessment {
    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        let others = [&self.geometric_safety, &self.required_friction, &self.friction_safety];
        self.standing.as_ref().err().or_else(|| others.into_iter().find_map(|x| x.as_ref().err()))
    }
}

/// Proves what holds for an arch of voussoirs with a thickness in `(0, 2]`, to `digits` significant digits.
pub(super) fn assessed(
    stones: &Stones,
    arch: &Arch,
    thickness: &ExactNumber,
    (first, digits): (u32, usize),
) -> VoussoirAssessment {
    let ties = Ties::of(arch, thickness);
    let angles = StoneAngles::new(stones);
    let joints =
        |friction: &Friction, bits| StoneJoints::new(&angles, arch.weight(), friction, bits);
    let eta = |bits| thickness.enclosure::<Ball>(bits);
    let own = arch.friction();
    let standing = raise(first, |bits| {
        let joints = joints(own, bits);
        let limit = |end: &ProvedThrustEnd| limit(&joints, end, digits);
        let limits = |[least, most]: &[ProvedThrustEnd; 2]| Some([limit(least)?, limit(most)?]);
        Ok(match ThickStones::new(&joints, &eta(bits), ties).range()? {
            ThrustRange::Stands(ends) => limits(&ends).map(VoussoirStanding::Stands),
            ThrustRange::Falls(ends) => limits(&ends).map(VoussoirStanding::Falls),
        })
    });
    let geometric_safety = raise(first, |bits| {
        Ok(match least(&joints(own, bits))? {
            LeastOutcome::Stands(state) => {
                Figure::new(&(eta(bits) / &state.thickness), digits).map(Some)
            }
            _ => Some(None),
        })
    });
    let required = |bits| {
        let joints = joints(&Friction::Infinite, bits);
        match ThickStones::new(&joints, &eta(bits), ties).range()? {
            ThrustRange::Falls(_) => Ok(None),
            ThrustRange::Stands(ends) => {
                let ring = Ring::new(arch.weight(), &eta(bits));
                joints.searched(|search| required(&joints, &ring, &ends, search)).map(Some)
            }
        }
    };
    let figure = |x: Option<Ball>| optional(x.as_ref(), |x| Figure::new(x, digits));
    let required_friction = raise(first, |bits| required(bits).map(figure));
    let friction_safety = raise(first, |bits| {
        // Where none is needed any is enough.
        let needed = required(bits)?.filter(|needed| needed.excludes_zero());
        Ok(figure(coefficient(own, bits).zip(needed).map(|(mu, needed)| mu / needed)))
    });
    VoussoirAssessment { standing, geometric_safety, required_friction, friction_safety }
}

/// The coefficient of a friction that is limited.
fn coefficient(friction: &Friction, bits: u32) -> Option<Ball> {
    let grip: Grip<Ball> = friction.grip(bits);
    (*friction != Friction::Infinite).then(|| grip.normal / grip.shear)
}

/// An end in digits; `None` if the rounding is not decided.
fn limit(joints: &StoneJoints<'_>, end: &ProvedThrustEnd, digits: usize) -> Option<VoussoirLimit> {
    let thrust = optional(end.thrust.as_ref(), |thrust| Figure::new(thrust, digits))?;
    let angles = end.contacts.iter().map(|(_, joint)| joints.figure(*joint, digits));
    let angles: Option<Vec<Figure>> = angles.collect();
    Some(VoussoirLimit { thrust, contacts: end.contacts.clone(), joints: angles? })
}
