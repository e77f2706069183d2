//! Results of `couplet audit`: a table for a person, CSV, and JSON, `couplet.audit/2`, in which fields may be
//! added and none changes its meaning.

use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use crate::judge::{Audited, Comparison, PrintedVerdict};
use serde_json::Value as Json;

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

fn printed(entry: &Audited) -> Record {
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
    Record::named(PRINTED, values)
}

fn compared(entry: &Comparison) -> Record {
    let values: [Json; 5] = [
        entry.landmark.symbol().into(),
        entry.quantity.name().into(),
        entry.claimed.name().into(),
        entry.certified.name().into(),
        entry.verdict().into(),
    ];
    Record::named(COMPARED, values)
}

impl Reported for Audit {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.audit/2");
        record.say(
            "Printed numbers against certified values; errors in units of the last printed place\n",
        );
        let titles = ["place", "weight", "", "quantity", "printed", "error", "digits", "verdict"];
        for cells in with_titles(titles, self.printed.iter().map(printed)) {
            let [place, weight, of, quantity, printed, error, digits, verdict] = &cells;
            record.say(format!(
                "{place:<8} {weight:<12} {of:<2} {quantity:<20} {printed:<20} {error:>8} {digits:>7}  {verdict}"
            ));
        }
        let count = |verdict| self.printed.iter().filter(|entry| entry.verdict == verdict).count();
        let (right, faithful, wrong) = (
            count(PrintedVerdict::CorrectlyRounded),
            count(PrintedVerdict::Faithful),
            count(PrintedVerdict::Wrong),
        );
        let all = self.printed.len();
        record.say(format!(
            "\n{all} printed numbers: {right} correctly rounded, {faithful} faithful, {wrong} wrong"
        ));
        if !self.comparisons.is_empty() {
            record.say("\nMilankovitch's weight compared with Heyman's\n");
            let titles = ["", "quantity", "claimed", "certified", "verdict"];
            for cells in with_titles(titles, self.comparisons.iter().map(compared)) {
                let [of, quantity, claimed, certified, verdict] = &cells;
                record
                    .say(format!("{of:<2} {quantity:<20} {claimed:<8} {certified:<10} {verdict}"));
            }
        }
        record.add_list("printed", self.printed.iter().map(printed));
        record.add_list("comparisons", self.comparisons.iter().map(compared));
        vec![record]
    }

    /// The printed numbers.
    fn tabular(&self) -> Tabular {
        Tabular::of(PRINTED, self.printed.iter().map(printed))
    }
}

/// The texts of rows, below their titles.
fn with_titles<const N: usize>(
    titles: [&str; N],
    rows: impl Iterator<Item = Record>,
) -> impl Iterator<Item = [String; N]> {
    let cells = |row: Record| {
        let mut texts = row.texts();
        std::array::from_fn(|_| texts.next().unwrap_or_default())
    };
    std::iter::once(titles.map(str::to_owned)).chain(rows.map(cells))
}
