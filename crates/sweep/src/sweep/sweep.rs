//! A sweep: what it is, the folder of its parts, and the work that one part is. Nothing else has to be known to whoever
//! shares the parts among processes or machines.

use super::cost::rows_of_a_part;
use super::part_file::Notes;
use super::queries::{AxisNumber, PartQueries};
use super::queries::{frictions, queries};
use super::store::{PartState, Store};
use super::{table, text};
use crate::certify::batch::{Batch, Threads};
use crate::failure::Failure;
use crate::problem::Friction;
use crate::report::ParquetFile;
use crate::scene::{DataFile, GROUP, SWEEP_DIGITS, SweepArches, SweepRecord};
use rayon::prelude::*;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A sweep and the folder of its parts.
pub struct Sweep {
    pub(super) record: SweepRecord,
    pub(super) store: Store,
    /// Folder where the paths of a data set begin.
    pub(super) base: PathBuf,
    pub(super) batch: Batch,
    parts: Vec<Range<u64>>,
    /// Frictions of a grid, read once for all its rows.
    frictions: OnceLock<Result<Vec<AxisNumber<Friction>>, String>>,
}

/// State of a part: complete, with the counts of its verdicts, or missing.
pub type SurveyedPart = (usize, Option<[u64; 4]>);

impl Sweep {
    /// The sweep of a plan, with results in a folder of `output`; `base` is where the paths of a data set begin. The
    /// files of a data set are read once.
    pub fn new(plan: SweepRecord, base: &Path, output: &Path) -> Result<Self, Failure> {
        let record = recorded(plan, base);
        record.check()?;
        Ok(Self::of(Store::new(output, &record), record, base))
    }

    /// A sweep that was begun, by the folder of its parts.
    pub fn open(folder: &Path, base: &Path) -> Result<Self, Failure> {
        let (store, record) = Store::open(folder)?;
        Ok(Self::of(store, record, base))
    }

    fn of(store: Store, record: SweepRecord, base: &Path) -> Self {
        let (quantities, digits) = (record.quantities.clone(), record.digits);
        let batch = Batch { quantities, digits, has_texts: digits > SWEEP_DIGITS };
        let parts = record.parts();
        let frictions = OnceLock::new();
        Self { record, store, base: base.to_owned(), batch, parts, frictions }
    }

    /// The folder of its parts.
    pub fn folder(&self) -> &Path {
        &self.store.folder
    }

    /// Number of parts.
    pub fn parts(&self) -> usize {
        self.parts.len()
    }

    /// The rows of a part.
    pub fn rows(&self, part: usize) -> Range<u64> {
        self.parts[part].clone()
    }

    /// The parts of a share `k` of `n`, from 1: every `n`-th.
    pub fn share(&self, k: usize, n: usize) -> Vec<usize> {
        (k - 1..self.parts.len()).step_by(n).collect()
    }

    /// Other sweeps beside it.
    pub fn others(&self) -> Vec<String> {
        self.store.others()
    }

    /// The files of a data set that cannot be read, and why.
    pub fn bad_files(&self) -> Vec<String> {
        let bad = |file: &DataFile| Some(format!("{}: {}", file.file, file.fault.as_ref()?));
        self.record.files().iter().filter_map(bad).collect()
    }

    /// Makes the folder, with the record of the sweep.
    pub fn prepare(&self) -> Result<(), Failure> {
        self.store.prepare(&self.record).map_err(|error| self.unwritten(&error))
    }

    fn unwritten(&self, error: &io::Error) -> Failure {
        Failure::writing(self.folder().display(), error)
    }

    /// Surveys some parts, told by their names and sizes, and if they are read by their content. What is not whole is
    /// removed; what is no part of the sweep is an error.
    pub fn survey(&self, parts: &[usize], reads: bool) -> Result<Vec<SurveyedPart>, Failure> {
        let files = self.store.files(self.parts())?;
        let foreign = |name: &str, what: &str| {
            let path = self.folder().join(name);
            Failure::Input(format!("{} is {what}; take it away", path.display()))
        };
        if let Some(name) = files.strays.first() {
            return Err(foreign(name, "no part of the sweep"));
        }
        let state = |&part: &usize| {
            let Some(of) = files.parts.get(&part) else { return Ok((part, None)) };
            match self.store.there(of, &self.parts[part], reads, true)? {
                PartState::Missing => Ok((part, None)),
                PartState::Whole(_, counts) => Ok((part, Some(counts))),
                PartState::Foreign(name) => {
                    Err(foreign(&name, "a part of another sweep or another build"))
                }
            }
        };
        parts.par_iter().map(state).collect()
    }

    /// The rows of a group of a part, as they are asked.
    pub(super) fn queries(&self, group: &Range<u64>) -> Result<PartQueries<'_>, String> {
        let frictions = self.frictions.get_or_init(|| frictions(&self.record));
        queries(&self.record, frictions.as_ref().map_err(Clone::clone)?, group, &self.base)
    }

    /// Computes a part, writes it, and counts its verdicts. It appears whole or not at all, and whoever computes it
    /// writes the same bytes. Of its rows a group is held in memory at a time.
    pub fn compute(&self, part: usize) -> Result<[u64; 4], Failure> {
        let unwritten = |error: io::Error| self.unwritten(&error);
        let mut file = self.store.begin().map_err(unwritten)?;
        let (rows, mut counts) = (self.parts[part].clone(), [0; 4]);
        let mut writer = ParquetFile::default();
        for group in self.record.groups(&rows) {
            let queries = self.queries(&group)?;
            let found = file.kept_during(|| self.batch.columns(&queries, Threads::One));
            found.verdicts.iter().for_each(|verdict| counts[*verdict as usize] += 1);
            let mut table = table::asked(&queries);
            table.columns.extend(table::answered(&self.batch.quantities, &found).columns);
            let bytes = writer.group(&table);
            bytes.and_then(|bytes| file.write_all(&bytes)).map_err(unwritten)?;
        }
        let notes = Notes { plan: self.store.plan.clone(), rows, counts };
        let bytes = writer.end(notes.entries());
        bytes.and_then(|bytes| file.write_all(&bytes)).map_err(unwritten)?;
        self.store.put((part, self.parts()), counts, file).map_err(unwritten)?;
        Ok(counts)
    }
}

/// The record of a plan, with the rows of a part. The files of a data set, whose paths begin in a folder, are read
/// once.
fn recorded(mut record: SweepRecord, base: &Path) -> SweepRecord {
    let path = |file: &DataFile| base.join(&file.file);
    let length = |file: &DataFile| fs::metadata(path(file)).map_or(0, |there| there.len());
    record.chunk = rows_of_a_part(&record, record.files().iter().map(length).sum());
    if let SweepArches::Data { files } = &mut record.arches {
        for file in files.iter_mut() {
            match text::slices(&path(file), record.chunk.min(GROUP)) {
                Ok((head, slices)) => (file.head, file.slices) = (head, slices),
                Err(fault) => file.fault = Some(fault),
            }
        }
        record.rows = files.iter().flat_map(|file| &file.slices).map(|slice| slice.rows).sum();
    }
    record
}
