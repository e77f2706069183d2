//! From TOML to curves of the map, as data or as a picture.

use super::overall::Overall;
use super::read_drawing::arch_figure;
use super::read_numbers::{Meaning, numbers};
use super::schema::{MAX_ITEMS, MapLine, SceneMap, What};
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::atlas::{Contour, Curve, LEAST_TOLERANCE};
use crate::problem::Landmark;
use crate::report::words::{did_you_mean, list};
use crate::report::{Axes, Format, MapAsked, Marked, Plane, Shown, Unit, View, arches_of_figure};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Where a scene does not say how wide a tube may be.
const TOLERANCE: f64 = 1e-4;

/// The map, or curves of it.
pub(super) fn map(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
    format: Option<&'static Format>,
) -> Option<What> {
    let is_page = format.is_some_and(Format::is_page);
    let usual = if is_page { &SelfWeight::ALL[..] } else { &[SelfWeight::Milankovitch] };
    let weights = overall.weights(reader, table, usual).map(in_order);
    let curves = table.get("curves").map_or(Some(Vec::new()), |value| curves(reader, value));
    let contours = contours(reader, table);
    let tolerance = tolerance(reader, table);
    let names = Plane::ALL.map(|plane| (plane.name(), plane));
    let plane = match table.get("plane") {
        Some(value) => {
            let all = reader.names("plane", value, &names);
            all.and_then(|all| only(reader, value, all)).map(Some)
        }
        None => Some(None),
    };
    let lines = table.get("lines").map_or(Some(false), |value| reader.truth("lines", value));
    let bare = table.get("bare").map_or(Some(false), |value| reader.truth("bare", value));
    let (axes, marks) = (axes(reader, table), marks(reader, table));
    let (weights, curves, contours, bare) = (weights?, curves?, contours?, bare?);
    let (axes, marks) = (axes?, marks?);
    let (tolerance, plane, lines, format) = (tolerance?, plane?, lines?, format?);
    let is_whole = curves.is_empty() && (contours.is_empty() || format.is_picture || is_page);
    let asked = MapAsked {
        format,
        weights: weights.len(),
        names_curves: !curves.is_empty(),
        contours: &contours,
        plane,
        lines,
        bare,
        asymmetric: false,
        axes: &axes,
        has_marks: !marks.is_empty(),
    };
    if let Some(message) = asked.misfit(key) {
        reader.fault(span.clone(), message);
        return None;
    }
    let plane = asked.plane();
    let mut command = command("map", &weights, tolerance);
    let is_asked = |curve: &Curve| is_whole || curves.contains(curve);
    let all = Curve::of_weights(&weights).into_iter().filter(|(_, curve)| is_asked(curve));
    let all = all.map(|(weight, curve)| (weight, MapLine::Curve(curve)));
    let names: Vec<String> = curves.iter().map(ToString::to_string).collect();
    if !names.is_empty() {
        command += &format!(" --curve {}", names.join(","));
    }
    for contour in &contours {
        command += &format!(" --{} {}", contour.name().replace(' ', "-"), contour.given());
    }
    if bare {
        command += " --bare";
    }
    let is_map = format.is_picture && is_whole && !lines;
    let contours = match is_map && contours.is_empty() && !bare {
        true => plane.contours(),
        false => contours,
    };
    let levels = weights.iter().flat_map(|weight| {
        contours.iter().map(|contour| (*weight, MapLine::Level(contour.clone())))
    });
    if lines {
        command += " --lines";
    } else if format.is_picture {
        command += &format!(" --plane {}", plane.name());
    }
    command += &words(table, &marks);
    let tolerance = axes.tolerance(tolerance);
    let view = if lines { View::Lines } else { View::Map(plane) };
    let shown = if is_page { &weights[..] } else { &[] };
    let landmarks = shown.iter().flat_map(|w| Landmark::ALL.map(|landmark| (landmark, *w)));
    let (lines, landmarks) = (all.chain(levels).collect(), landmarks.collect());
    Some(What::Map(SceneMap { lines, tolerance, landmarks, view, axes, marks, command }))
}

/// A figure of the paper.
pub(super) fn figure(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
) -> Option<What> {
    let number = match table.get("number") {
        Some(value) => reader.whole("number", value, 1..=12),
        None => {
            reader.fault(span.clone(), "number is missing; a figure is one of 1 to 12".to_owned());
            None
        }
    };
    let shown = number.and_then(arches_of_figure);
    let view = number.and_then(View::of_figure);
    let is_of_one = shown.is_some() || view.is_some_and(View::is_of_one_weight);
    let usual = if is_of_one { &[SelfWeight::Milankovitch] } else { &SelfWeight::ALL[..] };
    let weights = overall.weights(reader, table, usual).map(in_order);
    let tolerance = tolerance(reader, table);
    let (number, weights, tolerance) = (number?, weights?, tolerance?);
    if let Some(shown) = shown {
        let has_tolerance = table.contains_key("tolerance");
        return arch_figure(reader, span, (number, shown), &weights, has_tolerance);
    }
    let view = view?;
    if is_of_one && weights.len() > 1 {
        reader.fault(span.clone(), format!("figure {number} shows one weight"));
        return None;
    }
    let command = command(&format!("figure {number}"), &weights, tolerance);
    let contours = if let View::Map(plane) = view { plane.contours() } else { Vec::new() };
    let lines = |weight: &SelfWeight| {
        let curves = Curve::ALL.map(MapLine::Curve).into_iter();
        let all = curves.chain(contours.iter().cloned().map(MapLine::Level));
        all.map(|line| (*weight, line)).collect::<Vec<_>>()
    };
    let lines = weights.iter().flat_map(lines).collect();
    let (landmarks, axes, marks) = (Vec::new(), Axes::default(), Vec::new());
    Some(What::Figure(SceneMap { lines, tolerance, landmarks, view, axes, marks, command }))
}

/// The keys of axes: of the half opening, the friction and the thickness, with the units of each.
const AXES: [(&str, &str, &[&str]); 3] = [
    ("half_opening_unit", "half_opening_range", &["deg", "rad", "A"]),
    ("friction_unit", "friction_range", &["deg", "rad", "mu"]),
    ("scale", "thickness_range", &["linear", "log"]),
];

/// How a map shows its quantities, and from where to where.
fn axes(reader: &mut Reader, table: &DeTable) -> Option<Axes> {
    let mut shown = |(unit, range, units): (&str, &str, &[&'static str])| {
        let known: Vec<(&'static str, Unit)> =
            units.iter().map(|name| (*name, Unit::named(name))).collect();
        let unit = match table.get(unit) {
            Some(value) => *reader.names(unit, value, &known)?.first()?,
            None => Unit::Usual,
        };
        let range = match table.get(range) {
            Some(value) => {
                let text = value.get_ref().as_str().unwrap_or_default();
                match Shown::range_of(text) {
                    Ok(range) => Some(range),
                    Err(error) => {
                        reader.fault(value.span(), format!("{range}: {error}"));
                        return None;
                    }
                }
            }
            None => None,
        };
        Some(Shown { unit, range })
    };
    let [half_opening, friction, thickness] = AXES.map(&mut shown);
    Some(Axes { half_opening: half_opening?, friction: friction?, thickness: thickness? })
}

/// The arches to mark.
fn marks(reader: &mut Reader, table: &DeTable) -> Option<Vec<Marked>> {
    let Some(value) = table.get("marks") else { return Some(Vec::new()) };
    let before = reader.faults.len();
    let mut found: Vec<Marked> = Vec::new();
    for element in reader.elements("marks", value, "an arch as \"80deg,0.6,0.15\"") {
        let text = element.get_ref().as_str().unwrap_or_default();
        match text.parse() {
            Ok(_) if found.iter().any(|mark| mark.to_string() == text) => {
                reader.is_there("marks", element);
            }
            Ok(marked) => found.push(marked),
            Err(error) => reader.fault(element.span(), format!("marks: {error}")),
        }
    }
    (reader.faults.len() == before).then_some(found)
}

/// What a command says of axes and marks.
fn words(table: &DeTable, marks: &[Marked]) -> String {
    let keys = AXES.iter().flat_map(|(unit, range, _)| [*unit, *range]);
    let axes = keys.filter_map(|key| {
        let value = table.get(key)?.get_ref().as_str()?;
        Some(format!(" --{} {value}", key.replace('_', "-")))
    });
    axes.chain(marks.iter().map(|mark| format!(" --mark {mark}"))).collect()
}

/// The command that asks for the same.
fn command(name: &str, weights: &[SelfWeight], tolerance: f64) -> String {
    let weight = match weights {
        [one] => one.name(),
        _ => "both",
    };
    format!("couplet {name} --weight {weight} --tolerance {tolerance:?}")
}

/// In the order in which they are always shown.
fn in_order(weights: Vec<SelfWeight>) -> Vec<SelfWeight> {
    SelfWeight::ALL.into_iter().filter(|weight| weights.contains(weight)).collect()
}

fn only<T: Copy>(reader: &mut Reader, value: &Value, all: Vec<T>) -> Option<T> {
    if let [one] = all[..] {
        return Some(one);
    }
    reader.is_not("plane", value, "one plane");
    None
}

fn curves(reader: &mut Reader, value: &Value) -> Option<Vec<Curve>> {
    let names: Vec<String> = Curve::ALL.iter().map(ToString::to_string).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let allowed = format!("one of {}", list(names.iter().copied()));
    let before = reader.faults.len();
    let mut found = Vec::new();
    for element in reader.elements("curves", value, &allowed) {
        let text = element.get_ref().as_str();
        match text.and_then(Curve::named) {
            Some(curve) if found.contains(&curve) => reader.is_there("curves", element),
            Some(curve) => found.push(curve),
            None => {
                let hint = text.map_or(String::new(), |text| did_you_mean(text, &names));
                reader.is_not("curves", element, &format!("{allowed}{hint}"));
            }
        }
    }
    (reader.faults.len() == before).then_some(found)
}

/// What an option of the command is called here.
fn key(option: &str) -> String {
    match option {
        "curve" | "mark" => format!("{option}s"),
        _ => option.to_owned(),
    }
}

/// The levels that a table names.
fn contours(reader: &mut Reader, table: &DeTable) -> Option<Vec<Contour>> {
    let before = reader.faults.len();
    let mut found = Vec::new();
    for meaning in [Meaning::HalfOpening, Meaning::Thickness, Meaning::Friction] {
        let Some(value) = meaning.given(reader, table) else { continue };
        let Some(all) = numbers(reader, meaning, value) else { continue };
        if all.len() > MAX_ITEMS {
            let message = format!("a map has at most {MAX_ITEMS} lines of one {}", meaning.key());
            reader.fault(value.span(), message);
            continue;
        }
        match all.all() {
            Ok(all) => found.extend(all.into_iter().filter_map(|one| match meaning {
                Meaning::HalfOpening => one.number.map(Contour::HalfOpening),
                Meaning::Thickness => one.number.map(Contour::Thickness),
                Meaning::Friction | Meaning::FrictionAngle => {
                    Some(Contour::Friction(one.friction()))
                }
            })),
            Err(error) => reader.fault(value.span(), format!("{}: {error}", meaning.key())),
        }
    }
    (reader.faults.len() == before).then_some(found)
}

/// The largest half-width of a tube, a number as text or not.
fn tolerance(reader: &mut Reader, table: &DeTable) -> Option<f64> {
    let Some(value) = table.get("tolerance") else { return Some(TOLERANCE) };
    let text = match value.get_ref() {
        DeValue::String(text) => text.as_ref(),
        DeValue::Float(float) => float.as_str(),
        DeValue::Integer(integer) => integer.as_str(),
        _ => "",
    };
    let tolerance = text.parse().ok().filter(|width| (LEAST_TOLERANCE..=1.0).contains(width));
    if tolerance.is_none() {
        reader.is_not("tolerance", value, &format!("a number from {LEAST_TOLERANCE:e} to 1"));
    }
    tolerance
}
