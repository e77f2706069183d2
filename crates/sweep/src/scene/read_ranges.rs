//! Reading from TOML to arches between two ends, by the reader of every other door; and a range cut into boxes.

use super::read_arches::{Axis, QUESTION, Values, axis, digits, given_fields, product, quantities};
use super::read_numbers::{Meaning, numbers};
use super::schema::{MAX_ARCHES, MAX_RANGES, Request, SceneBoxes, SceneSurvey};
use super::table::TableReader;
use super::value::{TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, Field, Misfit, Range, Spelling, SurveyGiven, boxes};
use crate::number::{BETWEEN, is_range};
use crate::problem::Quantity;
use crate::report::words::{distinct, list};
use crate::report::{Format, Reported, SurveyedArches, SurveyedRows};
use crate::surveyed;
use toml::de::{DeTable, DeValue};

/// Tells whether a value of an item of arches is a range.
pub(super) fn are_ranged(table: &TableReader) -> bool {
    given_fields(table).iter().any(|(_, value)| is_ranged(value))
}

/// Tells whether a value, or one of a list, is a range.
fn is_ranged(value: &TomlValue) -> bool {
    match value.get_ref() {
        DeValue::Array(all) => all.iter().any(is_ranged),
        DeValue::Table(table) => table.contains_key("boxes"),
        DeValue::String(text) => is_range(text),
        _ => false,
    }
}

/// An item of arches with ranges; `used` counts the arches of all items, of which each range is one here.
pub(super) fn arches(
    table: &mut TableReader,
    format: Option<&'static Format>,
    used: &mut usize,
) -> Option<Request> {
    let before = table.reader.faults.len();
    is_written(table, format);
    let weights = table.weights(&[SelfWeight::Milankovitch]);
    let axes = axes(table);
    let with_thickness = table.given_field(Field::Thickness).is_some();
    let told = surveyed::told(|field| table.given_field(field).is_some());
    let quantities = quantities(table, &told, with_thickness);
    let digits = digits(table, table.reader.range_digits);
    let (weights, axes) = (weights?, axes?);
    let quantities = distinct(quantities?.into_iter().map(|of| match of {
        // The thickness of a state is the least.
        Quantity::Thickness => Quantity::LeastThickness,
        other => other,
    }));
    let boxes = whole(table, &axes, &quantities)?;
    let all = product(table, axes, weights.len(), used)?;
    let count = all.len() * weights.len();
    if boxes.is_none() && count > MAX_RANGES {
        return table.refuse(format!(
            "{count} ranges are too many; an item has at most {MAX_RANGES}, `couplet states --ranges` reads any number"
        ));
    }
    let read: Vec<_> = all.iter().filter_map(|asked| table.fitting(given(asked))).collect();
    table.remark_on(read.iter().flat_map(|given| &given.friction));
    if !table.is_well_since(before) {
        return None;
    }
    let surveys = weights.iter().flat_map(|&weight| {
        all.iter().map(move |asked| SceneSurvey { asked: asked.clone(), weight })
    });
    Some(Request::Surveys { surveys: surveys.collect(), boxes, quantities, digits: digits? })
}

/// Refuses a format that ranges do not have.
fn is_written(table: &mut TableReader, format: Option<&'static Format>) {
    let content = SurveyedArches::content();
    if let Some(format) = format.filter(|format| !content.is_written_as(format)) {
        let place = table.get("format").or_else(|| table.get("output"));
        let span = place.map_or(table.span.clone(), |value| value.span());
        let (names, name) = (Format::names(content), format.name);
        let message = format!("the answer of a range is written only as {names}, not {name}");
        table.reader.fault(span, message);
    }
}

/// The question about all boxes, if any range is cut; `None` if that makes no sense.
fn whole(
    table: &mut TableReader,
    axes: &[Axis],
    quantities: &[Quantity],
) -> Option<Option<Box<SceneBoxes>>> {
    let cut: Vec<(Field, usize)> = axes
        .iter()
        .filter(|axis| axis.whole.is_some())
        .map(|axis| (axis.field, axis.values.len()))
        .collect();
    if cut.is_empty() {
        return Some(None);
    }
    if let Some(many) = axes.iter().find(|axis| axis.whole.is_none() && axis.values.len() > 1) {
        let name = many.field.name();
        let span = table.given_field(many.field).map_or(table.span.clone(), |value| value.span());
        let message = format!("beside boxes {name} is one value, one range, or boxes too");
        return table.reader.refuse(span, message);
    }
    let mut asked = ArchAsked::default();
    for axis in axes {
        // What is not cut is one text.
        let one = match &axis.values {
            Values::Texts(texts) => texts.first().cloned(),
            Values::Numbers(_) => None,
        };
        *asked.at(axis.field) = axis.whole.clone().or(one);
    }
    let given = table.fitting(given(&asked))?;
    let rows = SurveyedRows::new(quantities.to_vec(), asked.thickness.is_some());
    Some(Some(Box::new(SceneBoxes { asked, given, cut, rows })))
}

/// The arches of a question.
pub(super) fn given(asked: &ArchAsked) -> Result<SurveyGiven, Misfit> {
    SurveyGiven::read(&QUESTION, asked, Spelling::Key)
}

/// The keys that are given, with their texts.
fn axes(table: &mut TableReader) -> Option<Vec<Axis>> {
    let before = table.reader.faults.len();
    let mut axes = Vec::new();
    for (field, value) in given_fields(table) {
        let meaning = Meaning::of(field);
        meaning.map(|meaning| table.given(meaning));
        axes.extend(match (value.get_ref(), meaning) {
            (DeValue::Table(parts), _) if parts.contains_key("boxes") => {
                cut(table.reader, field, value, parts)
            }
            (DeValue::Table(_), Some(meaning)) => {
                let values = numbers(table.reader, meaning, value).map(Values::Numbers);
                // The angle of a friction says itself that it is one.
                let field = if field == Field::FrictionAngle { Field::Friction } else { field };
                values.map(|values| Axis { field, values, whole: None })
            }
            _ => {
                let allowed = "a number, a range (\"0.5..0.6\", \"3m±1cm\"), or a list";
                axis(table.reader, (field, allowed), value)
            }
        });
    }
    table.is_well_since(before).then_some(axes)
}

/// `{ from, to, boxes }`: ranges that touch each other from end to end.
fn cut(reader: &mut TomlReader, field: Field, value: &TomlValue, parts: &DeTable) -> Option<Axis> {
    let keys = ["from", "to", "boxes"];
    let name = field.name();
    reader.unknown_keys(parts, "a range in boxes", &keys, &[]);
    let mut end = |key: &str| {
        let Some(end) = parts.get(key) else {
            let message = format!(
                "{name} has no {key}; boxes are {{ from = …, to = …, boxes = … }}: all of {}",
                list(keys)
            );
            return reader.refuse(value.span(), message);
        };
        let text = TomlReader::literal(end).filter(|text| !is_range(text));
        text.map(str::to_owned).or_else(|| reader.reject(key, end, "one value"))
    };
    let (lower, upper) = (end("from"), end("to"));
    let count = reader.whole("boxes", parts.get("boxes")?, 1..=MAX_ARCHES);
    let range = Range { lower: lower?, upper: upper? };
    let text = |range: &Range| format!("{}{BETWEEN}{}", range.lower, range.upper);
    match boxes(&range, count?) {
        Ok(all) => {
            let values = Values::Texts(all.map(|part| text(&part)).collect());
            Some(Axis { field, values, whole: Some(text(&range)) })
        }
        Err(error) => reader.refuse(value.span(), error.to_string()),
    }
}
