//! Signs for a state: what has to be positive, in the names of `Arch.v` and `States.v`.

use super::names::argument;
use crate::arch::Unknown;
use crate::problem::{Condition, Mode, System};

/// The equation that is left of a condition that is zero, for the tactic `ties`; `None` also if its sides are the same.
pub(super) fn tie(condition: Condition, mode: Mode, system: &System) -> Option<String> {
    // At the extrados both conditions are of one number.
    let condition = match condition {
        Condition::ExtradosAtCrown => Condition::ExtradosAtShoulder,
        other => other,
    };
    let sign = sign(condition, mode, system)?;
    let (less, more) = sign.split_once(" < ")?;
    (less != more).then(|| format!("{less} = {more}"))
}

/// The inequality of a condition; `None` for one that the theorems of `States.v` do without.
pub(super) fn sign(condition: Condition, mode: Mode, system: &System) -> Option<String> {
    use Condition as C;
    let of = |unknown| argument(system, unknown);
    let (alpha, mu) = (of(Unknown::HalfOpening), of(Unknown::Friction));
    let (beta, eta, h) = (of(Unknown::RotationJoint), of(Unknown::Thickness), of(Unknown::Thrust));
    let joint = of(Unknown::SlidingJoint);
    let delta = system.weight.flag();
    let (crown, shoulder) =
        (format!("at_crown {eta} {h}"), format!("at_shoulder {delta} {alpha} {eta} {h}"));
    Some(match condition {
        C::Above(unknown) => format!("0 < {}", of(unknown)),
        C::Below(Unknown::HalfOpening) => format!("{alpha} < PI"),
        C::Below(Unknown::Thickness) => format!("{eta} < 2"),
        C::Below(Unknown::Thrust) => format!("{h} < 1"),
        C::Below(joint @ (Unknown::RotationJoint | Unknown::SlidingJoint)) => {
            format!("{} < {alpha}", of(joint))
        }
        C::Compression => format!("0 < normal_force {alpha} {h}"),
        C::IntradosAtCrown => format!("intrados {eta} * (2 - {h}) < fac {delta} {eta}"),
        C::ExtradosAtShoulder => format!("{crown} < {shoulder}"),
        C::ExtradosAtCrown => format!("{shoulder} < {crown}"),
        C::ThickerStands => {
            format!("fac {delta} 2 * (1 - cos {alpha}) < 2 * normal_force {alpha} {h}")
        }
        C::SlidesAboveHaunch => format!("{joint} < {beta}"),
        C::SlidesBelowHaunch => format!("{beta} < {joint}"),
        C::SteepestAboveShoulder => format!("Arch.beta_s {h} < {alpha}"),
        C::FrictionAtShoulder => format!("mu_ss {alpha} {h} < {mu}"),
        C::FrictionInside => format!("mu_is {h} < {mu}"),
        C::ShoulderBoundsThrust => format!("0 < sin {alpha} - {mu} * cos {alpha}"),
        // At the shoulder it always does.
        C::SlidesTheRightWay if mode != Mode::SlidingRotational => {
            format!("0 < (2 - {eta}) * cos {beta} - (2 + {eta}) * cos {alpha}")
        }
        _ => return None,
    })
}
