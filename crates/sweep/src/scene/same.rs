//! What makes two pieces of a scene the same, so that they are computed once.

use super::schema::Drawn;
use crate::arch::SelfWeight;
use crate::atlas::Contour;
use crate::number::{ExactNumber, Form};
use crate::problem::{Arch, Friction, Landmark};
use rug::Rational;

/// What makes two arches the same, however they are written.
pub(super) type ArchKey = (SelfWeight, Number, Option<(bool, Number)>);
type Number = (Rational, Form);
type DrawnKey = (Option<Landmark>, Option<ArchKey>, Option<u64>, Option<Rational>, bool);

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

/// What makes two levels of the map the same, however they are written.
pub fn contour_key(contour: &Contour) -> (&'static str, Option<(bool, Number)>) {
    let value = match contour {
        Contour::HalfOpening(x) | Contour::Thickness(x) => Some((false, number(x))),
        Contour::Friction(mu) => friction(mu),
    };
    (contour.name(), value)
}

/// What makes two drawn arches the same; no friction is read of one that slides.
pub(super) fn drawn_key(drawn: &Drawn) -> DrawnKey {
    let is_dilatant = drawn.is_dilatant();
    match drawn {
        Drawn::Least { arch, stones, .. } => {
            (None, Some(arch_key(arch)), *stones, None, is_dilatant)
        }
        Drawn::Landmark { landmark, .. } => (Some(*landmark), None, None, None, is_dilatant),
        Drawn::Standing { arch, stones, thickness } => {
            (None, Some(arch_key(arch)), *stones, Some(thickness.to_rational()), is_dilatant)
        }
        Drawn::Sliding { arch, thickness, .. } => {
            (None, Some(arch_key(arch)), None, Some(thickness.to_rational()), is_dilatant)
        }
    }
}
