//! A problem: its equations, what is given, and the conditions on its root.

use super::asymmetric;
use super::verdict::{beyond, standing_margin};
use super::{Arch, Condition, Examined, Fixed, Known, Landmark, Mode, Quantity, System, Verdict};
use crate::arch::asymmetric::AsymmetricMode;
use crate::arch::{Configuration, SelfWeight, Unknown, thrust};
use crate::number::{Enclosure, Engine};

/// A landmark, an arch with the mode in which it collapses at its least thickness, another verdict on an arch, or an
/// asymmetric solution of (19): what a proof is about, and what a certificate claims.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Problem {
    /// A landmark point.
    Landmark {
        /// Landmark that is meant.
        landmark: Landmark,
        /// The self-weight model.
        weight: SelfWeight,
    },
    /// The state of an arch at its least thickness.
    State {
        /// Mode of its collapse.
        mode: Mode,
        /// The arch.
        arch: Arch,
    },
    /// Another verdict on an arch.
    Verdict {
        /// The verdict.
        verdict: Verdict,
        /// The arch.
        arch: Arch,
    },
    /// An asymmetric solution of the complementarity problem (19) of a whole arch with limited friction.
    Asymmetric {
        /// Way in which its mechanism closes.
        mode: AsymmetricMode,
        /// The arch.
        arch: Arch,
    },
}

impl Problem {
    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        match self {
            Self::Landmark { weight, .. } => *weight,
            Self::State { arch, .. }
            | Self::Verdict { arch, .. }
            | Self::Asymmetric { arch, .. } => arch.weight(),
        }
    }

    /// System of the problem: unknowns, equations, and what is fixed.
    pub fn system(&self) -> System {
        match self {
            Self::Landmark { landmark, weight } => landmark.system(*weight),
            Self::State { mode, arch } => mode.system(arch.weight()),
            Self::Verdict { verdict, arch } => verdict.system(arch),
            Self::Asymmetric { mode, arch } => asymmetric::system(*mode, arch.weight()),
        }
    }

    /// Given variables, in numbers of `bits` bits; everything else is zero.
    pub fn given<E: Engine>(&self, bits: u32) -> Configuration<E> {
        match self {
            Self::Landmark { .. } => Configuration::zero(&E::zero(bits as usize)),
            Self::State { arch, .. } | Self::Asymmetric { arch, .. } => arch.given(bits),
            Self::Verdict { verdict, arch } => verdict.given(arch, bits),
        }
    }

    /// Conditions that hold at the root, for the state of each mode that is spoken of: the physical range,
    /// that it is admissible, that no thinner arch stands, and what tells its mode from others. That an
    /// asymmetric solution is admissible is no sign at a point: [`check`](crate::check) looks at the whole
    /// arch.
    pub fn conditions(&self) -> Vec<(Mode, Vec<Condition>)> {
        match self {
            Self::Landmark { landmark, weight } => landmark.conditions(*weight),
            Self::State { mode, arch } => {
                let opening = Unknown::HalfOpening;
                let range = [Condition::Above(opening), Condition::Below(opening)];
                let all = range.into_iter().chain(Condition::of(*mode, arch.is_limited()));
                vec![(*mode, all.collect())]
            }
            Self::Verdict { verdict, arch } => {
                let mode = match verdict {
                    Verdict::TooThin { mode, .. } => *mode,
                    // It asks for no mechanism.
                    _ => Mode::Sliding,
                };
                vec![(mode, verdict.conditions(arch))]
            }
            // Its mechanism is none of the modes.
            Self::Asymmetric { mode, .. } => vec![(Mode::Sliding, asymmetric::conditions(*mode))],
        }
    }

    /// The first condition that is not shown to hold where the variables lie in the configuration given; what is
    /// given is compared in numbers of `bits` bits.
    pub fn first_failure<E: Engine>(&self, at: &Configuration<E>, bits: u32) -> Option<Condition> {
        self.conditions().into_iter().find_map(|(mode, conditions)| {
            let state = Examined::new(self.weight(), mode, at);
            let margin = |condition: Condition| match (self, condition) {
                (_, Condition::Beyond(unknown)) => beyond(unknown, &self.given(bits), at),
                (Self::Verdict { verdict: Verdict::Stands(standing), .. }, condition) => {
                    standing_margin(condition, self.weight(), standing, at, bits)
                        .unwrap_or_else(|| state.margin(condition))
                }
                (Self::Asymmetric { mode, .. }, condition) => {
                    asymmetric::margin(*mode, condition, at)
                        .unwrap_or_else(|| state.margin(condition))
                }
                _ => state.margin(condition),
            };
            let fails = |condition: &Condition| !margin(*condition).is_positive().is_proved();
            conditions.into_iter().find(fails)
        })
    }

    /// Bits of the longest number that is given as a witness.
    pub fn witness_bits(&self) -> usize {
        match self {
            Self::Verdict { verdict: Verdict::Stands(standing), .. } => {
                standing.thrust.bits().max(standing.crown_moment.bits())
            }
            _ => 0,
        }
    }

    /// Tells whether the problem has a quantity that can be stated: an unknown of its subject or something
    /// made from unknowns and fixed variables.
    pub fn has(&self, quantity: Quantity) -> bool {
        let system = self.system();
        match (self, quantity) {
            (Self::State { .. } | Self::Verdict { .. }, Quantity::OpeningVariable) => false,
            // The joint of a mode whose inner joint does not slide does not belong to the state.
            (Self::State { mode, .. }, _) if quantity.variable() == Some(Unknown::SlidingJoint) => {
                mode.slides_inside()
            }
            (Self::Verdict { verdict, arch }, _) => verdict.has(arch, quantity),
            (Self::Asymmetric { mode, .. }, _) => asymmetric::has(*mode, quantity),
            (_, Quantity::IntrinsicThrust) => {
                system.knows(Unknown::Thickness) && system.knows(Unknown::Thrust)
            }
            _ => quantity.variable().is_some_and(|unknown| system.knows(unknown)),
        }
    }

    /// The quantity where the variables lie in the configuration given; `None` for a quantity that one
    /// configuration does not determine.
    pub fn known<E: Enclosure>(
        &self,
        quantity: Quantity,
        at: &Configuration<E>,
    ) -> Option<Known<E>> {
        if let Self::Asymmetric { mode, arch } = self
            && let Some(x) = asymmetric::moving(*mode, arch.weight(), quantity, at)
        {
            return Some(Known::Enclosed(x));
        }
        let infinite = self.system().fixed_value(Unknown::Friction) == Some(Fixed::Infinite);
        Some(Known::Enclosed(match quantity.in_radians().unwrap_or(quantity) {
            Quantity::Friction if infinite => return Some(Known::Infinite),
            Quantity::FrictionAngle if infinite => at.thrust.pi() / at.thrust.int(2),
            Quantity::FrictionAngle => return Some(Known::AngleOfTangent(at.friction.clone())),
            Quantity::IntrinsicThrust => at.thickness.clone() * &at.thrust,
            Quantity::OpeningVariable => thrust::opening_variable(&at.half_opening).value(),
            quantity => at.value(quantity.variable()?).clone(),
        }))
    }
}
