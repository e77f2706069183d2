//! Coq theorems about the landmarks, printed from the equations of [`crate::arch`], and about certificates.
//!
//! | file | what it does |
//! |---|---|
//! | `term` | a number type that prints |
//! | `root`, `table` | one root of a system, and the numbers that prove it |
//! | `solution` | one solution of a system: what is claimed, the table, its check |
//! | `landmark` | the file of a landmark |
//! | `stands`, `sign` | what makes a landmark a state: its signs, and what follows |
//! | `certificate` | the file of a certificate: its numbers, which Coq checks by computing |
//! | `last_digit` | what follows from a landmark's certificate for the values that the paper prints |
//! | `printed` | what follows for the values that the paper prints |
//! | `half_opening`, `joint` | the files with one unknown and a very wide bracket |
//! | `weights` | the two self-weights compared |
//! | `names` | what Coq calls things |
//! | `numeral` | rationals as Coq reads them |
//! | `template`, `templates/` | the text around them |
//!
//! The mathematics is in the hand-written files of `proofs/coq`; what is printed here are statements,
//! numbers, and calls. **Only the statements matter**: they are in terms of the printed equations of
//! `Arch.v`, and Coq checks everything else.

mod certificate;
mod half_opening;
mod joint;
mod landmark;
mod last_digit;
mod names;
mod numeral;
mod printed;
mod root;
mod sign;
mod solution;
mod stands;
mod table;
mod template;
mod term;
mod weights;

pub use certificate::{CertificateError, certificate};
pub use term::Term;

use crate::arch::SelfWeight;
use crate::certify::{CertifiedLandmark, Undecided};
use crate::judge::audit;
use crate::problem::Landmark;
use names::module;

/// The files of all theorems, name and content, in alphabetical order.
pub fn files() -> Result<Vec<(String, String)>, Undecided> {
    let audited = audit()?;
    let mut files = Vec::new();
    let mut points = Vec::new();
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            let point = CertifiedLandmark::new(landmark, weight)?;
            files.push((file_name(&point), landmark::file(&point, &audited)?));
            points.push(point);
        }
    }
    files.push(("HalfOpenings.v".into(), half_opening::file(&points)?));
    files.push(("WidestJoints.v".into(), joint::file(&points)?));
    files.push(("Weights.v".into(), weights::file()?));
    files.sort();
    Ok(files)
}

fn file_name(point: &CertifiedLandmark) -> String {
    format!("{}.v", module(point.landmark(), point.weight()))
}
