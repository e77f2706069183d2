//! The equations of each kind of mechanism, for one half opening or for all.

use super::super::form::CurveForm;
use super::super::law::Law;
use super::super::variable::Variable;
use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::number::Ball;

/// The equation by which a kind closes.
pub(super) fn closing(kind: AsymmetricMode) -> Law {
    match kind {
        AsymmetricMode::InnerSliding => Law::InnerSlides,
        AsymmetricMode::ShoulderOpening => Law::ShoulderOpens,
        AsymmetricMode::ShoulderSliding => Law::HingesFit,
    }
}

/// Kind that a law closes.
pub(super) fn closed_by(law: Law) -> Option<AsymmetricMode> {
    AsymmetricMode::ALL.into_iter().find(|kind| closing(*kind) == law)
}

macro_rules! laws {
    ($($closing:ident),*) => {
        &[
            Law::CarriedShoulder,
            Law::OnCrown,
            Law::TouchesCrown,
            Law::OnHaunch,
            Law::TouchesHaunch,
            $(Law::$closing),*
        ]
    };
}

/// The laws of a symmetric state, whose line of thrust is level in the crown.
macro_rules! symmetric {
    ($closing:ident) => {
        &[Law::CarriedShoulder, Law::OnCrown, Law::OnHaunch, Law::TouchesHaunch, Law::$closing]
    };
}

/// The states of a kind of a half opening, by the vertical force. The inclination is that with the thrust `cos² chi`,
/// whether a joint slides or not.
pub(super) fn over_vertical_force(
    kind: AsymmetricMode,
    weight: SelfWeight,
    half_opening: &Ball,
) -> CurveForm {
    use Variable::{CrownHinge, CrownMoment, FrictionAngle, Inclination, JointSquare, Thickness};
    let unknowns = &[Inclination, FrictionAngle, CrownMoment, Thickness, CrownHinge, JointSquare];
    let laws = match kind {
        AsymmetricMode::InnerSliding => laws!(InnerSlides),
        AsymmetricMode::ShoulderOpening => laws!(ShoulderOpens),
        AsymmetricMode::ShoulderSliding => laws!(HingesFit),
    };
    let given = Some((Variable::HalfOpening, half_opening.clone()));
    CurveForm { given, ..CurveForm::new(weight, Variable::VerticalForce, unknowns, laws) }
}

/// The symmetric state of a half opening in which a kind ends: one equation more than unknowns.
pub(super) fn symmetric(
    kind: AsymmetricMode,
    weight: SelfWeight,
    half_opening: &Ball,
) -> CurveForm {
    use Variable::{CrownMoment, FrictionAngle, Inclination, JointSquare, Thickness};
    let laws = match kind {
        AsymmetricMode::InnerSliding => symmetric!(InnerSlides),
        AsymmetricMode::ShoulderOpening => symmetric!(ShoulderOpens),
        AsymmetricMode::ShoulderSliding => symmetric!(HingesFit),
    };
    let unknowns = &[Inclination, CrownMoment, Thickness, JointSquare];
    let given = Some((Variable::HalfOpening, half_opening.clone()));
    CurveForm { given, ..CurveForm::new(weight, FrictionAngle, unknowns, laws) }
}

/// The symmetric states in which the hinges and the shoulders fit, by the half opening.
pub(super) fn beginning(weight: SelfWeight) -> CurveForm {
    use Variable::{CrownMoment, FrictionAngle, Inclination, JointSquare, Thickness};
    let unknowns = &[FrictionAngle, Inclination, CrownMoment, Thickness, JointSquare];
    CurveForm::new(weight, Variable::HalfOpening, unknowns, symmetric!(HingesFit))
}

/// The states in which one kind becomes the other, by the half opening.
pub(super) fn between(kinds: [AsymmetricMode; 2], weight: SelfWeight) -> CurveForm {
    use AsymmetricMode::{InnerSliding, ShoulderOpening};
    use Variable::{CrownHinge, CrownMoment, FrictionAngle, Inclination};
    use Variable::{JointSquare, Thickness, VerticalForce};
    let unknowns = &[
        FrictionAngle,
        Inclination,
        CrownMoment,
        Thickness,
        CrownHinge,
        JointSquare,
        VerticalForce,
    ];
    let laws = match (kinds.contains(&InnerSliding), kinds.contains(&ShoulderOpening)) {
        (true, true) => laws!(InnerSlides, ShoulderOpens),
        (true, false) => laws!(InnerSlides, HingesFit),
        (false, _) => laws!(HingesFit, ShoulderOpens),
    };
    CurveForm::new(weight, Variable::HalfOpening, unknowns, laws)
}
