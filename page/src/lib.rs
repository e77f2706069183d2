//! What the page runs in the browser, over linear memory: a text goes in, a text comes out.
//!
//! The script writes a text where [`input`] says, calls [`check`] or [`prove`], and reads the answer, JSON, where
//! [`output`] says. A start is not looked for here: the script of the map has it, in doubles, and is not believed.

mod candidate;
mod drawing;
mod given;
mod prove;
mod question;
mod rounding;

use couplet_check::check::{Refusal, verify_file};
use serde::Serialize;
use std::cell::RefCell;

pub use prove::{Answer, Proved, proof};
pub use question::Question;

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUTPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// A verdict on the bytes of a file, in the words of `couplet check`.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub struct Checked {
    /// Whether the certificate is accepted.
    pub accepted: bool,
    /// `accepted`, `refused` or `not checked`, and what or why.
    pub sentence: String,
}

/// Checks the bytes of a file.
pub fn checked(bytes: &[u8]) -> Checked {
    let (accepted, sentence) = match verify_file(bytes) {
        Ok(found) => (true, format!("accepted  {}", found.summary())),
        Err(limit @ Refusal::Limit(..)) => (false, format!("not checked: {limit}")),
        Err(refusal) => (false, format!("refused: {refusal}")),
    };
    Checked { accepted, sentence }
}

/// Makes room for a text of so many bytes, and says where.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|bytes| {
        bytes.clear();
        bytes.resize(length, 0);
        bytes.as_mut_ptr()
    })
}

/// Where the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn output() -> *const u8 {
    OUTPUT.with_borrow(|bytes| bytes.as_ptr())
}

/// Checks the certificate that was written, and says how long the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn check() -> usize {
    answered(checked)
}

/// Proves what was asked, a [`Question`], and says how long the answer is, an [`Answer`].
#[unsafe(no_mangle)]
pub extern "C" fn prove() -> usize {
    answered(|bytes| match serde_json::from_slice::<Question>(bytes) {
        Ok(question) => Answer::of(&question),
        Err(error) => Answer::Open { reason: error.to_string(), command: None },
    })
}

fn answered<T: Serialize>(answer: impl Fn(&[u8]) -> T) -> usize {
    let answer = INPUT.with_borrow(|bytes| answer(bytes));
    let text = serde_json::to_vec(&answer).unwrap_or_default();
    let length = text.len();
    OUTPUT.replace(text);
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_gets_the_sentence_of_the_command() {
        let file = include_str!("../../proofs/constants/triple-point-heyman.json");
        let good = checked(file.as_bytes());
        assert!(
            good.accepted && good.sentence.starts_with("accepted  T heyman  thickness 0.6"),
            "{good:?}"
        );
        let bad = checked(file.replace("heyman", "milankovitch").as_bytes());
        assert!(!bad.accepted && bad.sentence.starts_with("refused: "), "{bad:?}");
        assert_eq!(checked(b"\xff").sentence, "refused: the file is not UTF-8 from byte 0 on");
    }
}
