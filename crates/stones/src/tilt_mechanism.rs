//! The joints that give way at the largest horizontal acceleration, their places proved, and the forces there.
//!
//! The conditions that limit it hold with equality, each at its joint; inside the arch each touches, its slope
//! along the arch being zero; and their multipliers leave the acceleration alone. These are as many equations as
//! unknowns: the forces and the acceleration, the joints inside, the multipliers. A box is proved to hold exactly one
//! root. Multipliers that are positive there bound the acceleration by that of the root. Where there is a condition for
//! each force, they fix the root without the multipliers, which its digits need no more.

use crate::arch::mechanism::Contact;
use crate::arch::whole::along;
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Jet, Real, Stumpff, bits_of};
use crate::positive::Zero;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Joints, Quantity};
use crate::prover::Undecided;
use crate::prover::decide::is_positive;
use crate::prover::root::{Form, root_near};
use crate::solve::tilt::{TiltNear, TiltTouch};
use couplet_prove::certify::state::{Measured, measured_of};
use rug::Float;

/// A joint that gives way.
#[derive(Clone, Debug)]
pub struct TiltedJoint {
    /// The condition, by its sign: on the left half `Inwards` slides outwards, and the other way round.
    pub contact: Contact,
    /// Angle of the joint from the crown, rad, positive on the right, to which the acceleration pushes.
    pub angle: Ball,
    /// The multiplier of its condition: positive.
    pub rate: Ball,
    /// True if the joint is at a springing.
    pub is_springing: bool,
}

/// The joints that give way together at the largest acceleration, from the right springing to the left one.
#[derive(Clone, Debug)]
pub struct TiltMechanism {
    /// `h, p, v` and the acceleration `k`.
    pub forces: [Ball; 4],
    /// The joints.
    pub joints: Vec<TiltedJoint>,
}

/// The sizes of an arch of a given thickness to `digits` significant digits, with the forces that its halves bear on
/// each other at the largest acceleration, where that is known. Undecided where its bits do not tell the digits.
pub fn measured_tilt(
    (arch, thickness): (&Arch, &ExactNumber),
    largest: Option<&TiltMechanism>,
    measures: &Measures,
    digits: usize,
) -> Result<Measured, Undecided> {
    let names = [Quantity::Force, Quantity::VerticalForceInKilonewtons];
    let told = |of: &TiltMechanism| {
        let [thrust, _, vertical, _] = of.forces.clone();
        names.into_iter().zip([thrust, vertical].map(Some)).collect()
    };
    let forces = largest.map_or(Vec::new(), told);
    let bits = largest.map_or(bits_of(digits) + GUARD, |of| of.tilt().prec());
    let of = (arch.half_opening(), thickness);
    let sizes = measured_of(of, measures, (None, forces), (bits, digits));
    sizes.ok_or_else(|| Undecided::new("the digits of the forces"))
}

/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// Place of a joint: at a springing, or somewhere inside the arch.
type JointPlace = Option<Ball>;

/// The equations for given conditions.
struct TiltRoot<'a> {
    joints: &'a Joints<Ball>,
    places: &'a [(Contact, JointPlace)],
    /// The unknowns of `h, p, v, k` that are fixed: without a hinge nothing is said of `p`.
    kept: &'static [usize],
    /// Numbers that are added to the unknowns, which may be near zero: Newton's method sees positive ones.
    added: &'a [Ball],
}

/// The root: the kept forces, the joints inside, and the multipliers where they are unknowns.
type TiltUnknowns = [Vec<Ball>; 3];

impl TiltRoot<'_> {
    fn inside(&self) -> usize {
        self.places.iter().filter(|(_, place)| place.is_none()).count()
    }

    /// The root next to a start.
    fn near(
        joints: &Joints<Ball>,
        places: &[(Contact, JointPlace)],
        start: &[Float],
        bits: u32,
    ) -> Result<TiltUnknowns, Undecided> {
        let kept = kept(places.iter().map(|(contact, _)| *contact));
        let added = |x: &Float| (Float::with_val(bits, x.abs_ref()) * 2u32).ceil() + 4u32;
        let added: Vec<Ball> = start.iter().map(|x| Ball::exact(added(x), bits)).collect();
        let form = TiltRoot { joints, places, kept, added: &added };
        let start =
            start.iter().zip(&added).map(|(x, added)| Float::with_val(bits, added.mid() + x));
        let root = root_near(&form, bits, start.collect())?;
        let mut root = root.into_iter().zip(&added).map(|(x, added)| x - added);
        let [forces, inside] =
            [kept.len(), form.inside()].map(|count| root.by_ref().take(count).collect());
        Ok([forces, inside, root.collect()])
    }
}

/// The unknowns of `h, p, v, k` that conditions fix.
pub(super) fn kept(contacts: impl IntoIterator<Item = Contact>) -> &'static [usize] {
    let is_pinned = contacts.into_iter().any(Contact::is_hinge);
    if is_pinned { &[0, 1, 2, 3] } else { &[0, 2, 3] }
}

/// The place of a joint near an angle.
fn place(angle_is_positive: bool, is_inside: bool, half_opening: &Ball) -> JointPlace {
    let springing = || if angle_is_positive { half_opening.clone() } else { -half_opening.clone() };
    (!is_inside).then(springing)
}

impl Form<Ball> for TiltRoot<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let like = &x[0].clone();
        let unknowns = x.iter().zip(self.added);
        let x: Vec<T> = unknowns.map(|(x, added)| x.clone() - number(added)).collect();
        let constant = |x: T| Jet::constant(x, 2);
        let mut values = [(); 4].map(|()| constant(like.int(0)));
        self.kept.iter().zip(&x).for_each(|(k, x)| values[*k] = constant(x.clone()));
        let mut near = x[self.kept.len()..].iter();
        let rates = &x[self.kept.len() + self.inside()..];
        let joints = self.joints.map(|x| constant(number(x)));
        let one = constant(like.int(1));
        let (mut rows, mut touches) = (Vec::new(), Vec::new());
        for (contact, place) in self.places {
            let joint = place.as_ref().map(&number).or_else(|| near.next().cloned());
            let joint = joint.unwrap_or_else(|| like.int(0));
            let row = joints.tilted(*contact, &along(&Angle::new(joint)));
            let condition = row.at(&values, &one);
            touches.push(condition.coefficient(0));
            if place.is_none() {
                touches.push(condition.coefficient(1));
            }
            rows.push(row);
        }
        let kept = if rates.is_empty() { &[] } else { self.kept };
        let left = kept.iter().map(|k| {
            let terms = rows.iter().zip(rates);
            terms.fold(like.int(-i32::from(*k == 3)), |sum, (row, rate)| {
                sum + row.coefficients[*k].coefficient(0) * rate
            })
        });
        left.chain(touches).collect()
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, _: impl Fn(&Ball) -> T, _: &[T]) -> bool {
        true
    }
}

impl TiltMechanism {
    /// The root next to a candidate, its joints proved to be of the arch and their multipliers to be positive.
    pub(super) fn new(
        joints: &Joints<Ball>,
        half_opening: &Ball,
        near: &TiltNear,
        bits: u32,
    ) -> Result<Self, Undecided> {
        let TiltNear { touches, state } = near;
        let place =
            |of: &TiltTouch| (of.contact, place(of.joint > 0.0, of.is_inside, half_opening));
        let places: Vec<(Contact, JointPlace)> = touches.iter().map(place).collect();
        let kept = kept(touches.iter().map(|touch| touch.contact));
        let inside = touches.iter().filter(|touch| touch.is_inside).map(|touch| touch.joint);
        let rates = touches.iter().map(|touch| touch.rate);
        let start = kept.iter().map(|k| state[*k]).chain(inside).chain(rates);
        let start: Vec<Float> = start.map(|x| Float::with_val(bits, x)).collect();
        let [fixed, inside, rates] = TiltRoot::near(joints, &places, &start, bits)?;
        let mut forces = state.map(|x| Ball::exact(Float::with_val(bits, x), bits));
        kept.iter().zip(fixed).for_each(|(k, x)| forces[*k] = x);
        let mut inside = inside.into_iter();
        let joint = |((contact, place), rate): (&(Contact, JointPlace), Ball)| {
            let (angle, is_springing) = (place.clone().or_else(|| inside.next())?, place.is_some());
            Some(TiltedJoint { contact: *contact, angle, rate, is_springing })
        };
        let joints: Vec<TiltedJoint> = places.iter().zip(rates).filter_map(joint).collect();
        let is_of_arch = |joint: &TiltedJoint| {
            let TiltedJoint { angle, is_springing, .. } = joint;
            let [right, left] = [half_opening.clone() - angle, half_opening.clone() + angle];
            *is_springing || is_positive(&right) && is_positive(&left)
        };
        let is_known = |joint: &TiltedJoint| is_positive(&joint.rate) && is_of_arch(joint);
        match joints.len() == places.len() && joints.iter().all(is_known) {
            true => Ok(Self::ordered(forces, joints)),
            false => Err(Undecided::new("which joints give way")),
        }
    }

    /// The acceleration over that of gravity.
    pub fn tilt(&self) -> &Ball {
        let [.., tilt] = &self.forces;
        tilt
    }

    /// Where the margins of the conditions are zero.
    pub(super) fn zeros(&self) -> Vec<(Contact, Zero)> {
        let zero = |joint: &TiltedJoint| {
            let at = joint.angle.clone();
            let zero = match (joint.is_springing, *at.mid() > 0) {
                (false, _) => Zero::Touch(at),
                (true, true) => Zero::End(at),
                (true, false) => Zero::Begin(at),
            };
            (joint.contact, zero)
        };
        self.joints.iter().map(zero).collect()
    }

    /// The mechanism of the same joints, proved to more bits: its root lies in that one.
    pub(super) fn refined(
        &self,
        joints: &Joints<Ball>,
        half_opening: &Ball,
        bits: u32,
    ) -> Result<Self, Undecided> {
        let place = |of: &TiltedJoint| {
            (of.contact, place(*of.angle.mid() > 0, !of.is_springing, half_opening))
        };
        let places: Vec<(Contact, JointPlace)> = self.joints.iter().map(place).collect();
        let kept = kept(self.joints.iter().map(|joint| joint.contact));
        let mut refined = self.clone();
        let mut unknowns: Vec<&mut Ball> = Vec::new();
        let forces = refined.forces.iter_mut().enumerate();
        unknowns.extend(forces.filter(|(k, _)| kept.contains(k)).map(|(_, force)| force));
        let mut rates = Vec::new();
        for joint in &mut refined.joints {
            if !joint.is_springing {
                unknowns.push(&mut joint.angle);
            }
            rates.push(&mut joint.rate);
        }
        if kept.len() != places.len() {
            unknowns.extend(rates);
        }
        let start: Vec<Float> = unknowns.iter().map(|x| x.mid().clone()).collect();
        let root = TiltRoot::near(joints, &places, &start, bits)?;
        for (x, refined) in unknowns.into_iter().zip(root.into_iter().flatten()) {
            if !refined.lies_inside(x) {
                return Err(Undecided::astray());
            }
            *x = refined;
        }
        Ok(refined)
    }

    /// From the right springing to the left one.
    pub(super) fn ordered(forces: [Ball; 4], mut joints: Vec<TiltedJoint>) -> Self {
        joints.sort_by(|a, b| b.angle.mid().total_cmp(a.angle.mid()));
        Self { forces, joints }
    }
}
