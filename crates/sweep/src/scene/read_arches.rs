//! Reading from TOML to arches: every half opening with every friction, thickness and weight.

use super::read_numbers::{Meaning, Numbers, SceneNumber, numbers};
use super::schema::{MAX_ARCHES, Request, SceneArch};
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::number::ExactNumber;
use crate::problem::{Arch, Quantity};

/// An item of arches; `used` counts the arches of all items.
pub(super) fn arches(table: &mut TableReader, used: &mut usize) -> Option<Request> {
    let thickness = table.given(Meaning::Thickness);
    let with_thickness = thickness.is_some();
    let weights = table.weights(&[SelfWeight::Milankovitch]);
    let half_openings = half_openings(table);
    let frictions = frictions(table);
    let thicknesses = match thickness {
        Some(value) => numbers(table.reader, Meaning::Thickness, value).map(Some),
        None => Some(None),
    };
    let all: &[Quantity] = if with_thickness { &Quantity::ASSESSMENT } else { &Quantity::STATE };
    let asked = quantities(table, all, with_thickness);
    let digits = digits(table);
    let (weights, half_openings, frictions) = (weights?, half_openings?, frictions?);
    let (thicknesses, digits) = (thicknesses?, digits?);
    let thickness_count = thicknesses.as_ref().map_or(1, Numbers::len);
    let count = [weights.len(), half_openings.len(), frictions.len(), thickness_count]
        .into_iter()
        .fold(1usize, usize::saturating_mul);
    if count > MAX_ARCHES - *used {
        return table.too_many(count, *used);
    }
    *used += count;
    let (half_openings, frictions) = (table.written(half_openings)?, table.written(frictions)?);
    let thicknesses = match thicknesses {
        Some(numbers) => table.written(numbers)?.into_iter().map(|given| given.number).collect(),
        None => vec![None],
    };
    let arches = product(&weights, &half_openings, &frictions, &thicknesses);
    Some(Request::Arches { arches, quantities: asked?, with_thickness, digits })
}

/// Quantities that are asked for, in the order in which they are always shown.
pub(super) fn quantities(
    table: &mut TableReader,
    all: &[Quantity],
    with_thickness: bool,
) -> Option<Vec<Quantity>> {
    let known: Vec<_> = all.iter().map(|quantity| (quantity.name(), *quantity)).collect();
    let asked = table.or("quantities", all.to_vec(), |reader, key, value| {
        match !with_thickness && needs_thickness(reader, value) {
            true => None,
            false => reader.names(key, value, &known),
        }
    })?;
    Some(all.iter().copied().filter(|quantity| asked.contains(quantity)).collect())
}

/// Tells whether quantities of arches of given thickness are asked for: then that is what is missing.
fn needs_thickness(reader: &mut TomlReader, value: &TomlValue) -> bool {
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
pub(super) fn half_openings(table: &mut TableReader) -> Option<Numbers> {
    let meaning = Meaning::HalfOpening;
    match table.given(meaning) {
        Some(value) => numbers(table.reader, meaning, value),
        None => table.refuse("half_opening is missing"),
    }
}

/// The frictions, or their angles.
pub(super) fn frictions(table: &mut TableReader) -> Option<Numbers> {
    let given = [Meaning::Friction, Meaning::FrictionAngle].map(|meaning| {
        let value = table.given(meaning)?;
        Some((value.span(), numbers(table.reader, meaning, value)))
    });
    match given {
        [Some(_), Some((angle, _))] => {
            table.reader.refuse(angle, "friction and friction_angle say the same: give one of them")
        }
        [Some((_, numbers)), None] | [None, Some((_, numbers))] => numbers,
        [None, None] => table.refuse("friction (or friction_angle) is missing"),
    }
}

pub(super) fn digits(table: &mut TableReader) -> Option<usize> {
    let all = table.reader.digits;
    table.or("digits", all, |reader, key, value| reader.whole(key, value, 1..=MAX_DIGITS))
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
                    measured: None,
                }));
            }
        }
    }
    arches
}
