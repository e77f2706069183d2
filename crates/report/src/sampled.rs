//! Arches that were drawn, for other programs: `couplet.sample/1`.

use super::format::Format;
use super::given::GivenDoubles;
use super::record::Record;
use super::{csv, json};
use crate::strategies::Sample;
use std::io;

/// The names of the fields.
const NAMES: &str =
    "id weight half_opening friction half_opening_rad half_opening_deg friction_double family";

/// The header, which objects have not.
pub fn sampled_header(format: &Format) -> io::Result<Vec<u8>> {
    if format.name == "csv" { csv::line(NAMES.split(' ')) } else { Ok(Vec::new()) }
}

/// One arch, with its number: a line of a table, or an object.
pub fn sampled_row(format: &Format, id: u64, sample: &Sample) -> io::Result<Vec<u8>> {
    let mut fields = fields(id, sample);
    if format.name == "csv" {
        if !sample.arch.is_limited() {
            // For infinity JSON has no number.
            fields.add("friction_double", "inf");
        }
        return csv::row(NAMES, &fields);
    }
    let mut all = Record::of("couplet.sample/1");
    all.append(fields);
    json::line(&all)
}

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
