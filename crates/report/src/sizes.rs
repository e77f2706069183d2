//! Sizes of a measured arch of stones, or of a tilted one: their lines, their fields and their columns.

use super::record::Record;
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
    /// Lines for a person, below a heading.
    pub(super) fn lines(&self, heading: &str) -> Vec<String> {
        let line =
            |name: &str, symbol: &str, text: &str| format!("   {name:<20} {symbol:<18} {text}");
        let mut lines = vec![format!("\n{heading}")];
        lines.push(line("measured_at", "circle", self.measured_at.name()));
        match &self.found {
            Err(open) => lines.push(format!("   {open}")),
            Ok(found) => lines.extend(found.iter().map(|(of, figure)| {
                let text = figure.as_ref().map_or("unbounded".to_owned(), ToString::to_string);
                line(of.name(), of.symbol(), &text)
            })),
        }
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
