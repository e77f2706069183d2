//! The joints of an arch of voussoirs in balls, and the conditions there.

use crate::arch::joint::{Grip, Row};
use crate::arch::{Ring, SelfWeight};
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Jet};
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Friction, slides_at_no_thrust};
use crate::solve::voussoirs::{DEGREE, Search};
use rug::Float;

/// An arch of voussoirs in balls of some bits.
pub(super) struct Joints<'a> {
    pub stones: &'a Stones,
    pub weight: SelfWeight,
    pub grip: Grip<Ball>,
    pub bits: u32,
    pub is_limited: bool,
    /// The friction that the grip is of; `None` for one that is no given number.
    pub friction: Option<Friction>,
}

impl<'a> Joints<'a> {
    /// The joints between these stones, with numbers of `bits` bits.
    pub(super) fn new(
        stones: &'a Stones,
        weight: SelfWeight,
        friction: &Friction,
        bits: u32,
    ) -> Self {
        let is_limited = *friction != Friction::Infinite;
        let given = Some(friction.clone());
        Self { stones, weight, grip: grip(friction, bits), bits, is_limited, friction: given }
    }

    /// Where to look for candidates.
    pub(super) fn search(&self) -> Search<'a> {
        Search::new(self.stones, self.weight, self.grip.clone().map(midpoint), self.bits)
    }

    /// A joint by its index.
    pub(super) fn angle(&self, index: u64) -> Angle<Ball> {
        let crown = index == 0 && self.stones.has_joint_at_crown();
        let like = Ball::integer(0, self.bits);
        if crown { Angle::zero(&like) } else { Angle::new(self.stones.joint(index, self.bits)) }
    }

    /// The same rounded; a rational joint may be a tie, which no ball decides.
    pub(super) fn figure(&self, index: u64, digits: usize) -> Option<Figure> {
        match self.stones.exact_joint(index) {
            Some(exact) => Figure::exact(&exact, digits),
            None => Figure::new(&self.angle(index).rad, digits),
        }
    }

    /// The index of the shoulder.
    pub(super) fn last(&self) -> u64 {
        self.stones.count() - 1
    }

    /// The conditions as polynomials in the thickness.
    pub(super) fn polynomial_rows(&self, contacts: &[JointContact; 3]) -> [Row<Jet<Ball>>; 3] {
        let like = Ball::integer(0, self.bits);
        let thickness = Jet::new(vec![like.clone(), like.int(1)], DEGREE);
        let ring = Ring::new(self.weight, &thickness);
        let grip = self.grip.clone().map(|x| Jet::constant(x, DEGREE));
        contacts.map(|contact| {
            let angle = self.angle(contact.1).map(|x| Jet::constant(x, DEGREE));
            contact.0.row(&angle, &ring, &grip)
        })
    }

    /// A condition at a thickness. The load of a slip is exactly zero where the joint slides at no thrust, which no ball tells.
    pub(super) fn row(&self, contact: JointContact, ring: &Ring<Ball>) -> Row<Ball> {
        let row = contact.0.row(&self.angle(contact.1), ring, &self.grip);
        let is_given = |friction| slides_at_no_thrust(self.stones, friction, contact);
        match self.friction.as_ref().is_some_and(is_given) {
            true => Row { load: row.load.int(0), ..row },
            false => row,
        }
    }
}

fn midpoint(x: Ball) -> Float {
    Float::with_val(x.prec(), x.mid())
}

/// Friction as the ratio that a joint asks for.
pub(in crate::certify) fn grip(friction: &Friction, bits: u32) -> Grip<Ball> {
    let number = |x: &ExactNumber| x.enclosure::<Ball>(bits);
    let one = Ball::integer(1, bits);
    match friction {
        Friction::Coefficient(mu) => Grip { shear: one, normal: number(mu) },
        Friction::Angle(phi) => {
            let angle = Angle::new(number(phi));
            Grip { shear: angle.cos, normal: angle.sin }
        }
        Friction::Infinite => Grip { shear: one.int(0), normal: one },
    }
}

/// A statement that has to be proved.
pub(super) fn require(is_proved: bool, question: &'static str) -> Result<(), Undecided> {
    if is_proved { Ok(()) } else { Err(Undecided::new(question)) }
}

/// Of two conditions that are free of the crown moment the first asks for a larger thrust than the second allows.
pub(super) fn leave_no_thrust([least, most]: [&Row<Ball>; 2]) -> Result<(), Undecided> {
    require(is_positive(&-least.thrust.clone()), "whether the thrust is bounded from below")?;
    require(is_positive(&most.thrust), "whether the thrust is bounded from above")?;
    // The two, each times the other's coefficient.
    let sum = least.load.clone() * &most.thrust - least.thrust.clone() * &most.load;
    require(is_positive(&sum), "whether no thrust is admissible")
}

/// Whether it is zero exactly.
pub(super) fn is_zero(x: &Ball) -> bool {
    x.mid().is_zero() && x.rad().is_zero()
}

/// Whether it is.
pub(super) fn is_positive(x: &Ball) -> bool {
    x.is_positive().is_proved()
}
