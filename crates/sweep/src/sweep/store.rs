//! The folder of the parts of a sweep, which has nothing else and so is a data set for any reader; the record is
//! beside it. A part is written whole under a name of its own, and then appears; its name has its size and the hash
//! of its content, which tell whether it is what was written.

use super::notes::Notes;
use super::part_name::{PartName, SHOWN};
use super::pieces::hash_of_pieces;
use super::record::{SweepRecord, VERSION};
use crate::check::reason;
use crate::failure::Failure;
use crate::report::words::shortened;
use crate::scene::Hashing;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tempfile::NamedTempFile;

/// Beginning of the name of the folder of a sweep, and the record beside it.
const FOLDER: &str = "sweep-";
/// Ending of the name of the record, which is otherwise named as the folder.
const RECORD: &str = ".json";
/// The record where it was before, among the parts.
const OLD_RECORD: &str = "_plan.json";
/// Beginning of the name of an unfinished file.
const UNFINISHED: &str = ".couplet-";
/// Parts of a folder; a sweep that has more has a folder for each so many.
const TOGETHER: usize = 1_000;
/// Age from which an unfinished part is stale.
const ABANDONED: Duration = Duration::from_secs(3600);

/// The folder of a sweep.
#[derive(Clone, Debug)]
pub(super) struct Store {
    pub folder: PathBuf,
    /// Path of the folder, with the record.
    output: PathBuf,
    /// The hash of the record.
    plan: String,
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

/// File that is written to the disk beside the folder, under another name, and then appears whole; if that fails
/// nothing of it remains.
pub(super) struct Unfinished {
    file: Hashing<NamedTempFile>,
    bytes: u64,
}

impl Store {
    /// The folder of a sweep in the folder of the results; it is not made.
    pub(super) fn new(output: &Path, record: &SweepRecord) -> Self {
        let plan = record.hash();
        Self { folder: output.join(named(&plan)), output: output.to_owned(), plan }
    }

    /// The folder of a sweep that was made, with its record, whose hash has to be its name.
    pub(super) fn open(folder: &Path) -> Result<(Self, SweepRecord), String> {
        let none = "it is not the folder of a sweep";
        let whole = fs::canonicalize(folder).map_err(|error| reason(&error))?;
        let (output, name) = (whole.parent(), whole.file_name().and_then(|name| name.to_str()));
        let (Some(output), Some(name)) = (output, name) else { return Err(none.into()) };
        let record = format!("{name}{RECORD}");
        let path = output.join(&record);
        let shown = shortened(&record);
        match path.is_file() {
            true => {}
            false if whole.join(OLD_RECORD).is_file() => {
                return Err(format!(
                    "it is of an older couplet, which kept the record among the parts: move {OLD_RECORD} beside it, \
                     as {shown}"
                ));
            }
            false => return Err(format!("{none}: it has no {shown} beside it")),
        }
        let text = fs::read(&path).map_err(|error| format!("{shown}: {}", reason(&error)))?;
        let record: Option<SweepRecord> = serde_json::from_slice(&text).ok();
        let record = record.filter(|record| record.text().as_bytes() == text);
        let record =
            record.ok_or(format!("{shown} is not the record of a sweep of this version"))?;
        let plan = record.hash();
        match (name == named(&plan), &record.couplet[..]) {
            (true, VERSION) => {}
            (true, other) => {
                let other = shortened(other);
                return Err(format!("couplet {other} began it, and this is {VERSION}"));
            }
            (false, _) => return Err(format!("{shown} is the record of {}", named(&plan))),
        }
        record.check()?;
        Ok((Self { folder: folder.to_owned(), output: output.to_owned(), plan }, record))
    }

    /// The hash of the record.
    pub(super) fn plan(&self) -> &str {
        &self.plan
    }

    /// The name of the record, beside the folder.
    fn record(&self) -> String {
        named(&self.plan) + RECORD
    }

    /// Beginning of the name of an unfinished file of this sweep; it is beside the folder too.
    fn unfinished(&self) -> String {
        format!("{UNFINISHED}{}-", named(&self.plan))
    }

    /// Other sweeps beside this one.
    pub(super) fn others(&self) -> Vec<String> {
        let own = self.record();
        let mut names: Vec<String> = fs::read_dir(self.results())
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
        let unfinished = self.unfinished();
        for entry in fs::read_dir(self.results())?.filter_map(|entry| entry.ok()) {
            let is_unfinished = entry.file_name().to_string_lossy().starts_with(&unfinished);
            let modified = entry.metadata().and_then(|there| there.modified());
            let age = modified.ok().and_then(|time| time.elapsed().ok());
            if is_unfinished && age.is_some_and(|age| age > ABANDONED) {
                // Somebody else may have been quicker.
                let _ = fs::remove_file(entry.path());
            }
        }
        let (path, text) = (self.output.join(self.record()), record.text());
        match path.is_file().then(|| fs::read(&path)) {
            Some(Ok(there)) if there == text.as_bytes() => Ok(()),
            _ => {
                let mut unfinished = self.begin()?;
                unfinished.write_all(text.as_bytes())?;
                unfinished.appear(|_, _| path)
            }
        }
    }

    /// The files in the folder of a sweep of so many parts, with their sizes. Hidden names are nobody's data.
    pub(super) fn files(&self, parts: usize) -> Result<PartFiles, Failure> {
        let mut files = PartFiles::default();
        match parts {
            0..=TOGETHER => self.folder_of(0..parts, "", &mut files)?,
            _ => {
                let firsts = (0..parts).step_by(TOGETHER);
                let folders: Vec<String> =
                    firsts.clone().map(|first| within(first, parts)).collect();
                for (first, folder) in firsts.zip(&folders) {
                    self.folder_of(first..parts.min(first + TOGETHER), folder, &mut files)?;
                }
                let is_folder = |name: &str| folders.iter().any(|of| of[..of.len() - 1] == *name);
                let mut others = self.entries("")?;
                others.retain(|(name, path)| !(path.is_dir() && is_folder(name)));
                files.strays.extend(others.into_iter().map(|(name, _)| name));
            }
        }
        files.parts.values_mut().for_each(|of| of.sort_by(|a, b| a.path.cmp(&b.path)));
        files.strays.sort();
        Ok(files)
    }

    /// Names that are not hidden in a folder within that of the sweep, with their paths; none without a folder.
    fn entries(&self, folder: &str) -> Result<Vec<(String, PathBuf)>, Failure> {
        let path = self.folder.join(folder);
        let failed = |error: io::Error| Failure::reading(path.display(), &error);
        let mut all = Vec::new();
        let entries = match fs::read_dir(&path) {
            Err(error) if is_no_folder(error.kind()) => return Ok(all),
            entries => entries.map_err(failed)?,
        };
        for entry in entries {
            let entry = entry.map_err(failed)?;
            all.push((entry.file_name().to_string_lossy().into_owned(), entry.path()));
        }
        all.retain(|(name, _)| !name.starts_with('.'));
        Ok(all)
    }

    /// Adds the files of a folder that has these parts.
    fn folder_of(
        &self,
        parts: Range<usize>,
        folder: &str,
        files: &mut PartFiles,
    ) -> Result<(), Failure> {
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
        Ok(())
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
                let mut file = File::open(&whole).map_err(failed)?;
                is_written = name.has(&hash_of_pieces(&mut file, &[(0, *bytes)]).map_err(failed)?);
                // Only what has the hash of its name is looked into.
                let notes = if is_written { Notes::of(&file) } else { None };
                is_ours &= !is_written
                    || notes.is_some_and(|notes| {
                        (&notes.plan, &notes.rows) == (&self.plan, rows)
                            && notes.counts == name.counts
                    });
            }
            match (is_ours, is_written) {
                (false, _) => return Ok(PartState::Foreign(path.clone())),
                (true, true) if there == PartState::Missing => {
                    there = PartState::Whole(path.clone(), name.counts);
                }
                (true, true) => return Ok(PartState::Foreign(path.clone())),
                (true, false) if removes => fs::remove_file(&whole).map_err(failed)?,
                (true, false) => {}
            }
        }
        Ok(there)
    }

    /// Begins a file of this sweep.
    pub(super) fn begin(&self) -> io::Result<Unfinished> {
        let (mut builder, prefix) = (tempfile::Builder::new(), self.unfinished());
        builder.prefix(&prefix);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The usual permissions of a new file; the process's mask restricts them.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        Ok(Unfinished { file: Hashing::new(builder.tempfile_in(self.results())?), bytes: 0 })
    }

    /// Makes a part of so many appear in the folder.
    pub(super) fn put(
        &self,
        (part, parts): (usize, usize),
        counts: [u64; 4],
        unfinished: Unfinished,
    ) -> io::Result<()> {
        let folder = self.folder.join(within(part, parts));
        fs::create_dir_all(&folder)?;
        unfinished.appear(|bytes, hash| {
            folder.join(PartName::new(part, &self.plan, counts, bytes, hash).to_string())
        })?;
        // The name, too. Some file systems have no such thing for folders.
        let _ = File::open(&folder).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// The folder of the results; nothing before a name is the current folder.
    fn results(&self) -> &Path {
        if self.output.as_os_str().is_empty() { Path::new(".") } else { &self.output }
    }
}

impl Unfinished {
    /// Makes the file appear, under a path that its size and its hash may tell.
    fn appear(self, path: impl FnOnce(u64, &str) -> PathBuf) -> io::Result<()> {
        let (file, hash) = self.file.end();
        file.as_file().sync_all()?;
        file.persist(path(self.bytes, &hash)).map_err(|error| error.error)?;
        Ok(())
    }
}

impl Write for Unfinished {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// The name of the sweep whose record has this hash.
fn named(plan: &str) -> String {
    format!("{FOLDER}{}", &plan[..SHOWN])
}

fn is_no_folder(error: io::ErrorKind) -> bool {
    matches!(error, io::ErrorKind::NotFound | io::ErrorKind::NotADirectory)
}

/// The folder within that of a sweep of so many parts where one is; nothing if all are together.
fn within(part: usize, parts: usize) -> String {
    match parts {
        0..=TOGETHER => String::new(),
        _ => format!("{:03}/", part / TOGETHER),
    }
}
