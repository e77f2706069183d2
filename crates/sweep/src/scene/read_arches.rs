//! Reading from TOML to arches, by the reader of every other door: each key is a list of texts, and every weight goes
//! with every combination of them.

use super::read_numbers::{Meaning, Numbers, numbers};
use super::schema::{MAX_ARCHES, MeasuredArch, Request, SceneArch};
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling};
use crate::certify::MAX_DIGITS;
use crate::problem::Quantity;

/// Fields of which each makes an arch a measured one.
const SIZES: [Field; 6] =
    [Field::Span, Field::Rise, Field::Radius, Field::MeasuredAt, Field::Density, Field::Depth];

/// Question that any arch of a scene answers.
pub(super) const QUESTION: ArchQuestion =
    ArchQuestion { refuses: &[], needs: &[], unlimited: false, example: "" };

/// Key with its values.
pub(super) struct Axis {
    pub field: Field,
    pub values: Values,
    /// Text of all of it, if it is cut into boxes.
    pub whole: Option<String>,
}

/// Values of a key. Numbers are written out only when it is known that they are not too many.
pub(super) enum Values {
    Texts(Vec<String>),
    Numbers(Numbers),
}

impl Values {
    /// Number of values.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Texts(texts) => texts.len(),
            Self::Numbers(numbers) => numbers.len(),
        }
    }

    /// Exact texts of all.
    fn texts(self, table: &mut TableReader) -> Option<Vec<String>> {
        match self {
            Self::Texts(texts) => Some(texts),
            Self::Numbers(numbers) => table.texts(numbers),
        }
    }
}

/// Tells whether arches are measured.
pub(super) fn is_measured(table: &TableReader) -> bool {
    SIZES.iter().any(|field| table.get(field.name()).is_some())
}

/// Values of arches that a table gives.
pub(super) fn given_fields<'a>(table: &TableReader<'a, '_>) -> Vec<(Field, &'a TomlValue<'a>)> {
    let numbers = [Field::HalfOpening, Field::Friction, Field::FrictionAngle, Field::Thickness];
    let fields = numbers.into_iter().chain(SIZES);
    fields.filter_map(|of| Some((of, table.given_field(of)?))).collect()
}

/// An item of arches; `used` counts the arches of all items.
pub(super) fn arches(table: &mut TableReader, used: &mut usize) -> Option<Request> {
    let with_thickness = table.given_field(Field::Thickness).is_some();
    let weights = table.weights(&[SelfWeight::Milankovitch]);
    let arches = weights.as_ref().and_then(|weights| all(table, weights, used));
    let measured = arches.as_ref().and_then(|all| Some(&all.first()?.measured.as_ref()?.given));
    let [usual, of_measured] = match with_thickness {
        true => [&Quantity::ASSESSMENT[..], &Quantity::MEASURED_ASSESSMENT],
        false => [&Quantity::STATE[..], &Quantity::MEASURED_STATE],
    };
    // Of arches in metres that make no sense nobody knows what may be asked.
    let known = match measured {
        Some(given) => Some(given.quantities(usual, of_measured)),
        None => (!is_measured(table)).then(|| usual.to_vec()),
    };
    let quantities = known.map(|known| quantities(table, &known, with_thickness));
    let digits = digits(table, table.reader.digits);
    let (arches, quantities, digits) = (arches?, quantities??, digits?);
    Some(Request::Arches { arches, quantities, with_thickness, digits })
}

/// Arches of every combination of what is given, with each weight; `used` counts the arches of all items.
pub(super) fn all(
    table: &mut TableReader,
    weights: &[SelfWeight],
    used: &mut usize,
) -> Option<Vec<SceneArch>> {
    let before = table.reader.faults.len();
    let axes = axes(table)?;
    let asked = product(table, axes, weights.len(), used)?;
    let is_measured = is_measured(table);
    let mut arches = Vec::with_capacity(asked.len() * weights.len());
    for &weight in weights {
        for asked in &asked {
            let given = ArchGiven::read(&QUESTION, asked, Spelling::Key);
            let read = given.and_then(|given| Ok((given.arch(weight)?, given)));
            let Some((arch, given)) = table.fitting(read) else { continue };
            let thickness = given.thickness.clone();
            let measured = || Box::new(MeasuredArch { asked: asked.clone(), given });
            arches.push(SceneArch { arch, thickness, measured: is_measured.then(measured) });
        }
    }
    table.remark_on(arches.iter().map(|of| of.arch.friction()));
    table.is_well_since(before).then_some(arches)
}

/// Every combination of the texts of the keys, the last key fastest; `used` counts them, with each weight.
pub(super) fn product(
    table: &mut TableReader,
    axes: Vec<Axis>,
    weights: usize,
    used: &mut usize,
) -> Option<Vec<ArchAsked>> {
    let lengths = axes.iter().map(|axis| axis.values.len());
    let count = lengths.fold(weights, usize::saturating_mul);
    if count > MAX_ARCHES - *used {
        return table.too_many(count, *used);
    }
    *used += count;
    let mut all = vec![ArchAsked::default()];
    for axis in axes {
        let with = |asked: &ArchAsked, text: &String| {
            let mut asked = asked.clone();
            *asked.at(axis.field) = Some(text.clone());
            asked
        };
        let texts = axis.values.texts(table)?;
        all = all.iter().flat_map(|asked| texts.iter().map(|text| with(asked, text))).collect();
    }
    Some(all)
}

/// The keys that are given, with their texts: numbers in a list or in steps, and texts of sizes.
fn axes(table: &mut TableReader) -> Option<Vec<Axis>> {
    let before = table.reader.faults.len();
    let is_measured = is_measured(table);
    let alpha = match is_measured && table.given_field(Field::HalfOpening).is_none() {
        true => None,
        false => Some((Field::HalfOpening, half_openings(table))),
    };
    let eta = table.given(Meaning::Thickness).filter(|_| !is_measured);
    let eta = eta.map(|value| (Field::Thickness, numbers(table.reader, Meaning::Thickness, value)));
    let found = [alpha, Some((Field::Friction, frictions(table))), eta].into_iter().flatten();
    let mut all = Vec::new();
    for (field, numbers) in found.collect::<Vec<_>>() {
        let values = numbers.map(Values::Numbers);
        all.extend(values.map(|values| Axis { field, values, whole: None }));
    }
    for (field, value) in given_fields(table) {
        if is_measured && (field == Field::Thickness || SIZES.contains(&field)) {
            let allowed = "a text, as the command has it (\"10m\"), or a list";
            all.extend(axis(table.reader, (field, allowed), value));
        }
    }
    table.is_well_since(before).then_some(all)
}

/// A key whose texts are read as they are, each once.
pub(super) fn axis(
    reader: &mut TomlReader,
    (field, allowed): (Field, &str),
    value: &TomlValue,
) -> Option<Axis> {
    let read = |reader: &mut TomlReader, element: &TomlValue| match TomlReader::literal(element) {
        Some(text) => Some((text.to_owned(), text.to_owned())),
        None => reader.reject(field.name(), element, allowed),
    };
    let texts = reader.each_once(field.name(), value, allowed, read)?;
    Some(Axis { field, values: Values::Texts(texts), whole: None })
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

/// Significant digits, so many where nothing is said.
pub(super) fn digits(table: &mut TableReader, usual: usize) -> Option<usize> {
    table.or("digits", usual, |reader, key, value| reader.whole(key, value, 1..=MAX_DIGITS))
}
