//! The folder that a run writes into: nothing outside it, and nothing in it that is not the run's.

use super::output::{Output, is_same_file, is_standard};
use crate::sweep::failure::Failure;
use crate::sweep::scene::{MANIFEST, Manifest, SceneItem};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The folder of the outputs, with the record of what runs wrote there.
pub(super) struct RunFolder {
    /// Folder as it was given; nothing before a file's name is the current folder.
    given: PathBuf,
    overwrites: bool,
    manifest: Manifest,
    /// The record as it was when this run last looked, if it was one: only another run changes it meanwhile.
    seen: Option<Manifest>,
}

impl RunFolder {
    /// The folder, with its record. `overwrites` allows to replace files that the record does not name.
    pub(super) fn open(given: Option<&Path>, overwrites: bool) -> Result<Self, Failure> {
        if given.is_some_and(is_standard) {
            return Err(
                "a run writes into a folder, not to standard output; ./- is a folder".into()
            );
        }
        let given = given.unwrap_or(Path::new("")).to_owned();
        let record = given.join(MANIFEST);
        let mut seen = None;
        let manifest = match Manifest::of(&given) {
            Ok(manifest) => seen.insert(manifest).clone(),
            Err(error) if error.kind() != io::ErrorKind::InvalidData => {
                return Err(Failure::reading(record.display(), &error));
            }
            Err(_) if overwrites => Manifest::default(),
            Err(_) => {
                let record = record.display();
                return Err(format!(
                    "{record} is not the record of a run; --overwrite replaces it"
                )
                .into());
            }
        };
        Ok(Self { given, overwrites, manifest, seen })
    }

    /// The path of an output, to be shown.
    pub(super) fn shown(&self, output: &Path) -> PathBuf {
        self.given.join(output)
    }

    /// Tells whether the output of an item is there and is what would be written again.
    pub(super) fn is_complete(&self, item: &SceneItem) -> bool {
        self.manifest.is_complete(&self.given, item)
    }

    /// Makes the folders of some outputs, and sees whether each can be written, before any work. `scene` is not to
    /// be replaced.
    pub(super) fn prepare(&self, outputs: &[&Path], scene: &Path) -> Result<(), Failure> {
        let shown = outputs.iter().map(|output| self.shown(output));
        if let Some(output) = shown.into_iter().find(|output| is_same_file(output, scene)) {
            let output = output.display();
            return Err(format!("refusing to overwrite the scene {output}").into());
        }
        for output in outputs {
            let path = self.destination(output)?;
            // Open a pipe only when there is something to write.
            if !path.exists() || path.is_file() || path.is_dir() {
                Output::open(Some(&path))?;
            }
        }
        match outputs.is_empty() {
            true => Ok(()),
            false => Output::open(Some(&self.record()?)).map(drop),
        }
    }

    /// Opens an output, which the record names from now on.
    pub(super) fn begin(&mut self, output: &Path) -> Result<Output, Failure> {
        let path = self.destination(output)?;
        self.manifest.begin(output);
        self.write_record()?;
        Output::open(Some(&path))
    }

    /// Notes that all that was asked of an item was written.
    pub(super) fn note(&mut self, item: &SceneItem, hash: String) -> Result<(), Failure> {
        self.manifest.note(item, hash);
        self.write_record()
    }

    fn write_record(&mut self) -> Result<(), Failure> {
        self.is_mine()?;
        Output::open(Some(&self.record()?))?.write(|out| self.manifest.write(out))?;
        self.seen = Some(self.manifest.clone());
        Ok(())
    }

    /// Tells whether no other run writes into the folder.
    fn is_mine(&self) -> Result<(), Failure> {
        if Manifest::of(&self.given).ok() == self.seen {
            return Ok(());
        }
        let record = self.given.join(MANIFEST);
        Err(Failure::Io(format!(
            "another run is at work: it has changed {} meanwhile; wait for it, or give another folder",
            record.display()
        )))
    }

    fn record(&self) -> Result<PathBuf, Failure> {
        Ok(self.resolved()?.join(MANIFEST))
    }

    /// The folder without links.
    fn resolved(&self) -> Result<PathBuf, Failure> {
        let given = if self.given.as_os_str().is_empty() { Path::new(".") } else { &self.given };
        let resolved = fs::create_dir_all(given).and_then(|()| fs::canonicalize(given));
        resolved.map_err(|error| Failure::writing(given.display(), &error))
    }

    /// Path to which an output is written: inside the folder whatever links there are, in a folder that is
    /// made, and not in place of a file that no run wrote.
    fn destination(&self, output: &Path) -> Result<PathBuf, Failure> {
        let shown = self.shown(output);
        let failed = |error: io::Error| Failure::writing(shown.display(), &error);
        let outside = || failed(io::Error::other("it leads outside the folder of outputs"));
        let root = self.resolved()?;
        let inside = |path: &Path| if path.starts_with(&root) { Ok(()) } else { Err(outside()) };
        let path = root.join(output);
        let parent = path.parent().unwrap_or(&root);
        // What is there decides where folders would be made.
        if let Some(there) = parent.ancestors().find_map(|part| fs::canonicalize(part).ok()) {
            inside(&there)?;
        }
        fs::create_dir_all(parent).map_err(failed)?;
        inside(&fs::canonicalize(parent).map_err(failed)?)?;
        if path.is_symlink() && path.exists() {
            inside(&fs::canonicalize(&path).map_err(failed)?)?;
        }
        if path.is_file() && !self.overwrites && !self.manifest.names(output) {
            self.is_mine()?;
            let shown = shown.display();
            return Err(
                format!("{shown} is there, and no run wrote it; --overwrite replaces it").into()
            );
        }
        Ok(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_told_of_another_at_the_same_folder() {
        let folder = tempfile::tempdir().unwrap();
        let open = || RunFolder::open(Some(folder.path()), false).unwrap();
        let (mut one, mut other, mut third) = (open(), open(), open());
        let write = |folder: &mut RunFolder| {
            folder.begin(Path::new("a.csv"))?.write(|out| out.write_all(b"x"))
        };
        assert!(write(&mut one).is_ok());
        for contested in [write(&mut other), third.begin(Path::new("b.csv")).map(drop)] {
            let Err(Failure::Io(message)) = contested else { panic!() };
            assert!(message.starts_with("another run is at work: "), "{message}");
        }
        assert!(write(&mut one).is_ok() && write(&mut open()).is_ok());
        fs::remove_file(folder.path().join(MANIFEST)).unwrap();
        let Err(Failure::Input(message)) = write(&mut open()) else { panic!() };
        assert!(message.ends_with("no run wrote it; --overwrite replaces it"), "{message}");
    }
}
