//! A table of TOML that is read key by key.

use super::schema::ItemKind;
use super::value::{Entry, TomlReader, TomlValue};
use crate::arch::SelfWeight;
use crate::ask::{Field, Misfit, notes, quoted};
use crate::problem::{Friction, Landmark, Quantity};
use std::hash::Hash;
use std::ops::Range;
use toml::Spanned;
use toml::de::DeTable;

/// A table, and the reader that collects its faults.
pub(super) struct TableReader<'a, 's> {
    pub reader: &'a mut TomlReader<'s>,
    /// Where the table is.
    pub span: Range<usize>,
    pub table: &'a DeTable<'a>,
}

impl<'a, 's> TableReader<'a, 's> {
    pub(super) fn get(&self, key: &str) -> Option<&'a TomlValue<'a>> {
        self.table.get(key)
    }

    /// A fault of the whole table, in place of what would be read.
    pub(super) fn refuse<T>(&mut self, message: impl Into<String>) -> Option<T> {
        self.reader.refuse(self.span.clone(), message)
    }

    /// The value of a key, or the usual one where there is none. `None` if it is wrong.
    pub(super) fn or<T>(
        &mut self,
        key: &str,
        usual: T,
        read: impl FnOnce(&mut TomlReader<'s>, Entry) -> Option<T>,
    ) -> Option<T> {
        match self.get(key) {
            Some(value) => read(self.reader, (key, value)),
            None => Some(usual),
        }
    }

    /// The value of a key if there is one, `Some(None)` without. `None` if it is wrong.
    pub(super) fn if_given<T>(
        &mut self,
        key: &str,
        read: impl FnOnce(&mut TomlReader<'s>, Entry) -> Option<T>,
    ) -> Option<Option<T>> {
        self.or(key, None, |reader, at| read(reader, at).map(Some))
    }

    /// True if the table says so under a key.
    pub(super) fn truth(&mut self, key: &str) -> Option<bool> {
        self.or(key, false, TomlReader::truth)
    }

    /// The weights of the table, in the order in which they are named: its own, those of the scene, or the usual ones.
    pub(super) fn weights(&mut self, usual: &[SelfWeight]) -> Option<Vec<SelfWeight>> {
        let usual = self.reader.weights.clone().unwrap_or(usual.to_vec());
        self.or("weight", usual, TomlReader::weights)
    }

    /// Significant digits of the table: its own, those of the scene, or the usual ones.
    pub(super) fn digits(&mut self, usual: usize) -> Option<usize> {
        let usual = self.reader.digits.unwrap_or(usual);
        self.or("digits", usual, TomlReader::digits)
    }

    /// Members of a list that a key names, all without it, in the order of the list.
    pub(super) fn chosen<T: Copy + Eq + Hash>(
        &mut self,
        key: &str,
        all: &[T],
        names: &[&str],
        find: impl Fn(&str) -> Option<T>,
    ) -> Option<Vec<T>> {
        let asked = self.or(key, all.to_vec(), |reader, at| reader.named(at, names, find))?;
        Some(all.iter().copied().filter(|one| asked.contains(one)).collect())
    }

    /// The quantities that the table names, of those that there are.
    pub(super) fn quantities(&mut self, all: &[Quantity]) -> Option<Vec<Quantity>> {
        let names: Vec<&str> = all.iter().map(|of| of.name()).collect();
        let find = |name: &str| all.iter().copied().find(|of| of.name() == name);
        self.chosen("quantities", all, &names, find)
    }

    /// The landmarks that a key names, by symbol or by long name.
    pub(super) fn landmarks(&mut self, key: &str) -> Option<Vec<Landmark>> {
        let names = [Landmark::symbol, Landmark::long_name].map(|name| Landmark::ALL.map(name));
        self.chosen(key, &Landmark::ALL, &names.concat(), Landmark::named)
    }

    /// The command that asks for what an item of this kind does: each key is an option, said as the table has it or
    /// otherwise.
    pub(super) fn command(
        &self,
        mut command: String,
        kind: ItemKind,
        said: &[(&str, Vec<String>)],
    ) -> String {
        for key in kind.keys().into_iter().filter(|key| !["format", "output"].contains(key)) {
            let value = Field::named(key).map_or_else(|| self.get(key), |of| self.given_field(of));
            let texts = match (said.iter().find(|(of, _)| *of == key), value) {
                (Some((_, texts)), _) => texts.clone(),
                (None, Some(value)) => TomlReader::literals(value),
                (None, None) => continue,
            };
            let option = match key {
                "curves" | "marks" => key.trim_end_matches('s').to_owned(),
                key => key.replace('_', "-"),
            };
            command.extend(texts.iter().map(|text| format!(" --{option} {}", quoted(text))));
            let usual = ["caption", "title"].contains(&key);
            let said = value.and_then(|value| value.get_ref().as_bool());
            if let Some(said) = said.filter(|said| *said != usual) {
                command += &format!(" --{}{option}", if said { "" } else { "no-" });
            }
        }
        command
    }

    /// Value of a field of an arch, under its name or its letter.
    pub(super) fn given_field(&self, field: Field) -> Option<&'a TomlValue<'a>> {
        self.get(field.name()).or_else(|| self.get(field.letter()?))
    }

    /// Keeps what was read of an arch, or tells the fault of what makes none at the key that it is of.
    pub(super) fn fitting<T>(&mut self, read: Result<T, Misfit>) -> Option<T> {
        let wrong = |Misfit { field, message }| {
            let value = field.and_then(|field| self.given_field(field));
            let span = value.map_or(self.span.clone(), |value| value.span());
            self.reader.fault(span, message);
        };
        read.map_err(wrong).ok()
    }

    /// Remarks on frictions that may have been meant as angles.
    pub(super) fn remark_on<'f>(&mut self, frictions: impl IntoIterator<Item = &'f Friction>) {
        let span = self.given_field(Field::Friction).map_or(self.span.clone(), Spanned::span);
        let all = notes(frictions);
        let more = match all.len() {
            0 | 1 => String::new(),
            count => format!("; so are {} others", count - 1),
        };
        if let Some(first) = all.first() {
            self.reader.remark(span, format!("{first}{more}"));
        }
    }

    /// Tells whether nothing was wrong since there were so many faults.
    pub(super) fn is_well_since(&self, faults: usize) -> bool {
        self.reader.faults.len() == faults
    }
}
