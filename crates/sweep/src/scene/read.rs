//! Reading from TOML to a valid scene, or to everything that is wrong with it.

use super::fault::Fault;
use super::figure::in_order;
use super::read_arches::arches;
use super::read_drawing::drawing;
use super::read_map::{map, read_figure};
use super::read_output::{OutputFiles, output, print};
use super::schema::{DIGITS, ItemKind, MAX_ITEMS, Request, SCENE_KEYS, SCHEMA, Scene, SceneItem};
use super::table::TableReader;
use super::value::{Entry, TomlReader};
use crate::arch::SelfWeight;
use crate::certify::quantities as quantities_of;
use crate::claims::{Claim, claims};
use crate::parse::claims_named;
use crate::picture::Print;
use crate::problem::{Landmark, Quantity};
use crate::report::words::{did_you_mean, list};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Reads a scene from a file's bytes; see [`read`].
pub fn read_bytes(bytes: &[u8]) -> Result<Scene, Vec<Fault>> {
    let (items, notes) = TomlReader::file(bytes, "a scene", SCHEMA, scene)?;
    Ok(Scene { items, notes })
}

/// Reads a scene. Nothing is computed; the faults are all there are, in the order of the file.
pub fn read(text: &str) -> Result<Scene, Vec<Fault>> {
    read_bytes(text.as_bytes())
}

fn scene(reader: &mut TomlReader, root: &DeTable) -> Option<Vec<SceneItem>> {
    let keys: Vec<&str> = SCENE_KEYS.into_iter().chain(ItemKind::ALL.map(ItemKind::name)).collect();
    reader.unknown_keys(root, "a scene", &keys);
    let mut whole = TableReader { reader, span: 0..0, table: root };
    let digits = whole.if_given("digits", TomlReader::digits);
    let weights = whole.if_given("weight", TomlReader::weights);
    (reader.digits, reader.weights) = (digits.flatten(), weights.flatten());
    let mut tables = tables(reader, root);
    if let Some((_, span, _)) = tables.get(MAX_ITEMS) {
        reader.fault(span.clone(), format!("a scene has at most {MAX_ITEMS} items"));
        tables.truncate(MAX_ITEMS);
    }
    if tables.is_empty() && reader.faults.is_empty() {
        let names: Vec<String> =
            ItemKind::ALL.iter().map(|kind| format!("[[{}]]", kind.name())).collect();
        let names = list(names.iter().map(String::as_str));
        reader.fault(0..0, format!("the scene asks for nothing; it may have {names}"));
    }
    let (mut files, mut used) = (OutputFiles::default(), 0);
    let items = tables.into_iter().filter_map(|(kind, span, table)| {
        item(TableReader { reader, span, table }, kind, &mut files, &mut used)
    });
    Some(items.collect())
}

/// The tables of the items in the order of the file.
fn tables<'v>(
    reader: &mut TomlReader,
    root: &'v DeTable<'v>,
) -> Vec<(ItemKind, Range<usize>, &'v DeTable<'v>)> {
    let mut tables = Vec::new();
    for kind in ItemKind::ALL {
        let Some(value) = root.get(kind.name()) else { continue };
        let allowed = format!("[[{}]]", kind.name());
        for element in reader.elements((kind.name(), value), &allowed) {
            match element.get_ref() {
                DeValue::Table(table) => tables.push((kind, element.span(), table)),
                _ => {
                    reader.reject::<()>((kind.name(), element), &format!("a table {allowed}"));
                }
            }
        }
    }
    tables.sort_by_key(|(_, span, _)| span.start);
    tables
}

/// An item, whatever faults it has, which the file tells; `used` counts the arches of all items.
fn item(
    mut table: TableReader,
    kind: ItemKind,
    files: &mut OutputFiles,
    used: &mut usize,
) -> Option<SceneItem> {
    let name = format!("[[{}]]", kind.name());
    table.reader.unknown_keys(table.table, &name, &kind.keys());
    let destination = output(&mut table, kind, files);
    let format = destination.as_ref().map(|(_, format)| *format);
    let what = match kind {
        ItemKind::Constants => constants(&mut table),
        ItemKind::Arches => arches(&mut table, format, used),
        ItemKind::Claims => some_claims(&mut table),
        ItemKind::Audit => points(&mut table).map(|points| Request::Audit { points }),
        ItemKind::Map => map(&mut table, format),
        ItemKind::Figure => read_figure(&mut table),
        ItemKind::Drawing => drawing(&mut table, format),
    };
    let print = if kind.is_drawn() { print(&mut table, format) } else { Some(Print::default()) };
    let ((output, format), print) = (destination?, print?);
    let place = table.reader.source.place(table.span.start);
    Some(SceneItem { place, kind, what: what?, format, print, output })
}

fn constants(table: &mut TableReader) -> Option<Request> {
    let points = points(table);
    let quantities = table.quantities(&Quantity::LANDMARK);
    let digits = table.digits(DIGITS);
    let (points, quantities, digits) = (points?, quantities?, digits?);
    let exists = |quantity| points.iter().any(|(l, _)| quantities_of(*l).any(|q| q == quantity));
    if let Some(value) = table.get("quantities") {
        for quantity in quantities.iter().filter(|quantity| !exists(**quantity)) {
            let message = format!("none of the landmarks has the quantity {}", quantity.name());
            table.reader.fault(value.span(), message);
        }
    }
    Some(Request::Constants { points, quantities, digits })
}

/// Landmarks times weights, by weight, in the order in which they are always shown.
fn points(table: &mut TableReader) -> Option<Vec<(Landmark, SelfWeight)>> {
    let (landmarks, weights) = (table.landmarks("landmarks"), table.weights(&SelfWeight::ALL));
    let (landmarks, weights) = (landmarks?, in_order(weights?));
    let of_each = |weight: SelfWeight| landmarks.iter().map(move |landmark| (*landmark, weight));
    Some(weights.into_iter().flat_map(of_each).collect())
}

/// Claims, each by its id or by the beginning of it up to a hyphen.
fn some_claims(table: &mut TableReader) -> Option<Request> {
    let show = table.truth("show");
    let claims = table.or("prove", claims(), chosen);
    Some(Request::Claims { claims: claims?, show: show? })
}

fn chosen(reader: &mut TomlReader, at: Entry) -> Option<Vec<Claim>> {
    let allowed = "ids of claims, or leave it out for all";
    let names = reader.each_once(at, allowed, |reader, at| {
        let name = at.1.get_ref().as_str().unwrap_or_default().to_owned();
        if claims_named(std::slice::from_ref(&name)).is_ok() {
            return Some((name.clone(), name));
        }
        let ids: Vec<&str> = claims().iter().map(|claim| claim.id).collect();
        let allowed =
            format!("a claim{}; couplet prove --list shows the claims", did_you_mean(&name, &ids));
        reader.reject(at, &allowed)
    })?;
    claims_named(&names).ok()
}
