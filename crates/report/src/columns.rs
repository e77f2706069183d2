//! The fields of an arch that JSON and tables of columns share.

use super::answer::Answer;
use super::answers::Answers;
use super::kept::Kept;
use super::record::{NOTE, Record};
use super::subject::Subject;
use crate::problem::Quantity;
use crate::problem::measures::Circle;

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
}

/// The arch as it was given.
pub(super) fn given(answer: &Answer, asked: Asked) -> Record {
    let mut fields = Record::with_room();
    let [alpha, mu, eta] = answer.subject.given();
    fields.add("weight", answer.subject.weight().map(|weight| weight.name()));
    fields.add("half_opening", alpha);
    fields.add("friction", mu);
    if asked.assessment {
        fields.add("thickness", eta);
    }
    fields
}

/// Given values as numbers; what no double holds is nothing.
pub(super) fn doubles(answer: &Answer, asked: Asked) -> Record {
    let (found, mut fields) = (answer.subject.doubles(), Record::default());
    fields.add_double("half_opening_rad", found.half_opening_rad);
    fields.add_double("half_opening_deg", found.half_opening_deg);
    fields.add_double("friction_double", found.friction);
    if asked.assessment {
        fields.add_double("thickness_double", found.thickness);
    }
    fields
}

/// The verdict and the mode.
pub(super) fn verdict(answer: &Answer, asked: Asked) -> Record {
    let mut fields = Record::default();
    fields.add("verdict", answer.status.name());
    if asked.state {
        fields.add("can_stand", answer.can_stand);
    }
    if asked.assessment {
        fields.add("stands", answer.stands);
    }
    if asked.state {
        fields.add("mode", answer.modes.first().map(|mode| mode.label()));
    }
    fields
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

/// The circle at which arches are measured, if they are.
pub(super) fn circle(report: &Answers, answer: &Answer) -> Record {
    let mut fields = Record::default();
    if report.are_measured() {
        fields.add("measured_at", answer.measured_at.map(Circle::name));
    }
    fields
}

/// The cells of an arch in a table, all empty for a query that could not be read.
pub(super) fn row(report: &Answers, answer: &Answer) -> Record {
    let asked = Asked::in_table(report);
    let mut fields = given(answer, asked);
    fields.append(circle(report, answer));
    fields.append(verdict(answer, asked));
    let asymmetric = answer.value(Quantity::AsymmetricThickness).map(|value| value.text());
    fields.add(Quantity::AsymmetricThickness.name(), asymmetric);
    for &quantity in &report.quantities {
        let open = answer.why_open(quantity).map(|_| "undecided".to_owned());
        fields.add(quantity.name(), open.or(answer.value(quantity).map(|value| value.text())));
    }
    if report.quantities.iter().any(|quantity| quantity.joint().is_some()) {
        let limits: Vec<&str> = answer.values.iter().filter_map(|(_, x)| x.limited_by).collect();
        fields.add("limited_by", limits.join("; "));
    }
    fields.add("reason", answer.reason());
    fields.add(NOTE, answer.note.as_deref());
    if let Subject::Query { .. } = answer.subject {
        fields.clear();
    }
    fields
}

/// The names of the columns of a table, each row of which is made so.
pub(super) fn header(row: impl Fn(&Answer) -> Record) -> Vec<String> {
    row(&Answer::refused(0, String::new())).names().map(str::to_owned).collect()
}
