//! Coq theorems about the landmarks and about certified states, printed from the equations of [`crate::arch`].
//!
//! | file | what it does |
//! |---|---|
//! | `term` | a number type that prints |
//! | `root`, `table` | one root of a system, and the numbers that prove it |
//! | `solution` | one solution of a system: what is claimed, the table, its check |
//! | `landmark` | the file of a landmark |
//! | `state`, `given`, `sign` | the file of a state: what is given, what its signs are, what follows |
//! | `asymmetric` | the file of an asymmetric solution of (19) |
//! | `printed` | what follows for the values that the paper prints |
//! | `half_opening`, `joint` | the files with one unknown and a very wide bracket |
//! | `weights` | the two self-weights compared |
//! | `numeral` | rationals as Coq reads them |
//! | `template`, `templates/` | the text around them |
//!
//! The mathematics is in the hand-written files of `proofs/coq`; what is printed here are statements,
//! numbers, and calls. **Only the statements matter**: they are in terms of the printed equations of
//! `Arch.v`, and Coq checks everything else.

mod asymmetric;
mod given;
mod half_opening;
mod joint;
mod landmark;
mod numeral;
mod printed;
mod root;
mod sign;
mod solution;
mod state;
mod table;
mod template;
mod term;
mod weights;

pub use state::{StateError, state};
pub use term::Term;

use crate::arch::{SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::judge::audit;
use crate::number::Ball;
use crate::problem::{Fixed, Landmark, System};
use numeral::{exact, nearest, text, unit};

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

/// The name of the Coq module of a landmark.
fn module(landmark: Landmark, weight: SelfWeight) -> String {
    format!("{landmark:?}{weight:?}")
}

/// The point of a landmark.
fn find(
    points: &[CertifiedLandmark],
    landmark: Landmark,
    weight: SelfWeight,
) -> Result<&CertifiedLandmark, Undecided> {
    points
        .iter()
        .find(|point| (point.landmark(), point.weight()) == (landmark, weight))
        .ok_or_else(|| Undecided::new(format!("{} is missing", landmark.symbol())))
}

/// Bits of an enclosure from which digits are printed.
const BITS: u32 = 512;

/// The digits of a number and the bracket that proves them.
fn bracket(value: &Ball) -> Vec<(&'static str, String)> {
    let centre = nearest(&exact(value.mid()), table::DECIMALS + 2);
    let radius = unit(table::DECIMALS);
    let (lo, hi) = (centre.clone() - &radius, centre.clone() + &radius);
    let named = [("centre", centre), ("radius", radius), ("lo", lo), ("hi", hi)];
    named.map(|(name, value)| (name, text(&value))).to_vec()
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
        Unknown::CrownHinge => "b0",
        Unknown::CrownMoment => "p",
        Unknown::VerticalForce => "v",
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
