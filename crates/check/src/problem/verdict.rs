//! Verdicts on an arch besides its state at the least thickness, and what decides each.
//!
//! Three say that it does not stand. Each compares what is given with a limit, the root of a system:
//!
//! - **It slides**: the friction is below that of the purely sliding state of the half opening. There a thrust `h0`
//!   asks for `mu0` at the shoulder and at the joint `beta_s`. A larger thrust asks for more at the shoulder, as
//!   `d(-T/N)/dh = alpha/N²` there while `N > 0`, and no admissible state has `N <= 0`; a smaller one asks for more at
//!   `beta_s`, as `d(T/N)/dh = -beta_s/N²`. So no thrust does with less than `mu0`, whatever the thickness.
//! - **It is too wide**: the half opening is beyond the one at which the physical limit `eta = 2` is just enough at the
//!   least thrust that friction allows. [`arch::contact`](crate::arch::contact) has why then no thickness is
//!   enough, for a negative margin; and over `1 - cos alpha` the margin is `2 h cos alpha/(1 - cos alpha) + 2 alpha
//!   cot(alpha/2)` and a constant, which fall as `alpha` grows.
//! - **It is too thin**: the thickness is below the least one, whose state shows that no thinner arch stands.
//!
//! One says that it **stands** at a thickness: a thrust `h` and a crown moment `p`, with which the line of thrust is
//! inside the arch, and friction enough, at every joint. The lemma of [`arch::contact`](crate::arch::contact) reduces
//! that to the signs at the crown, at the shoulder, and at the joint where the moment about the intrados is least: the
//! root of (5), or an end of the half arch. Where the line comes nearest to the intrados is another joint.

use super::system::system;
use super::{Arch, Condition, Landmark, Mode, Quantity, System};
use super::{inward_friction, room_for_steepest};
use crate::arch::{Configuration, SelfWeight, Unknown, contact};
use crate::number::{Dyadic, Engine, ExactNumber, Ternary, worded};

/// A verdict on an arch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The arch stands at no thickness: the friction is below that of the purely sliding state.
    Slides,
    /// The arch stands at no thickness: the half opening is beyond one that no arch with this friction
    /// exceeds. The widest that stands may be narrower, as nothing is asked here of the friction at the
    /// shoulder.
    TooWide,
    /// The arch does not stand: it is thinner than its least thickness.
    TooThin {
        /// Mode of its collapse at the least thickness.
        mode: Mode,
        /// The thickness it has.
        thickness: ExactNumber,
    },
    /// The arch stands.
    Stands(Standing),
}

/// An arch of a thickness, with an admissible state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// The thickness.
    pub thickness: ExactNumber,
    /// `h`, exactly.
    pub thrust: Dyadic,
    /// `p = h (1 + e0)`, exactly.
    pub crown_moment: Dyadic,
    /// Place where the moment about the intrados is least.
    pub nearest: Nearest,
}

worded! {
    /// Place where the moment of a line of thrust about the intrados is least.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Nearest {
        /// The place is at the crown.
        Crown = "crown",
        /// The place is at a joint between the crown and the shoulder.
        Haunch = "haunch",
        /// The place is at the shoulder.
        Shoulder = "shoulder",
    }
    /// All places.
    pub const ALL;
    /// The name used in files.
    pub fn name -> &'static str;
}

impl Verdict {
    /// The system whose root decides it: the limit, or the joint of the least moment.
    pub(super) fn system(&self, arch: &Arch) -> System {
        let weight = arch.weight();
        match self {
            Self::Slides => Mode::Sliding.system(weight),
            Self::TooWide if !arch.is_limited() => Landmark::OverturningEnd.system(weight),
            Self::TooWide => system! { weight;
                HalfOpening Thrust SlidingJoint; UpperThrust InnerSliding Steepest;
                RotationJoint = Integer(0), Thickness = Integer(2)
            },
            Self::TooThin { mode, .. } => mode.system(weight),
            Self::Stands(standing) => match standing.nearest {
                Nearest::Haunch => System::tangent(weight),
                _ => System { weight, unknowns: &[], equations: &[], fixed: &[] },
            },
        }
    }

    /// Given variables, in numbers of `bits` bits.
    pub(super) fn given<E: Engine>(&self, arch: &Arch, bits: u32) -> Configuration<E> {
        let given = arch.given(bits);
        match self {
            Self::Slides | Self::TooWide => given,
            Self::TooThin { thickness, .. } => {
                given.with(Unknown::Thickness, thickness.enclosure(bits))
            }
            Self::Stands(standing) => given
                .with(Unknown::Thickness, standing.thickness.enclosure(bits))
                .with(Unknown::Thrust, E::exact(&standing.thrust, bits as usize)),
        }
    }

    /// Tells whether a quantity can be stated: what is given or fixed is no result.
    pub(super) fn has(&self, arch: &Arch, quantity: Quantity) -> bool {
        let system = self.system(arch);
        let solves = |unknown| system.index(unknown).is_some();
        match quantity {
            Quantity::IntrinsicThrust => solves(Unknown::Thickness) && solves(Unknown::Thrust),
            _ => quantity.variable().is_some_and(solves),
        }
    }

    /// Conditions that hold at the root.
    pub(super) fn conditions(&self, arch: &Arch) -> Vec<Condition> {
        use {Condition as C, Unknown as U};
        let opening = [C::Above(U::HalfOpening), C::Below(U::HalfOpening)];
        let joint = [C::Above(U::SlidingJoint), C::Below(U::SlidingJoint)];
        match self {
            Self::Slides => [&joint[..], &[C::Compression, C::Beyond(U::Friction)]].concat(),
            Self::TooWide => {
                let joint = if arch.is_limited() { &joint[..] } else { &[] };
                [&opening[..], joint, &[C::Beyond(U::HalfOpening)]].concat()
            }
            Self::TooThin { mode, .. } => {
                let state = Condition::of(*mode, arch.is_limited());
                opening.into_iter().chain(state).chain([C::Beyond(U::Thickness)]).collect()
            }
            Self::Stands(standing) => {
                let nearest: &[C] = match standing.nearest {
                    Nearest::Crown => &[C::IntradosAtCrown],
                    Nearest::Haunch => &[C::Above(U::RotationJoint), C::Below(U::RotationJoint)],
                    Nearest::Shoulder => &[C::NearestAtShoulder],
                };
                let friction: &[C] = match arch.is_limited() {
                    true => &[C::FrictionAtShoulder, C::FrictionInside],
                    false => &[],
                };
                let state = &[
                    C::Above(U::Thrust),
                    C::Below(U::Thrust),
                    C::Compression,
                    C::ExtradosAtCrown,
                    C::ExtradosAtShoulder,
                ];
                [state, nearest, &[C::InsideIntrados], friction].concat()
            }
        }
    }
}

/// Distance of the given value beyond the limit that a root is.
pub(super) fn beyond<E: Engine>(
    unknown: Unknown,
    given: &Configuration<E>,
    limit: &Configuration<E>,
) -> E {
    let (given, limit) = (given.value(unknown).clone(), limit.value(unknown));
    match unknown {
        Unknown::HalfOpening => given - limit,
        _ => -given + limit,
    }
}

/// Margin of a condition of an arch that stands, if it is one that a given crown moment changes.
pub(super) fn standing_margin<E: Engine>(
    condition: Condition,
    weight: SelfWeight,
    standing: &Standing,
    at: &Configuration<E>,
    bits: u32,
) -> Option<E> {
    let moment = E::exact(&standing.crown_moment, bits as usize);
    Some(match condition {
        Condition::ExtradosAtCrown => contact::crown_moment(at) - moment,
        Condition::ExtradosAtShoulder => contact::extrados_margin_at_shoulder(weight, at, &moment),
        Condition::InsideIntrados => {
            let joint = match standing.nearest {
                Nearest::Shoulder => &at.half_opening,
                // Zero where it is the crown.
                _ => &at.rotation_joint,
            };
            contact::intrados_margin(weight, joint, at, &moment)
        }
        // (5) at the shoulder lies below: the line still comes nearer.
        Condition::NearestAtShoulder => -contact::approach(weight, &at.half_opening, at),
        Condition::FrictionInside => {
            // At the steepest joint, even of a longer arch, it is the most.
            let steepest_comes_first = room_for_steepest(at).is_positive() != Ternary::False;
            at.friction.clone() - inward_friction(at, steepest_comes_first)
        }
        _ => return None,
    })
}
