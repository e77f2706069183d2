//! The digits of a proved state: the precision is raised until all are decided.

use super::choice::{Fall, Outcome, State};
use super::question::{Arch, Doubt};
use crate::arch::Mode;
use crate::number::{Ball, Rounded};
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
pub struct Figure {
    /// Correctly rounded, with outward bounds.
    pub decimal: Rounded,
    /// The correctly rounded double.
    pub double: f64,
}

/// The values of a proved state, correctly rounded.
#[derive(Clone, Debug)]
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
    /// The friction below which nothing stands at this half opening.
    pub sliding_friction: Figure,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational_friction: Option<Figure>,
}

/// How often the precision is doubled before a comparison or a rounding counts as undecided.
const ATTEMPTS: u32 = 6;
/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 48;

impl Arch {
    /// Proves the state and rounds it to `digits` significant digits, raising the precision until
    /// every comparison and every rounding is decided. The doubt that stays is the answer otherwise.
    pub fn certify(&self, digits: usize) -> Result<Answer, Doubt> {
        let wanted = (digits as f64 * std::f64::consts::LOG2_10).ceil() as u32;
        let mut bits = wanted + GUARD + self.bits_lost();
        let mut last = None;
        for _ in 0..ATTEMPTS {
            match self.state(bits) {
                Ok(Outcome::Falls(fall)) => return Ok(Answer::Falls(fall)),
                Ok(Outcome::Stands(state)) => match state.digits(digits) {
                    Some(digits) => return Ok(Answer::Stands(Box::new(digits))),
                    None => last = None,
                },
                Err(doubt) => last = Some(doubt),
            }
            bits *= 2;
        }
        Err(last.unwrap_or(Doubt { question: "the rounding", between: Vec::new(), gap: f64::NAN }))
    }
}

impl Figure {
    /// The value of a ball, if the ball decides it.
    pub fn new(x: &Ball, digits: usize) -> Option<Self> {
        let decimal = match x.mid().is_zero() && x.rad().is_zero() {
            true => Rounded::from_rational(&Rational::new(), digits)?,
            false => Rounded::from_ball(x, digits)?,
        };
        Some(Self { decimal, double: x.nearest_double()? })
    }
}

impl State {
    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    fn digits(&self, digits: usize) -> Option<Digits> {
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
            sliding_friction: rounded(&self.sliding_friction)?,
            rotational_friction: optional(&self.rotational_friction)?,
        })
    }
}
