//! Sizes of a measured arch: their lines, and of one of stones or a tilted one their fields and columns.

use super::record::Record;
use super::understood::Understood;
use super::value::Value;
use crate::certify::Undecided;
use crate::certify::state::Measured;
use crate::problem::Quantity;
use crate::problem::measures::Circle;

/// Sizes of an arch that is measured at a circle, or why they are not proved.
#[derive(Debug)]
pub struct Sizes {
    /// The circle.
    pub measured_at: Circle,
    /// The sizes, in metres and kilonewtons.
    pub found: Result<Measured, Undecided>,
}

impl Sizes {
    /// Lines for a person, below an empty one and a heading.
    pub(super) fn lines(&self, heading: &str, asked: &Understood) -> Vec<String> {
        let value = |(of, figure): &(Quantity, _)| (*of, Value::figure(Option::as_ref(figure)));
        let found: Vec<_> = self.found.iter().flatten().map(value).collect();
        let found = found.iter().map(|(of, value)| (*of, value));
        let mut lines = vec![String::new(), heading.to_owned()];
        lines.extend(measured(self.measured_at, found, Some(asked)));
        lines.extend(self.found.as_ref().err().map(|open| format!("   {open}")));
        lines
    }

    /// Adds the sizes to an answer.
    pub(super) fn add_to(&self, record: &mut Record) {
        record.add("measured_at", self.measured_at.name());
        for (of, figure) in self.found.iter().flatten() {
            record.add_bounds(of.name(), figure.as_ref());
        }
    }

    /// Columns of a table with some such sizes.
    pub(super) fn columns<'s>(all: impl Iterator<Item = &'s Self>) -> String {
        let all: Vec<&Self> = all.collect();
        let is_told = |of: &&Quantity| {
            all.iter().any(|sizes| sizes.found.iter().flatten().any(|(told, _)| told == *of))
        };
        let told = Quantity::ALL.iter().filter(is_told).map(|of| of.name());
        let measured_at = (!all.is_empty()).then_some("measured_at");
        measured_at.into_iter().chain(told).map(|name| format!(" {name}")).collect()
    }
}

/// Lines of the sizes of an arch that is measured at a circle, lengths in the unit of the question too.
pub(super) fn measured<'v>(
    circle: Circle,
    sizes: impl IntoIterator<Item = (Quantity, &'v Value)>,
    asked: Option<&Understood>,
) -> Vec<String> {
    let line = |name, symbol, text: &str| format!("   {name:<20} {symbol:<18} {text}");
    let size = |(of, value): (Quantity, &Value)| {
        let text = if value.decimal.is_some() { value.text() } else { "unbounded".into() };
        let told = asked.and_then(|asked| asked.length(of, value));
        let told = told.map_or(String::new(), |told| format!(" = {told}"));
        line(of.name(), of.symbol(), &(text + &told))
    };
    let first = line("measured_at", "circle", circle.name());
    [first].into_iter().chain(sizes.into_iter().map(size)).collect()
}
