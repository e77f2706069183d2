//! The limits of the problem, and the problem at each distance from them.

use super::target::{LimitTarget, before, reference, rotational, sliding, state_target};
use crate::arch::Unknown;
use crate::problem::{Landmark, Mode};
use rug::{Float, Rational};

/// A limit with the problem at each distance from it.
#[non_exhaustive]
pub struct StudyLimit {
    /// A short name.
    pub name: &'static str,
    /// Description of the limit.
    pub words: &'static str,
    /// Value that is computed.
    pub output: &'static str,
    /// True if the limit is that of small half openings.
    pub(super) is_small: bool,
    /// The problem at the distance `10^-k`.
    pub(super) at: fn(&Rational) -> Option<LimitTarget>,
}

/// A limit of a name and of what is computed, and the problem at a distance.
const fn limit(
    name: &'static str,
    output: &'static str,
    at: fn(&Rational) -> Option<LimitTarget>,
) -> StudyLimit {
    StudyLimit { name, words: "", output, is_small: false, at }
}

impl StudyLimit {
    /// Says what happens there.
    const fn told(self, words: &'static str) -> Self {
        Self { words, ..self }
    }

    const fn of_small_openings(self) -> Self {
        Self { is_small: true, ..self }
    }
}

/// All limits.
pub const LIMITS: [StudyLimit; 8] = [
    limit("alpha-to-zero", "thickness", |x| rotational(x.clone(), Unknown::Thickness))
        .of_small_openings()
        .told("a tiny half opening: eta falls like alpha^4, h tends to 1"),
    limit("radicand-to-zero", "thickness", |x| {
        let joint = before(Landmark::WidestJoint, Unknown::RotationJoint, x)?;
        Some(LimitTarget::Closed { joint })
    })
    .told("a joint below that of sb, where two roots of the cubic meet"),
    limit("joint-to-crown", "rotation_joint", |x| {
        let alpha = before(Landmark::RotationEnd, Unknown::HalfOpening, x)?;
        rotational(alpha, Unknown::RotationJoint)
    })
    .told("a half opening below that of l: beta_r falls like the root of the distance"),
    limit("eta-to-two", "thickness", |x| Some(LimitTarget::Overturning { distance: x.clone() }))
        .told("overturning at A above 2/3: the square root in (15) tends to 0"),
    limit("mu-to-infinity", "thrust", |x| {
        let (alpha, friction) = (Rational::from((13, 5)), x.clone().recip());
        state_target(Mode::OverturningSliding, alpha, Some(friction), Unknown::Thrust)
    })
    .told("a large friction: an inner joint slides at a thrust like 1/(4 mu^2)"),
    limit("mu-to-zero", "friction", |x| sliding(x.clone()))
        .of_small_openings()
        .told("pure sliding of a tiny half opening: mu falls like alpha^3/12"),
    limit("alpha-to-pi", "friction", |x| {
        // pi to far more places than the distance has.
        let places = 60 + 4 * x.denom().significant_bits();
        let pi = Float::with_val(places, rug::float::Constant::Pi).to_rational()?;
        sliding(pi - x)
    })
    .told("pure sliding towards the full circle: mu grows without bound"),
    limit("next-to-T", "thickness", |x| {
        let zero = Rational::new();
        let alpha = before(Landmark::Triple, Unknown::HalfOpening, &zero)? + x;
        let friction = before(Landmark::Triple, Unknown::Friction, &zero)? + x.clone() * 10;
        let mode = reference(&alpha, Some(&friction))?.mode;
        state_target(mode, alpha, Some(friction), Unknown::Thickness)
    })
    .told("a half opening and a friction above those of T: four modes meet"),
];
