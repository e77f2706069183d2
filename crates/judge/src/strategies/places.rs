//! Places on the map of a mode or a landmark: candidates, for a strategy to know where to look.

use crate::arch::{SelfWeight, Unknown};
use crate::certify::CertifiedLandmark;
use crate::number::{Ball, Rounded, bits_of};
use crate::problem::{Landmark, Mode};
use crate::solve::start::sliding;
use rug::Float;
use std::collections::HashMap;
use std::sync::LazyLock;

/// Digits of a landmark that a query next to it can share with it.
pub(super) const DIGITS: usize = 40;

/// A landmark's half opening and friction; `None` where it has none.
type LandmarkPlace = [Option<Ball>; 2];

/// The half opening or the friction of a landmark; all of them are computed when the first is asked for.
pub(super) fn value(
    landmark: Landmark,
    weight: SelfWeight,
    unknown: Unknown,
) -> Option<&'static Ball> {
    static PLACES: LazyLock<HashMap<(Landmark, SelfWeight), LandmarkPlace>> = LazyLock::new(|| {
        let all = Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w)));
        all.map(|(landmark, weight)| ((landmark, weight), place(landmark, weight))).collect()
    });
    let [half_opening, friction] = PLACES.get(&(landmark, weight))?;
    if unknown == Unknown::Friction { friction.as_ref() } else { half_opening.as_ref() }
}

fn place(landmark: Landmark, weight: SelfWeight) -> LandmarkPlace {
    let refined = CertifiedLandmark::new(landmark, weight)
        .and_then(|point| point.enclosure(bits_of(DIGITS) + 64));
    let value = |unknown| refined.as_ref().ok()?.value(unknown);
    [value(Unknown::HalfOpening), value(Unknown::Friction)]
}

/// The decimal of so many digits just below a landmark's value, or just above it.
pub(super) fn beside(
    landmark: Landmark,
    weight: SelfWeight,
    unknown: Unknown,
    digits: usize,
    above: bool,
) -> Option<String> {
    let bounds = Rounded::from_ball(value(landmark, weight, unknown)?, digits)?;
    Some(if above { bounds.upper } else { bounds.lower }.to_string())
}

/// A candidate: a friction above that of the purely sliding state by between a ten-thousandth and ten
/// times of it, as the modes next to it have little room.
pub(super) fn above_sliding(alpha: f64, part: f64) -> f64 {
    let [least, _, _] = sliding(&Float::with_val(53, alpha));
    least.to_f64() * (1.0 + 10f64.powf(1.0 - 5.0 * part))
}

/// The half openings between which a mode is met.
pub(super) fn half_openings(mode: Mode, weight: SelfWeight) -> Option<[f64; 2]> {
    use Landmark::*;
    let at = |landmark| Some(value(landmark, weight, Unknown::HalfOpening)?.mid().to_f64());
    Some(match mode {
        Mode::SlidingRotational => [0.0, at(Triple)?],
        Mode::Rotational => [0.0, at(RotationEnd)?],
        Mode::RotationalSliding => [at(Triple)?, at(Shift)?.max(at(RotationEnd)?)],
        Mode::RotationalSlidingRotational => [at(Shift)?, at(Junction)?.max(at(RotationEnd)?)],
        Mode::OverturningSliding => [at(RotationEnd)?.min(at(Junction)?), at(OverturningEnd)?],
        Mode::Overturning => [at(RotationEnd)?, at(OverturningEnd)?],
        Mode::Sliding => return None,
    })
}
