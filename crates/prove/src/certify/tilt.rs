//! The largest horizontal acceleration at which an arch of a given thickness has an admissible state, proved.
//!
//! **From above**: conditions at a few joints, whose multipliers are positive and leave nothing of `h, p` and `v`,
//! leave a bound of `k`. It is valid for any choice of joints; its error is quadratic in their distance from the true
//! ones. **From below**: a state that is admissible at every joint of `[-alpha, alpha]`, by pieces that cover
//! it: a piece where a margin is convex is decided by its value and slope at one point, however little room there
//! is. Between the candidate of the limit and a state well inside there is one as near to the limit as one likes;
//! so both bounds come together to any number of digits.
//!
//! **What it means.** Admissible states at an acceleration lie between those at two others, and the mirror image is
//! one to the left. So there are some exactly up to the largest, and beyond it the arch falls. Below it, the static
//! theorem says that an arch stands if its joints open and do not slide, as with unlimited friction. With friction
//! an admissible state does not exclude a motion, as sliding opens no joint: the value then is an upper bound of
//! what the arch can bear.

use super::tilt_mechanism::{JointPlace, TiltMechanism};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::tilt::TiltedRow;
use crate::arch::whole::along;
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Jet, bits_of};
use crate::problem::{Arch, Joints, Slope};
use crate::prover::decide::is_positive;
use crate::prover::positive::is_positive_on;
use crate::prover::{Answered, Figure, Refused, Undecided, raise};
use crate::solve::tilt::{TiltCandidate, TiltSearch, TiltTouch, contacts};
use rug::Float;
use std::cell::OnceCell;

/// A condition of those that leave the bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TiltLimit {
    /// The condition, by its sign: on the left half `Inwards` slides outwards, and the other way round.
    pub contact: Contact,
    /// True if the joint is at a springing.
    pub is_springing: bool,
    /// True if the joint is on the right half, to which the acceleration pushes.
    pub is_right: bool,
    /// The joint between two stones, from the crown; `None` where there is one at every angle.
    pub joint: Option<u64>,
}

/// The largest acceleration with an admissible state.
#[derive(Clone, Debug)]
pub enum LargestTilt {
    /// The largest acceleration, over that of gravity, and the conditions that leave the bound.
    Limited(Box<Figure>, Vec<TiltLimit>),
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
    /// The joints that give way there.
    pub mechanism: Answered<TiltMechanism>,
}

impl TiltDigits {
    /// Proves an acceleration and the largest one, to some digits: `largest` proves that one, and `told`
    /// sees in it alone whether the acceleration asked for has a state. One nearer to the largest than its digits
    /// tell takes more bits.
    pub(super) fn found(
        (first, digits): (u32, usize),
        tilt: &Slope,
        largest: impl Fn(u32) -> Result<Option<TiltBound>, Undecided>,
        told: impl Fn(u32) -> Option<bool>,
        mechanism: impl Fn(&Figure) -> Result<TiltMechanism, Undecided>,
    ) -> Self {
        let compare = |found: &Option<TiltBound>, bits| {
            compared(found.as_ref().map(|(largest, _)| largest), tilt, bits)
        };
        let mut decided = None;
        let found = raise(first, |bits| {
            let found = largest(bits)?;
            decided = decided.or_else(|| compare(&found, bits));
            let Some((largest, limits)) = found else { return Ok(Some(LargestTilt::Unlimited)) };
            let figure = Figure::new(&largest, digits);
            Ok(figure.map(|figure| LargestTilt::Limited(Box::new(figure), limits)))
        });
        let beside = |bits| match told(bits) {
            Some(told) => Ok(Some(told)),
            None => {
                let open = || Undecided::new("whether the acceleration is below the largest");
                compare(&largest(bits)?, bits).map(Some).ok_or_else(open)
            }
        };
        let is_admissible = decided.map_or_else(|| raise(2 * first, beside), Ok);
        // Beside a verdict the reason for what stays open names it.
        let largest = found.map_err(|open| match is_admissible {
            Ok(_) => open.about("the largest tilt"),
            Err(_) => open,
        });
        let mechanism = match &largest {
            Ok(LargestTilt::Limited(figure, _)) => mechanism(figure).map(Some),
            Ok(LargestTilt::Unlimited) => Ok(None),
            Err(open) => Err(open.clone()),
        };
        Self { is_admissible, largest, mechanism }
    }
}

/// Question that stays open where no direction with room is found.
const UNBOUNDED: &str = "whether the acceleration is bounded";
/// Question that stays open where the search finds no conditions that limit it.
pub(super) const NOT_FOUND: &str = "which conditions limit the acceleration";
/// Bits beyond a third, as the state from below is nearer to the limit than these.
const GUARD: u32 = 16;

/// Proves what holds for an arch that stands at this thickness under an acceleration, to `digits` significant digits.
pub fn tilted(
    arch: &Arch,
    thickness: &ExactNumber,
    tilt: &Slope,
    digits: usize,
) -> Result<TiltDigits, Refused> {
    Refused::thickness(thickness)?;
    Refused::tilt_digits(digits)?;
    let first = 3 * (bits_of(digits) + GUARD);
    // Whether it is bounded at all is seen in doubles, with room or not: more bits tell no more.
    let hopeless = OnceCell::new();
    let largest = |bits| match hopeless.get() {
        Some(open) => Err(Undecided::clone(open)),
        None => TiltProof::new(arch, thickness, bits).largest().inspect_err(|open| {
            if open.reason == UNBOUNDED {
                hopeless.get_or_init(|| open.clone());
            }
        }),
    };
    // A state well inside tells by itself that there is one, whatever of the largest stays open.
    let told = |bits| TiltProof::new(arch, thickness, bits).has_state(tilt).then_some(true);
    let mechanism = |figure: &Figure| TiltProof::new(arch, thickness, first).mechanism(figure);
    Ok(TiltDigits::found((first, digits), tilt, largest, told, mechanism))
}

/// Tells whether an acceleration is below the largest; `None` if that is not told.
fn compared(largest: Option<&Ball>, tilt: &Slope, bits: u32) -> Option<bool> {
    let Some(largest) = largest else { return Some(true) };
    let room = largest.clone() - acceleration(tilt, bits);
    room.excludes_zero().then(|| *room.mid() > 0)
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

/// The largest acceleration, and the conditions that limit it.
pub(super) type TiltBound = (Ball, Vec<TiltLimit>);

impl TiltProof {
    fn new(arch: &Arch, thickness: &ExactNumber, bits: u32) -> Self {
        let half_opening = arch.half_opening().enclosure(bits);
        let grip = arch.friction().grip(bits);
        let joints = Joints::new(arch.weight(), &thickness.enclosure(bits), grip);
        Self { half_opening, joints, is_limited: arch.is_limited(), bits }
    }

    fn search(&self) -> TiltSearch {
        let mid = |x: &Ball| Float::with_val(self.bits, x.mid());
        TiltSearch::new(mid(&self.half_opening), self.joints.map(mid), self.is_limited, self.bits)
    }

    /// Tells whether the state at an acceleration that is farthest from all conditions satisfies them.
    fn has_state(&self, tilt: &Slope) -> bool {
        let tilt = acceleration(tilt, self.bits);
        let Some(state) = self.search().inside_at(tilt.mid().to_f64()) else { return false };
        let [h, p, v, _] = state.map(|x| Ball::exact(Float::with_val(self.bits, x), self.bits));
        let (weight, unknowns) = (h.int(1), [h, p, v, tilt]);
        self.is_admissible(&unknowns, &weight).is_ok()
    }

    /// The largest acceleration, between two bounds; `None` if there is none.
    fn largest(&self) -> Result<Option<TiltBound>, Undecided> {
        match self.search().candidate() {
            TiltCandidate::Nothing => Err(Undecided::new(NOT_FOUND)),
            TiltCandidate::Unlimited => self.unlimited().map(|()| None),
            TiltCandidate::Limited(near) => {
                let (high, limits) = self.bound_above(&near.touches)?;
                let low = self.bound_below(&near.limit, &near.inside)?;
                if high.is_less_than(&low).is_proved() {
                    return Err(Undecided::new("a bound of the acceleration"));
                }
                Ok(Some((low.hull(&high), limits)))
            }
        }
    }

    /// The joints that give way at the largest acceleration.
    fn mechanism(&self, largest: &Figure) -> Result<TiltMechanism, Undecided> {
        let TiltCandidate::Limited(near) = self.search().candidate() else {
            return Err(Undecided::new(NOT_FOUND));
        };
        let place = |touch: &TiltTouch| {
            let place = match (touch.is_inside, touch.joint > 0) {
                (true, _) => JointPlace::Near(touch.joint.clone()),
                (false, true) => JointPlace::Springing(self.half_opening.clone()),
                (false, false) => JointPlace::Springing(-self.half_opening.clone()),
            };
            (touch.contact, place)
        };
        let places: Vec<_> = near.touches.iter().map(place).collect();
        let start = (&near.limit, &near.rates[..]);
        TiltMechanism::new(&self.joints, &places, start, (largest, self.bits))
    }

    /// A bound from above. A line that touches at fewer joints than are needed: one of them becomes two beside it,
    /// the first with which there is a bound. Two hinges at an intrados that is one point are not.
    fn bound_above(&self, touches: &[TiltTouch]) -> Result<TiltBound, Undecided> {
        let is_pinned = touches.iter().any(|touch| touch.contact.is_hinge());
        let kept: &[usize] = if is_pinned { &[0, 1, 2] } else { &[0, 2] };
        let inside = || touches.iter().filter(|touch| touch.is_inside);
        let found = (0..inside().count().max(1)).find_map(|first| {
            let in_turn = inside().cycle().skip(first).take(inside().count());
            self.bound_by(&self.apart(touches, in_turn, kept.len() + 1), kept)
        });
        let bound = found.ok_or_else(|| Undecided::new("a bound of the acceleration"))?;
        let limit = |touch: &TiltTouch| TiltLimit {
            contact: touch.contact,
            is_springing: !touch.is_inside,
            is_right: touch.joint > 0,
            joint: None,
        };
        Ok((bound, touches.iter().map(limit).collect()))
    }

    /// Lists so many touches, with those of some joints, in turn, at two joints beside them.
    fn apart<'a>(
        &self,
        touches: &[TiltTouch],
        joints: impl Iterator<Item = &'a TiltTouch>,
        count: usize,
    ) -> Vec<TiltTouch> {
        let mut apart = touches.to_vec();
        let offset = Float::with_val(self.bits, 1) >> (self.bits / 4);
        for touch in joints {
            if apart.len() >= count {
                break;
            }
            let beside = |joint| TiltTouch { joint, ..touch.clone() };
            let at = apart.iter().position(|other| other.joint == touch.joint).unwrap_or(0);
            apart[at] = beside(Float::with_val(self.bits, &touch.joint - &offset));
            apart.push(beside(Float::with_val(self.bits, &touch.joint + &offset)));
        }
        apart
    }

    /// The bound that conditions at some joints leave, if their multipliers are positive and nothing is left of the
    /// numbers kept.
    fn bound_by(&self, apart: &[TiltTouch], kept: &[usize]) -> Option<Ball> {
        // A joint beyond the springings is none of the arch.
        let is_of_arch = |touch: &TiltTouch| {
            let size = Ball::exact(touch.joint.clone().abs(), self.bits);
            !touch.is_inside || (self.half_opening.clone() - size).is_positive().is_proved()
        };
        if apart.len() != kept.len() + 1 || !apart.iter().all(is_of_arch) {
            return None;
        }
        let rows: Vec<TiltedRow<Ball>> = apart.iter().map(|touch| self.row(touch)).collect();
        let columns: Vec<Vec<Ball>> = rows
            .iter()
            .map(|row| kept.iter().map(|k| row.coefficients[*k].clone()).collect())
            .collect();
        let mut rates = rates(&columns);
        if rates.iter().all(|rate| (-rate.clone()).is_positive().is_proved()) {
            rates = rates.into_iter().map(|rate| -rate).collect();
        }
        let zero = Ball::integer(0, self.bits);
        let sum = |of: &dyn Fn(&TiltedRow<Ball>) -> Ball| {
            let terms = rates.iter().zip(&rows);
            terms.fold(zero.clone(), |sum, (rate, row)| sum + rate.clone() * of(row))
        };
        let slope = sum(&|row| row.coefficients[3].clone());
        let is_bound = rates.iter().all(is_positive) && is_positive(&slope);
        is_bound.then(|| -sum(&|row| row.load.clone()) / slope)
    }

    fn row(&self, touch: &TiltTouch) -> TiltedRow<Ball> {
        let joint = match (touch.is_inside, touch.joint > 0) {
            (true, _) => Ball::exact(touch.joint.clone(), self.bits),
            (false, true) => self.half_opening.clone(),
            (false, false) => -self.half_opening.clone(),
        };
        self.joints.tilted(touch.contact, &Angle::new(joint))
    }

    /// The acceleration of an admissible state next to the limit.
    fn bound_below(&self, limit: &[Float; 4], inside: &[Float; 4]) -> Result<Ball, Undecided> {
        let share = Float::with_val(self.bits, 1) >> (self.bits / 3);
        let mix = |k: usize| {
            let way = Float::with_val(self.bits, &inside[k] - &limit[k]);
            Ball::exact(Float::with_val(self.bits, &limit[k] + way * &share), self.bits)
        };
        let unknowns: [Ball; 4] = std::array::from_fn(mix);
        let weight = Ball::integer(1, self.bits);
        self.is_admissible(&unknowns, &weight)?;
        let [.., tilt] = unknowns;
        Ok(tilt)
    }

    /// More thrust, and with it more acceleration, passes no condition: to a state that is admissible any amount of
    /// it is added.
    fn unlimited(&self) -> Result<(), Undecided> {
        let ball = |x: &Ball| Ball::exact(Float::with_val(self.bits, x.mid()), self.bits);
        let ring = &self.joints.ring;
        let cos = Angle::new(self.half_opening.clone()).cos;
        let moment = (ring.extrados() * cos + ring.intrados()) / ring.thickness.int(4);
        let moment = ball(&moment);
        let zero = moment.int(0);
        let holds = |k: i64| {
            let unknowns = [zero.int(1), moment.clone(), zero.clone(), zero.int(1).scaled(-k)];
            self.is_admissible(&unknowns, &zero)
        };
        let found = (3..30).step_by(3).find_map(|k| holds(k).ok());
        found.ok_or_else(|| Undecided::new(UNBOUNDED))
    }

    /// Checks that at numbers `h, p, v, k`, with the weight that goes with them (none for a direction), all margins are
    /// positive on the whole arch.
    fn is_admissible(&self, unknowns: &[Ball; 4], weight: &Ball) -> Result<(), Undecided> {
        let most = self.half_opening.upper();
        contacts(self.is_limited).iter().try_for_each(|contact| {
            let margin = |joint: &Ball| self.margin(*contact, joint, (unknowns, weight));
            is_positive_on(&margin, (&-most.clone(), &most), self.bits)
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
