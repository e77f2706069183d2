//! TOML values of the types that a scene has; any other type is a fault.

use super::fault::{Fault, SceneText};
use super::schema::MAX_BYTES;
use crate::arch::SelfWeight;
use crate::ask::Field;
use crate::certify::MAX_DIGITS;
use crate::report::words::{did_you_mean, list, shortened};
use std::collections::HashSet;
use std::fmt::Display;
use std::hash::Hash;
use std::ops::{Range, RangeInclusive};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and where it is.
pub(super) type TomlValue<'s> = Spanned<DeValue<'s>>;
/// A key and its value, or one of its values.
pub(super) type Entry<'v, 's> = (&'v str, &'v TomlValue<'s>);

/// The text that is read, what was wrong so far, and what is answered but worth a remark.
pub(super) struct TomlReader<'s> {
    pub source: SceneText<'s>,
    pub faults: Vec<Fault>,
    pub notes: Vec<Fault>,
    /// Significant digits of items that say nothing else, if the scene says so.
    pub digits: Option<usize>,
    /// Weights of items that say nothing else, if the scene says so.
    pub weights: Option<Vec<SelfWeight>>,
}

impl<'s> TomlReader<'s> {
    /// Content of the bytes of a file of this kind and version, as `read` reads it, with remarks; or all that is wrong
    /// with it, in the order of the file.
    pub(super) fn file<T>(
        bytes: &'s [u8],
        kind: &str,
        schema: &str,
        read: impl FnOnce(&mut Self, &DeTable) -> Option<T>,
    ) -> Result<(T, Vec<Fault>), Vec<Fault>> {
        let text = bytes.utf8_chunks().next().map_or("", |first| first.valid());
        let mut reader = Self {
            source: SceneText::new(text),
            faults: Vec::new(),
            notes: Vec::new(),
            digits: None,
            weights: None,
        };
        let found = if bytes.len() > MAX_BYTES {
            reader.refuse(0..0, format!("{kind} has at most {MAX_BYTES} bytes"))
        } else if text.len() < bytes.len() {
            reader.refuse(text.len()..text.len(), "not TOML: this is not valid UTF-8")
        } else {
            let (root, errors) = DeTable::parse_recoverable(text);
            for error in &errors {
                let message = format!("not TOML: {}", error.message().replace('\n', " "));
                reader.fault(error.span().unwrap_or(0..0), message);
            }
            let is_read = errors.is_empty() && reader.has_schema(root.get_ref(), schema, kind);
            if is_read { read(&mut reader, root.get_ref()) } else { None }
        };
        let Self { mut faults, notes, .. } = reader;
        if let Some(found) = found.filter(|_| faults.is_empty()) {
            return Ok((found, notes));
        }
        faults.sort();
        faults.dedup();
        Err(faults)
    }

    /// Tells whether a file is of the version that is read here: of another nothing can be said.
    fn has_schema(&mut self, root: &DeTable, schema: &str, what: &str) -> bool {
        match root.get("schema") {
            Some(value) if value.get_ref().as_str() == Some(schema) => true,
            Some(value) => {
                let here = format!("one that is read here: \"{schema}\"");
                self.reject::<()>(("schema", value), &here).is_some()
            }
            None => {
                self.fault(0..0, format!("schema is missing; {what} has schema = \"{schema}\""));
                true
            }
        }
    }

    pub(super) fn fault(&mut self, span: Range<usize>, message: impl Into<String>) {
        let message = message.into();
        self.faults.push(Fault { place: self.source.place(span.start), message });
    }

    /// A fault in place of what would be read.
    pub(super) fn refuse<T>(
        &mut self,
        span: Range<usize>,
        message: impl Into<String>,
    ) -> Option<T> {
        self.fault(span, message);
        None
    }

    /// Remarks on what is answered as it is written.
    pub(super) fn remark(&mut self, span: Range<usize>, message: String) {
        self.notes.push(Fault { place: self.source.place(span.start), message });
    }

    /// `key "value" is not allowed`, in place of what would be read.
    pub(super) fn reject<T>(&mut self, (key, value): Entry, allowed: &str) -> Option<T> {
        let shown = self.source.shown(value.span());
        self.refuse(value.span(), format!("{key} {shown} is not {allowed}"))
    }

    /// Every key that is not one of those a table may have, nor the letter of a field among them.
    pub(super) fn unknown_keys(&mut self, table: &DeTable, of: &str, known: &[&str]) {
        let is_known = |key: &str| {
            known.contains(&key) || Field::named(key).is_some_and(|of| known.contains(&of.name()))
        };
        for key in table.keys().filter(|key| !is_known(key.get_ref())) {
            let hint = did_you_mean(key.get_ref(), known);
            let (name, known) = (shortened(key.get_ref()), list(known.iter().copied()));
            let message = format!("unknown key \"{name}\" in {of}{hint}; the keys are {known}");
            self.fault(key.span(), message);
        }
    }

    pub(super) fn text<'v>(&mut self, at: Entry<'v, '_>) -> Option<&'v str> {
        at.1.get_ref().as_str().or_else(|| self.reject(at, "a text"))
    }

    /// Value that a text says, by its reader.
    pub(super) fn said<T, E: Display>(
        &mut self,
        at @ (key, value): Entry,
        read: impl FnOnce(&str) -> Result<T, E>,
    ) -> Option<T> {
        let text = Self::literal(value).or_else(|| self.reject(at, "a text"))?;
        read(text).map_err(|said| self.fault(value.span(), format!("{key}: {said}"))).ok()
    }

    pub(super) fn truth(&mut self, at: Entry) -> Option<bool> {
        at.1.get_ref().as_bool().or_else(|| self.reject(at, "true or false"))
    }

    /// The text of a number, with or without quotes.
    pub(super) fn literal<'v>(value: &'v TomlValue) -> Option<&'v str> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.as_ref()),
            DeValue::Float(float) => Some(float.as_str()),
            DeValue::Integer(integer) if integer.radix() == 10 => Some(integer.as_str()),
            _ => None,
        }
    }

    /// The texts of a number, of a text, or of a list of them.
    pub(super) fn literals(value: &TomlValue) -> Vec<String> {
        let all = match value.get_ref() {
            DeValue::Array(all) => all.iter().filter_map(Self::literal).collect(),
            _ => Vec::from_iter(Self::literal(value)),
        };
        all.into_iter().map(str::to_owned).collect()
    }

    /// A double in a range.
    pub(super) fn double(
        &mut self,
        at: Entry,
        (range, allowed): (RangeInclusive<f64>, &str),
    ) -> Option<f64> {
        let number = Self::literal(at.1).and_then(|text| text.parse().ok());
        number
            .filter(|number| range.contains(number))
            .or_else(|| self.reject(at, &format!("a number from {allowed}")))
    }

    pub(super) fn whole(&mut self, at: Entry, allowed: RangeInclusive<usize>) -> Option<usize> {
        let number = at.1.get_ref().as_integer().and_then(|integer| {
            usize::from_str_radix(integer.as_str().trim_start_matches('+'), integer.radix()).ok()
        });
        number.filter(|number| allowed.contains(number)).or_else(|| {
            let (least, most) = allowed.into_inner();
            self.reject(at, &format!("a whole number from {least} to {most}"))
        })
    }

    /// Significant digits.
    pub(super) fn digits(&mut self, at: Entry) -> Option<usize> {
        self.whole(at, 1..=MAX_DIGITS)
    }

    /// The elements of a list, or the value itself.
    pub(super) fn elements<'v, 't>(
        &mut self,
        (key, value): Entry<'v, 't>,
        allowed: &str,
    ) -> Vec<&'v TomlValue<'t>> {
        match value.get_ref() {
            DeValue::Array(array) => {
                if array.is_empty() {
                    self.fault(value.span(), format!("{key} is an empty list; give {allowed}"));
                }
                array.iter().collect()
            }
            _ => vec![value],
        }
    }

    /// The elements as `read` reads them, each once by the key beside it. `None` if any is wrong.
    pub(super) fn each_once<'v, 't, K: Eq + Hash, T>(
        &mut self,
        at: Entry<'v, 't>,
        allowed: &str,
        mut read: impl FnMut(&mut Self, Entry<'v, 't>) -> Option<(K, T)>,
    ) -> Option<Vec<T>> {
        let before = self.faults.len();
        let (mut found, mut seen) = (Vec::new(), HashSet::new());
        for element in self.elements(at, allowed) {
            let Some((of, one)) = read(self, (at.0, element)) else { continue };
            if seen.insert(of) {
                found.push(one);
            } else {
                let (key, shown) = (at.0, self.source.shown(element.span()));
                let message = format!("{key} {shown} is listed twice and counts once");
                self.remark(element.span(), message);
            }
        }
        (self.faults.len() == before).then_some(found)
    }

    /// Values of these names, each once: a list, or one by itself. `None` if any is wrong.
    pub(super) fn named<T: Copy + Eq + Hash>(
        &mut self,
        at: Entry,
        names: &[&str],
        find: impl Fn(&str) -> Option<T>,
    ) -> Option<Vec<T>> {
        let allowed = format!("one of {}", list(names.iter().copied()));
        self.each_once(at, &allowed, |reader, at| {
            let text = at.1.get_ref().as_str();
            text.and_then(&find).map(|found| (found, found)).or_else(|| {
                let hint = text.map_or(String::new(), |text| did_you_mean(text, names));
                reader.reject(at, &format!("{allowed}{hint}"))
            })
        })
    }

    /// Value of one of these names.
    pub(super) fn one_named<T: Copy + Eq + Hash>(
        &mut self,
        at: Entry,
        names: &[&str],
        find: impl Fn(&str) -> Option<T>,
    ) -> Option<T> {
        match self.named(at, names, find)?[..] {
            [one] => Some(one),
            _ => self.reject(at, "one of them"),
        }
    }

    /// The weights named, or both.
    pub(super) fn weights(&mut self, at: Entry) -> Option<Vec<SelfWeight>> {
        match at.1.get_ref().as_str() {
            Some("both") => Some(SelfWeight::ALL.to_vec()),
            _ => self.named(at, &SelfWeight::ALL.map(SelfWeight::name), SelfWeight::named),
        }
    }
}
