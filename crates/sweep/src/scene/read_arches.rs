//! Reading from TOML to arches, or to arches between two ends where any value is a range.

use super::axes::{ArchAxis, axes, example, is_measured, product};
use super::schema::{
    DIGITS, MAX_RANGES, MeasuredArch, RANGE_DIGITS, Request, SceneArch, SceneBoxes, SceneSurvey,
};
use super::table::TableReader;
use super::value::TomlValue;
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Misfit, Spelling, SurveyGiven};
use crate::number::is_range;
use crate::problem::Quantity;
use crate::report::words::distinct;
use crate::report::{Format, Reported, SurveyedArches, SurveyedRows, Understood};
use crate::surveyed;
use toml::de::DeValue;

/// Tells whether a value, or one of a list, is a range.
fn is_ranged(value: &TomlValue) -> bool {
    match value.get_ref() {
        DeValue::Array(all) => all.iter().any(is_ranged),
        DeValue::Table(table) => table.contains_key("boxes"),
        DeValue::String(text) => is_range(text),
        _ => false,
    }
}

/// An item of arches; `used` counts the arches of all items, of which each range is one.
pub(super) fn arches(
    table: &mut TableReader,
    format: Option<&'static Format>,
    used: &mut usize,
) -> Option<Request> {
    let ranges = Field::ALL.iter().filter_map(|of| table.given_field(*of)).any(is_ranged);
    if ranges {
        is_written(table, format);
    }
    let weights = table.weights(&[SelfWeight::Milankovitch]);
    let measured = is_measured(table);
    let axes = axes(table, Some(&ArchQuestion::ANY), ranges);
    let has = |field| table.given_field(field).is_some();
    let with_thickness = has(Field::Thickness);
    let known = if ranges {
        surveyed::told(has)
    } else {
        Quantity::of_arch(has(Field::Thickness), measured.then(|| has(Field::Density)))
    };
    let quantities = quantities(table, &known);
    let digits = table.digits(if ranges { RANGE_DIGITS } else { DIGITS });
    let (weights, axes, quantities, digits) = (weights?, axes?, quantities?, digits?);
    if ranges {
        return surveys(table, axes, &weights, (quantities, digits), used);
    }
    let asked = product(table, axes, weights.len(), used)?;
    let arches = all(table, &asked, &weights, measured);
    Some(Request::Arches { arches, quantities, with_thickness, digits })
}

/// Arches of questions that were found to go together, with each weight.
fn all(
    table: &mut TableReader,
    asked: &[ArchAsked],
    weights: &[SelfWeight],
    is_measured: bool,
) -> Vec<SceneArch> {
    let mut arches = Vec::with_capacity(asked.len() * weights.len());
    for &weight in weights {
        for asked in asked {
            let given = ArchGiven::read(&ArchQuestion::ANY, asked, Spelling::Key);
            let read = given.and_then(|given| Ok((given.arch(weight)?, given)));
            let Some((arch, given)) = table.fitting(read) else { continue };
            let thickness = given.thickness.clone();
            let measured = || Box::new(MeasuredArch { asked: asked.clone(), given });
            arches.push(SceneArch { arch, thickness, measured: is_measured.then(measured) });
        }
    }
    table.remark_on(arches.iter().map(|of| of.arch.friction()));
    arches
}

/// Arches between two ends, which may be boxes of one question.
fn surveys(
    table: &mut TableReader,
    axes: Vec<ArchAxis>,
    weights: &[SelfWeight],
    (quantities, digits): (Vec<Quantity>, usize),
    used: &mut usize,
) -> Option<Request> {
    // The thickness of a state is the least.
    let least = |of| if of == Quantity::Thickness { Quantity::LeastThickness } else { of };
    let quantities = distinct(quantities.into_iter().map(least));
    let cut = |axis: &ArchAxis| Some((axis.field, axis.count, axis.whole.clone()?));
    let cut: Vec<(Field, usize, String)> = axes.iter().filter_map(cut).collect();
    let several = axes.iter().find(|axis| axis.whole.is_none() && axis.count > 1);
    if let (false, Some(ArchAxis { field, .. })) = (cut.is_empty(), several) {
        let message =
            format!("beside boxes {} is one value, one range, or boxes too", field.name());
        return table.fitting(Err(Misfit { field: Some(*field), message }));
    }
    let all = product(table, axes, weights.len(), used)?;
    let count = all.len() * weights.len();
    if cut.is_empty() && count > MAX_RANGES {
        return table.refuse(format!(
            "{count} ranges are too many; an item has at most {MAX_RANGES}, `couplet states --ranges` reads any number"
        ));
    }
    let boxes = match cut.is_empty() {
        true => None,
        false => {
            let mut asked = all.first()?.clone();
            cut.iter().for_each(|(of, _, whole)| *asked.at(*of) = Some(whole.clone()));
            let given = table.fitting(given(&asked))?;
            let rows = SurveyedRows::new(quantities.clone(), asked.thickness.is_some());
            let cut = cut.into_iter().map(|(of, count, _)| (of, count)).collect();
            let asked = Understood::of_ranges(&asked, &given);
            Some(Box::new(SceneBoxes { asked, cut, rows }))
        }
    };
    let read: Vec<_> = all.iter().filter_map(|asked| table.fitting(given(asked))).collect();
    table.remark_on(read.iter().flat_map(|given| &given.friction));
    let surveys = weights.iter().flat_map(|&weight| {
        all.iter().map(move |asked| SceneSurvey { asked: asked.clone(), weight })
    });
    let surveys = surveys.collect();
    Some(Request::Surveys { surveys, boxes, quantities, digits })
}

/// The arches of a question.
pub(super) fn given(asked: &ArchAsked) -> Result<SurveyGiven, Misfit> {
    SurveyGiven::read(&ArchQuestion::ANY, asked, Spelling::Key)
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

/// Quantities that are asked for. Where those of arches of given thickness are and there is none, that is what is
/// missing.
fn quantities(table: &mut TableReader, all: &[Quantity]) -> Option<Vec<Quantity>> {
    let before = table.reader.faults.len();
    if let (Some(value), None) = (table.get("quantities"), table.given_field(Field::Thickness)) {
        for element in table.reader.elements(("quantities", value), "names of quantities") {
            let name = element.get_ref().as_str().unwrap_or_default();
            if Quantity::ASSESSMENT.iter().any(|quantity| quantity.name() == name) {
                let allowed = example(Field::Thickness);
                let message = format!("quantities \"{name}\" needs a thickness; give {allowed}");
                table.reader.fault(element.span(), message);
            }
        }
    }
    if table.is_well_since(before) { table.quantities(all) } else { None }
}
