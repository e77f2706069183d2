//! The folder of the parts of a sweep, which has nothing else and so is a data set for any reader; the record is
//! beside it. A part is written whole under a name of its own, and then appears; its name has the hash of its
//! content, which tells whether it is what was written.

use super::pieces::hash_of_pieces;
use super::record::{SweepRecord, VERSION};
use super::table::Notes;
use crate::check::reason;
use crate::failure::Failure;
use crate::report::words::shortened;
use crate::scene::hash_of;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Beginning of the name of the folder of a sweep, and the record beside it.
const FOLDER: &str = "sweep-";
/// Ending of the name of the record, which is otherwise named as the folder.
const RECORD: &str = ".json";
/// The record where it was before, among the parts.
const OLD_RECORD: &str = "_plan.json";
/// Beginning of the name of an unfinished file.
const UNFINISHED: &str = ".couplet-";
/// Digits of a hash that are in names.
const SHOWN: usize = 16;
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
    /// The names of the files of each part.
    pub parts: BTreeMap<usize, Vec<String>>,
    /// Strays: what is no part of the sweep, by name: every reader would take it for one, or not know what to do.
    pub strays: Vec<String>,
}

/// State of the files of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PartState {
    /// The part is missing: there is nothing, or files that are not what was written.
    Missing,
    /// The part, by its name, and the counts of its verdicts.
    Whole(String, [u64; 4]),
    /// A file that is as it was written and does not belong here: a part of another sweep, or the same part once more,
    /// of another build.
    Foreign(String),
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
            _ => self.write(&path, text.as_bytes()),
        }
    }

    /// Files in the folder of a sweep of so many parts. Hidden names are nobody's data.
    pub(super) fn files(&self, parts: usize) -> Result<PartFiles, Failure> {
        let failed = |error: io::Error| Failure::reading(self.folder.display(), &error);
        let mut files = PartFiles::default();
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(files),
            entries => entries.map_err(failed)?,
        };
        for entry in entries {
            let entry = entry.map_err(failed)?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let part = part_of(&name).filter(|part| *part < parts);
            match (part, fs::metadata(entry.path())) {
                _ if name.starts_with('.') => {}
                (Some(part), Ok(there)) if there.is_file() => {
                    files.parts.entry(part).or_default().push(name);
                }
                // Another run takes a part away that is not whole.
                (Some(_), Err(_)) if !entry.path().is_symlink() => {}
                // A pipe would be waited for.
                _ => files.strays.push(name),
            }
        }
        files.parts.values_mut().for_each(|names| names.sort());
        files.strays.sort();
        Ok(files)
    }

    /// State of the files of a part of these rows. Files that are not what was written are removed, if they may be.
    pub(super) fn there(
        &self,
        names: &[String],
        rows: &Range<u64>,
        removes: bool,
    ) -> Result<PartState, Failure> {
        let mut there = PartState::Missing;
        for name in names {
            let path = self.folder.join(name);
            let failed = |error: io::Error| Failure::reading(path.display(), &error);
            match content(&path, name).map_err(failed)? {
                None if removes => fs::remove_file(&path).map_err(failed)?,
                None => {}
                Some(Some(notes)) if notes.plan == self.plan && notes.rows == *rows => {
                    if there != PartState::Missing {
                        return Ok(PartState::Foreign(name.clone()));
                    }
                    there = PartState::Whole(name.clone(), notes.counts);
                }
                Some(_) => return Ok(PartState::Foreign(name.clone())),
            }
        }
        Ok(there)
    }

    /// The name of a part.
    pub(super) fn name(part: usize, bytes: &[u8]) -> String {
        format!("part-{part:08}-{}.parquet", &hash_of(bytes)[..SHOWN])
    }

    /// Makes a part appear in the folder, whole and on the disk. If that fails nothing of it remains.
    pub(super) fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        self.write(&self.folder.join(name), bytes)?;
        // The name, too. Some file systems have no such thing for folders.
        let _ = File::open(&self.folder).and_then(|folder| folder.sync_all());
        Ok(())
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let (mut builder, prefix) = (tempfile::Builder::new(), self.unfinished());
        builder.prefix(&prefix);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The usual permissions of a new file; the process's mask restricts them.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let mut unfinished = builder.tempfile_in(self.results())?;
        unfinished.write_all(bytes)?;
        unfinished.as_file().sync_all()?;
        unfinished.persist(path).map_err(|error| error.error)?;
        Ok(())
    }

    /// The folder of the results; nothing before a name is the current folder.
    fn results(&self) -> &Path {
        if self.output.as_os_str().is_empty() { Path::new(".") } else { &self.output }
    }
}

/// Notes of a file on itself, if its content is what its name says; nothing if it is no part of any sweep.
fn content(path: &Path, name: &str) -> io::Result<Option<Option<Notes>>> {
    let mut file = File::open(path)?;
    let length = file.metadata()?.len();
    let hash = hash_of_pieces(&mut file, &[(0, length)])?;
    let is_as_written = name.ends_with(&format!("-{}.parquet", &hash[..SHOWN]));
    Ok(is_as_written.then(|| Notes::of(&file)))
}

/// The name of the sweep whose record has this hash.
fn named(plan: &str) -> String {
    format!("{FOLDER}{}", &plan[..SHOWN])
}

/// The part whose file has this name.
fn part_of(name: &str) -> Option<usize> {
    let (part, hash) = name.strip_prefix("part-")?.strip_suffix(".parquet")?.split_once('-')?;
    let part: usize = part.parse().ok()?;
    let is_hash = hash.len() == SHOWN && hash.bytes().all(|c| c.is_ascii_hexdigit());
    (is_hash && name == format!("part-{part:08}-{hash}.parquet")).then_some(part)
}
