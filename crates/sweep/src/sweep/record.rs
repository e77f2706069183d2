//! The record of a sweep, `couplet.sweep/1`: everything that its rows depend on, in one form however the plan has it.
//!
//! Its SHA-256 is the name of the sweep, and of the folder of its parts: two different sweeps cannot meet in a folder,
//! and the same sweep always finds its own.

use super::cost::{GRID_GROUP, GROUP, MAX_PARTS, rows_of_a_part};
use super::text::{self, Head, TextSlice};
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::number::ExactNumber;
use crate::problem::{Friction, Quantity};
use crate::scene::{
    MAX_CHUNK, MAX_RECORD, MAX_SAMPLE, SWEEP_DIGITS, SWEEP_SCHEMA, SweepArches, SweepPlan, hash_of,
};
use serde::{Deserialize, Serialize};
use std::fs;
use std::ops::Range;
use std::path::Path;

/// The version of the program.
pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Record of a sweep, in names and exact texts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SweepRecord {
    pub schema: String,
    /// The version of the program: another one may prove what this one leaves undecided.
    pub couplet: String,
    pub weights: Vec<SelfWeight>,
    pub quantities: Vec<Quantity>,
    pub digits: usize,
    /// Rows in all.
    pub rows: u64,
    /// The most rows of a part.
    pub chunk: u64,
    pub arches: Arches,
}

/// Source of the arches.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub(super) enum Arches {
    /// Every weight with every half opening and every friction.
    Grid { half_opening: Vec<ExactNumber>, friction: Vec<Friction> },
    /// Drawn from a seed.
    Sample { seed: u64, hard: bool },
    /// The rows of files, each told by its name and its content.
    Data { files: Vec<DataFile> },
}

/// A file of a data set.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DataFile {
    /// Name of the file, as the plan names it.
    pub file: String,
    /// Fault of the file; then it has no rows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fault: Option<String>,
    /// Head of a table of text; JSON lines have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub head: Option<Head>,
    /// Pieces of the file, each as many rows as are held in memory at a time.
    pub slices: Vec<TextSlice>,
}

impl SweepRecord {
    /// Record of a plan whose paths begin in a folder. Files of a data set are read once.
    pub(super) fn new(plan: &SweepPlan, base: &Path) -> Self {
        let files: &[String] =
            if let SweepArches::Data { files } = &plan.arches { files } else { &[] };
        let length = |name: &String| fs::metadata(base.join(name)).map_or(0, |there| there.len());
        let chunk = rows_of_a_part(plan, files.iter().map(length).sum());
        let (rows, arches) = match &plan.arches {
            SweepArches::Grid { half_openings, frictions } => {
                let rows = [plan.weights.len(), half_openings.len(), frictions.len()];
                let (half_opening, friction) = (half_openings.clone(), frictions.clone());
                (rows.iter().product::<usize>() as u64, Arches::Grid { half_opening, friction })
            }
            SweepArches::Sample { count, seed, hard } => {
                (*count as u64, Arches::Sample { seed: *seed, hard: *hard })
            }
            SweepArches::Data { files } => {
                let file = |name: &String| {
                    let read = text::slices(&base.join(name), chunk.min(GROUP));
                    let fault = read.as_ref().err().cloned();
                    let (head, slices) = read.unwrap_or_default();
                    DataFile { file: name.clone(), fault, head, slices }
                };
                let files: Vec<DataFile> = files.iter().map(file).collect();
                let slices = files.iter().flat_map(|file| &file.slices);
                (slices.map(|slice| slice.rows).sum(), Arches::Data { files })
            }
        };
        Self {
            schema: SWEEP_SCHEMA.to_owned(),
            couplet: VERSION.to_owned(),
            weights: plan.weights.clone(),
            quantities: plan.quantities.clone(),
            digits: plan.digits,
            rows,
            chunk,
            arches,
        }
    }

    /// The one form: JSON on one line.
    pub(super) fn text(&self) -> String {
        // Only texts and whole numbers: nothing that JSON cannot hold.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// SHA-256 of the one form.
    pub(super) fn hash(&self) -> String {
        hash_of(self.text().as_bytes())
    }

    /// Checks that the record makes sense, and its parts can be listed: it may come from elsewhere.
    pub(super) fn check(&self) -> Result<(), String> {
        let all = |numbers: &[usize]| {
            numbers.iter().try_fold(1, |all: u64, number| all.checked_mul(*number as u64))
        };
        let rows = match &self.arches {
            Arches::Grid { half_opening, friction } => {
                all(&[self.weights.len(), half_opening.len(), friction.len()])
            }
            Arches::Sample { .. } => Some(self.rows).filter(|rows| *rows <= MAX_SAMPLE as u64),
            Arches::Data { files } => {
                let mut pieces = files.iter().flat_map(|file| &file.slices);
                pieces.try_fold(0, |all: u64, piece| {
                    let is_held = |rows: &u64| (1..=self.chunk.min(GROUP)).contains(rows);
                    all.checked_add(Some(piece.rows).filter(is_held)?)
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
        match &self.arches {
            Arches::Data { files } => {
                let parts = |file: &DataFile| file.slices.len().div_ceil(self.slices_of_a_part());
                files.iter().map(|file| parts(file) as u64).sum()
            }
            _ => match self.column() {
                column if column <= self.chunk => self.rows.div_ceil(self.chunk / column * column),
                column => self.rows / column * column.div_ceil(self.chunk),
            },
        }
    }

    /// The ranges of rows of the parts, in order. A part of a grid has whole columns, or a piece of one.
    pub(super) fn parts(&self) -> Vec<Range<u64>> {
        let Arches::Data { files } = &self.arches else {
            return pieces(&(0..self.rows), self.column(), self.chunk);
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
    pub(super) fn groups(&self, part: &Range<u64>) -> Vec<Range<u64>> {
        let files = match &self.arches {
            Arches::Grid { .. } => return pieces(part, self.column(), GRID_GROUP),
            Arches::Sample { .. } => return pieces(part, 1, GROUP),
            Arches::Data { files } => files,
        };
        let mut first = 0;
        let group = |slice: &TextSlice| {
            first += slice.rows;
            first - slice.rows..first
        };
        let groups = files.iter().flat_map(|file| &file.slices).map(group);
        groups.filter(|group| part.contains(&group.start)).collect()
    }

    /// Slices of a file that make a part.
    fn slices_of_a_part(&self) -> usize {
        (self.chunk / GROUP).max(1) as usize
    }

    /// Rows that follow each other of one half opening.
    fn column(&self) -> u64 {
        match &self.arches {
            Arches::Grid { friction, .. } => friction.len().max(1) as u64,
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
        SweepRecord::new(&read_sweep(text.as_bytes()).unwrap(), Path::new(""))
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
