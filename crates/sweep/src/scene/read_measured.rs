//! Reading from TOML to arches that are measured, by the reader of every other door.

use super::read_arches::{digits, frictions, half_openings, quantities};
use super::read_numbers::Numbers;
use super::schema::{MAX_ARCHES, MeasuredArch, Request, SceneArch};
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Misfit, Spelling};
use crate::problem::Quantity;

/// Fields of which each makes an arch a measured one.
const SIZES: [Field; 6] =
    [Field::Span, Field::Rise, Field::Radius, Field::MeasuredAt, Field::Density, Field::Depth];

const QUESTION: ArchQuestion =
    ArchQuestion { refuses: &[], needs: &[], unlimited: false, example: "" };

/// Tells whether arches are measured.
pub(super) fn is_measured(table: &TableReader) -> bool {
    SIZES.iter().any(|field| table.get(field.name()).is_some())
}

/// An item of arches in metres.
pub(super) fn arches(table: &mut TableReader, used: &mut usize) -> Option<Request> {
    let weights = table.weights(&[SelfWeight::Milankovitch])?;
    let with_thickness = table.given_field(Field::Thickness).is_some();
    let arches = measured(table, &weights, used)?;
    let given = arches.first()?.measured.as_ref()?;
    let all = match with_thickness {
        true => given.given.quantities(&Quantity::ASSESSMENT, &Quantity::MEASURED_ASSESSMENT),
        false => given.given.quantities(&Quantity::STATE, &Quantity::MEASURED_STATE),
    };
    let (quantities, digits) = (quantities(table, &all, with_thickness), digits(table));
    Some(Request::Arches { arches, quantities: quantities?, with_thickness, digits: digits? })
}

/// Arches of every combination of what is given, with each weight; `used` counts the arches of all items.
pub(super) fn measured(
    table: &mut TableReader,
    weights: &[SelfWeight],
    used: &mut usize,
) -> Option<Vec<SceneArch>> {
    let before = table.reader.faults.len();
    let mut all = vec![ArchAsked::default()];
    for field in [Field::HalfOpening, Field::Friction, Field::Thickness].into_iter().chain(SIZES) {
        let texts = match field {
            Field::HalfOpening if table.given_field(field).is_none() => continue,
            Field::HalfOpening => half_openings(table).and_then(|all| written(table, all)),
            Field::Friction => frictions(table).and_then(|all| written(table, all)),
            _ => match table.given_field(field) {
                Some(value) => texts(table.reader, field, value),
                None => continue,
            },
        };
        let Some(texts) = texts else { continue };
        let count = all.len().saturating_mul(texts.len()).saturating_mul(weights.len());
        if count > MAX_ARCHES - *used {
            return table.too_many(count, *used);
        }
        let with = |asked: &ArchAsked, text: &String| {
            let mut asked = asked.clone();
            *asked.at(field) = Some(text.clone());
            asked
        };
        all = all.iter().flat_map(|asked| texts.iter().map(|text| with(asked, text))).collect();
    }
    *used += all.len() * weights.len();
    if !table.is_well_since(before) {
        return None;
    }
    let mut arches = Vec::new();
    for &weight in weights {
        for asked in &all {
            match read(asked, weight) {
                Ok(arch) => arches.push(arch),
                Err(Misfit { field, message }) => {
                    let value = field.and_then(|field| table.given_field(field));
                    let span = value.map_or(table.span.clone(), |value| value.span());
                    table.reader.fault(span, message);
                }
            }
        }
    }
    table.is_well_since(before).then_some(arches)
}

fn read(asked: &ArchAsked, weight: SelfWeight) -> Result<SceneArch, Misfit> {
    let given = ArchGiven::read(&QUESTION, asked, Spelling::Key)?;
    let (arch, thickness) = (given.arch(weight)?, given.thickness.clone());
    let measured = MeasuredArch { asked: asked.clone(), given };
    Ok(SceneArch { arch, thickness, measured: Some(Box::new(measured)) })
}

/// Texts of numbers.
fn written(table: &mut TableReader, all: Numbers) -> Option<Vec<String>> {
    Some(table.written(all)?.into_iter().map(|number| number.exact_text()).collect())
}

/// Texts of a key, each once.
fn texts(reader: &mut TomlReader, field: Field, value: &TomlValue) -> Option<Vec<String>> {
    let allowed = "a text, as the command has it (\"10m\"), or a list";
    reader.each_once(field.name(), value, allowed, |reader, element| {
        match TomlReader::literal(element) {
            Some(text) => Some((text.to_owned(), text.to_owned())),
            None => reader.reject(field.name(), element, allowed),
        }
    })
}
