//! The equations of the forms, one by one.

use super::spot::VariableValues;
use crate::arch::asymmetric::AsymmetricMode;
use crate::arch::haunch::{opening_variable_at_half, touching_root};
use crate::arch::{Ring, SelfWeight, cycloid, thrust};
use crate::number::{Angle, Real, Stumpff};

/// An equation of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    /// (18), the friction angle.
    Cycloid,
    /// (17).
    Shoulder,
    /// (17) of a flat arch, in `q`.
    FlatShoulder,
    /// `alpha = phi + q chi`.
    Ratio,
    /// (17) of a flat arch that turns at the haunch, in `p` and `s`.
    FlatTurningShoulder,
    /// (4) less (5) of the same.
    FlatTurning,
    /// `alpha = p chi`.
    OpeningRatio,
    /// `beta_r² = s chi²`.
    JointRatio,
    /// (5).
    Tangency,
    /// The thrust that (2) and (5) have in common.
    Touching,
    /// The square root of that, regular where the thrust vanishes.
    TouchingRoot,
    /// The common thrust of (2) and (5) put into (5): what both leave of the thickness and the joint.
    Rotation,
    /// (4).
    Whole,
    /// (4) less (5): the half opening of the rotational states.
    WholeTangency,
    /// (3).
    Upper,
    /// (17) of a shoulder that carries less by the vertical force.
    CarriedShoulder,
    /// (18) of the left half, which carries more by the vertical force: an inner joint slides.
    InnerSlides,
    /// The line of thrust is on the extrados next to the crown, and touches it.
    OnCrown,
    TouchesCrown,
    /// The line of thrust is on the intrados at the left haunch, and touches it.
    OnHaunch,
    TouchesHaunch,
    /// The line of thrust is on the extrados of the right shoulder.
    ShoulderOpens,
    /// Two hinges and a sliding shoulder move without another joint.
    HingesFit,
}

impl Law {
    pub(super) fn residual<T: Real + Stumpff>(
        self,
        weight: SelfWeight,
        at: &VariableValues<T>,
    ) -> T {
        let ring = || Ring::new(weight, &at.thickness);
        let tangency = || thrust::tangency(&at.haunch.times_cotangent, &ring());
        let touching = || thrust::touching(&at.haunch.versine, &at.haunch.excess, &ring());
        let whole = || {
            let quarter = at.half_opening.square() / at.thrust.int(4);
            thrust::whole_through(&opening_variable_at_half(&quarter.stumpff(2)), &ring())
        };
        let chi = &at.inclination.rad;
        use Law::*;
        match self {
            Cycloid => cycloid::friction_angle(&at.inclination) - &at.friction_angle,
            Shoulder => cycloid::shoulder(&at.half_opening, &at.shoulder_inclination(), &at.thrust),
            FlatShoulder => cycloid::flat_shoulder(&at.ratio, chi),
            Ratio => at.half_opening.clone() - &at.friction_angle - at.ratio.clone() * chi,
            FlatTurningShoulder => at.flat().shoulder(weight, chi),
            FlatTurning => at.flat().turning(weight, &at.half_opening),
            OpeningRatio => at.half_opening.clone() - at.opening_ratio.clone() * chi,
            JointRatio => at.joint_square.clone() - chi.square() * &at.joint_ratio,
            Tangency => tangency().residual(&at.thrust),
            Touching => touching().residual(&at.thrust),
            TouchingRoot => touching_root(&at.inclination.cos, &at.joint_square, &ring()),
            Rotation => tangency().difference(&touching()),
            Whole => whole().residual(&at.thrust),
            WholeTangency => whole().difference(&tangency()),
            Upper => at.upper(weight).residual(&at.thrust),
            CarriedShoulder => {
                let carried = at.half_opening.clone() - &at.vertical_force;
                cycloid::shoulder(&carried, &at.shoulder_inclination(), &at.thrust)
            }
            InnerSlides => {
                at.friction_angle.clone()
                    - cycloid::friction_angle(&at.inclination)
                    - &at.vertical_force
            }
            OnCrown => at.at_crown(weight)[0].clone(),
            TouchesCrown => at.at_crown(weight)[1].clone(),
            OnHaunch => at.at_haunch(weight)[0].clone(),
            TouchesHaunch => at.at_haunch(weight)[1].clone(),
            ShoulderOpens => at.closing(AsymmetricMode::ShoulderOpening, weight),
            HingesFit => at.closing(AsymmetricMode::ShoulderSliding, weight),
        }
    }

    pub(super) fn divisor<T: Real + Stumpff>(
        self,
        weight: SelfWeight,
        at: &VariableValues<T>,
    ) -> Option<T> {
        match self {
            Self::Upper => Some(at.upper(weight).denominator),
            Self::Shoulder | Self::CarriedShoulder => {
                let Angle { sin, cos, .. } = at.shoulder_inclination();
                let alpha = at.half_opening.clone();
                let carried =
                    if self == Self::Shoulder { alpha } else { alpha - &at.vertical_force };
                // The force on the shoulder less its part along the joint: N over cos(phi).
                Some(at.thrust.clone() * cos + carried * sin)
            }
            Self::Tangency | Self::Rotation | Self::WholeTangency => {
                Some(Ring::new(weight, &at.thickness).intrados())
            }
            _ => None,
        }
    }
}
