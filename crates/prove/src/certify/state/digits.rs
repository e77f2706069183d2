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

/// A proved state with its digits or with some of its values, or why nothing stands.
#[derive(Clone, Debug)]
pub enum Answer<S = Box<Digits>> {
    /// The arch stands from a least thickness on.
    Stands(S),
    /// The arch does not stand at any thickness up to the physical limit.
    Falls {
        /// Reason why it falls.
        fall: Fall,
        /// Remedies that would be enough, if the frictions at which the mode changes are asked for.
        enough: Option<Box<Enough>>,
    },
}

/// Some values of a proved state, in the order of [`Quantity::STATE`]; nothing for a friction without bound.
#[derive(Clone, Debug)]
pub struct SomeDigits {
    /// Mode of its collapse.
    pub mode: Mode,
    /// The values.
    pub values: Vec<(Quantity, Option<Figure>)>,
}

impl<S> Answer<S> {
    /// Answer with something else of an arch that stands.
    pub fn map<U>(self, of: impl FnOnce(S) -> U) -> Answer<U> {
        match self {
            Self::Stands(state) => Answer::Stands(of(state)),
            Self::Falls { fall, enough } => Answer::Falls { fall, enough },
        }
    }
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
        self.value(quantity)?
    }

    /// The value of a quantity, where the state has it; `None` for a friction without bound.
    #[inline(always)]
    pub(in crate::certify) fn value(&self, quantity: Quantity) -> Option<Option<&T>> {
        Some(Some(match quantity {
            Quantity::Thickness => &self.thickness,
            Quantity::Thrust => &self.thrust,
            Quantity::IntrinsicThrust => &self.intrinsic_thrust,
            Quantity::RotationJoint => &self.rotation_joint,
            Quantity::SlidingJoint => self.sliding_joint.as_ref()?,
            Quantity::SlidingFriction => &self.frictions.as_ref()?.sliding,
            Quantity::RotationalFriction => {
                return Some(self.frictions.as_ref()?.rotational.as_ref());
            }
            _ => return None,
        }))
    }

    /// The values that there are, in the order of [`Quantity::STATE`]; `None` for a friction without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&T>)> {
        Quantity::STATE.into_iter().filter_map(|of| Some((of, self.value(of)?)))
    }
}

impl Digits {
    /// Digits of those values that are shown.
    pub fn only(&self, shows: impl Fn(Quantity) -> bool) -> SomeDigits {
        let shown = self.figures().filter(|(of, _)| shows(*of));
        SomeDigits { mode: self.mode, values: shown.map(|(of, x)| (of, x.cloned())).collect() }
    }

    /// Every value of a state rounded to `digits` significant digits, if the enclosures decide all of them.
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

impl<E> Digits<&E> {
    /// The state that has these values.
    pub(super) fn enclosed(&self) -> State<E>
    where
        E: Clone,
    {
        let frictions = self.frictions.as_ref();
        State {
            mode: self.mode,
            thickness: self.thickness.clone(),
            thrust: self.thrust.clone(),
            rotation_joint: self.rotation_joint.clone(),
            sliding_joint: self.sliding_joint.cloned(),
            frictions: frictions.map(|both| Frictions {
                sliding: both.sliding.clone(),
                rotational: both.rotational.cloned(),
            }),
        }
    }

    /// Digits of those values that are shown, rounded to `digits` significant digits, if the enclosures decide them.
    pub(super) fn some_rounded(
        &self,
        digits: usize,
        shows: impl Fn(Quantity) -> bool,
    ) -> Option<SomeDigits>
    where
        E: Figured,
    {
        let shown = self.figures().filter(|(of, _)| shows(*of));
        let rounded = shown.map(|(of, x)| Some((of, optional(x, |x| x.figure(digits))?)));
        Some(SomeDigits { mode: self.mode, values: rounded.collect::<Option<_>>()? })
    }
}
