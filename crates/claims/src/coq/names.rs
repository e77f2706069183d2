//! The names in which Coq knows landmarks, self-weights and variables, and the numbers that every file has.

use super::numeral::{exact, nearest, text, unit};
use crate::arch::{SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::Ball;
use crate::problem::{Fixed, Landmark, System};

/// Bits of an enclosure from which digits are printed.
pub(super) const BITS: u32 = 512;
/// Decimals to which a centre is known.
pub(super) const DECIMALS: u32 = 30;

/// The name of the Coq module of a landmark.
pub(super) fn module(landmark: Landmark, weight: SelfWeight) -> String {
    format!("{landmark:?}{weight:?}")
}

/// The point of a landmark.
pub(super) fn find(
    points: &[CertifiedLandmark],
    landmark: Landmark,
    weight: SelfWeight,
) -> Result<&CertifiedLandmark, Undecided> {
    let is_it =
        |point: &&CertifiedLandmark| (point.landmark(), point.weight()) == (landmark, weight);
    let missing = || Undecided::new(format!("{landmark} is missing"));
    points.iter().find(is_it).ok_or_else(missing)
}

/// The digits of a number and the bracket that proves them.
pub(super) fn bracket(value: &Ball) -> Vec<(&'static str, String)> {
    let centre = nearest(&exact(value.mid()), DECIMALS + 2);
    let radius = unit(DECIMALS);
    let (lo, hi) = (centre.clone() - &radius, centre.clone() + &radius);
    let named = [("centre", centre), ("radius", radius), ("lo", lo), ("hi", hi)];
    named.map(|(name, value)| (name, text(&value))).to_vec()
}

/// Name of a self-weight in a sentence.
pub(super) fn weight_name(weight: SelfWeight) -> &'static str {
    match weight {
        SelfWeight::Heyman => "Heyman's self-weight",
        SelfWeight::Milankovitch => "Milankovitch's self-weight",
    }
}

/// The name of a variable in Coq.
pub(super) fn symbol(unknown: Unknown) -> &'static str {
    match unknown {
        Unknown::HalfOpening => "alpha",
        Unknown::RotationJoint => "beta_r",
        Unknown::SlidingJoint => "beta_s",
        Unknown::Thickness => "eta",
        Unknown::Thrust => "h",
        Unknown::Friction => "mu",
        Unknown::CrownHinge => "b0",
        Unknown::CrownMoment => "p",
        Unknown::VerticalForce => "v",
    }
}

/// The names of the unknowns of a system, in its order.
pub(super) fn symbols(system: &System) -> Vec<&'static str> {
    system.unknowns.iter().map(|&unknown| symbol(unknown)).collect()
}

/// A variable of a system as an argument in Coq: its name, or the value it is fixed to.
pub(super) fn argument(system: &System, unknown: Unknown) -> String {
    match system.fixed_value(unknown) {
        Some(Fixed::Integer(n)) => n.to_string(),
        Some(Fixed::SameAs(other)) => symbol(other).into(),
        Some(Fixed::Infinite) | None => symbol(unknown).into(),
    }
}
