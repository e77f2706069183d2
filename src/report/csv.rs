//! CSV: one row per constant or printed number, with a header.

use super::{Audit, Constants, texts};
use std::io;

pub fn constants(report: &Constants, out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record(["weight", "landmark", "quantity", "value", "lower", "upper", "exact"])?;
    let proved = report.landmarks.iter().filter_map(|entry| entry.outcome.as_ref().ok());
    for constant in proved.flat_map(|proved| &proved.constants) {
        let [value, lower, upper] = texts(&constant.value);
        csv.write_record([
            constant.weight.name(),
            constant.landmark.symbol(),
            constant.quantity.name(),
            &value,
            &lower,
            &upper,
            constant.exact.as_deref().unwrap_or_default(),
        ])?;
    }
    csv.flush()
}

pub fn audit(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    let mut csv = ::csv::Writer::from_writer(out);
    csv.write_record([
        "place",
        "weight",
        "landmark",
        "quantity",
        "printed",
        "error_units",
        "correct_digits",
        "verdict",
    ])?;
    for entry in &report.printed {
        csv.write_record([
            entry.printed.place,
            entry.printed.weight.name(),
            entry.printed.landmark.symbol(),
            entry.printed.quantity.name(),
            entry.printed.text,
            &entry.error_units.to_string(),
            &entry.correct_digits.to_string(),
            entry.verdict.name(),
        ])?;
    }
    csv.flush()
}
