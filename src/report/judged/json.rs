//! `couplet.judged/1`, one row; `couplet.judge/1`, all of them.

use super::rows::{certified, side};
use super::{JudgeSummary, JudgedRow, digits};
use crate::judge::{Certified, Judged, Verdict};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;

/// A row; what is not claimed is missing, `inf` correct digits are those of an exact number.
#[derive(Serialize)]
struct RowEntry<'a> {
    schema: &'static str,
    line: u64,
    weight: &'a str,
    half_opening: &'a str,
    friction: &'a str,
    verdict: &'static str,
    accepted: bool,
    correct_digits: Option<String>,
    claimed_stands: Option<bool>,
    stands: Option<bool>,
    claimed_mode: Option<&'static str>,
    mode: Option<String>,
    side: Option<&'static str>,
    reason: Option<&'a str>,
    numbers: BTreeMap<&'static str, NumberEntry<'a>>,
}

/// A number; bounds are rounded outward, errors correctly rounded.
#[derive(Serialize)]
struct NumberEntry<'a> {
    claimed: &'a str,
    value: String,
    lower: Option<String>,
    upper: Option<String>,
    error: Option<String>,
    relative_error: Option<String>,
    error_units: Option<String>,
    error_ulp: Option<String>,
    correct_digits: String,
    rounding: Option<&'static str>,
    nearest_double: Option<bool>,
}

impl<'a> NumberEntry<'a> {
    fn new(number: &'a Judged) -> Self {
        let errors = number.errors.as_ref();
        let text = |x: Option<&crate::number::Decimal>| x.map(ToString::to_string);
        let bounds = match &number.certified {
            Certified::Finite(rounded) => [Some(&rounded.lower), Some(&rounded.upper)],
            _ => [None, None],
        };
        let [lower, upper] = bounds.map(text);
        Self {
            claimed: &number.claimed,
            value: certified(&number.certified),
            lower,
            upper,
            error: text(errors.map(|e| &e.absolute)),
            relative_error: text(errors.and_then(|e| e.relative.as_ref())),
            error_units: text(errors.map(|e| &e.units)),
            error_ulp: text(errors.and_then(|e| e.ulp.as_ref())),
            correct_digits: digits(number.correct_digits),
            rounding: number.rounding.map(|rounding| rounding.name()),
            nearest_double: number.is_nearest_double,
        }
    }
}

impl<'a> RowEntry<'a> {
    fn new(row: &'a JudgedRow) -> Self {
        let judgement = row.outcome.as_ref().ok();
        let verdict = row.verdict();
        let said = |text: String| Some(text).filter(|text| !text.is_empty());
        let numbers = judgement.map_or(&[][..], |j| &j.numbers);
        Self {
            schema: "couplet.judged/1",
            line: row.line,
            weight: &row.weight,
            half_opening: &row.half_opening,
            friction: &row.friction,
            verdict: verdict.name(),
            accepted: verdict.is_accepted(),
            correct_digits: judgement.and_then(|j| j.correct_digits()).map(digits),
            claimed_stands: row.claimed_stands,
            stands: row.stands(),
            claimed_mode: row.claimed_mode,
            mode: said(row.modes()),
            side: judgement.and_then(|j| j.side()).map(side),
            reason: Some(row.reason()).filter(|text| !text.is_empty()),
            numbers: numbers.iter().map(|n| (n.measure.name(), NumberEntry::new(n))).collect(),
        }
    }
}

/// One row on one line.
pub fn row(row: &JudgedRow) -> io::Result<Vec<u8>> {
    let mut text = serde_json::to_vec(&RowEntry::new(row))?;
    text.push(b'\n');
    Ok(text)
}

#[derive(Serialize)]
struct SummaryFile<'a> {
    schema: &'static str,
    rows: u64,
    accepted: u64,
    demanded_digits: usize,
    or_correctly_rounded: bool,
    verdicts: BTreeMap<&'static str, u64>,
    thinner: u64,
    thicker: u64,
    numbers: BTreeMap<&'static str, MeasureEntry>,
    correct_digits: Vec<BarEntry>,
    worst: Vec<RowEntry<'a>>,
    not_judged: Vec<RowEntry<'a>>,
}

#[derive(Serialize)]
struct MeasureEntry {
    judged: u64,
    correctly_rounded: u64,
    faithful: u64,
    wrong: u64,
    nearest_doubles: u64,
    least_correct_digits: String,
    largest_relative_error: Option<String>,
}

/// Rows whose worst number is correct to so many digits.
#[derive(Serialize)]
struct BarEntry {
    digits: String,
    rows: u64,
}

pub fn summary(summary: &JudgeSummary, out: &mut dyn io::Write) -> io::Result<()> {
    let numbers = summary.measures.iter().map(|m| {
        let entry = MeasureEntry {
            judged: m.judged,
            correctly_rounded: m.correctly_rounded,
            faithful: m.faithful,
            wrong: m.wrong(),
            nearest_doubles: m.nearest_doubles,
            least_correct_digits: digits(m.least),
            largest_relative_error: m.largest_relative.as_ref().map(ToString::to_string),
        };
        (m.measure.name(), entry)
    });
    let bar = |(correct, rows): (_, &u64)| BarEntry { digits: digits(correct), rows: *rows };
    let file = SummaryFile {
        schema: "couplet.judge/1",
        rows: summary.rows,
        accepted: summary.accepted(),
        demanded_digits: summary.demand.digits,
        or_correctly_rounded: summary.demand.or_all_printed,
        verdicts: Verdict::ALL.map(|v| (v.name(), summary.count(v))).into_iter().collect(),
        thinner: summary.thinner,
        thicker: summary.thicker,
        numbers: numbers.collect(),
        correct_digits: summary.histogram.iter().map(|(d, n)| bar((*d, n))).collect(),
        worst: summary.worst.iter().map(RowEntry::new).collect(),
        not_judged: summary.unjudged.iter().map(RowEntry::new).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &file)?;
    writeln!(out)
}
