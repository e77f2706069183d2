//! Arches in few words.

use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::CertifiedLandmark;
use couplet::certify::state::{Answer, Certify, Digits, Outcome};
use couplet::number::{Ball, ExactNumber};
use couplet::problem::{Arch, Landmark};
use rug::{Float, Rational};

pub(crate) const H: SelfWeight = SelfWeight::Heyman;
pub(crate) const M: SelfWeight = SelfWeight::Milankovitch;

pub(crate) fn number(text: &str) -> ExactNumber {
    text.parse().unwrap()
}

/// The arch of a half opening in radians and a friction, a coefficient or `inf`.
pub(crate) fn arch(weight: SelfWeight, half_opening: &str, friction: &str) -> Arch {
    Arch::new(weight, number(half_opening), friction.parse().unwrap()).unwrap()
}

/// The same of rational numbers.
pub(crate) fn rational_arch(
    weight: SelfWeight,
    half_opening: &Rational,
    friction: &Rational,
) -> Arch {
    arch(weight, &half_opening.to_string(), &friction.to_string())
}

/// The state of an arch that stands, to some digits.
#[track_caller]
pub(crate) fn stands(arch: &Arch, digits: usize) -> Box<Digits> {
    match arch.certify(digits) {
        Ok(Answer::Stands(state)) => state,
        other => panic!("{arch}: {other:?}"),
    }
}

/// The friction at which Heyman's semicircle changes its mode, nearer than any precision that is tried can tell.
pub(crate) fn critical_friction() -> String {
    let Ok(Outcome::Stands(state)) = arch(H, "pi/2", "1").state(40_000) else { panic!() };
    let critical = state.frictions.unwrap().rotational.unwrap();
    critical.mid().to_string_radix(10, Some(11_000))
}

/// The tangent of a half opening of one half, to more digits than any precision that is tried.
pub(crate) fn tangent_of_one_half() -> String {
    Float::with_val(40_000, 0.5).tan().to_string_radix(10, Some(11_000))
}

/// What a landmark has of an unknown.
pub(crate) fn at_landmark(
    landmark: Landmark,
    weight: SelfWeight,
    unknown: Unknown,
    bits: u32,
) -> Ball {
    let point = CertifiedLandmark::new(landmark, weight).unwrap();
    point.enclosure(bits).unwrap().value(unknown).unwrap()
}
