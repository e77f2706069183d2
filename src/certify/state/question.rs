//! An arch, as it is asked about, and the doubt that may be the answer.

use super::small::is_small;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{
    Ball, Enclosure, ExactNumber, Field, Magnitude, ParseExactError, Real, Ternary,
};
use crate::problem::Mode;
use rug::float::Round;
use rug::{Float, Rational};
use std::str::FromStr;

/// The friction of the joints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Friction {
    /// `mu`.
    Coefficient(ExactNumber),
    /// `phi = atan(mu)`, rad.
    Angle(ExactNumber),
    /// No limit.
    Infinite,
}

/// An arch whose thickness is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arch {
    weight: SelfWeight,
    half_opening: ExactNumber,
    friction: Friction,
}

/// Why an arch is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ArchError {
    /// The half opening is not between 0 and pi.
    #[error("the half opening {0} is not between 0 and pi (180deg)")]
    HalfOpening(String),
    /// The friction is negative.
    #[error("the friction {0} is negative")]
    Friction(String),
    /// The friction angle is not between 0 and a right angle.
    #[error("the friction angle {0} is not between 0 and pi/2 (90deg)")]
    FrictionAngle(String),
}

/// A comparison that is not decided at some precision.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Doubt {
    /// What could not be told.
    pub question: &'static str,
    /// The modes, or the mode and nothing, between which it stands.
    pub between: Vec<Mode>,
    /// A bound of the difference that could not be told from zero.
    pub gap: f64,
}

/// The result of a step of the proof at one precision.
pub(super) type Attempt<T> = Result<T, Doubt>;

impl FromStr for Friction {
    type Err = ParseExactError;

    /// A coefficient, or `inf`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "inf" => Ok(Self::Infinite),
            _ => text.parse().map(Self::Coefficient),
        }
    }
}

/// Whether a thickness is between 0 and the physical limit 2.
pub fn is_thickness(thickness: &ExactNumber) -> bool {
    thickness.is_rational() && *thickness.factor() > 0 && *thickness.factor() < 2
}

impl Arch {
    /// An arch, if its half opening is in `(0, pi)`, in radians, and its friction coefficient in
    /// `[0, inf)` or its friction angle in `[0, pi/2]`, in radians; pi/2 is [`Friction::Infinite`].
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        friction: Friction,
    ) -> Result<Self, ArchError> {
        if !is_between(&half_opening, false, 1) {
            return Err(ArchError::HalfOpening(half_opening.to_string()));
        }
        let friction = match friction {
            Friction::Coefficient(mu) if *mu.factor() < 0 => {
                return Err(ArchError::Friction(mu.to_string()));
            }
            Friction::Angle(phi)
                if !phi.is_rational() && *phi.factor() == Rational::from((1, 2)) =>
            {
                Friction::Infinite
            }
            Friction::Angle(phi) if !is_between(&phi, true, 2) => {
                return Err(ArchError::FrictionAngle(phi.to_string()));
            }
            friction => friction,
        };
        Ok(Self { weight, half_opening, friction })
    }

    /// The same arch with another friction.
    pub(super) fn with_friction(&self, friction: Friction) -> Self {
        Self { friction, ..self.clone() }
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.weight
    }

    /// The half opening as given.
    pub fn half_opening(&self) -> &ExactNumber {
        &self.half_opening
    }

    /// The friction as given.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// Whether the half opening is so small that the equations are used in the form of
    /// [`arch::small`](crate::arch::small), which loses nothing, at a precision of `bits` bits.
    pub(super) fn is_small(&self, bits: u32) -> bool {
        let exponent = self.half_opening.enclosure(64).mid().get_exp();
        exponent.is_some_and(|exponent| is_small(2 * i64::from(exponent), bits))
    }

    /// Bits that the printed equations lose by cancellation: the thickness falls like the fourth power of a
    /// small half opening, the thrust like the inverse square of a large friction.
    pub fn bits_lost(&self) -> u32 {
        let exponent = |x: &ExactNumber| x.enclosure(64).mid().get_exp().unwrap_or(0);
        let friction = match &self.friction {
            Friction::Coefficient(mu) => exponent(mu).max(64) - 64,
            _ => 0,
        };
        exponent(&self.half_opening).min(0).unsigned_abs() * 6 + friction.unsigned_abs() * 4
    }
}

/// Whether an angle is above zero (or is zero, if that is allowed) and below `pi / divisor`.
fn is_between(x: &ExactNumber, zero_is_in: bool, divisor: i32) -> bool {
    // Few bits decide nearly always; the last are more than the longest number that is read has.
    let below = [128, 80_000].into_iter().map(|bits| {
        let pi = Ball::integer(1, bits).pi();
        x.enclosure(bits).is_less_than(&(pi.clone() / pi.int(divisor)))
    });
    let positive = *x.factor() > 0 || (zero_is_in && x.factor().is_zero());
    positive && below.into_iter().find(|b| *b != Ternary::Undecided) == Some(Ternary::True)
}

/// An arch at one precision.
pub(super) struct Query {
    pub(super) weight: SelfWeight,
    pub(super) bits: u32,
    /// What is given: the half opening and, if finite, the friction.
    pub(super) given: Configuration<Ball>,
    pub(super) friction: Option<Ball>,
}

impl Query {
    /// The arch in numbers of `bits` bits.
    pub(super) fn new(arch: &Arch, bits: u32) -> Self {
        let alpha = arch.half_opening.enclosure(bits);
        let friction = match &arch.friction {
            Friction::Coefficient(mu) => Some(mu.enclosure(bits)),
            Friction::Angle(phi) => {
                let (sin, cos) = phi.enclosure(bits).sin_cos();
                Some(sin / cos)
            }
            Friction::Infinite => None,
        };
        let mut given = Configuration::zero(&alpha).with(Unknown::HalfOpening, alpha);
        if let Some(friction) = &friction {
            given = given.with(Unknown::Friction, friction.clone());
        }
        Self { weight: arch.weight, bits, given, friction }
    }

    /// The half opening as a candidate.
    pub(super) fn alpha(&self) -> Float {
        Float::with_val(self.bits, self.given.half_opening.rad.mid())
    }
}

/// Whether a margin is positive, or the doubt.
pub(super) fn decide(margin: &Ball, question: &'static str, between: &[Mode]) -> Attempt<bool> {
    match margin.is_positive() {
        Ternary::True => Ok(true),
        Ternary::False => Ok(false),
        Ternary::Undecided => {
            let gap = Magnitude::upper(margin.mid())
                .plus(margin.rad())
                .to_float()
                .to_f64_round(Round::Up);
            Err(Doubt { question, between: between.to_vec(), gap })
        }
    }
}

/// A condition that has to hold for the proof to go on; where it does not, nothing is known.
pub(super) fn require(margin: &Ball, question: &'static str, modes: &[Mode]) -> Attempt<()> {
    match decide(margin, question, modes)? {
        true => Ok(()),
        false => Err(Doubt { question, between: modes.to_vec(), gap: f64::INFINITY }),
    }
}
