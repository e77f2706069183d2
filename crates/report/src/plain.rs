//! The bare values, one a line, for a shell.

use super::answers::Answers;
use std::io;

/// Landmarks or arches: each quantity asked for, or all that there are; `none` for one without a value,
/// `undecided` for one that stays open.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    for answer in &report.list {
        let all: Vec<_> = answer.values.iter().map(|(quantity, _)| *quantity).collect();
        let asked = if report.quantities.is_empty() { &all } else { &report.quantities };
        for &quantity in asked {
            let none = if answer.why_open(quantity).is_some() { "undecided" } else { "none" };
            let text = answer.value(quantity).map_or(none.to_owned(), |value| value.text());
            writeln!(out, "{text}")?;
        }
    }
    Ok(())
}
