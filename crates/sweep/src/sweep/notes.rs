//! Notes of a part on itself, in the metadata of its file.

use crate::certify::batch::RowVerdict;
use crate::scene::SWEEP_SCHEMA;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::ops::Range;
use std::path::Path;

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

    /// Tells whether a file has these notes, and as many rows as they say.
    pub(super) fn are_of(&self, path: &Path) -> bool {
        let reader = File::open(path).ok().and_then(|file| SerializedFileReader::new(file).ok());
        let Some(reader) = reader else { return false };
        let there = reader.metadata().file_metadata();
        let is_there = |(key, text): (&str, String)| {
            let is = |n: &KeyValue| {
                n.key.strip_prefix("couplet.") == Some(key) && n.value.as_ref() == Some(&text)
            };
            there.key_value_metadata().is_some_and(|all| all.iter().any(is))
        };
        u64::try_from(there.num_rows()) == Ok(self.rows.end - self.rows.start)
            && self.entries().all(is_there)
    }
}
