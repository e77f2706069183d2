//! TOML values of the types that a scene has; any other type is a fault.

use super::fault::{Fault, Source};
use crate::report::words::{did_you_mean, list, shortened};
use std::ops::{Range, RangeInclusive};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and where it is.
pub(super) type Value<'s> = Spanned<DeValue<'s>>;

/// The text that is read, what was wrong so far, and what is answered but worth a remark.
pub(super) struct Reader<'s> {
    pub source: Source<'s>,
    pub faults: Vec<Fault>,
    pub notes: Vec<Fault>,
}

impl<'s> Reader<'s> {
    pub(super) fn new(text: &'s str) -> Self {
        Self { source: Source::new(text), faults: Vec::new(), notes: Vec::new() }
    }

    /// The table that the text is, or what is wrong with it as TOML.
    pub(super) fn parsed<'t>(&mut self, text: &'t str) -> Result<Spanned<DeTable<'t>>, Vec<Fault>> {
        let (root, errors) = DeTable::parse_recoverable(text);
        if errors.is_empty() {
            return Ok(root);
        }
        for error in errors {
            let span = error.span().unwrap_or(0..0);
            self.fault(span, format!("not TOML: {}", error.message().replace('\n', " ")));
        }
        self.sort();
        Err(std::mem::take(&mut self.faults))
    }

    /// Whether a file is of the version that is read here: of another nothing can be said.
    pub(super) fn has_schema(&mut self, root: &DeTable, schema: &str, what: &str) -> bool {
        match root.get("schema") {
            Some(value) if value.get_ref().as_str() == Some(schema) => true,
            Some(value) => {
                self.is_not("schema", value, &format!("one that is read here: \"{schema}\""));
                false
            }
            None => {
                self.fault(0..0, format!("schema is missing; {what} has schema = \"{schema}\""));
                true
            }
        }
    }

    fn sort(&mut self) {
        self.faults.sort();
        self.faults.dedup();
    }

    /// The faults in the order of the file, each once.
    pub(super) fn sorted(mut self) -> Vec<Fault> {
        self.sort();
        self.faults
    }

    pub(super) fn fault(&mut self, span: Range<usize>, message: String) {
        self.faults.push(Fault { place: self.source.place(span.start), message });
    }

    /// Remarks that a value, written somewhere, was there before, and counts once.
    pub(super) fn is_there(&mut self, key: &str, value: &Value) {
        let shown = self.source.shown(value.span());
        let message = format!("{key} {shown} is listed twice and counts once");
        self.notes.push(Fault { place: self.source.place(value.span().start), message });
    }

    /// `key "value" is not allowed`.
    pub(super) fn is_not(&mut self, key: &str, value: &Value, allowed: &str) {
        let shown = self.source.shown(value.span());
        self.fault(value.span(), format!("{key} {shown} is not {allowed}"));
    }

    /// Every key that is not one of those a table may have, nor a letter for one.
    pub(super) fn unknown_keys(
        &mut self,
        table: &DeTable,
        of: &str,
        known: &[&str],
        letters: &[&str],
    ) {
        let is_known = |key: &str| known.contains(&key) || letters.contains(&key);
        for key in table.keys().filter(|key| !is_known(key.get_ref())) {
            let hint = did_you_mean(key.get_ref(), known);
            let (name, known) = (shortened(key.get_ref()), list(known.iter().copied()));
            let message = format!("unknown key \"{name}\" in {of}{hint}; the keys are {known}");
            self.fault(key.span(), message);
        }
    }

    pub(super) fn text<'v>(&mut self, key: &str, value: &'v Value) -> Option<&'v str> {
        let text = value.get_ref().as_str();
        if text.is_none() {
            self.is_not(key, value, "a text");
        }
        text
    }

    pub(super) fn truth(&mut self, key: &str, value: &Value) -> Option<bool> {
        let truth = value.get_ref().as_bool();
        if truth.is_none() {
            self.is_not(key, value, "true or false");
        }
        truth
    }

    pub(super) fn whole(
        &mut self,
        key: &str,
        value: &Value,
        allowed: RangeInclusive<usize>,
    ) -> Option<usize> {
        let number = value.get_ref().as_integer().and_then(|integer| {
            usize::from_str_radix(integer.as_str().trim_start_matches('+'), integer.radix()).ok()
        });
        let number = number.filter(|number| allowed.contains(number));
        if number.is_none() {
            let (least, most) = allowed.into_inner();
            self.is_not(key, value, &format!("a whole number from {least} to {most}"));
        }
        number
    }

    /// The elements of a list, or the value itself.
    pub(super) fn elements<'v, 't>(
        &mut self,
        key: &str,
        value: &'v Value<'t>,
        allowed: &str,
    ) -> Vec<&'v Value<'t>> {
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

    /// Names, each once: a list or one by itself. `None` if any is wrong.
    pub(super) fn names<T: Copy + PartialEq>(
        &mut self,
        key: &str,
        value: &Value,
        known: &[(&'static str, T)],
    ) -> Option<Vec<T>> {
        let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
        let allowed = format!("one of {}", list(names.iter().copied()));
        let before = self.faults.len();
        let mut found = Vec::new();
        for element in self.elements(key, value, &allowed) {
            let text = element.get_ref().as_str();
            match known.iter().find(|(name, _)| Some(*name) == text) {
                Some((_, named)) if found.contains(named) => self.is_there(key, element),
                Some((_, named)) => found.push(*named),
                None => {
                    let hint = text.map_or(String::new(), |text| did_you_mean(text, &names));
                    self.is_not(key, element, &format!("{allowed}{hint}"));
                }
            }
        }
        (self.faults.len() == before).then_some(found)
    }
}
