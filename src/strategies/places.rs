//! Where on the map a mode or a landmark is: candidates, for a strategy to know where to look.

use crate::arch::{SelfWeight, Unknown};
use crate::certify::CertifiedLandmark;
use crate::number::{Ball, Rounded, bits_of};
use crate::problem::{Landmark, Mode};
use std::sync::OnceLock;

/// Digits of a landmark that a query next to it can share with it.
pub(super) const DIGITS: usize = 40;

/// A landmark's half opening and friction; `None` where it has none.
type Place = [Option<Ball>; 2];

/// The half opening or the friction of a landmark, which is computed once.
fn value(landmark: Landmark, weight: SelfWeight, unknown: Unknown) -> Option<&'static Ball> {
    static PLACES: [[OnceLock<Place>; 7]; 2] = [const { [const { OnceLock::new() }; 7] }; 2];
    let compute = || {
        let refined = CertifiedLandmark::new(landmark, weight)
            .and_then(|point| point.enclosure(bits_of(DIGITS) + 64));
        let value = |unknown| refined.as_ref().ok()?.value(unknown);
        [value(Unknown::HalfOpening), value(Unknown::Friction)]
    };
    let place = PLACES[weight as usize][landmark as usize].get_or_init(compute);
    place[usize::from(unknown == Unknown::Friction)].as_ref()
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
