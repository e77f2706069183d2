//! The digits of a proved state, and of an arch of a given thickness.

use super::assess::Assessment;
use super::enough::Enough;
use super::state::{Fall, Frictions, State};
use super::thrust_range::Limit;
use crate::problem::{Mode, Quantity};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::figure::{Figure, Figured};

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

/// Certain answers about an arch of a given thickness, correctly rounded; each answer with a reason where it
/// stays open.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct AssessmentDigits {
    /// Tells whether the arch stands.
    pub stands: Result<bool, Undecided>,
    /// Reason why no thickness is enough, if none is.
    pub fall: Option<Fall>,
    /// The least thickness; `None` if there is none.
    pub least_thickness: Result<Option<Figure>, Undecided>,
    /// The thickness over the least thickness.
    pub geometric_safety: Result<Option<Figure>, Undecided>,
    /// The least friction with which it stands; `None` if none is enough.
    pub required_friction: Result<Option<Figure>, Undecided>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Result<Option<Figure>, Undecided>,
    /// The least and the largest admissible thrust, if it stands.
    pub thrust: [Result<Option<LimitDigits>, Undecided>; 2],
}

/// An end of the range of admissible thrusts, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LimitDigits {
    /// The thrust; `None` if there is no bound.
    pub thrust: Option<Figure>,
    /// Name of the limit.
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
    pub(super) fn new<E: Arithmetic + Figured>(state: &State<E>, digits: usize) -> Option<Self> {
        let rounded = |x: &E| x.figure(digits);
        let optional = |x: &Option<E>| match x {
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

/// The quantities of a thickness and a friction, in the order of their fields.
const SINGLE: [Quantity; 4] = [
    Quantity::LeastThickness,
    Quantity::GeometricSafety,
    Quantity::RequiredFriction,
    Quantity::FrictionSafety,
];
/// The ends of the range of thrusts.
const THRUSTS: [Quantity; 2] = [Quantity::LeastThrust, Quantity::LargestThrust];

impl AssessmentDigits {
    fn single(&self) -> [&Result<Option<Figure>, Undecided>; 4] {
        let Self { least_thickness, geometric_safety, required_friction, friction_safety, .. } =
            self;
        [least_thickness, geometric_safety, required_friction, friction_safety]
    }

    /// The values that there are, in the order of [`Quantity::ASSESSMENT`] and each limiting joint behind its
    /// thrust; `None` for a thrust or a safety without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&Figure>)> {
        let single = SINGLE.into_iter().zip(self.single());
        let single = single.filter_map(|(of, figure)| Some((of, figure.as_ref().ok()?.as_ref())));
        let single = single.filter(|(of, figure)| {
            figure.is_some() || *of == Quantity::FrictionSafety && self.is_safe_from_sliding()
        });
        single.chain(THRUSTS.into_iter().zip(self.limits()).flat_map(|(thrust, limit)| {
            let joint = limit.and_then(|limit| thrust.joint().zip(limit.joint.as_ref()));
            let joint = joint.map(|(joint, figure)| (joint, Some(figure)));
            limit.map(|limit| (thrust, limit.thrust.as_ref())).into_iter().chain(joint)
        }))
    }

    /// Tells whether the arch stands and nothing slides: some friction is required, and it is unlimited.
    fn is_safe_from_sliding(&self) -> bool {
        let Self { stands, required_friction, friction_safety, .. } = self;
        let is_required = !matches!(required_friction, Ok(None));
        *stands == Ok(true) && is_required && matches!(friction_safety, Ok(None))
    }

    /// The ends of the range of thrusts, where they are known and the arch stands.
    pub fn limits(&self) -> [Option<&LimitDigits>; 2] {
        self.thrust.each_ref().map(|limit| limit.as_ref().ok()?.as_ref())
    }

    /// The quantities that stay open, and why.
    pub fn open(&self) -> impl Iterator<Item = (Quantity, &Undecided)> {
        let single = SINGLE.into_iter().zip(self.single());
        let single = single.filter_map(|(of, figure)| Some((of, figure.as_ref().err()?)));
        let thrusts = THRUSTS.into_iter().zip(&self.thrust);
        single.chain(thrusts.filter_map(|(of, limit)| Some((of, limit.as_ref().err()?))))
    }

    /// Reason why not everything is decided, where it is not.
    pub(super) fn first_open(&self) -> Option<&Undecided> {
        self.stands.as_ref().err().or_else(|| self.open().next().map(|(_, undecided)| undecided))
    }

    /// Every value rounded to `digits` significant digits; one that the enclosures, of `bits` bits, do not decide
    /// is open.
    pub(super) fn new<E: Figured>(assessment: Assessment<E>, (digits, bits): (usize, u32)) -> Self {
        let at = |open: Undecided| open.at(bits);
        let rounding = || Undecided::rounding("the rounding");
        let round = |x: &E| x.figure(digits).ok_or_else(rounding);
        let rounded = |x: Result<Option<E>, Undecided>| {
            x.and_then(|x| x.as_ref().map(round).transpose()).map_err(at)
        };
        let limit = |limit: Limit<E>| {
            Ok(LimitDigits {
                thrust: limit.thrust.as_ref().map(round).transpose()?,
                limited_by: limit.touch.name(),
                joint: limit.touch.joint().map(round).transpose()?,
            })
        };
        Self {
            stands: assessment.stands.map_err(at),
            fall: assessment.fall,
            least_thickness: rounded(assessment.least_thickness),
            geometric_safety: rounded(assessment.geometric_safety),
            required_friction: rounded(assessment.required_friction),
            friction_safety: rounded(assessment.friction_safety),
            thrust: assessment
                .thrust
                .map(|end| end.and_then(|end| end.map(limit).transpose()).map_err(at)),
        }
    }

    /// Assessment completed with what another precision has decided where this one has not.
    pub(super) fn or(self, other: Self) -> Self {
        let [[least, largest], [other_least, other_largest]] = [self.thrust, other.thrust];
        Self {
            stands: self.stands.or(other.stands),
            fall: self.fall.or(other.fall),
            least_thickness: self.least_thickness.or(other.least_thickness),
            geometric_safety: self.geometric_safety.or(other.geometric_safety),
            required_friction: self.required_friction.or(other.required_friction),
            friction_safety: self.friction_safety.or(other.friction_safety),
            thrust: [least.or(other_least), largest.or(other_largest)],
        }
    }
}
