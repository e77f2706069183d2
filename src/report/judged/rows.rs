//! Every row with its verdict, as CSV or JSON lines.

use super::{JudgedRow, digits, json};
use crate::judge::{Certified, Judged, Measure, Side};
use crate::report::rows::csv_line;
use std::io;

/// How judged rows are written.
#[derive(Clone, Debug)]
pub struct JudgedRows {
    /// JSON lines instead of CSV.
    pub json: bool,
    /// The numbers that have columns.
    pub measures: Vec<Measure>,
}

/// The columns of a row, before those of its numbers.
const COLUMNS: [&str; 13] = [
    "line",
    "weight",
    "half_opening",
    "friction",
    "verdict",
    "accepted",
    "correct_digits",
    "claimed_stands",
    "stands",
    "claimed_mode",
    "mode",
    "side",
    "reason",
];

/// The columns of a number, behind its name.
const NUMBER_COLUMNS: [&str; 9] = [
    "_claimed",
    "",
    "_error",
    "_relative_error",
    "_error_units",
    "_error_ulp",
    "_correct_digits",
    "_rounding",
    "_nearest_double",
];

impl JudgedRows {
    /// The header, where the format has one.
    pub fn header(&self) -> io::Result<Vec<u8>> {
        if self.json {
            return Ok(Vec::new());
        }
        let mut record: Vec<String> = COLUMNS.iter().map(ToString::to_string).collect();
        let columns = |m: &Measure| NUMBER_COLUMNS.map(|column| format!("{}{column}", m.name()));
        record.extend(self.measures.iter().flat_map(columns));
        csv_line(&record)
    }

    /// One row.
    pub fn row(&self, row: &JudgedRow) -> io::Result<Vec<u8>> {
        if self.json { json::row(row) } else { csv_line(&self.record(row)) }
    }

    fn record(&self, row: &JudgedRow) -> Vec<String> {
        let judgement = row.outcome.as_ref().ok();
        let verdict = row.verdict();
        let yes_or_no = |answer: Option<bool>| answer.map_or(String::new(), |a| a.to_string());
        let mut record = vec![
            row.line.to_string(),
            row.weight.clone(),
            row.half_opening.clone(),
            row.friction.clone(),
            verdict.name().to_owned(),
            verdict.is_accepted().to_string(),
            judgement.and_then(|j| j.correct_digits()).map_or(String::new(), digits),
            yes_or_no(row.claimed_stands),
            yes_or_no(row.stands()),
            row.claimed_mode.unwrap_or_default().to_owned(),
            row.modes(),
            judgement.and_then(|j| j.side()).map_or("", side).to_owned(),
            row.reason().to_owned(),
        ];
        for &measure in &self.measures {
            let number = judgement.and_then(|j| j.numbers.iter().find(|n| n.measure == measure));
            record.extend(number.map_or_else(Default::default, fields));
        }
        record
    }
}

/// The word for a side.
pub(super) fn side(side: Side) -> &'static str {
    match side {
        Side::Thinner => "thinner",
        Side::Thicker => "thicker",
    }
}

/// The text of a certified value.
pub(super) fn certified(value: &Certified) -> String {
    match value {
        Certified::Finite(rounded) => rounded.value.to_string(),
        Certified::Infinite => "inf".to_owned(),
        Certified::Missing => "none".to_owned(),
    }
}

fn fields(number: &Judged) -> [String; NUMBER_COLUMNS.len()] {
    let errors = number.errors.as_ref();
    let ulp = errors.and_then(|errors| errors.ulp.as_ref());
    let relative = errors.and_then(|errors| errors.relative.as_ref());
    let shown =
        |error: Option<&crate::number::Decimal>| error.map_or(String::new(), ToString::to_string);
    [
        number.claimed.clone(),
        certified(&number.certified),
        shown(errors.map(|errors| &errors.absolute)),
        shown(relative),
        shown(errors.map(|errors| &errors.units)),
        shown(ulp),
        digits(number.correct_digits),
        number.rounding.map_or(String::new(), |rounding| rounding.name().to_owned()),
        number.is_nearest_double.map_or(String::new(), |nearest| nearest.to_string()),
    ]
}
