//! The record of a run, `couplet.run/1`: what was asked of each output, and what was written.
//!
//! An output is complete if request, program version and file content are unchanged. Hashes decide: times
//! and names prove nothing. They protect against accidents, not against somebody who edits the record too.
//!
//! A run replaces only files that the record names; so each is named before it is written.

use super::hash::{Hashing, hash_of};
use super::schema::SceneItem;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::Path;

/// The name of the record in the folder of outputs.
pub const NAME: &str = "couplet-run.json";
const SCHEMA: &str = "couplet.run/1";

/// The outputs that were completed, by their paths in the folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    schema: String,
    outputs: BTreeMap<String, ManifestEntry>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct ManifestEntry {
    /// SHA-256 of the version of the program and the description of the item; none if it is not complete.
    asked: Option<String>,
    /// SHA-256 of the file; empty if it is not known.
    content: String,
}

/// The most bytes of a record; that of the most items that a scene can have is far smaller.
pub(super) const MAX_RECORD: u64 = 16 << 20;

/// The bytes of a record, of a run or of a sweep; an error of the kind `InvalidData` if they are more than one can
/// have.
pub(crate) fn record_bytes(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // One more than is allowed, so that more is seen.
    File::open(path)?.take(MAX_RECORD + 1).read_to_end(&mut bytes)?;
    match bytes.len() as u64 {
        0..=MAX_RECORD => Ok(bytes),
        _ => Err(io::ErrorKind::InvalidData.into()),
    }
}

impl Default for Manifest {
    fn default() -> Self {
        Self { schema: SCHEMA.to_owned(), outputs: BTreeMap::new() }
    }
}

impl Manifest {
    /// The record in a folder; an empty one if there is none. An error of the kind `InvalidData` where a file of
    /// that name is no record of this version, or larger than one can be.
    pub fn of(folder: &Path) -> io::Result<Self> {
        let path = folder.join(NAME);
        // What a link leads to is not this folder's, and a pipe would be waited for.
        match fs::symlink_metadata(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::default()),
            Err(error) => return Err(error),
            Ok(there) if !there.is_file() => {
                return Err(io::Error::other("it is a link, a folder, a pipe or a device"));
            }
            Ok(_) => {}
        }
        let record: Option<Self> = serde_json::from_slice(&record_bytes(&path)?).ok();
        record
            .filter(|manifest| manifest.schema == SCHEMA)
            .ok_or_else(|| io::ErrorKind::InvalidData.into())
    }

    /// Tells whether an output is one that a run wrote, or was about to write.
    pub fn names(&self, output: &Path) -> bool {
        self.outputs.contains_key(&key(output))
    }

    /// Tells whether the output of an item is there and is what would be written again.
    pub fn is_complete(&self, folder: &Path, item: &SceneItem) -> bool {
        let Some(output) = &item.output else { return false };
        let entry = self.outputs.get(&key(output));
        entry.is_some_and(|entry| {
            entry.asked.as_ref() == Some(&asked(item))
                && content_of(&folder.join(output)).is_ok_and(|content| content == entry.content)
        })
    }

    /// Notes that an output is about to be written, or was written and is not complete.
    pub fn begin(&mut self, output: &Path) {
        self.outputs.insert(key(output), ManifestEntry { asked: None, content: String::new() });
    }

    /// Notes that an output was written, with all that was asked.
    pub fn note(&mut self, item: &SceneItem, content: String) {
        if let Some(output) = &item.output {
            self.outputs.insert(key(output), ManifestEntry { asked: Some(asked(item)), content });
        }
    }

    /// Writes the record.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut *out, self)?;
        writeln!(out)
    }
}

fn key(output: &Path) -> String {
    output.to_string_lossy().into_owned()
}

fn asked(item: &SceneItem) -> String {
    let text = format!("couplet {}\n{}", env!("CARGO_PKG_VERSION"), item.description());
    hash_of(text.as_bytes())
}

/// SHA-256 of a file.
pub(crate) fn content_of(path: &Path) -> io::Result<String> {
    if !path.is_file() {
        return Err(io::ErrorKind::InvalidInput.into());
    }
    let mut hashing = Hashing::new(io::sink());
    io::copy(&mut File::open(path)?, &mut hashing)?;
    Ok(hashing.hash())
}
