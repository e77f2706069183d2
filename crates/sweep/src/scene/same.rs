//! Keys that make two pieces of a scene the same, however their numbers are written, so that they are computed once.

use crate::ask::ArchGiven;
use crate::atlas::Contour;
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction};

pub(super) fn number_key(x: &ExactNumber) -> String {
    format!("{} {:?}", x.to_rational(), x.form())
}

fn friction_key(friction: &Friction) -> String {
    match friction {
        Friction::Infinite => "inf".to_owned(),
        Friction::Coefficient(mu) => number_key(mu),
        Friction::Angle(phi) => format!("tan {}", number_key(phi)),
    }
}

pub(super) fn arch_key(arch: &Arch) -> String {
    let (alpha, mu) = (number_key(arch.half_opening()), friction_key(arch.friction()));
    format!("{} {alpha} {mu}", arch.weight().name())
}

/// Key of the number of which alone something is given, if it is one.
pub(super) fn given_key(given: &ArchGiven) -> Option<String> {
    let number = given.half_opening.as_ref().or(given.thickness.as_ref()).map(number_key);
    number.or_else(|| given.friction.as_ref().map(friction_key))
}

/// Key that makes two levels of the map the same.
pub fn contour_key(contour: &Contour) -> String {
    let key = match contour {
        Contour::HalfOpening(x) | Contour::Thickness(x) => number_key(x),
        Contour::Friction(mu) => friction_key(mu),
    };
    format!("{} {key}", contour.name())
}
