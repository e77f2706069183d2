//! From TOML to a valid scene, or to everything that is wrong with it.

use super::fault::{Fault, Source};
use super::overall::Overall;
use super::read_arches::arches;
use super::read_drawing::drawing;
use super::read_map::{figure, map};
use super::read_output::{Files, output};
use super::schema::{Item, Kind, MAX_BYTES, MAX_ITEMS, SCENE_KEYS, SCHEMA, Scene, What};
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::certify::{MAX_DIGITS, quantities};
use crate::claims::{Claim, claims};
use crate::problem::{Landmark, Quantity};
use crate::report::words::{did_you_mean, list};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What the items so far have taken.
#[derive(Default)]
struct Totals {
    files: Files,
    arches: usize,
}

/// Reads a scene from a file's bytes; see [`read`].
pub fn read_bytes(bytes: &[u8]) -> Result<Scene, Vec<Fault>> {
    read(text_of(bytes, "a scene")?)
}

/// The text of a file of this kind.
pub(super) fn text_of<'b>(bytes: &'b [u8], kind: &str) -> Result<&'b str, Vec<Fault>> {
    let fault = |before: &str, message: String| {
        Err(vec![Fault { place: Source::new(before).place(before.len()), message }])
    };
    if bytes.len() > MAX_BYTES {
        return fault("", format!("{kind} has at most {MAX_BYTES} bytes"));
    }
    match str::from_utf8(bytes) {
        Ok(text) => Ok(text),
        Err(error) => {
            let before = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
            fault(&before, "not TOML: this is not valid UTF-8".to_owned())
        }
    }
}

/// Reads a scene. Nothing is computed; the faults are all there are, in the order of the file.
pub fn read(text: &str) -> Result<Scene, Vec<Fault>> {
    let mut reader = Reader::new(text);
    let root = reader.parsed(text)?;
    let items = scene(&mut reader, root.get_ref());
    match reader.faults.is_empty() {
        true => Ok(Scene { items, notes: reader.notes }),
        false => Err(reader.sorted()),
    }
}

fn scene(reader: &mut Reader, root: &DeTable) -> Vec<Item> {
    if !reader.has_schema(root, SCHEMA, "a scene") {
        return Vec::new();
    }
    let keys: Vec<&str> = SCENE_KEYS.into_iter().chain(Kind::ALL.map(Kind::name)).collect();
    reader.unknown_keys(root, "a scene", &keys, &[]);
    let overall = Overall::new(reader, root);
    let mut tables = tables(reader, root);
    if tables.len() > MAX_ITEMS {
        let (_, span, _) = &tables[MAX_ITEMS];
        reader.fault(span.clone(), format!("a scene has at most {MAX_ITEMS} items"));
        tables.truncate(MAX_ITEMS);
    }
    if tables.is_empty() && reader.faults.is_empty() {
        let names: Vec<String> =
            Kind::ALL.iter().map(|kind| format!("[[{}]]", kind.name())).collect();
        let names = list(names.iter().map(String::as_str));
        reader.fault(0..0, format!("the scene asks for nothing; it may have {names}"));
    }
    let mut totals = Totals::default();
    tables
        .into_iter()
        .filter_map(|(kind, span, table)| item(reader, kind, &span, table, &overall, &mut totals))
        .collect()
}

/// The tables of the items in the order of the file.
fn tables<'v, 's>(
    reader: &mut Reader,
    root: &'v DeTable<'s>,
) -> Vec<(Kind, Range<usize>, &'v DeTable<'s>)> {
    let mut tables = Vec::new();
    for kind in Kind::ALL {
        let Some(value) = root.get(kind.name()) else { continue };
        let allowed = format!("[[{}]]", kind.name());
        for element in reader.elements(kind.name(), value, &allowed) {
            match element.get_ref() {
                DeValue::Table(table) => tables.push((kind, element.span(), table)),
                _ => reader.is_not(kind.name(), element, &format!("a table {allowed}")),
            }
        }
    }
    tables.sort_by_key(|(_, span, _)| span.start);
    tables
}

fn item(
    reader: &mut Reader,
    kind: Kind,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
    totals: &mut Totals,
) -> Option<Item> {
    let before = reader.faults.len();
    let name = format!("[[{}]]", kind.name());
    reader.unknown_keys(table, &name, kind.keys(), &kind.letters());
    let destination = output(reader, kind, table, &mut totals.files);
    let format = destination.as_ref().map(|(_, format)| *format);
    let what = match kind {
        Kind::Constants => constants(reader, span, table, overall),
        Kind::Arches => arches(reader, span, table, overall, &mut totals.arches),
        Kind::Claims => some_claims(reader, table),
        Kind::Audit => points(reader, table, overall).map(|points| What::Audit { points }),
        Kind::Map => map(reader, span, table, overall, format),
        Kind::Figure => figure(reader, span, table, overall),
        Kind::Drawing => drawing(reader, span, table, overall, format),
    };
    let (output, format) = destination?;
    let place = reader.source.place(span.start);
    let item = Item { place, what: what?, format, output };
    (reader.faults.len() == before).then_some(item)
}

fn constants(
    reader: &mut Reader,
    span: &Range<usize>,
    table: &DeTable,
    overall: &Overall,
) -> Option<What> {
    let points = points(reader, table, overall);
    let names = Quantity::LANDMARK.map(|quantity| (quantity.name(), quantity));
    let asked = match table.get("quantities") {
        Some(value) => reader.names("quantities", value, &names),
        None => Some(Quantity::LANDMARK.to_vec()),
    };
    let digits = match table.get("digits") {
        Some(value) => reader.whole("digits", value, 1..=MAX_DIGITS),
        None => Some(overall.digits),
    };
    let (points, asked, digits) = (points?, asked?, digits?);
    // In the order in which they are always shown.
    let asked: Vec<Quantity> =
        Quantity::LANDMARK.into_iter().filter(|quantity| asked.contains(quantity)).collect();
    let exists = |quantity| points.iter().any(|(l, _)| quantities(*l).any(|q| q == quantity));
    if table.contains_key("quantities") {
        for quantity in asked.iter().filter(|quantity| !exists(**quantity)) {
            let message = format!("none of the landmarks has the quantity {}", quantity.name());
            let at = table.get("quantities").map_or(span.clone(), toml::Spanned::span);
            reader.fault(at, message);
        }
    }
    Some(What::Constants { points, quantities: asked, digits })
}

/// Landmarks times weights, by weight, in the order in which they are always shown.
fn points(
    reader: &mut Reader,
    table: &DeTable,
    overall: &Overall,
) -> Option<Vec<(Landmark, SelfWeight)>> {
    let symbols = Landmark::ALL.map(|landmark| (landmark.symbol(), landmark));
    let long_names = Landmark::ALL.map(|landmark| (landmark.long_name(), landmark));
    let asked = match table.get("landmarks") {
        Some(value) => reader.names("landmarks", value, &[symbols, long_names].concat()),
        None => Some(Landmark::ALL.to_vec()),
    };
    let weights = overall.weights(reader, table, &SelfWeight::ALL);
    let (asked, weights) = (asked?, weights?);
    let all = SelfWeight::ALL.into_iter().filter(|weight| weights.contains(weight));
    let landmarks = || Landmark::ALL.into_iter().filter(|landmark| asked.contains(landmark));
    Some(all.flat_map(|weight| landmarks().map(move |landmark| (landmark, weight))).collect())
}

/// Claims, each by its id or by the beginning of it up to a hyphen.
fn some_claims(reader: &mut Reader, table: &DeTable) -> Option<What> {
    let show = match table.get("show") {
        Some(value) => reader.truth("show", value),
        None => Some(false),
    };
    let all = claims();
    let chosen = match table.get("prove") {
        Some(value) => chosen(reader, value, &all)?,
        None => all,
    };
    Some(What::Claims { claims: chosen, show: show? })
}

fn chosen(reader: &mut Reader, value: &Value, all: &[Claim]) -> Option<Vec<Claim>> {
    let before = reader.faults.len();
    let mut names: Vec<&str> = Vec::new();
    for element in reader.elements("prove", value, "ids of claims, or leave it out for all") {
        let name = element.get_ref().as_str().unwrap_or_default();
        if !all.iter().any(|claim| claim.is_named(name)) {
            let ids: Vec<&str> = all.iter().map(|claim| claim.id).collect();
            let hint = did_you_mean(name, &ids);
            let known = format!("a claim{hint}; couplet prove --list shows the claims");
            reader.is_not("prove", element, &known);
        } else if names.contains(&name) {
            reader.is_there("prove", element);
        } else {
            names.push(name);
        }
    }
    let is_chosen = |claim: &&Claim| names.iter().any(|name| claim.is_named(name));
    (reader.faults.len() == before).then(|| all.iter().filter(is_chosen).copied().collect())
}
