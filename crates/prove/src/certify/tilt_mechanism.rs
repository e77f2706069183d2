//! The joints that give way at the largest horizontal acceleration, their places proved, and the forces there.
//!
//! The conditions that leave the bound hold with equality, each at its joint; inside the arch each touches, its slope
//! along the arch being zero; and their multipliers leave the acceleration alone. These are as many equations as
//! unknowns: the forces and the acceleration, the joints inside, the multipliers. A box is proved to hold exactly one
//! root. Multipliers that are positive there bound the acceleration by that of the root, which has to be the one that
//! is proved to be the largest, as far as its digits tell.

use crate::arch::mechanism::Contact;
use crate::arch::whole::along;
use crate::number::{Angle, Ball, Enclosure, Jet, Real, Stumpff};
use crate::problem::Joints;
use crate::prover::decide::is_positive;
use crate::prover::root::{Form, root_near};
use crate::prover::{Figure, Undecided};
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

/// Place of a joint.
#[derive(Clone, Debug)]
pub(super) enum JointPlace {
    /// At a springing.
    Springing(Ball),
    /// About here.
    Near(Float),
}

/// The equations for given conditions.
struct TiltRoot<'a> {
    joints: &'a Joints<Ball>,
    places: &'a [(Contact, JointPlace)],
    /// The unknowns of `h, p, v, k` that are fixed: without a hinge nothing is said of `p`.
    kept: &'static [usize],
    /// The unknowns that are negative: Newton's method sees all as positive.
    is_negative: &'a [bool],
}

impl TiltRoot<'_> {
    fn inside(&self) -> usize {
        self.places.iter().filter(|(_, place)| matches!(place, JointPlace::Near(_))).count()
    }
}

impl Form<Ball> for TiltRoot<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        let like = &x[0];
        let signed =
            |(x, is_negative): (&T, &bool)| if *is_negative { -x.clone() } else { x.clone() };
        let x: Vec<T> = x.iter().zip(self.is_negative).map(signed).collect();
        let constant = |x: T| Jet::constant(x, 2);
        let mut values = [(); 4].map(|()| constant(like.int(0)));
        self.kept.iter().zip(&x).for_each(|(k, x)| values[*k] = constant(x.clone()));
        let mut near = x[self.kept.len()..].iter();
        let rates = &x[self.kept.len() + self.inside()..];
        let joints = self.joints.map(|x| constant(number(x)));
        let one = constant(like.int(1));
        let (mut rows, mut touches) = (Vec::new(), Vec::new());
        for (contact, place) in self.places {
            let joint = match place {
                JointPlace::Springing(joint) => Some(number(joint)),
                JointPlace::Near(_) => near.next().cloned(),
            };
            let joint = joint.unwrap_or_else(|| like.int(0));
            let row = joints.tilted(*contact, &along(&Angle::new(joint)));
            let condition = row.at(&values, &one);
            touches.push(condition.coefficient(0));
            if matches!(place, JointPlace::Near(_)) {
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
    /// The root of the conditions at some places next to a state and multipliers, whose acceleration is a figure.
    pub(super) fn new(
        joints: &Joints<Ball>,
        places: &[(Contact, JointPlace)],
        (state, rates): (&[Float; 4], &[Float]),
        (largest, bits): (&Figure, u32),
    ) -> Result<Self, Undecided> {
        let is_pinned = places.iter().any(|(contact, _)| contact.is_hinge());
        let kept: &[usize] = if is_pinned { &[0, 1, 2, 3] } else { &[0, 2, 3] };
        let near = places.iter().filter_map(|(_, place)| match place {
            JointPlace::Near(joint) => Some(joint),
            JointPlace::Springing(_) => None,
        });
        let start: Vec<&Float> = kept.iter().map(|k| &state[*k]).chain(near).chain(rates).collect();
        let is_negative: Vec<bool> = start.iter().map(|x| **x < 0).collect();
        let form = TiltRoot { joints, places, kept, is_negative: &is_negative };
        let sizes = start.into_iter().map(|x| x.clone().abs()).collect();
        let root = root_near(&form, bits, sizes)?.into_iter().zip(&is_negative);
        let mut root = root.map(|(x, is_negative)| if *is_negative { -x } else { x });
        let mut forces = state.each_ref().map(|x| Ball::exact(Float::with_val(bits, x), bits));
        kept.iter().zip(root.by_ref()).for_each(|(k, x)| forces[*k] = x);
        let near: Vec<Ball> = root.by_ref().take(form.inside()).collect();
        let mut near = near.into_iter();
        let joint = |((contact, place), rate): (&(Contact, JointPlace), Ball)| {
            let (angle, is_springing) = match place {
                JointPlace::Springing(joint) => (joint.clone(), true),
                JointPlace::Near(_) => (near.next()?, false),
            };
            Some(TiltedJoint { contact: *contact, angle, rate, is_springing })
        };
        let joints: Vec<TiltedJoint> = places.iter().zip(root).filter_map(joint).collect();
        let open = || Undecided::new("which joints give way");
        let is_largest = forces[3].overlaps(&largest.enclosure(bits));
        let is_known =
            joints.len() == places.len() && joints.iter().all(|joint| is_positive(&joint.rate));
        (is_largest && is_known).then(|| Self::ordered(forces, joints)).ok_or_else(open)
    }

    /// From the right springing to the left one.
    pub(super) fn ordered(forces: [Ball; 4], mut joints: Vec<TiltedJoint>) -> Self {
        joints.sort_by(|a, b| b.angle.mid().total_cmp(a.angle.mid()));
        Self { forces, joints }
    }
}
