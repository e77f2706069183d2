//! The largest horizontal acceleration at which an arch of a given thickness has an admissible state, proved.
//!
//! A search in doubles says which conditions limit it. They hold with equality, each at its joint, and touch there:
//! these equations have one root in a box ([`TiltMechanism`]), and its acceleration is the largest exactly, since
//!
//! - **from above**, its multipliers are positive and leave nothing of `h, p` and `v`: they bound `k` by that of the
//!   root;
//! - **from below**, the state of the root is admissible at every joint of `[-alpha, alpha]`, by pieces that cover it.
//!   Next to a joint that touches, the margin is convex, and no value is below that of the touch, which is zero.
//!
//! So the proof is done once, with few bits; the digits are those of the root.
//!
//! **At one acceleration** a state with room says that there is one, and four conditions that contradict each other
//! that there is none, whatever of the largest stays open.
//!
//! **What it means.** Admissible states at an acceleration lie between those at two others, and the mirror image is
//! one to the left. So there are some exactly up to the largest, and beyond it the arch falls. Below it, the static
//! theorem says that an arch stands if its joints open and do not slide, as with unlimited friction. With friction
//! an admissible state does not exclude a motion, as sliding opens no joint: the value then is an upper bound of
//! what the arch can bear.

use super::tilt_mechanism::TiltMechanism;
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::tilt::TiltedRow;
use crate::arch::whole::along;
use crate::number::{Angle, Ball, Drawable, Enclosure, ExactNumber, Field, Jet, bits_of};
use crate::positive::{Zero, is_positive_on};
use crate::problem::{Arch, Joints, Slope};
use crate::prover::decide::is_positive;
use crate::prover::{Figure, Refused, Undecided, raise};
use crate::solve::tilt::{TiltCandidate, TiltNear, TiltSearch, contacts};
use rug::Float;
use std::cell::{LazyCell, OnceCell};

/// The largest acceleration with an admissible state.
#[derive(Clone, Debug)]
pub enum LargestTilt {
    /// The largest acceleration, over that of gravity, and the joints that give way there.
    Limited(Box<Figure>, Box<TiltMechanism>),
    /// There is an admissible state at every acceleration.
    Unlimited,
}

/// Certain answers about an arch under a horizontal acceleration.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TiltDigits {
    /// True if there is an admissible state at the acceleration asked for.
    pub is_admissible: Result<bool, Undecided>,
    /// The largest acceleration with one.
    pub largest: Result<LargestTilt, Undecided>,
}

impl TiltDigits {
    /// Proves an acceleration and the largest one, to some digits: `proved` finds with few bits what gives way there,
    /// `None` if there is none, `refined` tells its mechanism to as many as are asked for, and `has_state` and
    /// `has_none` see by the acceleration asked for alone whether that has a state. One nearer to the largest than its
    /// digits tell takes more bits.
    pub(super) fn found<P>(
        digits: usize,
        tilt: &Slope,
        proved: impl Fn(u32) -> Result<Option<P>, Undecided>,
        refined: impl Fn(&P, u32) -> Result<TiltMechanism, Undecided>,
        [has_state, has_none]: [&dyn Fn(&Ball) -> bool; 2],
    ) -> Self {
        let first = bits_of(digits) + GUARD;
        let found = OnceCell::new();
        let largest =
            |bits| match found.get_or_init(|| proved(BITS[0]).or_else(|_| proved(BITS[1]))) {
                Ok(found) => found.as_ref().map(|found| refined(found, bits)).transpose(),
                Err(open) => Err(Undecided::clone(open)),
            };
        let told = || {
            let tilt = acceleration(tilt, BITS[0]);
            has_state(&tilt).then_some(true).or_else(|| has_none(&tilt).then_some(false))
        };
        let compare = |found: &Option<TiltMechanism>, bits| match found {
            None => Some(true),
            Some(mechanism) => {
                let room = mechanism.tilt().clone() - acceleration(tilt, bits);
                room.excludes_zero().then(|| *room.mid() > 0)
            }
        };
        let mut decided = None;
        let found = raise(first, |bits| {
            let found = largest(bits)?;
            decided = decided.or_else(|| compare(&found, bits));
            let Some(mechanism) = found else { return Ok(Some(LargestTilt::Unlimited)) };
            let figure = Figure::new(mechanism.tilt(), digits);
            Ok(figure.map(|figure| LargestTilt::Limited(Box::new(figure), Box::new(mechanism))))
        });
        let is_admissible = decided
            .or_else(told)
            .map_or_else(|| raise(2 * first, |bits| Ok(compare(&largest(bits)?, bits))), Ok);
        // Beside a verdict the reason for what stays open names it.
        let largest = found.map_err(|open| match is_admissible {
            Ok(_) => open.about("the largest tilt"),
            Err(_) => open,
        });
        Self { is_admissible, largest }
    }
}

/// Question that stays open where no direction with room is found.
pub(super) const UNBOUNDED: &str = "whether the acceleration is bounded";
/// Question that stays open where the search finds no conditions that limit it.
pub(super) const NOT_FOUND: &str = "which conditions limit the acceleration";
/// Bits of the proof, and those with which it is tried once more.
const BITS: [u32; 2] = [256, 1024];
/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// Proves what holds for an arch that stands at this thickness under an acceleration, to `digits` significant digits.
pub fn tilted(
    arch: &Arch,
    thickness: &ExactNumber,
    tilt: &Slope,
    digits: usize,
) -> Result<TiltDigits, Refused> {
    Refused::thickness(thickness)?;
    Refused::digits(digits)?;
    let proof = |bits| TiltProof::new(arch, thickness, bits);
    let refined = |proved: &TiltMechanism, bits| proof(bits).refined(proved);
    let few = LazyCell::new(|| proof(BITS[0]));
    let told: [&dyn Fn(&Ball) -> bool; 2] =
        [&|tilt| few.has_state(tilt), &|tilt| few.has_none(tilt)];
    Ok(TiltDigits::found(digits, tilt, |bits| proof(bits).largest(), refined, told))
}

/// The acceleration over gravity that is asked for, in balls of some bits: given like a friction, by itself or by
/// its angle.
pub(super) fn acceleration(tilt: &Slope, bits: u32) -> Ball {
    let Grip { shear, normal } = tilt.grip::<Ball>(bits);
    normal / shear
}

/// An arch in balls of some bits.
struct TiltProof {
    half_opening: Ball,
    joints: Joints<Ball>,
    is_limited: bool,
    bits: u32,
}

impl TiltProof {
    fn new(arch: &Arch, thickness: &ExactNumber, bits: u32) -> Self {
        let half_opening = arch.half_opening().enclosure(bits);
        let grip = arch.friction().grip(bits);
        let joints = Joints::new(arch.weight(), &thickness.enclosure(bits), grip);
        Self { half_opening, joints, is_limited: arch.is_limited(), bits }
    }

    fn search(&self) -> TiltSearch {
        let double = |x: &Ball| x.mid().to_f64();
        TiltSearch::new(double(&self.half_opening), self.joints.map(double), self.is_limited)
    }

    /// Tells whether the state at an acceleration that is farthest from all conditions satisfies them.
    fn has_state(&self, tilt: &Ball) -> bool {
        let Some(state) = self.search().inside_at(tilt.mid().to_f64()) else { return false };
        let [h, p, v, _] = state.map(|x| Ball::exact(Float::with_val(self.bits, x), self.bits));
        let (weight, unknowns) = (h.int(1), [h, p, v, tilt.clone()]);
        self.is_admissible(&unknowns, &weight, &[]).is_ok()
    }

    /// Tells whether some conditions contradict each other at an acceleration.
    fn has_none(&self, tilt: &Ball) -> bool {
        let Some(places) = self.search().against(tilt.mid().to_f64()) else { return false };
        let row = |(contact, joint): &(Contact, f64)| {
            // No joint is beyond a springing: the outermost ones are the springings themselves.
            let size = Ball::exact(Float::with_val(self.bits, joint.abs()), self.bits);
            let is_inside = is_positive(&(self.half_opening.clone() - &size));
            let size = if is_inside { size } else { self.half_opening.clone() };
            let at = if *joint < 0.0 { -size } else { size };
            self.joints.tilted(*contact, &Angle::new(at))
        };
        contradict(&places.iter().map(row).collect::<Vec<_>>(), tilt)
    }

    /// The joints that give way at the largest acceleration, proved; `None` if there is no largest one.
    fn largest(&self) -> Result<Option<TiltMechanism>, Undecided> {
        match self.search().candidate() {
            TiltCandidate::Nothing => Err(Undecided::new(NOT_FOUND)),
            TiltCandidate::Unlimited => self.unlimited().map(|()| None),
            TiltCandidate::Limited(near) => {
                let mechanism = self.mechanism(&near)?;
                let weight = Ball::integer(1, self.bits);
                self.is_admissible(&mechanism.forces, &weight, &mechanism.zeros())?;
                Ok(Some(mechanism))
            }
        }
    }

    fn mechanism(&self, near: &TiltNear) -> Result<TiltMechanism, Undecided> {
        TiltMechanism::new(&self.joints, &self.half_opening, near, self.bits)
    }

    /// The joints that are proved to give way, to the bits of this proof.
    fn refined(&self, proved: &TiltMechanism) -> Result<TiltMechanism, Undecided> {
        match proved.tilt().prec() >= self.bits {
            true => Ok(proved.clone()),
            false => proved.refined(&self.joints, &self.half_opening, self.bits),
        }
    }

    /// More thrust, and with it more acceleration, passes no condition: to a state that is admissible any amount of
    /// it is added.
    fn unlimited(&self) -> Result<(), Undecided> {
        let ring = &self.joints.ring;
        let cos = Angle::new(self.half_opening.clone()).cos;
        let moment = (ring.extrados() * cos + ring.intrados()) / ring.thickness.int(4);
        let moment = moment.midpoint();
        let zero = moment.int(0);
        let holds = |k: i64| {
            let unknowns = [zero.int(1), moment.clone(), zero.clone(), zero.int(1).scaled(-k)];
            self.is_admissible(&unknowns, &zero, &[])
        };
        let found = (3..30).step_by(3).find_map(|k| holds(k).ok());
        found.ok_or_else(|| Undecided::new(UNBOUNDED))
    }

    /// Checks that at numbers `h, p, v, k`, with the weight that goes with them (none for a direction), no margin is
    /// negative anywhere on the arch, and that it is zero at given joints alone.
    fn is_admissible(
        &self,
        unknowns: &[Ball; 4],
        weight: &Ball,
        zeros: &[(Contact, Zero)],
    ) -> Result<(), Undecided> {
        let most = self.half_opening.upper();
        contacts(self.is_limited).iter().try_for_each(|contact| {
            let margin = |joint: &Ball| self.margin(*contact, joint, (unknowns, weight));
            let zeros = zeros.iter().filter(|(of, _)| of == contact);
            let zeros: Vec<Zero> = zeros.map(|(_, zero)| zero.clone()).collect();
            is_positive_on(&margin, (&-most.clone(), &most), &zeros, self.bits)
        })
    }

    /// A margin as a series along the arch.
    fn margin(
        &self,
        contact: Contact,
        joint: &Ball,
        (unknowns, weight): (&[Ball; 4], &Ball),
    ) -> Jet<Ball> {
        let constant = |x: &Ball| Jet::constant(x.clone(), 2);
        let row = self.joints.constant(2).tilted(contact, &along(&Angle::new(joint.clone())));
        -row.at(&unknowns.each_ref().map(constant), &constant(weight))
    }
}

/// Tells whether four conditions, or three slips, with positive multipliers that leave nothing of `h, p` and `v`,
/// contradict each other at an acceleration.
pub(super) fn contradict(of: &[TiltedRow<Ball>], tilt: &Ball) -> bool {
    // Slips say nothing of p.
    let is_pinned = of.iter().any(|row| !row.coefficients[1].is_zero());
    let kept: &[usize] = if is_pinned { &[0, 1, 2] } else { &[0, 2] };
    if of.len() != kept.len() + 1 {
        return false;
    }
    let column =
        |row: &TiltedRow<Ball>| kept.iter().map(|k| row.coefficients[*k].clone()).collect();
    let columns: Vec<Vec<Ball>> = of.iter().map(column).collect();
    let rates = rates(&columns);
    let passed = |row: &TiltedRow<Ball>| row.coefficients[3].clone() * tilt + &row.load;
    let terms = rates.iter().zip(of).map(|(rate, row)| rate.clone() * passed(row));
    let sum = terms.fold(tilt.int(0), |sum, term| sum + term);
    // The multipliers may all be negative: then so is what is left.
    let is_negative = |x: &Ball| is_positive(&-x.clone());
    rates.iter().all(is_positive) && is_positive(&sum)
        || rates.iter().all(is_negative) && is_negative(&sum)
}

/// Multipliers with which every column of the rows drops out, one row being too many: the minors, with signs in turn.
pub(super) fn rates(rows: &[Vec<Ball>]) -> Vec<Ball> {
    let without = |i: usize| {
        let minor = determinant(&[&rows[..i], &rows[i + 1..]].concat());
        if i.is_multiple_of(2) { minor } else { -minor }
    };
    (0..rows.len()).map(without).collect()
}

/// The determinant of a small matrix, by its first column.
pub(super) fn determinant(matrix: &[Vec<Ball>]) -> Ball {
    if let [row] = matrix {
        return row[0].clone();
    }
    let rest: Vec<Vec<Ball>> = matrix.iter().map(|row| row[1..].to_vec()).collect();
    let terms = rates(&rest).into_iter().zip(matrix).map(|(minor, row)| row[0].clone() * minor);
    terms.fold(matrix[0][0].int(0), |sum, term| sum + term)
}

#[cfg(test)]
mod tests;
