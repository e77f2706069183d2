//! The digits of a proved state, and of an arch of a given thickness.

use super::enough::Enough;
use super::state::{Fall, Frictions, State};
use crate::problem::{Mode, Quantity};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::figure::{Figure, Figured, optional};

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

/// The values of a proved state, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Digits {
    /// Mode of its collapse.
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

impl Digits {
    /// The values that there are, in the order of [`Quantity::STATE`]; `None` for a friction without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&Figure>)> {
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

    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn new<E: Arithmetic + Figured>(state: &State<E>, digits: usize) -> Option<Self> {
        let rounded = |x: &E| x.figure(digits);
        Some(Self {
            mode: state.mode,
            thickness: rounded(&state.thickness)?,
            thrust: rounded(&state.thrust)?,
            intrinsic_thrust: rounded(&(state.thickness.clone() * &state.thrust))?,
            rotation_joint: rounded(&state.rotation_joint)?,
            sliding_joint: optional(state.sliding_joint.as_ref(), rounded)?,
            frictions: optional(state.frictions.as_ref(), |both| {
                let rotational = optional(both.rotational.as_ref(), rounded)?;
                Some(Frictions { sliding: rounded(&both.sliding)?, rotational })
            })?,
        })
    }
}
