//! Files and folders that are being written: hidden until they are whole, and gone if they never are.
//!
//! Everything that is unfinished in this process is known here, for whoever ends the process: there is no other way to
//! begin a file that is to appear whole.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Beginning of the name of what is unfinished.
pub const HIDDEN: &str = ".couplet-";

/// The paths of all that is unfinished. Who makes something, lets it appear or removes it holds this meanwhile.
static ALL: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
/// Work to be done before anything is begun.
static GUARD: Mutex<Option<fn()>> = Mutex::new(None);

/// A hidden file or folder; it is removed if it is dropped.
#[derive(Debug)]
pub struct Unfinished(PathBuf);

impl Unfinished {
    /// A file in a folder. `name` stands behind the beginning of its name.
    pub fn file(folder: &Path, name: &str) -> io::Result<(Self, File)> {
        // The usual permissions of a new file; the process's mask restricts them.
        Self::begin(name, 0o666, |builder| builder.tempfile_in(folder)?.keep().map_err(Into::into))
    }

    /// A folder in a folder.
    pub fn folder(folder: &Path) -> io::Result<Self> {
        let make = |builder: &tempfile::Builder| Ok(((), builder.tempdir_in(folder)?.keep()));
        Self::begin("", 0o777, make).map(|(folder, ())| folder)
    }

    #[cfg_attr(not(unix), allow(unused_variables, reason = "permissions are those of Unix"))]
    fn begin<T>(
        name: &str,
        mode: u32,
        make: impl FnOnce(&tempfile::Builder) -> io::Result<(T, PathBuf)>,
    ) -> io::Result<(Self, T)> {
        if let Some(guard) = held(&GUARD).take() {
            guard();
        }
        let (mut builder, name) = (tempfile::Builder::new(), [HIDDEN, name].concat());
        builder.prefix(&name);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            builder.permissions(fs::Permissions::from_mode(mode));
        }
        let mut all = held(&ALL);
        let (made, path) = make(&builder)?;
        all.insert(path.clone());
        Ok((Self(path), made))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Makes it appear under a path, in place of a file that is there.
    pub fn appear(self, path: &Path) -> io::Result<()> {
        let mut all = held(&ALL);
        fs::rename(&self.0, path)?;
        all.remove(&self.0);
        Ok(())
    }

    /// Makes what is in this folder appear in another one, the name `last` behind all others.
    pub fn appear_in(self, folder: &Path, last: &str) -> io::Result<()> {
        let _all = held(&ALL);
        let names = fs::read_dir(&self.0)?.map(|entry| Ok(entry?.file_name()));
        let mut names = names.collect::<io::Result<Vec<_>>>()?;
        names.sort_by_key(|name| name == last);
        names.iter().try_for_each(|name| fs::rename(self.0.join(name), folder.join(name)))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        let mut all = held(&ALL);
        if all.remove(&self.0) {
            remove(&self.0);
        }
    }
}

/// Has something done before anything is begun, once.
pub fn guard(guard: fn()) {
    *held(&GUARD) = Some(guard);
}

/// Removes all that is unfinished. The process is about to end: nothing is begun any more, and nothing appears.
pub fn remove_all() {
    let all = held(&ALL);
    all.iter().for_each(|path| remove(path));
    std::mem::forget(all);
}

/// Nothing more can be done about what resists.
fn remove(path: &Path) {
    let _ = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
}

fn held<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread;
    use std::time::Duration;

    fn count(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn nothing_is_made_that_who_ends_the_process_would_not_know() {
        let folder = tempfile::tempdir().unwrap();
        thread::scope(|scope| {
            // As who ends the process holds it.
            let ends = held(&ALL);
            let begun = scope.spawn(|| Unfinished::file(folder.path(), "x-").unwrap());
            thread::sleep(Duration::from_millis(20));
            assert_eq!(count(folder.path()), 0);
            drop(ends);
            let (unfinished, _) = begun.join().unwrap();
            assert_eq!(unfinished.path().parent(), Some(folder.path()));
            assert!(held(&ALL).contains(unfinished.path()) && count(folder.path()) == 1);
        });
        assert_eq!(count(folder.path()), 0);
    }

    #[test]
    fn a_folder_appears_whole_or_goes_with_all_that_is_in_it() {
        let home = tempfile::tempdir().unwrap();
        let begin = || {
            let folder = Unfinished::folder(home.path()).unwrap();
            fs::write(folder.path().join("a"), "a").unwrap();
            folder
        };
        drop(begin());
        assert_eq!(count(home.path()), 0);
        begin().appear(&home.path().join("one")).unwrap();
        begin().appear_in(&home.path().join("one"), "a").unwrap();
        assert_eq!((count(home.path()), count(&home.path().join("one"))), (1, 1));
        assert!(begin().appear_in(&home.path().join("none"), "a").is_err());
        assert_eq!(count(home.path()), 1);
    }
}
