//! A candidate for the least thickness of an arch of voussoirs: which conditions hold with equality there.
//!
//! For three conditions, one of them a hinge at the intrados, the thickness is the root of a polynomial. The hinge
//! is moved to the joint where the line of thrust passes the intrados farthest, until there is none: every step is
//! a lower bound, and a few are enough. On the joints each condition rises and then falls
//! ([`contact`](crate::arch::contact)), so that its largest value is found by halving.

use crate::arch::joint::{Grip, Row, combination};
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Ball, Engine, Jet, Real};
use crate::problem::Joints;
use crate::problem::stones::{JointContact, Stones};
use crate::start::Start;
use rug::Float;

/// Probable verdict on an arch of voussoirs.
#[derive(Clone, Debug)]
pub enum VoussoirCandidate {
    /// The conditions that hold with equality at the least thickness.
    Collapses {
        /// The conditions.
        contacts: [JointContact; 3],
        /// The thickness.
        thickness: Float,
    },
    /// The arch stands however thin it is.
    AnyThickness,
    /// Nothing stands: an inner joint slides, or the shoulder.
    Slides {
        /// The inner joint.
        inner: u64,
    },
    /// Nothing up to the physical limit stands, as these conditions contradict each other.
    TooThick {
        /// The conditions.
        contacts: [JointContact; 3],
    },
}

/// The polynomials in the thickness have at most this degree.
pub const DEGREE: usize = 3;
/// A step of Newton's method is short if it is so many bits below what it changes.
const SHORT: i64 = 24;
/// Rounds of moving the hinge; each climbs, and there are only so many joints near the best.
const ROUNDS: usize = 100;

/// An arch of voussoirs in doubles, or in numbers of some bits.
pub struct Search<'a, T> {
    pub(super) stones: &'a Stones,
    weight: SelfWeight,
    grip: Grip<T>,
    half_opening: T,
    bits: u32,
    /// The middle of a ball in these numbers.
    pub(super) near: &'a dyn Fn(&Ball) -> T,
}

impl<'a, T: Start> Search<'a, T> {
    /// An arch, and its friction as a [`Grip`], in numbers that are `near` the middles of balls of `bits` bits.
    pub fn new(
        (stones, weight, grip): (&'a Stones, SelfWeight, &Grip<Ball>),
        bits: u32,
        near: &'a dyn Fn(&Ball) -> T,
    ) -> Self {
        let half_opening = near(&stones.half_opening().enclosure(bits));
        Self { stones, weight, grip: grip.clone().map(|x| near(&x)), half_opening, bits, near }
    }

    /// The number itself.
    pub(super) fn to_float(&self, x: &T) -> Float {
        <Ball as Engine>::exact(&x.exact(), self.bits as usize).mid().clone()
    }

    pub(super) fn last(&self) -> u64 {
        self.stones.last()
    }

    pub(super) fn angle(&self, index: u64) -> Angle<T> {
        let whole = |n: u64| self.half_opening.int(i32::try_from(n).unwrap_or(i32::MAX));
        Angle::new(match self.stones {
            Stones::Equal { stones, .. } => {
                whole(2 * index + stones % 2) * &self.half_opening / whole(*stones)
            }
            Stones::Joints(_) => (self.near)(&self.stones.joint(index, self.bits)),
        })
    }

    pub(super) fn row(&self, contact: JointContact, thickness: &T) -> Row<T> {
        contact.0.row(&self.angle(contact.1), &Ring::new(self.weight, thickness), &self.grip)
    }

    /// The thrust at which a joint slides; `None` if no thrust is too small, or none too large.
    fn sliding_thrust(&self, contact: JointContact) -> Option<T> {
        let row = self.row(contact, &self.half_opening.int(1));
        let bounds = match contact.0 {
            Contact::Inwards => row.thrust < 0.0,
            _ => row.thrust > 0.0,
        };
        bounds.then(|| -row.load / row.thrust)
    }

    /// The joint that asks for the largest thrust.
    pub(super) fn inner(&self) -> u64 {
        let thrust = |index| self.sliding_thrust((Contact::Inwards, index));
        // Without friction the crown asks for nothing.
        let first = u64::from(self.stones.has_joint_at_crown() && thrust(0).is_none());
        // None is less than any.
        peak(first, self.last(), thrust)
    }

    /// The joint where the intrados is passed farthest.
    pub(super) fn haunch(&self, thrust: &T, thickness: &T) -> u64 {
        let zero = thrust.int(0);
        let depth = |index| self.row((Contact::Intrados, index), thickness).at(thrust, &zero);
        peak(0, self.last(), depth)
    }

    /// The least thickness with a thrust between the two at which something slides.
    pub(super) fn least(&self) -> VoussoirCandidate {
        let (inner, last) = (self.inner(), self.last());
        let least = self.sliding_thrust((Contact::Inwards, inner));
        let most = self.sliding_thrust((Contact::Outwards, last));
        let hinges = |haunch| {
            [(Contact::Extrados, 0), (Contact::Intrados, haunch), (Contact::Extrados, last)]
        };
        let shoulder = |haunch| {
            [(Contact::Extrados, 0), (Contact::Intrados, haunch), (Contact::Outwards, last)]
        };
        let inside = |haunch| {
            [(Contact::Inwards, inner), (Contact::Intrados, haunch), (Contact::Extrados, last)]
        };
        if let (Some(least), Some(most)) = (&least, &most)
            && least > most
        {
            return VoussoirCandidate::Slides { inner };
        }
        let (rotation, thrust) = self.climb(&hinges);
        match (least, most) {
            (Some(least), _) if thrust < least => self.climb(&inside).0,
            (_, Some(most)) if thrust > most => self.climb(&shoulder).0,
            _ => rotation,
        }
    }

    /// The thickness of three conditions with the hinge at the intrados where it has to be, and the thrust there.
    fn climb(&self, contacts: &impl Fn(u64) -> [JointContact; 3]) -> (VoussoirCandidate, T) {
        let mut haunch = self.last() / 2;
        let mut found = (VoussoirCandidate::AnyThickness, self.half_opening.int(1));
        for _ in 0..ROUNDS {
            let three = contacts(haunch);
            let root = self.root(&three);
            let thickness = root.clone().unwrap_or(self.half_opening.int(2));
            let rows = three.map(|contact| self.row(contact, &thickness));
            // Two whose coefficients are farthest from being multiples.
            let (thrust, _) = rows[0].meeting(&rows[2]);
            found.0 = match root {
                None => VoussoirCandidate::TooThick { contacts: three },
                Some(thickness) if thickness == 0.0 => VoussoirCandidate::AnyThickness,
                Some(thickness) => {
                    let thickness = self.to_float(&thickness);
                    VoussoirCandidate::Collapses { contacts: three, thickness }
                }
            };
            let next = self.haunch(&thrust, &thickness);
            found.1 = thrust;
            if next == haunch {
                break;
            }
            haunch = next;
        }
        found
    }

    /// The thickness at which three conditions stop contradicting each other: zero if they never do, `None` if they
    /// do up to 2.
    fn root(&self, contacts: &[JointContact; 3]) -> Option<T> {
        let like = self.half_opening.int(0);
        // Both faces of one joint contradict nothing.
        if contacts.contains(&(Contact::Extrados, contacts[1].1)) {
            return Some(like);
        }
        let joints = Joints::in_thickness(self.weight, self.grip.clone(), DEGREE);
        let row = |(contact, index)| joints.row_at(contact, self.angle(index), DEGREE);
        let polynomial = combination(&contacts.map(row));
        if polynomial.at(&like) <= like {
            return Some(like);
        }
        let (mut low, mut high) = (like.clone(), like.int(2));
        if polynomial.at(&high) > like {
            return None;
        }
        // Newton's method from above, halved where it leaves what is known: a thin arch has its root near zero.
        let (mut x, mut last) = (high.clone(), i64::MAX);
        for _ in 0..20 * self.bits {
            let at = polynomial.at(&x);
            match at > like {
                true => low = x.clone(),
                false => high = x.clone(),
            }
            let step = at / slope(&polynomial, &x);
            let newton = x.clone() - &step;
            let size = step.exponent();
            let is_short = |by: i64| size.saturating_add(by) <= x.exponent();
            // A short step that is no shorter than the one before is rounding too.
            if is_short(i64::from(x.bits()) - 2) || is_short(SHORT) && size >= last {
                return Some(x);
            }
            last = size;
            x = match newton > low && newton < high {
                true => newton,
                false => (low.clone() + &high) / like.int(2),
            };
            if x == low || x == high {
                break;
            }
        }
        Some(high)
    }
}

/// The slope of a polynomial.
fn slope<T: Real>(of: &Jet<T>, x: &T) -> T {
    let terms = of.coefficients().iter().enumerate().skip(1).rev();
    terms.fold(x.int(0), |sum, (k, term)| sum * x + term.int(k as i32) * term)
}

/// Place where a function that rises and then falls is largest.
pub(super) fn peak<V: PartialOrd>(mut first: u64, mut last: u64, value: impl Fn(u64) -> V) -> u64 {
    while first < last {
        let middle = first + (last - first) / 2;
        match value(middle) < value(middle + 1) {
            true => first = middle + 1,
            false => last = middle,
        }
    }
    first
}
