//! The fields of an arch that JSON and tables of columns share.

use super::answer::Answer;
use super::answers::Answers;
use super::column::Column::{self, Double, Made, Shown};
use super::column::NamedColumn;
use super::kept::Kept;
use super::record::NOTE;
use super::value_row::ValueRow;
use super::words::hexadecimal;
use crate::problem::Quantity;
use std::fmt::Display;

/// Question that was asked of an arch, and so which fields it has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// True if the question is whether it can stand at all.
    pub state: bool,
    /// True if the question is whether it stands at a given thickness.
    pub assessment: bool,
}

impl Asked {
    /// Question of one arch.
    pub(super) fn of(answer: &Answer) -> Self {
        let assessment = answer.subject.is_assessed();
        Self { state: !assessment, assessment }
    }

    /// Question of the arches of a table.
    pub(super) fn in_table(report: &Answers) -> Self {
        Self { state: report.have_states(), assessment: report.have_assessments() }
    }

    /// Tells whether who asks this is told what a column has.
    fn has(self, name: &str) -> bool {
        match name {
            "thickness" | "thickness_double" | "stands" => self.assessment,
            "can_stand" | "mode" => self.state,
            _ => true,
        }
    }

    /// The columns of some names, of those that who asks this is told.
    pub(super) fn columns<'a>(self, names: &str) -> Vec<NamedColumn<ValueRow<'a>>> {
        let mut columns = ValueRow::named(names);
        columns.retain(|(name, _)| self.has(name));
        columns
    }
}

/// A column of a table of arches: its name, its quantity, and how it finds its cells.
pub(super) struct TableColumn<'a> {
    name: String,
    quantity: Option<Quantity>,
    cell: Column<ValueRow<'a>>,
}

/// The arch as it was given.
pub(super) const GIVEN: &str = "weight half_opening friction thickness";

/// Given values as numbers; what no double holds is nothing.
pub(super) const DOUBLES: &str =
    "half_opening_rad half_opening_deg friction_double thickness_double";

/// The verdict and the mode.
pub(super) const VERDICT: &str = "verdict can_stand stands mode";

/// The value of the quantity, or a word where it stays open.
fn shown<'r>(at: &'r ValueRow) -> Option<&'r dyn Display> {
    match at.answer.why_open(at.quantity?) {
        Some(_) => Some(&"undecided"),
        None => Some(at.value?.texts()[0]),
    }
}

/// Columns of numbers that a table of arches has beside what is asked and what is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beside {
    /// The nearest doubles of what is given and of each value.
    pub doubles: bool,
    /// The nearest doubles of each value in hexadecimal.
    pub hex: bool,
}

impl Beside {
    /// All that there are.
    pub const ALL: Self = Self { doubles: true, hex: true };

    /// Adds the columns of a name; answers whether it is one.
    pub fn add(&mut self, name: &str) -> bool {
        match name {
            "doubles" => self.doubles = true,
            "hex" => self.hex = true,
            "all" => *self = Self::ALL,
            _ => return false,
        }
        true
    }
}

impl<'a> TableColumn<'a> {
    /// The columns of a table for a person.
    pub(super) fn told(report: &Answers) -> Vec<Self> {
        let circle = report.are_measured().then_some("measured_at");
        let names = [GIVEN].into_iter().chain(circle).chain([VERDICT]);
        let mut all: Vec<Self> = names.flat_map(|names| Self::named(report, names)).collect();
        let told = [Quantity::AsymmetricThickness].into_iter().chain(report.quantities.clone());
        all.extend(told.map(|of| Self::of(of, "", Shown(shown))));
        if report.quantities.iter().any(|quantity| quantity.joint().is_some()) {
            let limits = |at: &ValueRow| {
                let limits = at.answer.values.iter().filter_map(|(_, value)| value.limited_by);
                Some(limits.collect::<Vec<_>>().join("; "))
            };
            all.push(Self::plain(("limited_by", Made(limits))));
        }
        let reason =
            |at: &ValueRow| Some(at.answer.reason().filter(|_| at.answer.is_read())?.into_owned());
        all.push(Self::plain(("reason", Made(reason))));
        all.extend(Self::named(report, NOTE));
        all
    }

    /// The columns of a table for a program; `with_lines` if a row has the line of its query, and its error.
    pub(super) fn all(report: &Answers, with_lines: bool, beside: Beside) -> Vec<Self> {
        let mut all = Self::told(report);
        if with_lines {
            all.extend(Self::named(report, "line error"));
        }
        if beside.doubles {
            all.extend(Self::named(report, DOUBLES));
        }
        if report.are_many() && (with_lines || report.have_doubles()) {
            for &of in &report.quantities {
                let double = Self::of(of, "_double", Double(|at| Some(at.value?.double)));
                let hex = |at: &ValueRow| Some(hexadecimal(at.value?.double));
                all.extend(beside.doubles.then_some(double));
                all.extend(beside.hex.then(|| Self::of(of, "_hex", Made(hex))));
            }
        }
        all
    }

    /// The columns of some names, of those that the table has.
    fn named(report: &Answers, names: &str) -> impl Iterator<Item = Self> {
        Asked::in_table(report).columns(names).into_iter().map(Self::plain)
    }

    fn plain((name, cell): NamedColumn<ValueRow<'a>>) -> Self {
        Self { name: name.to_owned(), quantity: None, cell }
    }

    fn of(quantity: Quantity, end: &str, cell: Column<ValueRow<'a>>) -> Self {
        Self { name: format!("{}{end}", quantity.name()), quantity: Some(quantity), cell }
    }

    /// The names of some columns.
    pub(super) fn names(columns: &[Self]) -> Vec<String> {
        columns.iter().map(|column| column.name.clone()).collect()
    }

    /// Writes the cell of an answer behind a text.
    pub(super) fn write(&self, answer: &'a Answer, text: &mut String) {
        self.cell.write(&ValueRow::at(answer, self.quantity), text);
    }

    /// The cells of an answer.
    pub(super) fn texts(columns: &[Self], answer: &'a Answer) -> impl Iterator<Item = String> {
        let text = move |column: &Self| column.cell.text(&ValueRow::at(answer, column.quantity));
        columns.iter().map(text)
    }
}

/// The names of the columns that are handed on: one that the table has of its own is another there.
pub(super) fn kept_names(kept: &[String], own: &[String]) -> Vec<String> {
    let name = |name: &String| match own.contains(name) {
        true => format!("input_{name}"),
        false => name.clone(),
    };
    kept.iter().map(name).collect()
}

/// The cell of what is handed on under a name, empty where there is nothing.
pub(super) fn kept_cell<'a>(row: &'a [(String, Kept)], name: &str) -> &'a str {
    match row.iter().find(|(of, _)| of == name) {
        Some((_, Kept::Json(null))) if null == "null" => "",
        kept => kept.map_or("", |(_, kept)| kept.text()),
    }
}

/// Cells of what is handed on.
pub(super) fn kept_cells(names: &[String], row: &[(String, Kept)]) -> impl Iterator<Item = String> {
    names.iter().map(|name| kept_cell(row, name).to_owned())
}
