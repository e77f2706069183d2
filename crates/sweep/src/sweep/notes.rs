//! Notes of a part on itself, in the metadata of its file.

use crate::certify::batch::RowVerdict;
use crate::scene::SWEEP_SCHEMA;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use std::collections::BTreeMap;
use std::fs::File;
use std::ops::Range;

/// Notes of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Notes {
    /// The hash of the record of its sweep.
    pub plan: String,
    /// Rows of the part.
    pub rows: Range<u64>,
    /// Numbers of rows with each verdict, in the order of [`RowVerdict::ALL`].
    pub counts: [u64; 4],
}

impl Notes {
    /// The entries of the file.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, String)> {
        let rows = format!("{}..{}", self.rows.start, self.rows.end);
        let own =
            [("schema", SWEEP_SCHEMA.to_owned()), ("plan", self.plan.clone()), ("rows", rows)];
        let counts = RowVerdict::ALL.iter().zip(self.counts);
        let counts = counts.map(|(verdict, count)| (verdict.name(), count.to_string()));
        own.into_iter().chain(counts)
    }

    /// Notes of a file; none if it is no part of a sweep, or has other rows than it says.
    pub(super) fn of(file: &File) -> Option<Self> {
        let reader = SerializedFileReader::new(file.try_clone().ok()?).ok()?;
        let notes = reader.metadata().file_metadata().key_value_metadata()?;
        let notes: BTreeMap<&str, &str> =
            notes.iter().filter_map(|n| Some((n.key.as_str(), n.value.as_deref()?))).collect();
        let (start, end) = notes.get("couplet.rows")?.split_once("..")?;
        let rows = start.parse::<u64>().ok()?..end.parse().ok()?;
        let mut counts = [0; 4];
        for verdict in RowVerdict::ALL {
            counts[verdict as usize] =
                notes.get(format!("couplet.{}", verdict.name()).as_str())?.parse().ok()?;
        }
        let length = rows.end.checked_sub(rows.start)?;
        let whole = u64::try_from(reader.metadata().file_metadata().num_rows()) == Ok(length)
            && notes.get("couplet.schema") == Some(&SWEEP_SCHEMA);
        let plan = (*notes.get("couplet.plan")?).to_owned();
        whole.then_some(Self { plan, rows, counts })
    }
}
