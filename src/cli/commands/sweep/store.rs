//! The folder of the parts of a sweep. A part is written whole under a name of its own, and then appears; its name has
//! the hash of its content, which tells whether it is what was written.

use super::pieces::{hash_of, hash_of_pieces};
use super::record::Record;
use super::table::Notes;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The record of a sweep, in its folder. Readers of data sets leave out what begins so.
pub(super) const RECORD: &str = "_plan.json";
/// How the folder of a sweep begins.
const FOLDER: &str = "sweep-";
/// How an unfinished file begins.
const UNFINISHED: &str = ".couplet-";
/// Digits of a hash that are in names.
const SHOWN: usize = 16;
/// Nobody writes a part for so long.
const ABANDONED: Duration = Duration::from_secs(3600);

/// The folder of a sweep.
#[derive(Clone, Debug)]
pub(super) struct Store {
    pub folder: PathBuf,
    /// The hash of the record.
    plan: String,
}

/// What there is of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum There {
    /// Nothing, or files that are not what was written.
    Missing,
    /// The part, by its name, and the counts of its verdicts.
    Whole(String, [u64; 4]),
    /// A file that is as it was written and does not belong here: a part of another sweep, or the same part once more,
    /// of another build.
    Foreign(String),
}

impl Store {
    /// The folder of a sweep in the folder of the results; it is not made.
    pub(super) fn new(output: &Path, record: &Record) -> Self {
        let plan = record.hash();
        Self { folder: output.join(format!("{FOLDER}{}", &plan[..SHOWN])), plan }
    }

    /// The folder of a sweep that was made, with its record, whose name has to be its hash.
    pub(super) fn open(folder: &Path) -> Result<(Self, Record), String> {
        let path = folder.join(RECORD);
        let text = fs::read(&path).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => {
                "it is not the folder of a sweep: it has no _plan.json".into()
            }
            _ => format!("_plan.json: {error}"),
        })?;
        let record: Option<Record> = serde_json::from_slice(&text).ok();
        let record = record.filter(|record| record.text().as_bytes() == text);
        let record = record.ok_or("its _plan.json is not the record of a sweep of this version")?;
        Ok((Self { folder: folder.to_owned(), plan: record.hash() }, record))
    }

    /// The hash of the record.
    pub(super) fn plan(&self) -> &str {
        &self.plan
    }

    /// Whether the folder has the name of its sweep.
    pub(super) fn is_named(&self) -> bool {
        let name = self.folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name == format!("{FOLDER}{}", &self.plan[..SHOWN])
    }

    /// Other sweeps beside this one.
    pub(super) fn others(&self) -> Vec<String> {
        let Some(output) = self.folder.parent() else { return Vec::new() };
        let own = self.folder.file_name();
        let mut names: Vec<String> = fs::read_dir(output)
            .into_iter()
            .flatten()
            .filter_map(|entry| entry.ok())
            .filter(|entry| Some(entry.file_name().as_os_str()) != own)
            .filter(|entry| entry.path().join(RECORD).is_file())
            .filter_map(|entry| entry.file_name().into_string().ok())
            .filter(|name| name.starts_with(FOLDER))
            .collect();
        names.sort();
        names
    }

    /// Makes the folder, with the record, and clears what killed runs have left.
    pub(super) fn prepare(&self, record: &Record) -> io::Result<()> {
        fs::create_dir_all(&self.folder)?;
        for entry in fs::read_dir(&self.folder)?.filter_map(|entry| entry.ok()) {
            let is_unfinished = entry.file_name().to_string_lossy().starts_with(UNFINISHED);
            let modified = entry.metadata().and_then(|there| there.modified());
            let age = modified.ok().and_then(|time| time.elapsed().ok());
            if is_unfinished && age.is_some_and(|age| age > ABANDONED) {
                // Somebody else may have been quicker.
                let _ = fs::remove_file(entry.path());
            }
        }
        let text = record.text();
        match fs::read(self.folder.join(RECORD)) {
            Ok(there) if there == text.as_bytes() => Ok(()),
            _ => self.put(RECORD, text.as_bytes()),
        }
    }

    /// The files of each part, by their names.
    pub(super) fn files(&self) -> io::Result<BTreeMap<usize, Vec<String>>> {
        let mut files: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(files),
            entries => entries?,
        };
        for entry in entries {
            let name = entry?.file_name();
            if let Some((part, name)) = name.to_str().and_then(|name| Some((part_of(name)?, name)))
            {
                files.entry(part).or_default().push(name.to_owned());
            }
        }
        files.values_mut().for_each(|names| names.sort());
        Ok(files)
    }

    /// What there is of a part of these rows. Files that are not what was written are removed, if they may be.
    pub(super) fn there(
        &self,
        names: &[String],
        rows: &Range<u64>,
        removes: bool,
    ) -> io::Result<There> {
        let mut there = There::Missing;
        for name in names {
            match self.content(name)? {
                None if removes => fs::remove_file(self.folder.join(name))?,
                None => {}
                Some(Some(notes)) if notes.plan == self.plan && notes.rows == *rows => {
                    if there != There::Missing {
                        return Ok(There::Foreign(name.clone()));
                    }
                    there = There::Whole(name.clone(), notes.counts);
                }
                Some(_) => return Ok(There::Foreign(name.clone())),
            }
        }
        Ok(there)
    }

    /// What a file says of itself, if its content is what its name says; nothing if it is no part of any sweep.
    fn content(&self, name: &str) -> io::Result<Option<Option<Notes>>> {
        let mut file = File::open(self.folder.join(name))?;
        let length = file.metadata()?.len();
        let hash = hash_of_pieces(&mut file, &[(0, length)])?;
        let is_as_written = name.ends_with(&format!("-{}.parquet", &hash[..SHOWN]));
        Ok(is_as_written.then(|| Notes::of(&file)))
    }

    /// The name of a part.
    pub(super) fn name(part: usize, bytes: &[u8]) -> String {
        format!("part-{part:08}-{}.parquet", &hash_of(bytes)[..SHOWN])
    }

    /// Makes a file appear, whole and on the disk. If that fails nothing of it remains.
    pub(super) fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(UNFINISHED);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The usual permissions of a new file; the process's mask restricts them.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let mut unfinished = builder.tempfile_in(&self.folder)?;
        unfinished.write_all(bytes)?;
        unfinished.as_file().sync_all()?;
        unfinished.persist(self.folder.join(name)).map_err(|error| error.error)?;
        // The name, too. Some file systems have no such thing for folders.
        let _ = File::open(&self.folder).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

/// The part whose file has this name.
fn part_of(name: &str) -> Option<usize> {
    let (part, hash) = name.strip_prefix("part-")?.strip_suffix(".parquet")?.split_once('-')?;
    let is_digit = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
    (hash.len() == SHOWN && is_digit(part)).then(|| part.parse().ok())?
}
