//! A file of a sweep that is being written: hidden beside the folder, and never old while somebody writes it.

use crate::scene::Hashing;
use crate::unfinished::{HIDDEN, Unfinished};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Time after which a file that did not change is nobody's any more.
const ABANDONED: Duration = Duration::from_secs(3600);
/// Time after which a file is made young again; tests do not wait so long.
const REFRESHED: Duration = Duration::from_millis(if cfg!(test) { 10 } else { 60_000 });

/// File that appears whole, under another name, which its size and its hash may tell; if that fails nothing of it
/// remains.
pub(super) struct NewFile {
    file: Hashing<File>,
    bytes: u64,
    unfinished: Unfinished,
}

impl NewFile {
    /// Begins a file in a folder, of a sweep of this name.
    pub(super) fn begin(folder: &Path, sweep: &str) -> io::Result<Self> {
        let (unfinished, file) = Unfinished::file(folder, &format!("{sweep}-"))?;
        Ok(Self { file: Hashing::new(file), bytes: 0, unfinished })
    }

    /// Result of some work, before it is written. However long that takes, no other run takes the file for abandoned.
    pub(super) fn kept_during<T>(&self, work: impl FnOnce() -> T) -> T {
        let (is_done, done) = channel::<()>();
        thread::scope(|scope| {
            let refresh = move || {
                while done.recv_timeout(REFRESHED) == Err(RecvTimeoutError::Timeout) {
                    self.refresh();
                }
            };
            // Where no thread can be started the file grows old, and that is all.
            let _ = thread::Builder::new().spawn_scoped(scope, refresh);
            let made = work();
            drop(is_done);
            made
        })
    }

    /// Makes the file young, by the clock of the file system, which other machines see too.
    fn refresh(&self) {
        let _ = self.file.inner.set_len(self.bytes);
    }

    /// Writes some bytes behind the others.
    pub(super) fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.bytes += bytes.len() as u64;
        self.file.write_all(bytes)
    }

    /// Makes the file appear.
    pub(super) fn appear(self, path: impl FnOnce(u64, &str) -> PathBuf) -> io::Result<()> {
        self.file.inner.sync_all()?;
        if !self.unfinished.path().exists() {
            let words =
                "another run has removed what was being written: it had not changed for an hour";
            return Err(io::Error::other(words));
        }
        self.unfinished.appear(&path(self.bytes, &self.file.hash()))
    }
}

/// Removes what killed runs of a sweep have left in a folder: what did not change for long, or was changed far in the
/// future, as nobody's clock is the file system's who writes there now.
pub(super) fn clear(folder: &Path, sweep: &str) -> io::Result<()> {
    let begin = format!("{HIDDEN}{sweep}-");
    let entries = fs::read_dir(folder)?.filter_map(Result::ok);
    let is_hidden = |entry: &fs::DirEntry| entry.file_name().to_string_lossy().starts_with(&begin);
    let hidden: Vec<PathBuf> = entries.filter(is_hidden).map(|entry| entry.path()).collect();
    if hidden.is_empty() {
        return Ok(());
    }
    let now = NewFile::begin(folder, sweep)?.file.inner.metadata()?.modified()?;
    for path in hidden {
        let Ok(time) = fs::metadata(&path).and_then(|there| there.modified()) else { continue };
        let age = now.duration_since(time).unwrap_or_else(|future| future.duration());
        if age > ABANDONED {
            // Somebody else may have been quicker.
            let _ = fs::remove_file(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::SystemTime;

    const LONG: Duration = Duration::from_secs(2 * 3600);

    #[test]
    fn what_is_nobodys_goes_whatever_its_time_and_what_is_written_stays() {
        let folder = tempfile::tempdir().unwrap();
        let now = SystemTime::now();
        let aged = |name: &str, time: SystemTime| {
            let path = folder.path().join(name);
            File::create(&path).unwrap().set_modified(time).unwrap();
            path
        };
        let gone = [aged(".couplet-sweep-a-1", now - LONG), aged(".couplet-sweep-a-2", now + LONG)];
        let kept = [
            aged(".couplet-sweep-a-3", now),
            aged(".couplet-sweep-b-1", now - LONG),
            aged("sweep-a", now - LONG),
        ];
        let mut file = NewFile::begin(folder.path(), "sweep-a").unwrap();
        file.write_all(b"abc").unwrap();
        for old in [now - LONG, now + LONG] {
            file.file.inner.set_modified(old).unwrap();
            file.refresh();
            clear(folder.path(), "sweep-a").unwrap();
        }
        assert!(kept.iter().all(|path| path.exists()) && !gone.iter().any(|path| path.exists()));
        assert_eq!(fs::read(file.unfinished.path()).unwrap(), b"abc");
        // One that its writer could not keep young.
        file.file.inner.set_modified(now - LONG).unwrap();
        clear(folder.path(), "sweep-a").unwrap();
        let error = file.appear(|_, _| folder.path().join("part")).unwrap_err();
        assert!(error.to_string().starts_with("another run has removed"), "{error}");
        assert!(!folder.path().join("part").exists());
    }

    #[test]
    fn a_file_stays_young_during_work_which_ends_whatever_becomes_of_it() {
        let folder = tempfile::tempdir().unwrap();
        let file = NewFile::begin(folder.path(), "sweep-a").unwrap();
        let old = SystemTime::now() - LONG;
        let time = || file.file.inner.metadata().unwrap().modified().unwrap();
        file.file.inner.set_modified(old).unwrap();
        let is_young = || {
            thread::sleep(REFRESHED);
            time().duration_since(old).unwrap() > LONG / 2
        };
        assert!(file.kept_during(|| (0..1000).any(|_| is_young())));
        let panics = std::panic::AssertUnwindSafe(|| file.kept_during(|| panic!("as meant")));
        assert!(std::panic::catch_unwind(panics).is_err());
    }
}
