//! The house whose tests these are: its files, and what is made of it.

use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};

/// The path of a file or a folder.
pub(crate) fn house(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

pub(crate) fn read(path: &str) -> String {
    fs::read_to_string(house(path)).unwrap()
}

/// The files of a folder with this end.
pub(crate) fn files(folder: &str, end: &str) -> Vec<PathBuf> {
    let files = fs::read_dir(house(folder)).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|of| of == end)).collect()
}

/// The certificates that are stored in these folders of `proofs`.
pub(crate) fn certificates<const N: usize>(folders: [&str; N]) -> Vec<PathBuf> {
    folders.map(|folder| files(&format!("proofs/{folder}"), "json")).concat()
}

/// A file is what is made anew; `UPDATE_SNAPSHOTS=1` writes it.
#[track_caller]
pub(crate) fn is_made(path: &str, made: &str) {
    match std::env::var_os("UPDATE_SNAPSHOTS") {
        Some(_) => fs::write(house(path), made).unwrap(),
        None => assert_eq!(read(path), made, "make snapshots makes it anew"),
    }
}

pub(crate) fn hash(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
