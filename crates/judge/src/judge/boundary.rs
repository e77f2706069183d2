//! Distance to another mode, where the one that is claimed is wrong.

use super::printed_rational::PrintedRational;
use crate::certify::state::{Answer, Certify};
use crate::number::{Decimal, ExactNumber, Rounded, power_of_ten};
use crate::problem::{Arch, Friction, Mode, Quantity};
use rug::Rational;

/// A boundary between two modes, within the rounding of what is given of an arch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// Quantity that has to be moved for the other mode: the friction or the half opening.
    pub quantity: Quantity,
    /// Bound of the distance, in the unit in which it is given.
    pub within: Decimal,
}

/// Powers of ten by which a boundary may be nearer than the rounding.
const POWERS: u32 = 40;

impl Boundary {
    /// The boundary of `mode` next to an arch of another mode: half a unit of the last place of the friction
    /// or of the half opening away at most. It is proved: the moved arch has that mode. `None` if none is
    /// found so near, and for what is not a decimal with a point, which nobody has rounded.
    pub(super) fn near(arch: &Arch, mode: Mode) -> Option<Self> {
        [Quantity::Friction, Quantity::HalfOpening].into_iter().find_map(|quantity| {
            let mut own = (arch.half_opening().clone(), arch.friction().clone());
            let half = half_unit(given(&mut own, quantity)?)?;
            [half.clone(), -half].into_iter().find_map(|step| {
                let steps = (0..POWERS).map(|power| step.clone() / power_of_ten(power));
                let nearest =
                    steps.take_while(|step| mode_beside(arch, quantity, step) == Some(mode));
                let within = Rounded::from_rational(&nearest.last()?.abs(), 1)?.value;
                Some(Self { quantity, within })
            })
        })
    }
}

/// The half opening or the friction of the two that are given.
fn given(
    (half_opening, friction): &mut (ExactNumber, Friction),
    quantity: Quantity,
) -> Option<&mut ExactNumber> {
    match (quantity, friction) {
        (Quantity::HalfOpening, _) => Some(half_opening),
        (_, Friction::Coefficient(x) | Friction::Angle(x)) => Some(x),
        (_, Friction::Infinite) => None,
    }
}

/// Half a unit of the last place of a decimal with a point, in the unit in which it is given.
fn half_unit(x: &ExactNumber) -> Option<Rational> {
    let text = x.to_string();
    let number = text.strip_suffix("deg").unwrap_or(&text);
    let decimal: Decimal = number.parse().ok().filter(|_| number.contains('.'))?;
    Some(PrintedRational::power_of_ten(decimal.exponent())?.to_rational() / 2u32)
}

/// The mode of the arch in which what is given is moved by a step; `None` if it falls or that is not certain.
fn mode_beside(arch: &Arch, quantity: Quantity, step: &Rational) -> Option<Mode> {
    let mut moved = (arch.half_opening().clone(), arch.friction().clone());
    let x = given(&mut moved, quantity)?;
    *x = match x.is_in_degrees() {
        true => ExactNumber::from(&(x.to_rational() * 180u32 + step)).degrees(),
        // Of the others only a rational number has a decimal that can be moved.
        false => ExactNumber::from(&(x.to_rational() + step)),
    };
    let (half_opening, friction) = moved;
    match Arch::new(arch.weight(), half_opening, friction).ok()?.certify_alone(1) {
        Ok(Answer::Stands(state)) => Some(state.mode),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_boundary_is_found_within_the_rounding_of_what_is_given() {
        // Collapse of this arch is purely rotational from the friction 0.39583203813806954… on.
        let near = |mu: &str, mode: Mode| {
            let arch = Arch::parse("heyman", "pi/2", mu).unwrap();
            let found = Boundary::near(&arch, mode)?;
            Some((found.quantity, found.within.to_string()))
        };
        let friction = |within: &str| Some((Quantity::Friction, within.to_owned()));
        assert_eq!(near("0.3958320381380695", Mode::Rotational), friction("5e-17"));
        assert_eq!(near("0.39583", Mode::Rotational), friction("0.000005"));
        assert_eq!(near("0.39580", Mode::Rotational), None);
        assert_eq!(near("0.39583", Mode::Overturning), None, "no such mode is near");
        let degrees = Arch::parse("heyman", "90.0deg", "0.3958").unwrap();
        assert!(Boundary::near(&degrees, Mode::Rotational).is_some());
    }
}
