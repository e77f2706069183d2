//! Results of `couplet audit`: a table for a person, CSV, and JSON, `couplet.audit/2`, in which fields may be
//! added and none changes its meaning.

use super::csv;
use super::fields::Fields;
use super::json;
use crate::judge::{Audited, Comparison, PrintedVerdict};
use serde_json::Value as Json;
use std::io;

/// Printed numbers against certified values.
#[derive(Debug)]
pub struct Audit {
    /// Every printed number.
    pub printed: Vec<Audited>,
    /// The claims that compare the two weights.
    pub comparisons: Vec<Comparison>,
}

/// The columns of the printed numbers, and those of the comparisons.
const PRINTED: &str = "place weight landmark quantity printed error_units correct_digits verdict";
const COMPARED: &str = "landmark quantity claimed certified verdict";

fn printed(entry: &Audited) -> Fields {
    let values: [Json; 8] = [
        entry.printed.place.into(),
        entry.printed.weight.name().into(),
        entry.printed.landmark.symbol().into(),
        entry.printed.quantity.name().into(),
        entry.printed.text.into(),
        entry.error_units.to_string().into(),
        entry.correct_digits.into(),
        entry.verdict.name().into(),
    ];
    Fields::named(PRINTED, values)
}

fn compared(entry: &Comparison) -> Fields {
    let values: [Json; 5] = [
        entry.landmark.symbol().into(),
        entry.quantity.name().into(),
        entry.claimed.name().into(),
        entry.certified.name().into(),
        entry.verdict().into(),
    ];
    Fields::named(COMPARED, values)
}

/// JSON.
pub(super) fn json(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    let mut file = Fields::of("couplet.audit/2");
    file.add_list("printed", report.printed.iter().map(printed));
    file.add_list("comparisons", report.comparisons.iter().map(compared));
    json::write(&file, out)
}

/// CSV of the printed numbers.
pub(super) fn csv(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    csv::table(PRINTED, report.printed.iter().map(printed), out)
}

/// A table.
pub(super) fn table(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    let titles = ["place", "weight", "", "quantity", "printed", "error", "digits", "verdict"];
    writeln!(
        out,
        "Printed numbers against certified values; errors in units of the last printed place\n"
    )?;
    for cells in with_titles(titles, report.printed.iter().map(printed)) {
        let [place, weight, of, quantity, printed, error, digits, verdict] = &cells;
        writeln!(
            out,
            "{place:<8} {weight:<12} {of:<2} {quantity:<20} {printed:<20} {error:>8} {digits:>7}  {verdict}"
        )?;
    }
    let count = |verdict| report.printed.iter().filter(|entry| entry.verdict == verdict).count();
    let (right, faithful, wrong) = (
        count(PrintedVerdict::CorrectlyRounded),
        count(PrintedVerdict::Faithful),
        count(PrintedVerdict::Wrong),
    );
    let all = report.printed.len();
    writeln!(
        out,
        "\n{all} printed numbers: {right} correctly rounded, {faithful} faithful, {wrong} wrong"
    )?;
    if report.comparisons.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nMilankovitch's weight compared with Heyman's\n")?;
    let titles = ["", "quantity", "claimed", "certified", "verdict"];
    for cells in with_titles(titles, report.comparisons.iter().map(compared)) {
        let [of, quantity, claimed, certified, verdict] = &cells;
        writeln!(out, "{of:<2} {quantity:<20} {claimed:<8} {certified:<10} {verdict}")?;
    }
    Ok(())
}

/// The texts of rows, below their titles.
fn with_titles<const N: usize>(
    titles: [&str; N],
    rows: impl Iterator<Item = Fields>,
) -> impl Iterator<Item = [String; N]> {
    let cells = |row: Fields| {
        let mut texts = row.texts();
        std::array::from_fn(|_| texts.next().unwrap_or_default())
    };
    std::iter::once(titles.map(str::to_owned)).chain(rows.map(cells))
}
