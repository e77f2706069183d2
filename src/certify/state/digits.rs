//! The digits of a proved state: the precision is raised until all are decided.

use super::assess::{Assessment, Limit, Wanted};
use super::choice::{Fall, Frictions, State};
use super::inquiry::Inquiry;
use super::question::{Arch, Attempt, Doubt};
use crate::number::{Ball, Binary, ExactNumber, Rounded, bits_of};
use crate::problem::Mode;
use rug::Rational;

/// A proved state with its digits, or why nothing stands.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The arch stands from a least thickness on.
    Stands(Box<Digits>),
    /// It does not stand at any thickness up to the physical limit.
    Falls(Fall),
}

/// A proved value: decimal digits with bounds, and the nearest double.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Figure {
    /// Correctly rounded, with outward bounds.
    pub decimal: Rounded,
    /// The correctly rounded double.
    pub double: f64,
    /// What that double leaves open.
    pub binary: Binary,
}

/// The values of a proved state, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Digits {
    /// How it collapses.
    pub mode: Mode,
    /// `eta`.
    pub thickness: Figure,
    /// `h`.
    pub thrust: Figure,
    /// `eta h`.
    pub intrinsic_thrust: Figure,
    /// `beta_r`, rad.
    pub rotation_joint: Figure,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<Figure>,
    /// The frictions at which the mode changes, if they are asked for.
    pub frictions: Option<Frictions<Figure>>,
}

/// The precision is doubled up to this many bits, and at least twice, before a comparison or a rounding
/// counts as undecided.
const ENOUGH: u32 = 8192;
/// Bits beyond the digits asked for, at the first attempt.
pub(super) const GUARD: u32 = 48;

/// What is certain of an arch of a given thickness, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AssessmentDigits {
    /// Whether it stands.
    pub stands: bool,
    /// The least thickness, or why there is none.
    pub least_thickness: Result<Figure, Fall>,
    /// The thickness over the least thickness.
    pub geometric_safety: Option<Figure>,
    /// The least friction with which it stands; `None` if none is enough.
    pub required_friction: Option<Figure>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Option<Figure>,
    /// The least and the largest admissible thrust, if it stands.
    pub thrust: Option<[LimitDigits; 2]>,
}

/// An end of the range of admissible thrusts, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LimitDigits {
    /// The thrust; `None` if there is no bound.
    pub thrust: Option<Figure>,
    /// What limits it.
    pub limited_by: &'static str,
    /// The joint that limits it, where it is not at an end of the half arch.
    pub joint: Option<Figure>,
}

impl Arch {
    /// Proves the state and rounds it to `digits` significant digits, raising the precision until
    /// every comparison and every rounding is decided. `digits` is at least one. The doubt that stays
    /// is the answer otherwise: the query lies on a boundary, or nearer to one than 8192 bits or four
    /// times those of the digits can tell.
    pub fn certify(&self, digits: usize) -> Result<Answer, Doubt> {
        Inquiry::new(self, digits, true).state(digits, true)
    }

    /// The same without the frictions at which the mode changes: nothing is evaluated that the proof of
    /// the state does not need.
    pub fn certify_alone(&self, digits: usize) -> Result<Answer, Doubt> {
        Inquiry::new(self, digits, false).state(digits, false)
    }

    /// Proves what holds for the arch with a given thickness `t/r` in `(0, 2)`, in the same way; any other
    /// thickness is a doubt.
    pub fn certify_thickness(
        &self,
        thickness: &ExactNumber,
        digits: usize,
    ) -> Result<AssessmentDigits, Doubt> {
        Inquiry::new(self, digits, false).assess(thickness, digits, Wanted::Everything)
    }

    /// What a proof of the state finds, with more bits until it does; the doubt that stays otherwise.
    pub(crate) fn raised<T>(
        &self,
        digits: usize,
        proof: impl Fn(u32) -> Attempt<Option<T>>,
    ) -> Result<T, Doubt> {
        let first = bits_of(digits) + GUARD;
        let lost = if self.is_small(first) { 0 } else { self.bits_lost() };
        raised(first + lost, proof)
    }
}

/// A proof that decides everything: `first` bits, and twice as many until they are enough.
pub(super) fn raised<T>(
    first: u32,
    mut proof: impl FnMut(u32) -> Attempt<Option<T>>,
) -> Result<T, Doubt> {
    let mut bits = first;
    let rounding = || Doubt { question: "the rounding", between: Vec::new(), gap: f64::NAN };
    let mut last = rounding();
    while bits <= ENOUGH.max(4 * first) {
        match proof(bits) {
            Ok(Some(answer)) => return Ok(answer),
            Ok(None) => last = rounding(),
            Err(doubt) => last = doubt,
        }
        bits *= 2;
    }
    Err(last)
}

impl Assessment {
    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn digits(&self, digits: usize) -> Option<AssessmentDigits> {
        let optional = |x: Option<&Ball>| match x {
            Some(x) => Figure::new(x, digits).map(Some),
            None => Some(None),
        };
        let limit = |limit: &Limit| {
            Some(LimitDigits {
                thrust: optional(limit.thrust.as_ref())?,
                limited_by: limit.touch.name(),
                joint: optional(limit.touch.joint())?,
            })
        };
        Some(AssessmentDigits {
            stands: self.stands,
            least_thickness: match &self.least_thickness {
                Ok(least) => Ok(Figure::new(least, digits)?),
                Err(fall) => Err(*fall),
            },
            geometric_safety: optional(self.geometric_safety.as_ref())?,
            required_friction: optional(self.required_friction.as_ref())?,
            friction_safety: optional(self.friction_safety.as_ref())?,
            thrust: match &self.thrust {
                Some([least, largest]) => Some([limit(least)?, limit(largest)?]),
                None => None,
            },
        })
    }
}

impl Figure {
    /// The value of a ball to `digits` significant digits, at least one; `None` if the ball is too wide to
    /// decide them or the double.
    pub fn new(x: &Ball, digits: usize) -> Option<Self> {
        let decimal = match x.mid().is_zero() && x.rad().is_zero() {
            true => Rounded::from_rational(&Rational::new(), digits)?,
            false => Rounded::from_ball(x, digits)?,
        };
        let double = x.nearest_double()?;
        Some(Self { decimal, double, binary: Binary::new(x, double) })
    }
}

impl State {
    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn digits(&self, digits: usize) -> Option<Digits> {
        let rounded = |x: &Ball| Figure::new(x, digits);
        let optional = |x: &Option<Ball>| match x {
            Some(x) => rounded(x).map(Some),
            None => Some(None),
        };
        Some(Digits {
            mode: self.mode,
            thickness: rounded(&self.thickness)?,
            thrust: rounded(&self.thrust)?,
            intrinsic_thrust: rounded(&(self.thickness.clone() * &self.thrust))?,
            rotation_joint: rounded(&self.rotation_joint)?,
            sliding_joint: optional(&self.sliding_joint)?,
            frictions: match &self.frictions {
                Some(Frictions { sliding, rotational }) => Some(Frictions {
                    sliding: rounded(sliding)?,
                    rotational: optional(rotational)?,
                }),
                None => None,
            },
        })
    }
}
