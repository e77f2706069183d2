//! From TOML to a valid scene, or to everything that is wrong with it.

use super::destination::Files;
use super::fault::{Fault, Source, did_you_mean, list};
use super::number::{Given, Meaning};
use super::schema::{
    AskedArch, DIGITS, Item, Kind, MAX_ARCH_DIGITS, MAX_ARCHES, MAX_BYTES, MAX_ITEMS, SCENE_KEYS,
    SCHEMA, Scene, What,
};
use super::value::{Reader, Value};
use crate::arch::{Landmark, Quantity, SelfWeight};
use crate::certify::state::{Arch, Friction};
use crate::certify::{MAX_DIGITS, quantities};
use crate::claims::{Claim, claims};
use crate::report::{ASSESS_VALUES, STATE_VALUES};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What holds for items that say nothing else.
struct Overall {
    digits: usize,
    weights: Option<Vec<SelfWeight>>,
}

/// Reads a scene from a file's bytes; see [`read`].
pub fn read_bytes(bytes: &[u8]) -> Result<Scene, Vec<Fault>> {
    let fault = |before: &str, message: String| {
        Err(vec![Fault { place: Source(before).place(before.len()), message }])
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
        let (mut files, mut arches) = (Files::default(), 0);
        tables
            .into_iter()
            .filter_map(|(kind, span, table)| {
                let item = self.item(kind, &span, table, &overall, &mut files)?;
                if let What::Arches { arches: asked, .. } = &item.what {
                    arches += asked.len();
                    if arches > MAX_ARCHES {
                        let message =
                            format!("{arches} arches so far; a scene has at most {MAX_ARCHES}");
                        self.fault(span, message);
                    }
                }
                Some(item)
            })
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
        files: &mut Files,
    ) -> Option<Item> {
        let before = self.faults.len();
        self.unknown_keys(table, &format!("[[{}]]", kind.name()), kind.keys());
        let what = match kind {
            Kind::Constants => self.constants(span, table, overall),
            Kind::Arches => self.arches(span, table, overall),
            Kind::Claims => self.claims(table),
            Kind::Audit => self.points(table, overall).map(|points| What::Audit { points }),
        };
        let destination =
            self.destination(kind, ["output", "format"].map(|key| table.get(key)), files);
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

    fn item_weights(
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

    fn arches(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
    ) -> Option<What> {
        let with_thickness = table.contains_key("thickness");
        let weights = self.item_weights(table, overall, &[SelfWeight::Milankovitch]);
        let half_openings = match table.get("half_opening") {
            Some(value) => self.numbers(Meaning::HalfOpening, value),
            None => {
                let allowed = Meaning::HalfOpening.allowed();
                self.fault(span.clone(), format!("half_opening is missing; give {allowed}"));
                None
            }
        };
        let frictions = self.frictions(span, table);
        let thicknesses = match table.get("thickness") {
            Some(value) => self
                .numbers(Meaning::Thickness, value)
                .map(|all| all.into_iter().map(|given| given.number).collect()),
            None => Some(vec![None]),
        };
        let names: &[&'static str] = if with_thickness { &ASSESS_VALUES } else { &STATE_VALUES };
        let known: Vec<(&'static str, &'static str)> = names.iter().map(|&n| (n, n)).collect();
        let asked = match table.get("quantities") {
            Some(value) => self.names("quantities", value, &known),
            None => Some(names.to_vec()),
        };
        let digits = self.arch_digits(span, table, overall);
        let (weights, half_openings, (meaning, frictions)) = (weights?, half_openings?, frictions?);
        let (thicknesses, asked, digits) = (thicknesses?, asked?, digits?);
        let count = [weights.len(), half_openings.len(), frictions.len(), thicknesses.len()]
            .into_iter()
            .fold(1usize, usize::saturating_mul);
        if count > MAX_ARCHES {
            let message = format!("{count} arches are too many; a scene has at most {MAX_ARCHES}");
            self.fault(span.clone(), message);
            return None;
        }
        let mut arches = Vec::with_capacity(count);
        for &weight in &weights {
            for half_opening in &half_openings {
                for friction in &frictions {
                    let (friction, text) = in_words(meaning, friction);
                    let half_opening = half_opening.number.clone()?;
                    // Each number was found in its range before.
                    let arch = Arch::new(weight, half_opening, friction).ok()?;
                    arches.extend(thicknesses.iter().map(|thickness| AskedArch {
                        arch: arch.clone(),
                        friction: text.clone(),
                        thickness: thickness.clone(),
                    }));
                }
            }
        }
        let quantities = names.iter().copied().filter(|name| asked.contains(name)).collect();
        Some(What::Arches { arches, quantities, with_thickness, digits })
    }

    fn frictions(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
    ) -> Option<(Meaning, Vec<Given>)> {
        let given = [Meaning::Friction, Meaning::FrictionAngle].map(|meaning| {
            let value = table.get(meaning.key())?;
            Some((meaning, value.span(), self.numbers(meaning, value)))
        });
        match given {
            [Some(_), Some((_, angle, _))] => {
                self.fault(angle, "friction_angle besides friction; give one of them".to_owned());
                None
            }
            [Some((meaning, _, numbers)), None] | [None, Some((meaning, _, numbers))] => {
                Some((meaning, numbers?))
            }
            [None, None] => {
                let (mu, phi) = (Meaning::Friction.allowed(), Meaning::FrictionAngle.allowed());
                let message = format!("friction is missing; give {mu}, or friction_angle, {phi}");
                self.fault(span.clone(), message);
                None
            }
        }
    }

    fn arch_digits(
        &mut self,
        span: &Range<usize>,
        table: &DeTable<'s>,
        overall: &Overall,
    ) -> Option<usize> {
        match table.get("digits") {
            Some(value) => self.whole("digits", value, 1..=MAX_ARCH_DIGITS),
            None if overall.digits > MAX_ARCH_DIGITS => {
                let message = format!(
                    "the scene's {} digits are too many for arches; give this item digits of its own, 1 \
                     to {MAX_ARCH_DIGITS}",
                    overall.digits
                );
                self.fault(span.clone(), message);
                None
            }
            None => Some(overall.digits),
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

/// A friction and how it is shown.
fn in_words(meaning: Meaning, given: &Given) -> (Friction, String) {
    match (&given.number, meaning) {
        (None, _) => (Friction::Infinite, given.text.clone()),
        (Some(phi), Meaning::FrictionAngle) => {
            (Friction::Angle(phi.clone()), format!("tan({phi})"))
        }
        (Some(mu), _) => (Friction::Coefficient(mu.clone()), given.text.clone()),
    }
}
