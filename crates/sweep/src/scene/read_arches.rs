//! From TOML to arches: every half opening with every friction, thickness and weight.

use super::overall::Overall;
use super::read_numbers::{Meaning, Numbers, SceneNumber, numbers};
use super::schema::{MAX_ARCHES, SceneArch, What};
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::certify::MAX_ARCH_DIGITS;
use crate::number::{ExactNumber, ParseExactError};
use crate::problem::Arch;
use crate::problem::Quantity;
use std::ops::Range;
use toml::de::DeTable;

/// An item of arches; `used` counts the arches of all items.
pub(super) fn arches(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
    used: &mut usize,
) -> Option<What> {
    let thickness = Meaning::Thickness.given(reader, table);
    let with_thickness = thickness.is_some();
    let weights = overall.weights(reader, table, &[SelfWeight::Milankovitch]);
    let half_openings = half_openings(reader, span, table);
    let frictions = frictions(reader, span, table);
    let thicknesses = match thickness {
        Some(value) => numbers(reader, Meaning::Thickness, value).map(Some),
        None => Some(None),
    };
    let all: &[Quantity] = if with_thickness { &Quantity::ASSESSMENT } else { &Quantity::STATE };
    let known: Vec<_> = all.iter().map(|quantity| (quantity.name(), *quantity)).collect();
    let asked = match table.get("quantities") {
        Some(value) if !with_thickness && needs_thickness(reader, value) => None,
        Some(value) => reader.names("quantities", value, &known),
        None => Some(all.to_vec()),
    };
    let digits = arch_digits(reader, span, table, overall);
    let (weights, half_openings, frictions) = (weights?, half_openings?, frictions?);
    let (thicknesses, asked, digits) = (thicknesses?, asked?, digits?);
    let thickness_count = thicknesses.as_ref().map_or(1, Numbers::len);
    let count = [weights.len(), half_openings.len(), frictions.len(), thickness_count]
        .into_iter()
        .fold(1usize, usize::saturating_mul);
    if count > MAX_ARCHES - *used {
        let before = if *used > 0 { format!(" after {used} before") } else { String::new() };
        let message = format!(
            "{count} arches{before} are too many; a scene has at most {MAX_ARCHES}, `couplet states` \
                 reads any number"
        );
        reader.fault(span.clone(), message);
        return None;
    }
    *used += count;
    let mut written = |numbers: Numbers| {
        let fault = |error: ParseExactError| reader.fault(span.clone(), error.to_string());
        numbers.all().map_err(fault).ok()
    };
    let (half_openings, frictions) = (written(half_openings)?, written(frictions)?);
    let thicknesses = match thicknesses {
        Some(numbers) => written(numbers)?.into_iter().map(|given| given.number).collect(),
        None => vec![None],
    };
    let arches = product(&weights, &half_openings, &frictions, &thicknesses);
    let quantities = all.iter().copied().filter(|quantity| asked.contains(quantity)).collect();
    Some(What::Arches { arches, quantities, with_thickness, digits })
}

/// Whether quantities of arches of given thickness are asked for: then that is what is missing.
fn needs_thickness(reader: &mut Reader, value: &Value) -> bool {
    let before = reader.faults.len();
    for element in reader.elements("quantities", value, "names of quantities") {
        let name = element.get_ref().as_str().unwrap_or_default();
        if Quantity::ASSESSMENT.iter().any(|quantity| quantity.name() == name) {
            let allowed = Meaning::Thickness.allowed();
            let message = format!("quantities \"{name}\" needs a thickness; give {allowed}");
            reader.fault(element.span(), message);
        }
    }
    reader.faults.len() > before
}

/// The half openings.
pub(super) fn half_openings(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
) -> Option<Numbers> {
    if let Some(value) = Meaning::HalfOpening.given(reader, table) {
        return numbers(reader, Meaning::HalfOpening, value);
    }
    let allowed = Meaning::HalfOpening.allowed();
    reader.fault(span.clone(), format!("half_opening is missing; give {allowed}"));
    None
}

/// The frictions, or their angles.
pub(super) fn frictions(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
) -> Option<Numbers> {
    let given = [Meaning::Friction, Meaning::FrictionAngle].map(|meaning| {
        let value = meaning.given(reader, table)?;
        Some((value.span(), numbers(reader, meaning, value)))
    });
    match given {
        [Some(_), Some((angle, _))] => {
            reader.fault(angle, "both friction and friction_angle; give one of them".to_owned());
            None
        }
        [Some((_, numbers)), None] | [None, Some((_, numbers))] => numbers,
        [None, None] => {
            let (mu, phi) = (Meaning::Friction.allowed(), Meaning::FrictionAngle.allowed());
            let message = format!("friction is missing; give {mu}, or friction_angle, {phi}");
            reader.fault(span.clone(), message);
            None
        }
    }
}

fn arch_digits(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
) -> Option<usize> {
    match table.get("digits") {
        Some(value) => reader.whole("digits", value, 1..=MAX_ARCH_DIGITS),
        None if overall.digits > MAX_ARCH_DIGITS => {
            let message = format!(
                "the scene's {} digits are too many for arches; give this item digits of its own, 1 \
                 to {MAX_ARCH_DIGITS}",
                overall.digits
            );
            reader.fault(span.clone(), message);
            None
        }
        None => Some(overall.digits),
    }
}

/// Every weight with every half opening, friction and thickness, in this order.
pub(super) fn product(
    weights: &[SelfWeight],
    half_openings: &[SceneNumber],
    frictions: &[SceneNumber],
    thicknesses: &[Option<ExactNumber>],
) -> Vec<SceneArch> {
    let mut arches = Vec::new();
    for &weight in weights {
        for half_opening in half_openings.iter().filter_map(|given| given.number.as_ref()) {
            for given in frictions {
                let friction = given.clone().friction();
                // Each number was found to be in its range.
                let Ok(arch) = Arch::new(weight, half_opening.clone(), friction) else { continue };
                arches.extend(thicknesses.iter().map(|thickness| SceneArch {
                    arch: arch.clone(),
                    thickness: thickness.clone(),
                }));
            }
        }
    }
    arches
}
