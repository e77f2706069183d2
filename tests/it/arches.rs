//! Arches in few words.

use couplet::arch::SelfWeight;
use couplet::number::ExactNumber;
use couplet::problem::Arch;
use rug::Rational;

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
