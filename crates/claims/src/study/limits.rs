//! The limits of the problem, and the problem at each distance from them.

use super::target::{Target, arch, before, rotational};
use crate::arch::Unknown;
use crate::certify::state::{Certify, Outcome};
use crate::problem::{Landmark, Mode};
use rug::{Float, Rational};

/// A limit with the problem at each distance from it.
#[non_exhaustive]
pub struct Limit {
    /// A short name.
    pub name: &'static str,
    /// What happens there.
    pub words: &'static str,
    /// What is computed.
    pub output: &'static str,
    /// Whether it is that of small half openings.
    pub(super) is_small: bool,
    /// The problem at the distance `10^-k`.
    pub(super) at: fn(&Rational) -> Option<Target>,
}

/// All limits.
pub const LIMITS: [Limit; 8] = [
    Limit {
        name: "alpha-to-zero",
        words: "a tiny half opening: eta falls like alpha^4, h tends to 1",
        output: "thickness",
        is_small: true,
        at: |x| rotational(x.clone(), Unknown::Thickness),
    },
    Limit {
        name: "radicand-to-zero",
        words: "a joint below that of sb, where two roots of the cubic meet",
        output: "thickness",
        is_small: false,
        at: |x| {
            let joint = before(Landmark::WidestJoint, Unknown::RotationJoint, x)?;
            Some(Target::Closed { joint })
        },
    },
    Limit {
        name: "joint-to-crown",
        words: "a half opening below that of l: beta_r falls like the root of the distance",
        output: "rotation_joint",
        is_small: false,
        at: |x| {
            let alpha = before(Landmark::RotationEnd, Unknown::HalfOpening, x)?;
            rotational(alpha, Unknown::RotationJoint)
        },
    },
    Limit {
        name: "eta-to-two",
        words: "overturning at A above 2/3: the square root in (15) tends to 0",
        output: "thickness",
        is_small: false,
        at: |x| Some(Target::Overturning { distance: x.clone() }),
    },
    Limit {
        name: "mu-to-infinity",
        words: "a large friction: an inner joint slides at a thrust like 1/(4 mu^2)",
        output: "thrust",
        is_small: false,
        at: |x| {
            Some(Target::State {
                mode: Mode::OverturningSliding,
                half_opening: Rational::from((13, 5)),
                friction: Some(x.clone().recip()),
                output: Unknown::Thrust,
            })
        },
    },
    Limit {
        name: "mu-to-zero",
        words: "pure sliding of a tiny half opening: mu falls like alpha^3/12",
        output: "friction",
        is_small: true,
        at: |x| Some(Target::Sliding { half_opening: x.clone() }),
    },
    Limit {
        name: "alpha-to-pi",
        words: "pure sliding towards the full circle: mu grows without bound",
        output: "friction",
        is_small: false,
        at: |x| {
            // pi to far more places than the distance has.
            let places = 60 + 4 * x.denom().significant_bits();
            let pi = Float::with_val(places, rug::float::Constant::Pi).to_rational()?;
            Some(Target::Sliding { half_opening: pi - x })
        },
    },
    Limit {
        name: "next-to-T",
        words: "a half opening and a friction above those of T: four modes meet",
        output: "thickness",
        is_small: false,
        at: |x| {
            let zero = Rational::new();
            let alpha = before(Landmark::Triple, Unknown::HalfOpening, &zero)? + x;
            let friction = before(Landmark::Triple, Unknown::Friction, &zero)? + x.clone() * 10;
            let mode = match arch(&alpha, Some(&friction))?.state(1024).ok()? {
                Outcome::Stands(state) => state.mode,
                Outcome::Falls(_) => return None,
            };
            Some(Target::State {
                mode,
                half_opening: alpha,
                friction: Some(friction),
                output: Unknown::Thickness,
            })
        },
    },
];
