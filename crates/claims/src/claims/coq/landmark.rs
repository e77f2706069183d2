//! The file of a landmark: its one solution, and what follows for the values that the paper prints.

use super::printed;
use super::root::CoqRoot;
use super::solution::CoqSolution;
use super::template::fill;
use crate::certify::{CertifiedLandmark, Undecided};
use crate::judge::Audited;
use crate::problem::{Equation, Landmark};

/// The whole file.
pub(super) fn file(point: &CertifiedLandmark, audited: &[Audited]) -> Result<String, Undecided> {
    let mut solution = CoqSolution::new(&CoqRoot::of_landmark(point)?, &[])?;
    solution.values.push(("title", title(point.landmark())));
    let mut out = fill(include_str!("templates/landmark.v"), &solution.values);
    out.push_str(&solution.text());
    if point.isolated().system().equations.contains(&Equation::DoubleThickness) {
        out.push_str(&fill(include_str!("templates/radicand.v"), &solution.values));
    }
    out.push_str(&printed::corollaries(point, audited, &solution.symbols));
    Ok(out)
}

/// A landmark as a title.
pub(super) fn title(landmark: Landmark) -> String {
    format!("The point {landmark}: {}", landmark.name())
}
