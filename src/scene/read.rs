//! From TOML to a valid scene, or to everything that is wrong with it.

use super::destination::Files;
use super::fault::{Fault, Source, did_you_mean, list};
use super::schema::{DIGITS, Item, Kind, MAX_BYTES, MAX_ITEMS, SCENE_KEYS, SCHEMA, Scene, What};
use super::value::{Reader, Value};
use crate::arch::SelfWeight;
use crate::certify::{MAX_DIGITS, quantities};
use crate::claims::{Claim, claims};
use crate::problem::{Landmark, Quantity};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What holds for items that say nothing else.
pub struct Overall {
    pub digits: usize,
    weights: Option<Vec<SelfWeight>>,
}

/// What the items so far have taken.
#[derive(Default)]
struct Used {
    files: Files,
    arches: usize,
}

/// Reads a scene from a file's bytes; see [`read`].
pub fn read_bytes(bytes: &[u8]) -> Result<Scene, Vec<Fault>> {
    let fault = |before: &str, message: String| {
        Err(vec![Fault { place: Source::new(before).place(before.len()), message }])
    };
    if bytes.len() > MAX_BYTES {
        return fault("", format!("a scene has at most {MAX_BYTES} bytes"));
    }
    match str::from_utf8(bytes) {
        Ok(text) => read(text),
        Err(error) => {
            let before = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
            fault(&before, "not TOML: this is no text in UTF-8".to_owned())
        }
    }
}

/// Reads a scene. Nothing is computed; the faults are all there are, in the order of the file.
pub fn read(text: &str) -> Result<Scene, Vec<Fault>> {
    let mut reader = Reader::new(text);
    let (root, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        for error in errors {
            let span = error.span().unwrap_or(0..0);
            reader.fault(span, format!("not TOML: {}", error.message().replace('\n', " ")));
        }
        return Err(reader.sorted());
    }
    let items = reader.scene(root.get_ref());
    if reader.faults.is_empty() { Ok(Scene { items }) } else { Err(reader.sorted()) }
}

/// The names of the weights with the weights.
fn weights() -> [(&'static str, SelfWeight); 2] {
    SelfWeight::ALL.map(|weight| (weight.name(), weight))
}

impl<'s> Reader<'s> {
    fn sorted(mut self) -> Vec<Fault> {
        self.faults.sort();
        self.faults.dedup();
        self.faults
    }

    fn scene(&mut self, root: &DeTable<'s>) -> Vec<Item> {
        if !self.schema(root) {
            return Vec::new();
        }
        let keys: Vec<&str> = SCENE_KEYS.into_iter().chain(Kind::ALL.map(Kind::name)).collect();
        self.unknown_keys(root, "a scene", &keys);
        let digits =
            root.get("digits").and_then(|value| self.whole("digits", value, 1..=MAX_DIGITS));
        let named = root.get("weight").and_then(|value| self.names("weight", value, &weights()));
        let overall = Overall { digits: digits.unwrap_or(DIGITS), weights: named };
        let mut tables = self.tables(root);
        if tables.len() > MAX_ITEMS {
            let (_, span, _) = &tables[MAX_ITEMS];
            self.fault(span.clone(), format!("a scene has at most {MAX_ITEMS} items"));
            tables.truncate(MAX_ITEMS);
        }
        if tables.is_empty() && self.faults.is_empty() {
            let names: Vec<String> =
                Kind::ALL.iter().map(|kind| format!("[[{}]]", kind.name())).collect();
            let names = list(names.iter().map(String::as_str));
            self.fault(0..0, format!("the scene asks for nothing; it may have {names}"));
        }
        let mut used = Used::default();
        tables
            .into_iter()
            .filter_map(|(kind, span, table)| self.item(kind, &span, table, &overall, &mut used))
            .collect()
    }

    /// Whether the scene is of the version that is read here: of another nothing can be said.
    fn schema(&mut self, root: &DeTable<'s>) -> bool {
        match root.get("schema") {
            Some(value) if value.get_ref().as_str() == Some(SCHEMA) => true,
            Some(value) => {
                self.is_not("schema", value, &format!("one that is read here: \"{SCHEMA}\""));
                false
            }
            None => {
                self.fault(0..0, format!("schema is missing; a scene has schema = \"{SCHEMA}\""));
                true
            }
        }
    }

    /// The tables of the items in the order of the file.
    fn tables<'v>(&mut self, root: &'v DeTable<'s>) -> Vec<(Kind, Range<usize>, &'v DeTable<'s>)> {
        let mut tables = Vec::new();
        for kind in Kind::ALL {
            let Some(value) = root.get(kind.name()) else { continue };
            let allowed = format!("[[{}]]", kind.name());
            for element in self.elements(kind.name(), value, &allowed) {
                match element.get_ref() {
                    DeValue::Table(table) => tables.push((kind, element.span(), table)),
                    _ => self.is_not(kind.name(), element, &format!("a table {allowed}")),
                }
            }
        }
        tables.sort_by_key(|(_, span, _)| span.start);
        tables
    }

    fn item(
        &mut self,
        kind: Kind,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
        used: &mut Used,
    ) -> Option<Item> {
        let before = self.faults.len();
        self.unknown_keys(table, &format!("[[{}]]", kind.name()), kind.keys());
        let what = match kind {
            Kind::Constants => self.constants(span, table, overall),
            Kind::Arches => self.arches(span, table, overall, &mut used.arches),
            Kind::Claims => self.claims(table),
            Kind::Audit => self.points(table, overall).map(|points| What::Audit { points }),
        };
        let destination =
            self.destination(kind, ["output", "format"].map(|key| table.get(key)), &mut used.files);
        let (output, format) = destination?;
        let place = self.source.place(span.start);
        let item = Item { place, what: what?, format, output };
        (self.faults.len() == before).then_some(item)
    }

    fn constants(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
    ) -> Option<What> {
        let points = self.points(table, overall);
        let names = Quantity::ALL.map(|quantity| (quantity.name(), quantity));
        let asked = match table.get("quantities") {
            Some(value) => self.names("quantities", value, &names),
            None => Some(Quantity::ALL.to_vec()),
        };
        let digits = match table.get("digits") {
            Some(value) => self.whole("digits", value, 1..=MAX_DIGITS),
            None => Some(overall.digits),
        };
        let (points, asked, digits) = (points?, asked?, digits?);
        // In the order in which they are always shown.
        let asked: Vec<Quantity> =
            Quantity::ALL.into_iter().filter(|quantity| asked.contains(quantity)).collect();
        let exists = |quantity| points.iter().any(|(l, _)| quantities(*l).any(|q| q == quantity));
        if table.contains_key("quantities") {
            for quantity in asked.iter().filter(|quantity| !exists(**quantity)) {
                let message = format!("none of the landmarks has the quantity {}", quantity.name());
                let at = table.get("quantities").map_or(span.clone(), toml::Spanned::span);
                self.fault(at, message);
            }
        }
        Some(What::Constants { points, quantities: asked, digits })
    }

    /// Landmarks times weights, by weight, in the order in which they are always shown.
    fn points(
        &mut self,
        table: &DeTable<'s>,
        overall: &Overall,
    ) -> Option<Vec<(Landmark, SelfWeight)>> {
        let symbols = Landmark::ALL.map(|landmark| (landmark.symbol(), landmark));
        let asked = match table.get("landmarks") {
            Some(value) => self.names("landmarks", value, &symbols),
            None => Some(Landmark::ALL.to_vec()),
        };
        let weights = self.item_weights(table, overall, &SelfWeight::ALL);
        let (asked, weights) = (asked?, weights?);
        let all = SelfWeight::ALL.into_iter().filter(|weight| weights.contains(weight));
        let landmarks = || Landmark::ALL.into_iter().filter(|landmark| asked.contains(landmark));
        Some(all.flat_map(|weight| landmarks().map(move |landmark| (landmark, weight))).collect())
    }

    pub fn item_weights(
        &mut self,
        table: &DeTable<'s>,
        overall: &Overall,
        otherwise: &[SelfWeight],
    ) -> Option<Vec<SelfWeight>> {
        match table.get("weight") {
            Some(value) => self.names("weight", value, &weights()),
            None => Some(overall.weights.clone().unwrap_or(otherwise.to_vec())),
        }
    }

    /// Claims, each by its id or by the beginning of it up to a hyphen.
    fn claims(&mut self, table: &DeTable<'s>) -> Option<What> {
        let show = match table.get("show") {
            Some(value) => self.truth("show", value),
            None => Some(false),
        };
        let all = claims();
        let chosen = match table.get("prove") {
            Some(value) => self.chosen(value, &all)?,
            None => all,
        };
        Some(What::Claims { claims: chosen, show: show? })
    }

    fn chosen(&mut self, value: &Value<'s>, all: &[Claim]) -> Option<Vec<Claim>> {
        let before = self.faults.len();
        let mut names: Vec<&str> = Vec::new();
        for element in self.elements("prove", value, "ids of claims, or leave it out for all") {
            let name = element.get_ref().as_str().unwrap_or_default();
            if !all.iter().any(|claim| claim.is_named(name)) {
                let ids: Vec<&str> = all.iter().map(|claim| claim.id).collect();
                let hint = did_you_mean(name, &ids);
                let ids = list(ids);
                self.is_not("prove", element, &format!("a claim{hint}; the claims are {ids}"));
            } else if names.contains(&name) {
                self.fault(element.span(), format!("prove \"{name}\" is listed twice"));
            } else {
                names.push(name);
            }
        }
        let is_chosen = |claim: &&Claim| names.iter().any(|name| claim.is_named(name));
        (self.faults.len() == before).then(|| all.iter().filter(is_chosen).copied().collect())
    }
}
