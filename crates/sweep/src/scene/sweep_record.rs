//! The record of a sweep, `couplet.sweep/1`: everything that its rows depend on, in one form however the plan has it.
//!
//! Its SHA-256 is the name of the sweep, and of the folder of its parts: two different sweeps cannot meet in a folder,
//! and the same sweep always finds its own.

use super::hash::hash_of;
use super::manifest::MAX_RECORD;
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::number::ExactNumber;
use crate::problem::{Friction, Quantity};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The name and the version of the schema: of a plan, of its record, and of the parts that are written.
pub const SWEEP_SCHEMA: &str = "couplet.sweep/1";

/// Digits that tell the nearest double; with more a value is written as text too.
pub const SWEEP_DIGITS: usize = 17;

/// The version of the program.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The most arches of a sample.
pub(super) const MAX_SAMPLE: usize = 10_000_000_000;
/// The most rows of a part.
pub(super) const MAX_CHUNK: usize = 100_000_000;
/// The most parts of a sweep: they are listed, and their folders have a thousand each.
const MAX_PARTS: u64 = 1_000_000;
/// The most rows of a part that are held in memory at a time, in about 600 bytes a row: a row group of its file. It is
/// a multiple of what is drawn from one seed.
pub const GROUP: u64 = 125_000;
/// The most rows of a row group of a grid, which share their numbers.
const GRID_GROUP: u64 = 500_000;

/// Record of a sweep, in names and exact texts. One that no more than a plan is known of has no files read, and no rows
/// of a part unless the plan says how many.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SweepRecord {
    /// The name and the version of the schema.
    pub schema: String,
    /// The version of the program: another one may prove what this one leaves undecided.
    pub couplet: String,
    /// The weights of a grid, in the order in which they are swept; of a data set one, that of the rows without.
    pub weights: Vec<SelfWeight>,
    /// The values that are computed, in the order of [`Quantity::STATE_ROW`].
    pub quantities: Vec<Quantity>,
    /// Significant digits.
    pub digits: usize,
    /// Rows in all.
    pub rows: u64,
    /// The most rows of a part.
    pub chunk: u64,
    /// The arches.
    pub arches: SweepArches,
}

/// The arches of a sweep.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SweepArches {
    /// Every weight with every half opening and every friction, in this order.
    Grid {
        /// Half openings in `(0, pi)`, rad.
        half_opening: Vec<ExactNumber>,
        /// The frictions.
        friction: Vec<Friction>,
    },
    /// Arches drawn from a seed.
    Sample {
        /// Seed that the first are drawn from.
        seed: u64,
        /// True if the arches are hard ones.
        hard: bool,
    },
    /// The rows of files, each told by its name and its content.
    Data {
        /// Files, one after the other.
        files: Vec<DataFile>,
    },
}

/// A file of a data set.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct DataFile {
    /// Name of the file, as the plan names it.
    pub file: String,
    /// Fault of the file; then it has no rows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fault: Option<String>,
    /// Head of a table of text, which tells the columns: the header with all that was looked at to know it, which is
    /// the first row too where a remark is the header. JSON lines have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub head: Option<FilePiece>,
    /// Slices of the file, each as many rows as are held in memory at a time.
    pub slices: Vec<TextSlice>,
}

/// Bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FilePiece {
    /// Place of the first (bytes).
    pub offset: u64,
    /// Number of them.
    pub bytes: u64,
    /// SHA-256 of them.
    pub sha256: String,
}

/// A slice: all that was looked at to know its rows. It may reach into the next one, where a quote is not closed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TextSlice {
    /// Number of its rows.
    pub rows: u64,
    /// The number of its first line, from 1.
    pub line: u64,
    /// Bytes of the slice.
    #[serde(flatten)]
    pub piece: FilePiece,
}

impl SweepRecord {
    /// The files of a data set; none of other sweeps.
    pub fn files(&self) -> &[DataFile] {
        if let SweepArches::Data { files } = &self.arches { files } else { &[] }
    }

    /// The slices of the files, in order, each with its file and with its rows.
    pub fn slices(&self) -> impl Iterator<Item = (Range<u64>, &DataFile, &TextSlice)> {
        let slices =
            self.files().iter().flat_map(|file| file.slices.iter().map(move |of| (file, of)));
        let mut first = 0;
        slices.map(move |(file, of)| {
            first += of.rows;
            (first - of.rows..first, file, of)
        })
    }

    /// The one form: JSON on one line.
    pub fn text(&self) -> String {
        // Only texts and whole numbers: nothing that JSON cannot hold.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// SHA-256 of the one form.
    pub fn hash(&self) -> String {
        hash_of(self.text().as_bytes())
    }

    /// Checks that the record makes sense, and its parts can be listed: it may come from elsewhere.
    pub fn check(&self) -> Result<(), String> {
        let all = |numbers: &[usize]| {
            numbers.iter().try_fold(1, |all: u64, number| all.checked_mul(*number as u64))
        };
        let rows = match &self.arches {
            SweepArches::Grid { half_opening, friction } => {
                all(&[self.weights.len(), half_opening.len(), friction.len()])
            }
            SweepArches::Sample { .. } => Some(self.rows).filter(|rows| *rows <= MAX_SAMPLE as u64),
            SweepArches::Data { files } => {
                let mut slices = files.iter().flat_map(|file| &file.slices);
                slices.try_fold(0, |all: u64, slice| {
                    let is_held = |rows: &u64| (1..=self.chunk.min(GROUP)).contains(rows);
                    all.checked_add(Some(slice.rows).filter(is_held)?)
                })
            }
        };
        let is_known = (SWEEP_DIGITS..=MAX_DIGITS).contains(&self.digits)
            && (1..=MAX_CHUNK as u64).contains(&self.chunk);
        if rows != Some(self.rows) || !is_known {
            return Err("its record contradicts itself".into());
        }
        match self.count() {
            // Who opens the sweep reads no more.
            0..=MAX_PARTS if self.text().len() as u64 > MAX_RECORD => Err(format!(
                "the record of a sweep has at most {} MiB, and this would have more: give a larger chunk, or several plans",
                MAX_RECORD >> 20
            )),
            0..=MAX_PARTS => Ok(()),
            parts => Err(format!(
                "a sweep has at most {MAX_PARTS} parts, and this would have {parts}: give a larger chunk"
            )),
        }
    }

    /// Number of parts.
    fn count(&self) -> u64 {
        let chunk = self.chunk.max(1);
        match &self.arches {
            SweepArches::Data { files } => {
                let parts = |file: &DataFile| file.slices.len().div_ceil(self.slices_of_a_part());
                files.iter().map(|file| parts(file) as u64).sum()
            }
            _ => match self.column() {
                column if column <= chunk => self.rows.div_ceil(chunk / column * column),
                column => self.rows / column * column.div_ceil(chunk),
            },
        }
    }

    /// The ranges of rows of the parts, in order. A part of a grid has whole columns, or a piece of one; of a plan that
    /// does not say how many rows a part has, one row.
    pub fn parts(&self) -> Vec<Range<u64>> {
        let SweepArches::Data { files } = &self.arches else {
            return pieces(&(0..self.rows), self.column(), self.chunk.max(1));
        };
        let mut first = 0;
        let parts = files.iter().flat_map(|file| file.slices.chunks(self.slices_of_a_part()));
        let part = |slices: &[TextSlice]| {
            let start = first;
            first += slices.iter().map(|slice| slice.rows).sum::<u64>();
            start..first
        };
        parts.map(part).collect()
    }

    /// The ranges of the rows of a part that are held in memory at a time, in order.
    pub fn groups(&self, part: &Range<u64>) -> Vec<Range<u64>> {
        match &self.arches {
            SweepArches::Grid { .. } => pieces(part, self.column(), GRID_GROUP),
            SweepArches::Sample { .. } => pieces(part, 1, GROUP),
            SweepArches::Data { .. } => {
                let slices = self.slices().map(|(rows, ..)| rows);
                slices.filter(|rows| part.contains(&rows.start)).collect()
            }
        }
    }

    /// Slices of a file that make a part.
    fn slices_of_a_part(&self) -> usize {
        (self.chunk / GROUP).max(1) as usize
    }

    /// Rows that follow each other of one half opening.
    fn column(&self) -> u64 {
        match &self.arches {
            SweepArches::Grid { friction, .. } => friction.len().max(1) as u64,
            _ => 1,
        }
    }
}

/// Pieces of some rows with at most so many each: whole columns, or pieces of one.
fn pieces(rows: &Range<u64>, column: u64, most: u64) -> Vec<Range<u64>> {
    let mut pieces = Vec::new();
    let mut start = rows.start;
    while start < rows.end {
        let end = match column <= most {
            true => start + most / column * column,
            // A column that is too long is divided.
            false => (start + most).min((start / column + 1) * column),
        };
        pieces.push(start..end.min(rows.end));
        start = end;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read_sweep;

    fn record(rest: &str) -> SweepRecord {
        let text = format!("schema = \"couplet.sweep/1\"\n{rest}");
        let (plan, _) = read_sweep(text.as_bytes()).unwrap();
        SweepRecord { chunk: if plan.chunk > 0 { plan.chunk } else { 6_500 }, ..plan }
    }

    #[test]
    fn the_same_sweep_has_one_name_and_another_has_another() {
        let usual = "[grid]\nhalf_opening = [1, 2]\nfriction = [0.5, 1]\n";
        let name = record(usual).hash();
        for same in [
            "# A remark.\n[grid]\nmu = [0.5, \"1\"]\nalpha = { from = 1, to = 2, steps = 2 }\n",
            "weight = \"milankovitch\"\ndigits = 17\nquantities = \"thickness\"\n\
             [grid]\nhalf_opening = [1, 2]\nfriction = [0.5, 1]\n",
        ] {
            assert_eq!(record(same).hash(), name, "{same}");
        }
        for (from, to) in
            [("0.5", "0.25"), ("[1, 2]", "[2, 1]"), ("[1, 2]", "1"), ("0.5", "\"1/2\"")]
        {
            assert_ne!(record(&usual.replace(from, to)).hash(), name, "{to}");
        }
        for more in
            ["digits = 18\n", "chunk = 1\n", "weight = \"heyman\"\n", "quantities = \"thrust\"\n"]
        {
            assert_ne!(record(&format!("{more}{usual}")).hash(), name, "{more}");
        }
        let (one, other) =
            (record("[sample]\ncount = 9\n"), record("[sample]\ncount = 9\nseed = 2\n"));
        assert_ne!(one.hash(), other.hash());
        assert_eq!(serde_json::from_str::<SweepRecord>(&one.text()).unwrap(), one);
    }

    #[test]
    fn a_record_that_cannot_be_is_refused_before_its_parts_are_listed() {
        let usual = || record("chunk = 9\n[sample]\ncount = 10\n");
        assert_eq!(usual().check(), Ok(()));
        let contradicts = |record: SweepRecord| {
            assert_eq!(record.check(), Err("its record contradicts itself".to_owned()));
        };
        contradicts(SweepRecord { rows: 1_000_000_000_000_000_000, ..usual() });
        contradicts(SweepRecord { chunk: 0, ..usual() });
        assert_eq!(SweepRecord { chunk: 0, ..usual() }.parts().len(), 10);
        contradicts(SweepRecord { chunk: u64::MAX, ..usual() });
        contradicts(SweepRecord { digits: usize::MAX, ..usual() });
        let text = usual().text().replace("\"thickness\"", "\"x\"");
        assert!(serde_json::from_str::<SweepRecord>(&text).is_err());
        let grid = record("[grid]\nhalf_opening = [1, 2]\nfriction = 1\n");
        contradicts(SweepRecord { rows: 3, ..grid });
        let text = record("chunk = 1\n[sample]\ncount = 1000001\n").check().unwrap_err();
        assert!(text.ends_with("1000000 parts, and this would have 1000001: give a larger chunk"));
    }

    #[test]
    fn parts_are_whole_columns_or_pieces_of_one_and_leave_nothing_out() {
        let of = |chunk: u64| {
            let grid =
                "[grid]\nhalf_opening = [1, 2, 2.5]\nfriction = { from = 0, to = 1, steps = 5 }\n";
            let record = record(&format!("weight = \"both\"\nchunk = {chunk}\n{grid}"));
            assert_eq!(record.count(), record.parts().len() as u64);
            record.parts()
        };
        assert_eq!(of(12), [0..10, 10..20, 20..30]);
        assert_eq!(of(5).len(), 6);
        assert_eq!(of(3)[..3], [0..3, 3..5, 5..8]);
        assert_eq!((of(100).len(), of(100)[0].clone()), (1, 0..30));
        for chunk in 1..=31 {
            let parts = of(chunk);
            assert_eq!((parts[0].start, parts[parts.len() - 1].end), (0, 30));
            assert!(parts.windows(2).all(|pair| pair[0].end == pair[1].start), "{chunk}");
            assert!(parts.iter().all(|part| part.end - part.start <= chunk), "{chunk}");
            for part in parts {
                let whole = std::slice::from_ref(&part);
                assert_eq!(pieces(&part, 5, 31), whole, "a small part is one group");
                let groups = pieces(&part, 5, 2);
                assert_eq!((groups[0].start, groups[groups.len() - 1].end), (part.start, part.end));
                let is_one = |rows: &Range<u64>| rows.start / 5 == (rows.end - 1) / 5;
                assert!(groups.iter().all(|rows| rows.end - rows.start <= 2 && is_one(rows)));
            }
        }
        let sample = record("chunk = 4\n[sample]\ncount = 9\n").parts();
        assert_eq!(sample, [0..4, 4..8, 8..9]);
    }
}
