//! The fields of an arch that JSON and tables of columns share.

use super::answer::Answer;
use super::answers::Answers;
use super::column::Column::{self, Double, Integer, Made, Shown, Text, Truth};
use super::column::NamedColumn;
use super::kept::Kept;
use super::record::{NOTE, Record};
use super::subject::Subject;
use super::value::Value;
use super::words::hexadecimal;
use crate::problem::Quantity;
use crate::problem::measures::Circle;
use std::borrow::Cow;
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
}

/// An answer in a row, and the quantity of a column where that has one.
pub(super) struct At<'a> {
    answer: &'a Answer,
    quantity: Option<Quantity>,
}

/// A column of a table of arches: its name, its quantity, and how it finds its cells.
pub(super) struct TableColumn<'a> {
    name: Cow<'static, str>,
    quantity: Option<Quantity>,
    cell: Column<At<'a>>,
}

/// The arch as it was given.
pub(super) const fn given<'a>() -> [NamedColumn<At<'a>>; 4] {
    [
        ("weight", Text(|at| Some(at.answer.subject.weight()?.name()))),
        ("half_opening", Text(|at| at.answer.subject.given()[0])),
        ("friction", Text(|at| at.answer.subject.given()[1])),
        ("thickness", Text(|at| at.answer.subject.given()[2])),
    ]
}

/// The circle at which an arch is measured.
pub(super) const fn circle<'a>() -> [NamedColumn<At<'a>>; 1] {
    [("measured_at", Text(|at| at.answer.measured_at.map(Circle::name)))]
}

/// Given values as numbers; what no double holds is nothing.
pub(super) const fn doubles<'a>() -> [NamedColumn<At<'a>>; 4] {
    [
        ("half_opening_rad", Double(|at| at.answer.subject.doubles().half_opening_rad)),
        ("half_opening_deg", Double(|at| at.answer.subject.doubles().half_opening_deg)),
        ("friction_double", Double(|at| at.answer.subject.doubles().friction)),
        ("thickness_double", Double(|at| at.answer.subject.doubles().thickness)),
    ]
}

/// The verdict and the mode.
pub(super) const fn verdict<'a>() -> [NamedColumn<At<'a>>; 4] {
    [
        ("verdict", Text(|at| Some(at.answer.status.name()).filter(|_| !at.is_query()))),
        ("can_stand", Truth(|at| at.answer.can_stand)),
        ("stands", Truth(|at| at.answer.stands)),
        ("mode", Text(|at| Some(at.answer.modes.first()?.label()))),
    ]
}

/// The reason why something stays open, and what may have been meant otherwise.
const fn reasons<'a>() -> [NamedColumn<At<'a>>; 2] {
    [
        ("reason", Made(|at| Some(at.answer.reason().filter(|_| !at.is_query())?.into_owned()))),
        (NOTE, Text(|at| at.answer.note.as_deref())),
    ]
}

/// The line of a query, and why it could not be read.
const fn query<'a>() -> [NamedColumn<At<'a>>; 2] {
    [("line", Integer(|at| at.answer.subject.line())), ("error", Text(|at| at.answer.fault()))]
}

impl At<'_> {
    fn value(&self) -> Option<&Value> {
        self.answer.value(self.quantity?)
    }

    /// The value of the quantity, or a word where it stays open.
    fn shown(&self) -> Option<&dyn Display> {
        match self.answer.why_open(self.quantity?) {
            Some(_) => Some(&"undecided"),
            None => Some(self.value()?.texts()[0]),
        }
    }

    /// Tells whether the answer is to a query that could not be read, of which only that is told.
    fn is_query(&self) -> bool {
        matches!(self.answer.subject, Subject::Query { .. })
    }
}

/// The fields of an answer in some columns.
pub(super) fn fields<'a, const N: usize>(
    columns: [NamedColumn<At<'a>>; N],
    answer: &'a Answer,
    asked: Asked,
) -> Record {
    let (at, mut fields) = (At { answer, quantity: None }, Record::default());
    fields.add_found(columns.iter().filter(|(name, _)| asked.has(name)), &at);
    fields
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
        let asked = Asked::in_table(report);
        let circle = report.are_measured().then(circle).into_iter().flatten();
        let named = given().into_iter().chain(circle).chain(verdict());
        let mut all: Vec<Self> =
            named.filter(|(name, _)| asked.has(name)).map(Self::plain).collect();
        let told = [Quantity::AsymmetricThickness].into_iter().chain(report.quantities.clone());
        all.extend(told.map(|of| Self::of(of, "", Shown(At::shown))));
        if report.quantities.iter().any(|quantity| quantity.joint().is_some()) {
            let limits = |at: &At| {
                let limits = at.answer.values.iter().filter_map(|(_, value)| value.limited_by);
                Some(limits.collect::<Vec<_>>().join("; "))
            };
            all.push(Self::plain(("limited_by", Made(limits))));
        }
        all.extend(reasons().map(Self::plain));
        all
    }

    /// The columns of a table for a program; `with_lines` if a row has the line of its query, and its error.
    pub(super) fn all(report: &Answers, with_lines: bool, beside: Beside) -> Vec<Self> {
        let mut all = Self::told(report);
        if with_lines {
            all.extend(query().map(Self::plain));
        }
        if beside.doubles {
            let asked = Asked::in_table(report);
            let given = doubles().into_iter().filter(|(name, _)| asked.has(name));
            all.extend(given.map(Self::plain));
        }
        if report.are_many() && (with_lines || report.have_doubles()) {
            for &of in &report.quantities {
                let double = Self::of(of, "_double", Double(|at| Some(at.value()?.double)));
                let hex = |at: &At| Some(hexadecimal(at.value()?.double));
                all.extend(beside.doubles.then_some(double));
                all.extend(beside.hex.then(|| Self::of(of, "_hex", Made(hex))));
            }
        }
        all
    }

    fn plain((name, cell): NamedColumn<At<'a>>) -> Self {
        Self { name: name.into(), quantity: None, cell }
    }

    fn of(quantity: Quantity, end: &str, cell: Column<At<'a>>) -> Self {
        let name = match end {
            "" => quantity.name().into(),
            end => format!("{}{end}", quantity.name()).into(),
        };
        Self { name, quantity: Some(quantity), cell }
    }

    /// The names of some columns.
    pub(super) fn names(columns: &[Self]) -> Vec<String> {
        columns.iter().map(|column| column.name.to_string()).collect()
    }

    /// Writes the cell of an answer behind a text.
    pub(super) fn write(&self, answer: &'a Answer, text: &mut String) {
        self.cell.write(&At { answer, quantity: self.quantity }, text);
    }

    /// The cells of an answer.
    pub(super) fn texts(columns: &[Self], answer: &'a Answer) -> impl Iterator<Item = String> {
        let text = move |column: &Self| column.cell.text(&At { answer, quantity: column.quantity });
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

/// The values that are handed on, as one object.
pub(super) fn kept_fields(row: &[(String, Kept)]) -> Record {
    let mut kept = Record::default();
    row.iter().for_each(|(name, value)| kept.keep(name, value));
    kept
}
