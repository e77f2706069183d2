//! A record: what a result says, in its order. Named cells are an object in JSON and cells of a row in a table; lines
//! and the cells that are shown are what a person reads.

use super::column::{Column, NamedColumn};
use super::kept::Kept;
use crate::certify::state::Figure;
use crate::number::Rounded;
use crate::problem::{Arch, Quantity};
use serde::{Serialize, Serializer};
use serde_json::Value as Json;
use serde_json::value::RawValue;
use std::borrow::Cow;

/// Name of the cell of what may have been meant otherwise.
pub(crate) const NOTE: &str = "note";

/// Lines and named cells in their order.
#[derive(Debug, Default)]
pub struct Record(Vec<Part>);

#[derive(Debug)]
enum Part {
    /// A line for a person.
    Line(String),
    /// A cell, which a person sees if it has a symbol.
    Cell { name: Cow<'static, str>, symbol: Option<Symbol>, value: Cell },
}

/// A symbol beside the name of a cell that is shown.
#[derive(Clone, Copy, Debug)]
pub struct Symbol {
    /// The symbol.
    pub text: &'static str,
    /// Characters of the column that it stands in.
    pub width: usize,
    /// Characters of the column of names.
    pub name_width: usize,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Cell {
    Value(Option<Json>),
    /// Infinity is `null` in JSON.
    Double(f64),
    Raw(Box<RawValue>),
    Record(Record),
    List(Vec<Record>),
}

impl Record {
    /// A document of a schema.
    pub fn of(schema: &'static str) -> Self {
        Self::named("schema", [schema.into()])
    }

    /// Adds a line for a person.
    pub fn say(&mut self, line: impl Into<String>) {
        self.0.push(Part::Line(line.into()));
    }

    /// Adds lines for a person.
    pub fn say_all(&mut self, lines: impl IntoIterator<Item = impl Into<String>>) {
        lines.into_iter().for_each(|line| self.say(line));
    }

    /// Adds a figure that a person sees, with its symbol in a column of `width` characters.
    pub fn show(&mut self, of: Quantity, width: usize, figure: &Rounded) {
        self.show_as(of.name(), Symbol { text: of.symbol(), width, name_width: 20 }, figure);
    }

    /// Adds a figure that a person sees, under a name and a symbol.
    pub fn show_as(&mut self, name: &'static str, symbol: Symbol, figure: &Rounded) {
        let value = Cell::Record(Self::bounds(figure));
        self.0.push(Part::Cell { name: name.into(), symbol: Some(symbol), value });
    }

    fn put(&mut self, name: impl Into<Cow<'static, str>>, value: Cell) {
        self.0.push(Part::Cell { name: name.into(), symbol: None, value });
    }

    /// Adds a cell; nothing is `null`.
    pub fn add(&mut self, name: impl Into<Cow<'static, str>>, value: impl Into<Json>) {
        self.put(name, Cell::new(value.into()));
    }

    /// Adds a double, which is infinite in CSV and TOML too.
    pub fn add_double(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        value: impl Into<Option<f64>>,
    ) {
        self.put(name, value.into().map_or(Cell::Value(None), Cell::Double));
    }

    /// Adds what columns find in a row.
    pub(crate) fn add_found<'c, R: 'c>(
        &mut self,
        columns: impl IntoIterator<Item = &'c NamedColumn<R>>,
        row: &R,
    ) {
        for &(name, ref column) in columns {
            match column {
                Column::Double(cell) => self.add_double(name, cell(row)),
                other => self.add(name, other.json(row)),
            }
        }
    }

    /// Adds an object, or `null`.
    pub fn add_record(&mut self, name: &'static str, record: Option<Self>) {
        self.put(name, record.map_or(Cell::Value(None), Cell::Record));
    }

    /// Adds an object of objects, in the order of their names.
    pub fn add_sorted(
        &mut self,
        name: &'static str,
        all: impl IntoIterator<Item = (&'static str, Self)>,
    ) {
        let mut all: Vec<_> = all.into_iter().collect();
        all.sort_by_key(|(name, _)| *name);
        let mut sorted = Self::default();
        all.into_iter().for_each(|(name, record)| sorted.add_record(name, Some(record)));
        self.add_record(name, Some(sorted));
    }

    /// Adds an arch, as it was given.
    pub(crate) fn add_arch(&mut self, arch: &Arch) {
        self.add("weight", arch.weight().name());
        self.add("half_opening", arch.half_opening().to_string());
        self.add("friction", arch.friction().to_string());
    }

    /// Adds a list of objects.
    pub fn add_list(&mut self, name: &'static str, list: impl IntoIterator<Item = Self>) {
        self.put(name, Cell::List(list.into_iter().collect()));
    }

    /// Adds a figure with its bounds, or `null`.
    pub fn add_bounds(&mut self, name: &'static str, figure: Option<&Figure>) {
        self.add_rounded(name, figure.map(|figure| &figure.decimal));
    }

    /// Adds a decimal with its bounds, or `null`.
    pub fn add_rounded(&mut self, name: &'static str, decimal: Option<&Rounded>) {
        self.add_record(name, decimal.map(Self::bounds));
    }

    /// A decimal with its bounds.
    pub fn bounds(of: &Rounded) -> Self {
        let texts = [&of.value, &of.lower, &of.upper].map(|x| x.to_string().into());
        Self::named("value lower upper", texts)
    }

    /// Values under names that are given in one text, in its order.
    pub fn named<const N: usize>(names: &'static str, values: [Json; N]) -> Self {
        names.split(' ').zip(values).collect()
    }

    /// Adds what another has.
    pub fn append(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }

    /// Adds what is handed on under names from outside, if anything is.
    pub(crate) fn keep(&mut self, all: &[(String, Kept)]) {
        if all.is_empty() {
            return;
        }
        let mut fields = Self::default();
        for (name, kept) in all {
            let raw = match kept {
                Kept::Text(_) => None,
                Kept::Json(json) => RawValue::from_string(json.clone()).ok(),
            };
            fields.put(name.clone(), raw.map_or_else(|| Cell::new(kept.text().into()), Cell::Raw));
        }
        self.add_record("kept", Some(fields));
    }

    /// Adds what may have been meant otherwise, if anything may.
    pub fn note(&mut self, note: Option<&str>) {
        if let Some(note) = note {
            self.add(NOTE, note);
        }
    }

    fn cells(&self) -> impl DoubleEndedIterator<Item = (&str, &Cell)> {
        self.0.iter().filter_map(|part| match part {
            Part::Cell { name, value, .. } => Some((name.as_ref(), value)),
            Part::Line(_) => None,
        })
    }

    /// The names of the cells.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.cells().map(|(name, _)| name)
    }

    /// The cells as text, each as in a table.
    pub fn texts(self) -> impl Iterator<Item = String> {
        self.0.into_iter().filter_map(|part| match part {
            Part::Cell { value: Cell::Value(Some(Json::String(text))), .. } => Some(text),
            Part::Cell { value, .. } => Some(value.text()),
            Part::Line(_) => None,
        })
    }

    /// The text of a cell, empty where there is none; of several with one name it is the last.
    pub fn text(&self, name: &str) -> String {
        let cell = self.cells().rfind(|(of, _)| *of == name);
        cell.map_or(String::new(), |(_, cell)| cell.text())
    }

    /// Lines for a person: those that are said, and the cells that are shown, here and in the records inside.
    pub fn lines(&self) -> String {
        let mut all = String::new();
        for part in &self.0 {
            match part {
                Part::Line(line) => all.extend([line, "\n"]),
                Part::Cell { name, symbol: Some(symbol), value } => {
                    let (Symbol { text, width, name_width }, value) = (symbol, value.text());
                    all += &format!("   {name:<name_width$} {text:<width$} {value}\n");
                }
                Part::Cell { value: Cell::Record(record), .. } => all += &record.lines(),
                Part::Cell { value: Cell::List(list), .. } => {
                    all.extend(list.iter().map(Self::lines));
                }
                Part::Cell { .. } => {}
            }
        }
        all
    }

    /// Values of the cells that are shown, here and in the records inside.
    pub fn shown(&self) -> Vec<String> {
        let of_part = |part: &Part| match part {
            Part::Cell { symbol: Some(_), value, .. } => vec![value.text()],
            Part::Cell { value: Cell::Record(record), .. } => record.shown(),
            Part::Cell { value: Cell::List(list), .. } => {
                list.iter().flat_map(Self::shown).collect()
            }
            _ => Vec::new(),
        };
        self.0.iter().flat_map(of_part).collect()
    }
}

impl Cell {
    fn new(value: Json) -> Self {
        Self::Value(Some(value).filter(|value| !value.is_null()))
    }

    /// The cell in a table: of a value with bounds the value, of texts all; `null` and other lists are empty.
    fn text(&self) -> String {
        match self {
            Self::Value(Some(Json::String(text))) => text.clone(),
            Self::Value(Some(Json::Array(texts))) => {
                texts.iter().filter_map(Json::as_str).collect::<Vec<_>>().join("; ")
            }
            Self::Value(None) | Self::List(_) => String::new(),
            Self::Value(Some(other)) => other.to_string(),
            Self::Double(x) => format!("{x:?}"),
            Self::Raw(json) => json.get().to_owned(),
            Self::Record(record) => record.text("value"),
        }
    }
}

impl FromIterator<(&'static str, Json)> for Record {
    fn from_iter<I: IntoIterator<Item = (&'static str, Json)>>(cells: I) -> Self {
        let mut record = Self::default();
        cells.into_iter().for_each(|(name, value)| record.add(name, value));
        record
    }
}

impl Serialize for Record {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.cells())
    }
}
