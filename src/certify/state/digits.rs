//! The digits of a proved state, and of an arch of a given thickness.

use super::assess::Assessment;
use super::figure::Figure;
use super::state::{Fall, Frictions, State};
use super::thrust_range::Limit;
use crate::number::Ball;
use crate::problem::{Mode, Quantity};

/// A proved state with its digits, or why nothing stands.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The arch stands from a least thickness on.
    Stands(Box<Digits>),
    /// It does not stand at any thickness up to the physical limit.
    Falls(Fall),
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
    pub(super) fn new(state: &State, digits: usize) -> Option<Self> {
        let rounded = |x: &Ball| Figure::new(x, digits);
        let optional = |x: &Option<Ball>| match x {
            Some(x) => rounded(x).map(Some),
            None => Some(None),
        };
        Some(Self {
            mode: state.mode,
            thickness: rounded(&state.thickness)?,
            thrust: rounded(&state.thrust)?,
            intrinsic_thrust: rounded(&(state.thickness.clone() * &state.thrust))?,
            rotation_joint: rounded(&state.rotation_joint)?,
            sliding_joint: optional(&state.sliding_joint)?,
            frictions: match &state.frictions {
                Some(Frictions { sliding, rotational }) => Some(Frictions {
                    sliding: rounded(sliding)?,
                    rotational: optional(rotational)?,
                }),
                None => None,
            },
        })
    }
}

impl AssessmentDigits {
    /// The values that there are, in the order of [`Quantity::ASSESSMENT`] and each limiting joint behind its
    /// thrust; `None` for a thrust without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&Figure>)> {
        let least = self.least_thickness.as_ref().ok();
        let single = [
            (Quantity::LeastThickness, least),
            (Quantity::GeometricSafety, self.geometric_safety.as_ref()),
            (Quantity::RequiredFriction, self.required_friction.as_ref()),
            (Quantity::FrictionSafety, self.friction_safety.as_ref()),
        ];
        let single = single.into_iter().filter(|(_, figure)| figure.is_some());
        let thrusts = [Quantity::LeastThrust, Quantity::LargestThrust];
        let limits = thrusts.into_iter().zip(self.thrust.iter().flatten());
        single.chain(limits.flat_map(|(thrust, limit)| {
            let joint = thrust.joint().zip(limit.joint.as_ref());
            let joint = joint.map(|(joint, figure)| (joint, Some(figure)));
            std::iter::once((thrust, limit.thrust.as_ref())).chain(joint)
        }))
    }

    /// Every value rounded to `digits` significant digits, if the enclosures decide all of them.
    pub(super) fn new(assessment: &Assessment, digits: usize) -> Option<Self> {
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
        Some(Self {
            stands: assessment.stands,
            least_thickness: match &assessment.least_thickness {
                Ok(least) => Ok(Figure::new(least, digits)?),
                Err(fall) => Err(*fall),
            },
            geometric_safety: optional(assessment.geometric_safety.as_ref())?,
            required_friction: optional(assessment.required_friction.as_ref())?,
            friction_safety: optional(assessment.friction_safety.as_ref())?,
            thrust: match &assessment.thrust {
                Some([least, largest]) => Some([limit(least)?, limit(largest)?]),
                None => None,
            },
        })
    }
}
