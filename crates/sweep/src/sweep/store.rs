//! The folder of the parts of a sweep, which has nothing else and so is a data set for any reader; the record is
//! beside it. A part is written whole under a name of its own, and then appears; its name has its size and the hash
//! of its content, which tell whether it is what was written.

use super::new_file::{self, NewFile};
use super::part_file::Notes;
use super::part_name::{PartName, SHOWN};
use crate::failure::Failure;
use crate::report::words::shortened;
use crate::scene::{SweepRecord, VERSION, content_of, record_bytes};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io;
use std::ops::Range;
use std::path::{self, Path, PathBuf};

/// Beginning of the name of the folder of a sweep, and the record beside it.
const FOLDER: &str = "sweep-";
/// Ending of the name of the record, which is otherwise named as the folder.
const RECORD: &str = ".json";
/// The record where it was before, among the parts.
const OLD_RECORD: &str = "_plan.json";
/// Parts of a folder; a sweep that has more has a folder for each so many.
const TOGETHER: usize = 1_000;

/// The folder of a sweep.
#[derive(Clone, Debug)]
pub(super) struct Store {
    pub folder: PathBuf,
    /// The folder of the results, with the record.
    output: PathBuf,
    /// The hash of the record.
    pub plan: String,
}

/// Files of parts in the folder of a sweep.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PartFiles {
    /// The files of each part.
    pub parts: BTreeMap<usize, Vec<PartFile>>,
    /// Strays: what is no part of the sweep, by name: every reader would take it for one, or not know what to do.
    pub strays: Vec<String>,
}

/// File of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PartFile {
    /// Path of the file, from the folder of the sweep.
    pub path: String,
    name: PartName,
    bytes: u64,
}

/// State of the files of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PartState {
    /// The part is missing: there is nothing, or files that are not what was written.
    Missing,
    /// The part, by its path, and the counts of its verdicts.
    Whole(String, [u64; 4]),
    /// A file that does not belong here: a part of another sweep, or the same part once more, of another build.
    Foreign(String),
}

impl Store {
    /// The folder of a sweep in the folder of the results; it is not made.
    pub(super) fn new(output: &Path, record: &SweepRecord) -> Self {
        let plan = record.hash();
        // Nothing before a name is the current folder.
        let results = if output.as_os_str().is_empty() { Path::new(".") } else { output };
        Self { folder: output.join(named(&plan)), output: results.to_owned(), plan }
    }

    /// The folder of a sweep that was made, with its record, whose hash has to be its name.
    pub(super) fn open(folder: &Path) -> Result<(Self, SweepRecord), Failure> {
        let wrong = |fault: String| Failure::Input(format!("{}: {fault}", folder.display()));
        let none = "it is not the folder of a sweep";
        let failed = |error: io::Error| Failure::reading(folder.display(), &error);
        let whole = fs::canonicalize(folder).map_err(failed)?;
        // The folder may be a link beside the record, and its own name another one.
        let given = path::absolute(folder).map_err(failed)?;
        let is_beside = |path: &Path| {
            let record = path.file_name()?.to_str().filter(|name| name.starts_with(FOLDER))?;
            Some(path.with_file_name(format!("{record}{RECORD}")).is_file())
        };
        let there = if is_beside(&given) == Some(true) { &given } else { &whole };
        let (output, name) = (there.parent(), there.file_name().and_then(|name| name.to_str()));
        let (Some(output), Some(name)) = (output, name) else { return Err(wrong(none.into())) };
        let record = format!("{name}{RECORD}");
        let path = output.join(&record);
        let shown = shortened(&record);
        if !path.is_file() {
            return Err(wrong(match whole.join(OLD_RECORD).is_file() {
                true => format!(
                    "it is of an older couplet, which kept the record among the parts: move {OLD_RECORD} beside it, \
                     as {shown}"
                ),
                false => format!("{none}: it has no {shown} beside it"),
            }));
        }
        let text = match record_bytes(&path) {
            Err(error) if error.kind() == io::ErrorKind::InvalidData => Vec::new(),
            text => text.map_err(|error| Failure::reading(path.display(), &error))?,
        };
        let record: Option<SweepRecord> = serde_json::from_slice(&text).ok();
        let record = record.filter(|record| record.text().as_bytes() == text);
        let record = record.ok_or_else(|| {
            wrong(format!("{shown} is not the record of a sweep of this version"))
        })?;
        let plan = record.hash();
        if name != named(&plan) {
            return Err(wrong(format!("{shown} is the record of {}", named(&plan))));
        }
        if record.couplet != VERSION {
            let other = shortened(&record.couplet);
            return Err(wrong(format!("couplet {other} began it, and this is {VERSION}")));
        }
        record.check().map_err(wrong)?;
        Ok((Self { folder: folder.to_owned(), output: output.to_owned(), plan }, record))
    }

    /// The name of the record, beside the folder.
    fn record(&self) -> String {
        named(&self.plan) + RECORD
    }

    /// Other sweeps beside this one.
    pub(super) fn others(&self) -> Vec<String> {
        let own = self.record();
        let mut names: Vec<String> = fs::read_dir(&self.output)
            .into_iter()
            .flatten()
            .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
            .filter(|name| name.starts_with(FOLDER) && *name != own)
            .filter_map(|name| Some(name.strip_suffix(RECORD)?.to_owned()))
            .collect();
        names.sort();
        names
    }

    /// Makes the folder, with the record beside it, and clears what killed runs have left.
    pub(super) fn prepare(&self, record: &SweepRecord) -> io::Result<()> {
        fs::create_dir_all(&self.folder)?;
        new_file::clear(&self.output, &named(&self.plan))?;
        let (path, text) = (self.output.join(self.record()), record.text());
        match path.is_file().then(|| record_bytes(&path)) {
            Some(Ok(there)) if there == text.as_bytes() => Ok(()),
            _ => {
                let mut file = self.begin()?;
                file.write_all(text.as_bytes())?;
                file.appear(|_, _| path)
            }
        }
    }

    /// The files in the folder of a sweep of so many parts, with their sizes. Hidden names are nobody's data.
    pub(super) fn files(&self, parts: usize) -> Result<PartFiles, Failure> {
        let mut files = PartFiles::default();
        // A sweep without parts has a folder too.
        let firsts = (0..parts.max(1)).step_by(TOGETHER);
        let folders: Vec<String> = firsts.clone().map(|first| within(first, parts)).collect();
        for (first, folder) in firsts.zip(&folders) {
            let parts = first..parts.min(first + TOGETHER);
            for (name, whole) in self.entries(folder)? {
                let path = format!("{folder}{name}");
                let name = PartName::read(&name).filter(|name| parts.contains(&name.part));
                match (name, fs::metadata(&whole)) {
                    (Some(name), Ok(there)) if there.is_file() => {
                        let of = files.parts.entry(name.part).or_default();
                        of.push(PartFile { path, name, bytes: there.len() });
                    }
                    // Another run takes a part away that is not whole.
                    (Some(_), Err(_)) if !whole.is_symlink() => {}
                    // A pipe would be waited for.
                    _ => files.strays.push(path),
                }
            }
        }
        if parts > TOGETHER {
            let is_folder =
                |name: &str| folders.iter().any(|of| of.strip_suffix('/') == Some(name));
            let mut others = self.entries("")?;
            others.retain(|(name, path)| !(path.is_dir() && is_folder(name)));
            files.strays.extend(others.into_iter().map(|(name, _)| name));
        }
        files.parts.values_mut().for_each(|of| of.sort_by(|a, b| a.path.cmp(&b.path)));
        files.strays.sort();
        Ok(files)
    }

    /// Names that are not hidden in a folder within that of the sweep, with their paths; none without a folder.
    fn entries(&self, folder: &str) -> Result<Vec<(String, PathBuf)>, Failure> {
        let path = self.folder.join(folder);
        let failed = |error: io::Error| Failure::reading(path.display(), &error);
        let is_no_folder =
            |of| matches!(of, io::ErrorKind::NotFound | io::ErrorKind::NotADirectory);
        let entries = match fs::read_dir(&path) {
            Err(error) if is_no_folder(error.kind()) => return Ok(Vec::new()),
            entries => entries.map_err(failed)?,
        };
        let named = entries.map(|entry| {
            let entry = entry?;
            Ok((entry.file_name().to_string_lossy().into_owned(), entry.path()))
        });
        let mut all = named.collect::<io::Result<Vec<_>>>().map_err(failed)?;
        all.retain(|(name, _)| !name.starts_with('.'));
        Ok(all)
    }

    /// State of the files of a part of these rows, told by name and size; where they are read, or there are several, by
    /// their content. Files that are not what was written are removed, if they may be.
    pub(super) fn there(
        &self,
        files: &[PartFile],
        rows: &Range<u64>,
        reads: bool,
        removes: bool,
    ) -> Result<PartState, Failure> {
        let mut there = PartState::Missing;
        for PartFile { path, name, bytes } in files {
            let whole = self.folder.join(path);
            let failed = |error: io::Error| Failure::reading(whole.display(), &error);
            let mut is_ours = name.is_of(&self.plan, rows.end - rows.start);
            let mut is_written = *bytes == name.bytes;
            if is_written && (reads || files.len() > 1) {
                is_written = name.has(&content_of(&whole).map_err(failed)?);
                // Only what has the hash of its name is looked into.
                let notes =
                    || Notes { plan: self.plan.clone(), rows: rows.clone(), counts: name.counts };
                is_ours &= !is_written || notes().are_of(&whole);
            }
            match (is_ours, is_written) {
                (true, true) if there == PartState::Missing => {
                    there = PartState::Whole(path.clone(), name.counts);
                }
                (false, _) | (true, true) => return Ok(PartState::Foreign(path.clone())),
                (true, false) if removes => fs::remove_file(&whole).map_err(failed)?,
                (true, false) => {}
            }
        }
        Ok(there)
    }

    /// Begins a file of this sweep.
    pub(super) fn begin(&self) -> io::Result<NewFile> {
        NewFile::begin(&self.output, &named(&self.plan))
    }

    /// Makes a part of so many appear in the folder.
    pub(super) fn put(
        &self,
        (part, parts): (usize, usize),
        counts: [u64; 4],
        file: NewFile,
    ) -> io::Result<()> {
        let folder = self.folder.join(within(part, parts));
        fs::create_dir_all(&folder)?;
        file.appear(|bytes, hash| {
            folder.join(PartName::new(part, &self.plan, counts, bytes, hash).to_string())
        })?;
        // The name, too. Some file systems have no such thing for folders.
        let _ = File::open(&folder).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

/// The name of the sweep whose record has this hash.
fn named(plan: &str) -> String {
    format!("{FOLDER}{}", &plan[..SHOWN])
}

/// The folder within that of a sweep of so many parts where one is; nothing if all are together.
fn within(part: usize, parts: usize) -> String {
    match parts {
        0..=TOGETHER => String::new(),
        _ => format!("{:03}/", part / TOGETHER),
    }
}
