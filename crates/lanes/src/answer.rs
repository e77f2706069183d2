//! An answer to an arch that is proved.

use crate::number::DoubleDoubleBall;
use crate::problem::Mode;

/// The answer to an arch.
#[derive(Clone, Copy, Debug)]
pub enum LaneAnswer {
    /// The arch falls whatever its thickness.
    Falls,
    /// The arch stands from a least thickness on.
    Stands(LaneState),
}

/// The state at the least thickness of an arch, in enclosures.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct LaneState {
    /// Mode of its collapse.
    pub mode: Mode,
    /// `eta`.
    pub thickness: DoubleDoubleBall,
    /// `h`.
    pub thrust: DoubleDoubleBall,
    /// `eta h`.
    pub intrinsic_thrust: DoubleDoubleBall,
    /// `beta_r`, rad.
    pub rotation_joint: DoubleDoubleBall,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<DoubleDoubleBall>,
}

impl LaneState {
    /// A state by its thickness, its thrust, the product of both, and its rotational joint.
    pub(super) fn new(
        mode: Mode,
        [thickness, thrust, intrinsic_thrust, rotation_joint]: [DoubleDoubleBall; 4],
        sliding_joint: Option<DoubleDoubleBall>,
    ) -> Self {
        Self { mode, thickness, thrust, intrinsic_thrust, rotation_joint, sliding_joint }
    }

    /// The state of a half opening that rotates, from what is proved of it.
    pub(super) fn rotating(
        &[thickness, thrust, intrinsic_thrust, joint, ..]: &[DoubleDoubleBall; 6],
    ) -> Self {
        Self::new(Mode::Rotational, [thickness, thrust, intrinsic_thrust, joint], None)
    }
}

/// Roots that bound the thrusts of an arch with a thickness, each where it is proved to exist. Which signs make it a
/// bound is not looked at.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct LaneRoots {
    /// `beta_r` and `h` where the line of the least thrust touches the intrados, (2) and (5).
    pub least: Option<[DoubleDoubleBall; 2]>,
    /// `beta_r` and `h` where the line of the largest thrust does, (3) and (5).
    pub largest: Option<[DoubleDoubleBall; 2]>,
    /// The friction and `h` of the purely sliding state.
    pub sliding: Option<[DoubleDoubleBall; 2]>,
    /// `h` and `beta_s` where an inner joint slides, (18).
    pub steepest: Option<[DoubleDoubleBall; 2]>,
}

/// A friction from which something holds.
#[derive(Clone, Copy, Debug)]
pub enum FromFriction {
    /// From this one on.
    From(DoubleDoubleBall),
    /// None is enough.
    Never,
}

/// The frictions of a half opening at which the mode changes, as far as they are proved.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct LaneFrictions {
    /// The friction below which no arch of the half opening stands.
    pub sliding: Option<DoubleDoubleBall>,
    /// The friction from which collapse is purely rotational, infinite where none is enough.
    pub rotational: Option<FromFriction>,
}
