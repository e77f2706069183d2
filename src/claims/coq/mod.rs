//! Coq theorems about the landmarks, printed from the equations of [`crate::arch`].
//!
//! | file | what it does |
//! |---|---|
//! | `term` | a number type that prints |
//! | `table` | the numbers that prove one root of a system |
//! | `landmark` | the file of a landmark: what is claimed, the table, its check |
//! | `printed` | what follows for the values that the paper prints |
//! | `half_opening`, `joint` | the files with one unknown and a very wide bracket |
//! | `numeral` | rationals as Coq reads them |
//!
//! The mathematics is in the hand-written files of `proofs/coq`; what is printed here are statements,
//! numbers, and calls. **Only the statements matter**: they are in terms of the printed equations of
//! `Arch.v`, and Coq checks everything else.

mod half_opening;
mod joint;
mod landmark;
mod numeral;
mod printed;
mod table;
mod term;

pub use term::Term;

use crate::arch::{Fixed, Landmark, SelfWeight, System, Unknown};
use crate::certify::{CertifiedLandmark, Undecided, audit};

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
    files.sort();
    Ok(files)
}

fn file_name(point: &CertifiedLandmark) -> String {
    format!("{}.v", module(point.landmark(), point.weight()))
}

/// The name of the Coq module of a landmark.
fn module(landmark: Landmark, weight: SelfWeight) -> String {
    format!("{landmark:?}{weight:?}")
}

/// What stands at the head of every file.
fn head(title: &str, text: &str) -> String {
    format!(
        "(** * {title}\n\n{text}\n\n    Written by `couplet prove --coq` from the equations of the program. *)\n\n\
         From Couplet Require Import Instance.\nOpen Scope R_scope.\n"
    )
}

/// How a self-weight is spoken of.
fn weight_name(weight: SelfWeight) -> &'static str {
    match weight {
        SelfWeight::Heyman => "Heyman's self-weight",
        SelfWeight::Milankovitch => "Milankovitch's self-weight",
    }
}

/// The name of a variable in Coq.
fn symbol(unknown: Unknown) -> &'static str {
    match unknown {
        Unknown::HalfOpening => "alpha",
        Unknown::RotationJoint => "beta_r",
        Unknown::SlidingJoint => "beta_s",
        Unknown::Thickness => "eta",
        Unknown::Thrust => "h",
        Unknown::Friction => "mu",
    }
}

/// The names of the unknowns of a system, in its order.
struct Symbols(Vec<&'static str>);

impl Symbols {
    fn of(system: &System) -> Self {
        Self(system.unknowns.iter().map(|&unknown| symbol(unknown)).collect())
    }

    fn iter(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.0.iter().copied()
    }

    fn get(&self, index: usize) -> &'static str {
        self.0[index]
    }

    fn index(&self, name: &str) -> Option<(usize, &'static str)> {
        self.0.iter().position(|symbol| *symbol == name).map(|k| (k, self.0[k]))
    }

    /// The names as arguments.
    fn arguments(&self) -> String {
        self.0.join(" ")
    }
}

/// A variable of a system as an argument in Coq: its name, or the value it is fixed to.
fn argument(system: &System, unknown: Unknown) -> String {
    match system.fixed_value(unknown) {
        Some(Fixed::Integer(n)) => n.to_string(),
        Some(Fixed::SameAs(other)) => symbol(other).into(),
        Some(Fixed::Infinite) | None => symbol(unknown).into(),
    }
}
