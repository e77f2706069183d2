//! A value of an answer as a row: in Parquet, in CSV of landmarks, in the document that lists each value; and the
//! answer itself, whose columns JSON and tables of arches share.

use super::answer::Answer;
use super::column::Column::{Double, Integer, Made, Shown, Text, Truth};
use super::column::NamedColumn;
use super::value::Value;
use super::words::labels;
use crate::problem::Quantity;
use crate::problem::measures::Circle;

/// A value and its answer; without a value it is the answer.
#[derive(Clone, Copy)]
pub(super) struct ValueRow<'a> {
    pub answer: &'a Answer,
    pub quantity: Option<Quantity>,
    pub value: Option<&'a Value>,
}

impl<'a> ValueRow<'a> {
    /// The columns. `double` is the nearest to the true value, the doubles after it bound that value and its
    /// error; `half_opening`, `friction` and `thickness` are the texts of the query in `line`, with the doubles
    /// nearest to them.
    pub(super) const COLUMNS: [NamedColumn<Self>; 26] = [
        ("line", Integer(|row| row.answer.subject.line())),
        ("weight", Text(|row| row.answer.subject.weight().map(|weight| weight.name()))),
        ("landmark", Text(|row| row.answer.subject.landmark().map(|landmark| landmark.symbol()))),
        ("half_opening", Text(|row| row.answer.subject.given()[0])),
        ("half_opening_rad", Double(|row| row.answer.subject.doubles().half_opening_rad)),
        ("half_opening_deg", Double(|row| row.answer.subject.doubles().half_opening_deg)),
        ("friction", Text(|row| row.answer.subject.given()[1])),
        ("friction_double", Double(|row| row.answer.subject.doubles().friction)),
        ("thickness", Text(|row| row.answer.subject.given()[2])),
        ("thickness_double", Double(|row| row.answer.subject.doubles().thickness)),
        ("mode", Text(|row| row.mode())),
        ("can_stand", Truth(|row| row.answer.can_stand)),
        ("stands", Truth(|row| row.answer.stands)),
        ("status", Text(|row| Some(row.answer.status.name()))),
        ("reason", Text(|row| row.answer.status.reason())),
        ("note", Text(|row| row.answer.note.as_deref())),
        ("quantity", Text(|row| row.quantity.map(Quantity::name))),
        ("value", Shown(|row| Some(row.value?.texts()[0]))),
        ("lower", Shown(|row| Some(row.value?.texts()[1]))),
        ("upper", Shown(|row| Some(row.value?.texts()[2]))),
        ("exact", Text(|row| row.value?.exact.as_deref())),
        ("double", Double(|row| row.value.map(|value| value.double))),
        ("double_lower", Double(|row| row.value.map(|value| value.binary.lower))),
        ("double_upper", Double(|row| row.value.map(|value| value.binary.upper))),
        ("double_error", Double(|row| row.value.map(|value| value.binary.error))),
        ("certificate_sha256", Text(|row| Some(&row.answer.certificate.as_ref().ok()?.sha256))),
    ];

    /// The columns of an answer that Parquet has not: the modes that meet at a landmark, the circle at which an arch is
    /// measured, the verdict on a query that could be read, and why it could not.
    const OTHERS: [NamedColumn<Self>; 4] = [
        ("modes", Made(|row| Some(labels(&row.answer.modes).join(" ")))),
        ("measured_at", Text(|row| row.answer.measured_at.map(Circle::name))),
        ("verdict", Text(|row| Some(row.answer.status.name()).filter(|_| row.answer.is_read()))),
        ("error", Text(|row| row.answer.fault())),
    ];

    /// The columns of some names, which are given in one text, in its order.
    pub(super) fn named(names: &str) -> Vec<NamedColumn<Self>> {
        let all = || Self::COLUMNS.iter().chain(&Self::OTHERS);
        names.split(' ').filter_map(|name| all().find(|(of, _)| *of == name)).copied().collect()
    }

    /// An answer at a quantity, where that is told of it.
    pub(super) fn at(answer: &'a Answer, quantity: Option<Quantity>) -> Self {
        Self { answer, quantity, value: quantity.and_then(|of| answer.value(of)) }
    }

    /// The rows of an answer: one without a value where it has none.
    pub(super) fn all(answer: &'a Answer) -> Vec<Self> {
        if answer.values.is_empty() {
            return vec![Self::at(answer, None)];
        }
        let row = |(quantity, value): &'a (Quantity, Value)| Self {
            answer,
            quantity: Some(*quantity),
            value: Some(value),
        };
        answer.values.iter().map(row).collect()
    }

    /// The mode of an arch; at a landmark several meet.
    fn mode(&self) -> Option<&'static str> {
        let mode = self.answer.modes.first().map(|mode| mode.label());
        mode.filter(|_| self.answer.subject.landmark().is_none())
    }
}
