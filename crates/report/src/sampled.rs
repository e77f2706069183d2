//! Arches that were drawn, for other programs: `couplet.sample/1`.

use super::format::Format;
use super::given::GivenDoubles;
use super::record::Record;
use super::{csv, json};
use crate::strategies::Sample;
use std::io;

/// Writers of drawn arches.
#[derive(Clone, Copy, Debug)]
pub struct SampledLines {
    /// The header.
    pub header: fn() -> io::Result<Vec<u8>>,
    /// Writer of one arch, with its number.
    pub row: fn(u64, &Sample) -> io::Result<Vec<u8>>,
}

/// The names of the fields.
const NAMES: &str =
    "id weight half_opening friction half_opening_rad half_opening_deg friction_double family";

impl SampledLines {
    /// CSV or JSON lines; arches that are drawn have no other format.
    pub fn of(format: &Format) -> Option<Self> {
        match format.name {
            "csv" => Some(CSV),
            "jsonl" => Some(JSON_LINES),
            _ => None,
        }
    }
}

/// A table.
const CSV: SampledLines = SampledLines {
    header: || csv::line(NAMES.split(' ').map(str::to_owned).collect()),
    row: |id, sample| {
        let mut row = fields(id, sample);
        if !sample.arch.is_limited() {
            // For infinity JSON has no number.
            row.add("friction_double", "inf");
        }
        csv::line(NAMES.split(' ').map(|name| row.text(name)).collect())
    },
};

/// JSON lines.
const JSON_LINES: SampledLines = SampledLines {
    header: || Ok(Vec::new()),
    row: |id, sample| {
        let mut all = Record::of("couplet.sample/1");
        all.append(fields(id, sample));
        json::line(&all)
    },
};

fn fields(id: u64, sample: &Sample) -> Record {
    let doubles = GivenDoubles::new(&sample.arch, None);
    let values: [serde_json::Value; 8] = [
        id.into(),
        sample.arch.weight().name().into(),
        sample.arch.half_opening().to_string().into(),
        sample.arch.friction().to_string().into(),
        doubles.half_opening_rad.into(),
        doubles.half_opening_deg.into(),
        doubles.friction.into(),
        sample.family.as_str().into(),
    ];
    Record::named(NAMES, values)
}
