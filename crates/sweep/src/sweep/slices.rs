//! The pieces of a file of a data set, each the rows of a part. A piece is read without the rest of the file, and its
//! hash says whether it still is what it was.

use super::groups::{self, GroupSlice};
use super::query::Listed;
use super::text::{self, Head, TextSlice};
use crate::arch::SelfWeight;
use crate::check::reason;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// The pieces of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub(super) enum Slices {
    /// Slices of a table of text.
    Text { head: Head, slices: Vec<TextSlice> },
    /// Slices of a Parquet file.
    Parquet(Vec<GroupSlice>),
}

impl Default for Slices {
    /// Slices of a file that cannot be read.
    fn default() -> Self {
        Self::Parquet(Vec::new())
    }
}

impl Slices {
    /// Slices of a file, with at most so many rows each; or what is wrong with the file.
    pub(super) fn of(path: &Path, rows: u64) -> Result<Self, String> {
        let read = |error: io::Error| reason(&error);
        // A pipe would be waited for.
        if !fs::metadata(path).map_err(read)?.is_file() {
            return Err("it is a folder, a pipe or a device".into());
        }
        let mut file = File::open(path).map_err(read)?;
        let mut first = [0; 4];
        let length = file.read(&mut first).map_err(read)?;
        match &first[..length] {
            b"PAR1" => groups::slices(path, rows).map(Self::Parquet),
            _ => text::slices(path, rows).map(|(head, slices)| Self::Text { head, slices }),
        }
    }

    /// The rows of each piece.
    pub(super) fn lengths(&self) -> Vec<u64> {
        match self {
            Self::Text { slices, .. } => slices.iter().map(|slice| slice.rows).collect(),
            Self::Parquet(slices) => slices.iter().map(|slice| slice.rows).collect(),
        }
    }

    /// The rows of the file.
    pub(super) fn rows(&self) -> u64 {
        self.lengths().iter().sum()
    }
}

/// The rows of the piece that begins at this row of a file, and the lines or the places in the file of each.
pub(super) fn read_slice(
    slices: &Slices,
    path: &Path,
    first: u64,
    weight: SelfWeight,
) -> Result<(Vec<u64>, Listed), String> {
    let mut before = 0;
    let place = slices.lengths().iter().position(|rows| {
        before += rows;
        before > first
    });
    match (slices, place) {
        (Slices::Text { head, slices }, Some(place)) => {
            text::read(path, head, &slices[place], weight)
        }
        (Slices::Parquet(slices), Some(place)) => groups::read(path, &slices[place], first, weight),
        (_, None) => Ok((Vec::new(), Listed::default())),
    }
}
