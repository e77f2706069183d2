//! Notes, on standard error, of a question that is answered as it is asked but may have been meant otherwise.

use crate::ask;
use crate::cli::line::say;
use crate::problem::Friction;
use std::collections::HashSet;
use std::fmt::Display;
use std::hash::Hash;

/// Coefficients that may have been meant as angles.
pub(super) fn frictions<'a>(all: impl IntoIterator<Item = &'a Friction>) {
    tell(ask::notes(all));
}

/// Tells what is worth a note, a line each.
pub(super) fn tell(notes: impl IntoIterator<Item = impl Display>) {
    notes.into_iter().for_each(|note| say(&format!("couplet: {note}")));
}

/// The values, each once; of one that is given twice that is told.
pub(super) fn each_once<T, K: Eq + Hash>(
    given: impl IntoIterator<Item = T>,
    key: impl Fn(&T) -> K,
    shown: impl Fn(&T) -> String,
) -> Vec<T> {
    let mut seen = HashSet::new();
    let is_first = |one: &T| {
        let is_first = seen.insert(key(one));
        if !is_first {
            say(&format!("couplet: {} is given twice and counts once", shown(one)));
        }
        is_first
    };
    given.into_iter().filter(is_first).collect()
}
