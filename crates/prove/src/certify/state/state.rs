//! Certain answers about an arch: enclosures, all proved.

use crate::arch::{Configuration, Unknown};
use crate::number::Ball;
use crate::problem::Mode;

/// Certain answer about an arch.
#[derive(Clone, Debug)]
pub enum Outcome<T = Ball> {
    /// The arch stands from a least thickness on.
    Stands(Box<State<T>>),
    /// The arch does not stand at any thickness up to the physical limit 2.
    Falls(Fall),
}

impl<T> Outcome<T> {
    /// Maps the values to other numbers.
    pub(super) fn map<U>(self, f: impl Fn(T) -> U) -> Outcome<U> {
        match self {
            Self::Stands(state) => Outcome::Stands(Box::new(state.map(f))),
            Self::Falls(fall) => Outcome::Falls(fall),
        }
    }
}

/// Reason why no thickness is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fall {
    /// The friction is below that of the purely sliding state.
    Sliding,
    /// The arch would have to be thicker than twice the radius.
    Thickness,
}

impl Fall {
    /// The reason in words.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Sliding => "it slides: the friction is below that of the purely sliding state",
            Self::Thickness => "it would have to be thicker than twice its radius",
        }
    }
}

/// The state at the least thickness: enclosures, all proved.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct State<T = Ball> {
    /// Mode of its collapse.
    pub mode: Mode,
    /// `eta`.
    pub thickness: T,
    /// `h`.
    pub thrust: T,
    /// `beta_r`, rad; exactly zero at the crown.
    pub rotation_joint: T,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<T>,
    /// The frictions at which the mode changes, if they are asked for.
    pub frictions: Option<Frictions<T>>,
}

/// The frictions between which a half opening has states that slide.
#[derive(Clone, Debug)]
pub struct Frictions<T> {
    /// The friction below which nothing stands.
    pub sliding: T,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational: Option<T>,
}

impl<T> State<T> {
    /// A state without the frictions at which its mode changes.
    pub(super) fn new(mode: Mode, at: Configuration<T>) -> Self {
        Self {
            mode,
            thickness: at.thickness,
            thrust: at.thrust,
            rotation_joint: at.rotation_joint.rad,
            sliding_joint: mode.slides_inside().then_some(at.sliding_joint.rad),
            frictions: None,
        }
    }

    fn map<U>(self, f: impl Fn(T) -> U) -> State<U> {
        State {
            mode: self.mode,
            thickness: f(self.thickness),
            thrust: f(self.thrust),
            rotation_joint: f(self.rotation_joint),
            sliding_joint: self.sliding_joint.map(&f),
            frictions: self.frictions.map(|Frictions { sliding, rotational }| Frictions {
                sliding: f(sliding),
                rotational: rotational.map(&f),
            }),
        }
    }

    /// The value of a variable that is solved for, where the state has it.
    pub fn value(&self, unknown: Unknown) -> Option<&T> {
        match unknown {
            Unknown::RotationJoint => Some(&self.rotation_joint),
            Unknown::SlidingJoint => self.sliding_joint.as_ref(),
            Unknown::Thickness => Some(&self.thickness),
            Unknown::Thrust => Some(&self.thrust),
            _ => None,
        }
    }
}
