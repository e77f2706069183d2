//! `couplet.judged/2`, one row; `couplet.judge/2`, all of them.

use super::row::{JudgedRow, NUMBER, digits};
use super::summary::{JudgeSummary, QuantitySummary};
use crate::arch::SelfWeight;
use crate::json;
use crate::judge::{CorrectDigits, Judged, Verdict};
use crate::record::Record;
use std::collections::BTreeMap;
use std::io;

/// A row; `inf` correct digits are those of an exact number.
fn entry(row: &JudgedRow) -> Record {
    let mut fields = Record::of("couplet.judged/2");
    fields.keep(&row.kept);
    fields.add_found(&JudgedRow::COLUMNS, row);
    let number = |judged: &Judged| {
        let mut fields = Record::default();
        fields.add_found(&NUMBER, judged);
        (judged.quantity.name(), fields)
    };
    let numbers = row.numbers().iter().map(number);
    fields.add_sorted("numbers", numbers);
    fields
}

/// Writes one row on one line.
pub(super) fn row(row: &JudgedRow) -> io::Result<Vec<u8>> {
    json::line(&entry(row))
}

fn quantity(of: &QuantitySummary) -> Record {
    let mut fields = Record::default();
    fields.add("judged", of.judged);
    fields.add("correctly_rounded", of.correctly_rounded);
    fields.add("faithful", of.faithful);
    fields.add("wrong", of.wrong());
    fields.add("nearest_doubles", of.nearest_doubles);
    fields.add("least_correct_digits", digits(of.least));
    fields.add("largest_relative_error", of.largest_relative.as_ref().map(ToString::to_string));
    fields
}

/// The whole summary.
pub(super) fn summary(summary: &JudgeSummary) -> Record {
    let verdicts: BTreeMap<_, _> =
        Verdict::ALL.into_iter().map(|v| (v.name(), summary.count(v).into())).collect();
    // How many rows have a worst number correct to so many digits.
    let bar = |(correct, rows): (&CorrectDigits, &u64)| {
        Record::named("digits rows", [digits(*correct).into(), (*rows).into()])
    };
    let mut file = Record::of("couplet.judge/2");
    file.add("rows", summary.rows);
    file.add("accepted", summary.accepted());
    file.add("demanded_digits", summary.demand.digits);
    file.add("or_as_printed", summary.demand.or_as_printed);
    file.add("assumed_weight", summary.assumed.map(SelfWeight::name));
    file.add_record("verdicts", Some(verdicts.into_iter().collect()));
    file.add("thinner", summary.thinner);
    file.add("thicker", summary.thicker);
    file.add_sorted(
        "numbers",
        summary.quantities.iter().map(|of| (of.quantity.name(), quantity(of))),
    );
    file.add_list("correct_digits", summary.histogram.iter().map(bar));
    file.add_list("worst", summary.worst.iter().map(entry));
    file.add_list("not_judged", summary.unjudged.iter().map(entry));
    file
}
