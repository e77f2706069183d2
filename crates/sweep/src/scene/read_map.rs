//! Reading from TOML to curves of the map, as data or as a picture.

use super::axes;
use super::figure::{TOLERANCE, figure, in_order, weight_word};
use super::scene_map::SceneMap;
use super::schema::{ItemKind, MAX_ITEMS, Request};
use super::table::TableReader;
use super::value::{Entry, TomlReader};
use crate::arch::SelfWeight;
use crate::ask::Misfit;
use crate::atlas::{Contour, Curve, LEAST_TOLERANCE};
use crate::report::{Axes, Format, MapAsked, Marked, Plane, Shown, Unit};

/// The map, or curves of it.
pub(super) fn map(table: &mut TableReader, format: Option<&'static Format>) -> Option<Request> {
    let is_page = format.is_some_and(Format::is_page);
    let usual = if is_page { &SelfWeight::ALL[..] } else { &[SelfWeight::Milankovitch] };
    let weights = table.weights(usual).map(in_order);
    let curves = table.or("curves", Vec::new(), curves);
    let contours = contours(table);
    let tolerance = table.or("tolerance", TOLERANCE, tolerance);
    let plane = table.if_given("plane", plane);
    let [lines, bare, asymmetric] = ["lines", "bare", "asymmetric"].map(|key| table.truth(key));
    let (axes, marks) = (axes(table), table.or("marks", Vec::new(), marks));
    let (axes, format) = (axes?, format?);
    let axes = if asymmetric == Some(true) { axes.of_asymmetric(format) } else { axes };
    let asked = MapAsked {
        format,
        weights: weights?,
        curves: curves?,
        contours: contours?,
        plane: plane?,
        lines: lines?,
        bare: bare?,
        asymmetric: asymmetric?,
        axes,
        marks: marks?,
        tolerance: tolerance?,
    };
    if let Some(message) = asked.misfit(key) {
        return table.refuse(message);
    }
    let said = |name| {
        let all = asked.contours.iter().filter(|of| of.name().replace(' ', "_") == name);
        (name, all.map(Contour::given).collect())
    };
    let [alpha, eta, mu] = ["half_opening", "thickness", "friction"].map(said);
    let said = [alpha, eta, mu, ("weight", vec![weight_word(&asked.weights)])];
    let command = table.command("couplet map".to_owned(), ItemKind::Map, &said);
    Some(Request::Map(SceneMap::new(asked, command)))
}

/// A figure of the paper.
pub(super) fn read_figure(table: &mut TableReader) -> Option<Request> {
    let number = match table.get("number") {
        Some(value) => table.reader.whole(("number", value), 1..=12),
        None => table.refuse("number is missing; a figure is one of 1 to 12"),
    };
    let weights = table.if_given("weight", TomlReader::weights);
    let tolerance = table.if_given("tolerance", tolerance);
    let (number, weights, tolerance) = (number?, weights?, tolerance?);
    let weights = weights.or_else(|| table.reader.weights.clone());
    let command = |weights: &[SelfWeight]| {
        let begin = format!("couplet figure {number} --weight {}", weight_word(weights));
        let said = [("number", Vec::new()), ("weight", Vec::new())];
        table.command(begin, ItemKind::Figure, &said)
    };
    match figure(number, weights, tolerance, str::to_owned, command) {
        Ok(what) => Some(what),
        Err(said) => table.refuse(said),
    }
}

/// The keys of axes: of the half opening, the friction and the thickness, with the units of each.
const AXES: [(&str, &str, &[&str]); 3] = [
    ("half_opening_unit", "half_opening_range", &["deg", "rad", "A"]),
    ("friction_unit", "friction_range", &["deg", "rad", "mu"]),
    ("scale", "thickness_range", &["linear", "log"]),
];

/// Axes: how a map shows its quantities, and from where to where.
fn axes(table: &mut TableReader) -> Option<Axes> {
    let mut shown = |(unit, range, units): (&str, &str, &[&str])| {
        let named = |name: &str| units.contains(&name).then(|| Unit::named(name));
        let unit = table.or(unit, Unit::Usual, |reader, at| reader.one_named(at, units, named))?;
        let range = table.if_given(range, |reader, at| reader.said(at, Shown::range_of))?;
        Some(Shown { unit, range })
    };
    let [half_opening, friction, thickness] = AXES.map(&mut shown);
    Some(Axes { half_opening: half_opening?, friction: friction?, thickness: thickness? })
}

/// The arches to mark.
fn marks(reader: &mut TomlReader, at: Entry) -> Option<Vec<Marked>> {
    let allowed = "an arch as \"80deg,0.6,0.15\"";
    reader.each_once(at, allowed, |reader, at| {
        let marked = reader.said(at, str::parse::<Marked>)?;
        Some((at.1.get_ref().as_str(), marked))
    })
}

fn plane(reader: &mut TomlReader, at: Entry) -> Option<Plane> {
    reader.one_named(at, &Plane::ALL.map(Plane::name), Plane::named)
}

fn curves(reader: &mut TomlReader, at: Entry) -> Option<Vec<Curve>> {
    let names: Vec<String> = Curve::ALL.iter().map(ToString::to_string).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    reader.named(at, &names, Curve::named)
}

/// Key for an option of the command.
fn key(option: &str) -> String {
    match option {
        "curve" | "mark" => format!("{option}s"),
        _ => option.to_owned(),
    }
}

/// The levels that a table names.
fn contours(table: &mut TableReader) -> Option<Vec<Contour>> {
    let (before, mut found) = (table.reader.faults.len(), Vec::new());
    for axis in axes::axes(table, None, false)? {
        if axis.count > MAX_ITEMS {
            let message =
                format!("a map has at most {MAX_ITEMS} lines of one {}", axis.field.name());
            table.fitting::<()>(Err(Misfit { field: Some(axis.field), message }));
            continue;
        }
        for of in axis.parts(table).flatten() {
            found.extend(of.half_opening.map(Contour::HalfOpening));
            found.extend(of.thickness.map(Contour::Thickness));
            found.extend(of.friction.map(Contour::Friction));
        }
    }
    // In the order in which the command has them.
    found.sort_by_key(|of| matches!(of, Contour::Friction(_)));
    table.is_well_since(before).then_some(found)
}

/// The largest half-width of a tube.
fn tolerance(reader: &mut TomlReader, at: Entry) -> Option<f64> {
    let allowed = format!("{LEAST_TOLERANCE:e} to 1");
    reader.double(at, (LEAST_TOLERANCE..=1.0, &allowed))
}
