//! The joints of an arch of voussoirs in balls, and the conditions there.

use crate::arch::joint::{Grip, Row};
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Ball, Field, Jet};
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Friction, Joints};
use crate::prover::decide::{ensure, is_positive};
use crate::prover::ties::slides_at_no_thrust;
use crate::prover::{Figure, Undecided};
use crate::solve::voussoir_thrust::Searches;
use crate::solve::voussoirs::{DEGREE, Search};
use rug::Float;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Bits in which signs are nearly always decided.
const FEW: u32 = 256;

/// The joints of an arch with their sines and cosines, which cost most of a proof: each is computed once.
pub(super) struct StoneAngles<'a> {
    pub stones: &'a Stones,
    known: RefCell<BTreeMap<(u64, u32), Angle<Ball>>>,
}

impl<'a> StoneAngles<'a> {
    /// Joints of which no angle is known.
    pub(super) fn new(stones: &'a Stones) -> Self {
        Self { stones, known: RefCell::default() }
    }

    /// A joint by its index, in numbers of `bits` bits.
    fn at(&self, index: u64, bits: u32) -> Angle<Ball> {
        let mut known = self.known.borrow_mut();
        known.entry((index, bits)).or_insert_with(|| self.stones.angle(index, bits)).clone()
    }
}

/// An arch of voussoirs in balls of some bits.
#[derive(Clone)]
pub(super) struct StoneJoints<'a> {
    pub stones: &'a Stones,
    pub angles: &'a StoneAngles<'a>,
    pub weight: SelfWeight,
    pub grip: Grip<Ball>,
    pub bits: u32,
    /// The friction that the grip is of; `None` for one that is no given number.
    pub friction: Option<Friction>,
}

impl<'a> StoneJoints<'a> {
    /// The joints between these stones, with numbers of `bits` bits.
    pub(super) fn new(
        angles: &'a StoneAngles<'a>,
        weight: SelfWeight,
        friction: &Friction,
        bits: u32,
    ) -> Self {
        let (stones, friction) = (angles.stones, friction.clone());
        Self { stones, angles, weight, grip: friction.grip(bits), bits, friction: Some(friction) }
    }

    /// Arch in balls of few bits, which tell most signs; `None` if these have no more.
    pub(super) fn in_few(&self) -> Option<Self> {
        let grip = self.grip.clone().map(|x| x.with_precision(FEW));
        (self.bits > FEW).then(|| Self { grip, bits: FEW, ..self.clone() })
    }

    /// True if the friction has a limit.
    pub(super) fn is_limited(&self) -> bool {
        self.friction != Some(Friction::Infinite)
    }

    /// The proof of what a search for candidates finds in doubles, or else in all bits.
    pub(super) fn searched<T>(
        &self,
        proof: impl Fn(&dyn Searches) -> Result<T, Undecided>,
    ) -> Result<T, Undecided> {
        let (arch, bits) = ((self.stones, self.weight, &self.grip), self.bits);
        let in_full = |x: &Ball| Float::with_val(bits, x.mid());
        proof(&Search::new(arch, bits, &|x: &Ball| x.mid().to_f64()))
            .or_else(|_| proof(&Search::new(arch, bits, &in_full)))
    }

    /// A joint by its index.
    pub(super) fn angle(&self, index: u64) -> Angle<Ball> {
        self.angles.at(index, self.bits)
    }

    /// The last of equal stones' joints that seems to be before an angle; any will do, and none is proved.
    pub(super) fn near(&self, angle: f64) -> u64 {
        let stones = self.stones.number();
        let parts = angle / self.angle(self.last()).rad.mid().to_f64() * stones as f64;
        ((parts - (stones % 2) as f64) / 2.0) as u64
    }

    /// The angle of a joint rounded; a rational joint may be a tie, which no ball decides.
    pub(super) fn figure(&self, index: u64, digits: usize) -> Option<Figure> {
        match self.stones.exact_joint(index) {
            Some(exact) => Figure::exact(&exact, digits),
            None => Figure::new(&self.stones.joint(index, self.bits), digits),
        }
    }

    /// Tells whether a joint is open: it has no normal force, and no moment.
    pub(super) fn is_open(&self, contacts: &[JointContact], joint: u64) -> bool {
        let slides = |contact| contacts.contains(&(contact, joint));
        self.stones.may_open(joint, self.is_limited())
            && (slides(Contact::Inwards) || slides(Contact::Outwards) && !self.is_limited())
    }

    /// The index of the shoulder.
    pub(super) fn last(&self) -> u64 {
        self.stones.last()
    }

    /// The conditions as polynomials in the thickness.
    pub(super) fn polynomial_rows(&self, contacts: &[JointContact; 3]) -> [Row<Jet<Ball>>; 3] {
        let joints = Joints::in_thickness(self.weight, self.grip.clone(), DEGREE);
        contacts.map(|(contact, index)| joints.row_at(contact, self.angle(index), DEGREE))
    }

    /// A condition at a thickness. The load of a slip is exactly zero where the joint slides at no thrust, which no
    /// ball tells.
    pub(super) fn row(&self, contact: JointContact, ring: &Ring<Ball>) -> Row<Ball> {
        let row = contact.0.row(&self.angle(contact.1), ring, &self.grip);
        let is_given = |friction| slides_at_no_thrust(self.stones, friction, contact);
        match self.friction.as_ref().is_some_and(is_given) {
            true => Row { load: row.load.int(0), ..row },
            false => row,
        }
    }
}

/// Checks that of two conditions that are free of the crown moment the first asks for a larger thrust than
/// the second allows.
pub(super) fn leave_no_thrust([least, most]: [&Row<Ball>; 2]) -> Result<(), Undecided> {
    ensure(is_positive(&-least.thrust.clone()), "whether the thrust is bounded from below")?;
    ensure(is_positive(&most.thrust), "whether the thrust is bounded from above")?;
    // The two, each times the other's coefficient.
    let sum = least.load.clone() * &most.thrust - least.thrust.clone() * &most.load;
    ensure(is_positive(&sum), "whether no thrust is admissible")
}
