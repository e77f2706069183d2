//! Keys that make two pieces of a scene the same, so that they are computed once.

use crate::arch::SelfWeight;
use crate::atlas::Contour;
use crate::number::{ExactNumber, Form};
use crate::problem::{Arch, Friction};
use rug::Rational;

/// Key that makes two arches the same, however they are written.
pub(super) type ArchKey = (SelfWeight, Number, Option<(bool, Number)>);
type Number = (Rational, Form);

fn number(x: &ExactNumber) -> Number {
    (x.to_rational(), x.form())
}

fn friction(friction: &Friction) -> Option<(bool, Number)> {
    match friction {
        Friction::Infinite => None,
        Friction::Coefficient(mu) => Some((false, number(mu))),
        Friction::Angle(phi) => Some((true, number(phi))),
    }
}

pub(super) fn arch_key(arch: &Arch) -> ArchKey {
    (arch.weight(), number(arch.half_opening()), friction(arch.friction()))
}

/// Key that makes two levels of the map the same, however they are written.
pub fn contour_key(contour: &Contour) -> (&'static str, Option<(bool, Number)>) {
    let value = match contour {
        Contour::HalfOpening(x) | Contour::Thickness(x) => Some((false, number(x))),
        Contour::Friction(mu) => friction(mu),
    };
    (contour.name(), value)
}
