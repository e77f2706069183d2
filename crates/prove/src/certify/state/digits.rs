//! The digits of a proved state, and of an arch of a given thickness.

use super::enough::Enough;
use super::state::{Fall, Frictions, State};
use crate::problem::{Mode, Quantity};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::figure::{Figure, Figured, optional};
use std::fmt;

impl fmt::Display for Digits {
    /// The mode and the values, on a line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.mode)?;
        self.figures().try_for_each(|(of, figure)| match figure {
            Some(figure) => write!(f, ", {of} {figure}"),
            None => write!(f, ", {of} inf"),
        })
    }
}

impl fmt::Display for Answer {
    /// The state, or why there is none.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stands(state) => state.fmt(f),
            Self::Falls { fall, .. } => write!(f, "stands at no thickness: {}", fall.reason()),
        }
    }
}

/// A proved state with its digits, or why nothing stands.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The arch stands from a least thickness on.
    Stands(Box<Digits>),
    /// The arch does not stand at any thickness up to the physical limit.
    Falls {
        /// Reason why it falls.
        fall: Fall,
        /// Remedies that would be enough, if the frictions at which the mode changes are asked for.
        enough: Option<Box<Enough>>,
    },
}

/// The values of a proved state, correctly rounded or as other numbers.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Digits<T = Figure> {
    /// Mode of its collapse.
    pub mode: Mode,
    /// `eta`.
    pub thickness: T,
    /// `h`.
    pub thrust: T,
    /// `eta h`.
    pub intrinsic_thrust: T,
    /// `beta_r`, rad.
    pub rotation_joint: T,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<T>,
    /// The frictions at which the mode changes, if they are asked for.
    pub frictions: Option<Frictions<T>>,
}

impl<T> Digits<T> {
    /// The value of a quantity of [`Quantity::STATE`], where the state has it.
    ///
    /// ```
    /// use couplet_prove::prelude::*;
    /// let state = Arch::parse("milankovitch", "80deg", "0.6")?.least(17)?;
    /// assert_eq!(state.get(Quantity::Thrust).unwrap().to_string(), "0.69680832880605749");
    /// assert_eq!(state.get("beta_r".parse()?).unwrap().double, 0.8718805531713881);
    /// assert!(state.get(Quantity::SlidingJoint).is_none(), "no inner joint slides");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn get(&self, quantity: Quantity) -> Option<&T> {
        self.figures().find(|(of, _)| *of == quantity)?.1
    }

    /// The values that there are, in the order of [`Quantity::STATE`]; `None` for a friction without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&T>)> {
        let joint = self.sliding_joint.as_ref();
        let frictions = self.frictions.as_ref();
        [
            Some((Quantity::Thickness, Some(&self.thickness))),
            Some((Quantity::Thrust, Some(&self.thrust))),
            Some((Quantity::IntrinsicThrust, Some(&self.intrinsic_thrust))),
            Some((Quantity::RotationJoint, Some(&self.rotation_joint))),
            joint.map(|joint| (Quantity::SlidingJoint, Some(joint))),
            frictions.map(|both| (Quantity::SlidingFriction, Some(&both.sliding))),
            frictions.map(|both| (Quantity::RotationalFriction, both.rotational.as_ref())),
        ]
        .into_iter()
        .flatten()
    }
}

impl Digits {
    /// Every value of a state rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn new<E: Arithmetic + Figured>(state: &State<E>, digits: usize) -> Option<Self> {
        let values = Digits {
            mode: state.mode,
            thickness: &state.thickness,
            thrust: &state.thrust,
            intrinsic_thrust: &(state.thickness.clone() * &state.thrust),
            rotation_joint: &state.rotation_joint,
            sliding_joint: state.sliding_joint.as_ref(),
            frictions: state.frictions.as_ref().map(|both| Frictions {
                sliding: &both.sliding,
                rotational: both.rotational.as_ref(),
            }),
        };
        values.rounded(digits)
    }
}

impl<E> Digits<&E> {
    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn rounded(&self, digits: usize) -> Option<Digits>
    where
        E: Figured,
    {
        let rounded = |x: &E| x.figure(digits);
        Some(Digits {
            mode: self.mode,
            thickness: rounded(self.thickness)?,
            thrust: rounded(self.thrust)?,
            intrinsic_thrust: rounded(self.intrinsic_thrust)?,
            rotation_joint: rounded(self.rotation_joint)?,
            sliding_joint: optional(self.sliding_joint, rounded)?,
            frictions: optional(self.frictions.as_ref(), |both| {
                let rotational = optional(both.rotational, rounded)?;
                Some(Frictions { sliding: rounded(both.sliding)?, rotational })
            })?,
        })
    }
}
