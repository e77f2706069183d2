//! The joints that give way at the largest horizontal acceleration, their places proved, and the forces there.
//!
//! The conditions that limit it hold with equality, each at its joint; inside the arch each touches, its slope
//! along the arch being zero; and their multipliers leave the acceleration alone. These are as many equations as
//! unknowns: the forces and the acceleration, the joints inside, the multipliers. A box is proved to hold exactly one
//! root. Multipliers that are positive there bound the acceleration by that of the root.

use crate::arch::mechanism::Contact;
use crate::arch::whole::along;
use crate::number::{Angle, Ball, Enclosure, Jet, Real, Stumpff};
use crate::positive::Zero;
use crate::problem::Joints;
use crate::prover::Undecided;
use crate::prover::decide::is_positive;
use crate::prover::root::{Form, root_near};
use crate::solve::tilt::{TiltNear, TiltTouch};
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

impl TiltRoot<'_> {
    fn inside(&self) -> usize {
        self.places.iter().filter(|(_, place)| place.is_none()).count()
    }
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
        let left = self.kept.iter().map(|k| {
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
        let is_pinned = touches.iter().any(|touch| touch.contact.is_hinge());
        let kept: &[usize] = if is_pinned { &[0, 1, 2, 3] } else { &[0, 2, 3] };
        let springing =
            |joint: f64| if joint > 0.0 { half_opening.clone() } else { -half_opening.clone() };
        let place =
            |touch: &TiltTouch| (touch.contact, (!touch.is_inside).then(|| springing(touch.joint)));
        let places: Vec<(Contact, JointPlace)> = touches.iter().map(place).collect();
        let inside = touches.iter().filter(|touch| touch.is_inside).map(|touch| touch.joint);
        let rates = touches.iter().map(|touch| touch.rate);
        let start: Vec<f64> = kept.iter().map(|k| state[*k]).chain(inside).chain(rates).collect();
        let exact = |x: f64| Ball::exact(Float::with_val(bits, x), bits);
        let added: Vec<Ball> = start.iter().map(|x| exact((2.0 * x.abs()).ceil() + 4.0)).collect();
        let form = TiltRoot { joints, places: &places, kept, added: &added };
        let start =
            start.iter().zip(&added).map(|(x, added)| Float::with_val(bits, added.mid() + x));
        let root = root_near(&form, bits, start.collect())?.into_iter().zip(&added);
        let mut root = root.map(|(x, added)| x - added);
        let mut forces = state.map(exact);
        kept.iter().zip(root.by_ref()).for_each(|(k, x)| forces[*k] = x);
        let near: Vec<Ball> = root.by_ref().take(form.inside()).collect();
        let mut near = near.into_iter();
        let joint = |((contact, place), rate): (&(Contact, JointPlace), Ball)| {
            let (angle, is_springing) = (place.clone().or_else(|| near.next())?, place.is_some());
            Some(TiltedJoint { contact: *contact, angle, rate, is_springing })
        };
        let joints: Vec<TiltedJoint> = places.iter().zip(root).filter_map(joint).collect();
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

    /// Tells whether its unknowns lie in the interior of those of another, number by number.
    pub(super) fn lies_inside(&self, other: &Self) -> bool {
        let (inner, outer) = (self.unknowns(), other.unknowns());
        inner.len() == outer.len() && inner.iter().zip(outer).all(|(x, whole)| x.lies_inside(whole))
    }

    /// The unknowns of its equations: a springing is none, and without a hinge `p` is none.
    fn unknowns(&self) -> Vec<&Ball> {
        let Self { forces: [h, p, v, k], joints } = self;
        let is_pinned = joints.iter().any(|joint| joint.contact.is_hinge());
        let inside = joints.iter().filter(|joint| !joint.is_springing).map(|joint| &joint.angle);
        let rates = joints.iter().map(|joint| &joint.rate);
        let all = [h, v, k].into_iter().chain(is_pinned.then_some(p));
        all.chain(inside).chain(rates).collect()
    }

    /// From the right springing to the left one.
    pub(super) fn ordered(forces: [Ball; 4], mut joints: Vec<TiltedJoint>) -> Self {
        joints.sort_by(|a, b| b.angle.mid().total_cmp(a.angle.mid()));
        Self { forces, joints }
    }
}
