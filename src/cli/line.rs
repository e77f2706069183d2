//! The command line of this run: what a picture or a record says of how it was made.

use std::ffi::OsString;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// The arguments of the last command that began in this process.
static WORDS: Mutex<Vec<OsString>> = Mutex::new(Vec::new());

/// Keeps the arguments of a command that begins.
pub(super) fn keep(arguments: &[OsString]) {
    *WORDS.lock().unwrap_or_else(PoisonError::into_inner) = arguments.to_vec();
}

/// The command as it was typed, but for the folder of the file that it writes, which is of one machine.
pub(super) fn typed() -> String {
    let words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
    let mut before = None;
    let mut word = |word: &OsString| {
        let is_file = matches!(before.replace(word.clone()), Some(name) if name == "-o" || name == "--output");
        let name = Path::new(word).file_name().filter(|_| is_file);
        name.unwrap_or(word).to_string_lossy().into_owned()
    };
    format!("couplet {}", words.iter().map(&mut word).collect::<Vec<_>>().join(" "))
}
