//! `couplet.judged/2`, one row; `couplet.judge/2`, all of them.

use super::row::{JudgedRow, digits, number};
use super::summary::JudgeSummary;
use crate::arch::SelfWeight;
use crate::judge::Verdict;
use crate::report::columns::kept_fields;
use crate::report::fields::Fields;
use crate::report::json;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;

/// A row; `inf` correct digits are those of an exact number.
#[derive(Serialize)]
struct RowEntry {
    schema: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    kept: Option<Fields>,
    #[serde(flatten)]
    fields: Fields,
    numbers: BTreeMap<&'static str, Fields>,
}

impl RowEntry {
    fn new(row: &JudgedRow) -> Self {
        let numbers = row.numbers().iter().map(|judged| (judged.quantity.name(), number(judged)));
        let kept = (!row.kept.is_empty()).then(|| kept_fields(&row.kept));
        let schema = "couplet.judged/2";
        Self { schema, kept, fields: row.fields(), numbers: numbers.collect() }
    }
}

/// One row on one line.
pub(super) fn row(row: &JudgedRow) -> io::Result<Vec<u8>> {
    json::line(&RowEntry::new(row))
}

#[derive(Serialize)]
struct SummaryFile {
    schema: &'static str,
    rows: u64,
    accepted: u64,
    demanded_digits: usize,
    or_as_printed: bool,
    assumed_weight: Option<&'static str>,
    verdicts: BTreeMap<&'static str, u64>,
    thinner: u64,
    thicker: u64,
    numbers: BTreeMap<&'static str, QuantityEntry>,
    correct_digits: Vec<BarEntry>,
    worst: Vec<RowEntry>,
    not_judged: Vec<RowEntry>,
}

#[derive(Serialize)]
struct QuantityEntry {
    judged: u64,
    correctly_rounded: u64,
    faithful: u64,
    wrong: u64,
    nearest_doubles: u64,
    least_correct_digits: String,
    largest_relative_error: Option<String>,
}

/// How many rows have a worst number correct to this many digits.
#[derive(Serialize)]
struct BarEntry {
    digits: String,
    rows: u64,
}

/// All of them.
pub(crate) fn summary(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    let numbers = summary.quantities.iter().map(|m| {
        let entry = QuantityEntry {
            judged: m.judged,
            correctly_rounded: m.correctly_rounded,
            faithful: m.faithful,
            wrong: m.wrong(),
            nearest_doubles: m.nearest_doubles,
            least_correct_digits: digits(m.least),
            largest_relative_error: m.largest_relative.as_ref().map(ToString::to_string),
        };
        (m.quantity.name(), entry)
    });
    let bar = |(correct, rows): (_, &u64)| BarEntry { digits: digits(correct), rows: *rows };
    let file = SummaryFile {
        schema: "couplet.judge/2",
        rows: summary.rows,
        accepted: summary.accepted(),
        demanded_digits: summary.demand.digits,
        or_as_printed: summary.demand.or_as_printed,
        assumed_weight: summary.assumed.map(SelfWeight::name),
        verdicts: Verdict::ALL.map(|v| (v.name(), summary.count(v))).into_iter().collect(),
        thinner: summary.thinner,
        thicker: summary.thicker,
        numbers: numbers.collect(),
        correct_digits: summary.histogram.iter().map(|(d, n)| bar((*d, n))).collect(),
        worst: summary.worst.iter().map(RowEntry::new).collect(),
        not_judged: summary.unjudged.iter().map(RowEntry::new).collect(),
    };
    json::write_printable(&file, out)
}
