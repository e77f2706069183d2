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

/// The laws of a state, but for those by which it closes.
const STATE: [Law; 5] =
    [Law::CarriedShoulder, Law::OnCrown, Law::TouchesCrown, Law::OnHaunch, Law::TouchesHaunch];

/// The laws of a symmetric state, whose line of thrust is level in the crown, but for that by which it closes.
const SYMMETRIC: [Law; 4] = [Law::CarriedShoulder, Law::OnCrown, Law::OnHaunch, Law::TouchesHaunch];

/// Laws of states together with those of the kinds by which they close.
fn closed(laws: &[Law], kinds: &[AsymmetricMode]) -> Vec<Law> {
    laws.iter().copied().chain(kinds.iter().map(|kind| closing(*kind))).collect()
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
    let given = Some((Variable::HalfOpening, half_opening.clone()));
    CurveForm {
        given,
        ..CurveForm::new(weight, Variable::VerticalForce, unknowns, &closed(&STATE, &[kind]))
    }
}

/// The symmetric state of a half opening in which a kind ends: one equation more than unknowns.
pub(super) fn symmetric(
    kind: AsymmetricMode,
    weight: SelfWeight,
    half_opening: &Ball,
) -> CurveForm {
    use Variable::{CrownMoment, FrictionAngle, Inclination, JointSquare, Thickness};
    let unknowns = &[Inclination, CrownMoment, Thickness, JointSquare];
    let given = Some((Variable::HalfOpening, half_opening.clone()));
    CurveForm {
        given,
        ..CurveForm::new(weight, FrictionAngle, unknowns, &closed(&SYMMETRIC, &[kind]))
    }
}

/// The symmetric states in which the hinges and the shoulders fit, by the half opening.
pub(super) fn beginning(weight: SelfWeight) -> CurveForm {
    use Variable::{CrownMoment, FrictionAngle, Inclination, JointSquare, Thickness};
    let unknowns = &[FrictionAngle, Inclination, CrownMoment, Thickness, JointSquare];
    let laws = closed(&SYMMETRIC, &[AsymmetricMode::ShoulderSliding]);
    CurveForm::new(weight, Variable::HalfOpening, unknowns, &laws)
}

/// The states in which one kind becomes the other, by the half opening.
pub(super) fn between(kinds: [AsymmetricMode; 2], weight: SelfWeight) -> CurveForm {
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
    CurveForm::new(weight, Variable::HalfOpening, unknowns, &closed(&STATE, &kinds))
}
