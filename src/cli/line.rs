//! The command line of this run: what a picture or a record says of how it was made.

use std::ffi::OsString;
use std::sync::{Mutex, PoisonError};

/// The arguments of the last command that began in this process.
static WORDS: Mutex<Vec<OsString>> = Mutex::new(Vec::new());

/// Keeps the arguments of a command that begins.
pub(super) fn keep(arguments: &[OsString]) {
    *WORDS.lock().unwrap_or_else(PoisonError::into_inner) = arguments.to_vec();
}

/// The command as it was typed.
pub(super) fn typed() -> String {
    let words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
    let words: Vec<_> = words.iter().map(|word| word.to_string_lossy()).collect();
    format!("couplet {}", words.join(" "))
}
