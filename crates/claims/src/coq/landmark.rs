//! The file of a landmark: its one solution, the state of its arch, and what follows for the values that the paper
//! prints.

use super::printed;
use super::root::CoqRoot;
use super::solution::{CoqSolution, Holes};
use super::stands::{admissibility, conjunction, signs, ties};
use crate::arch::Unknown;
use crate::certify::{CertifiedLandmark, Undecided};
use crate::judge::Audited;
use crate::problem::{Equation, Fixed, Landmark, Mode, System};

/// The whole file.
pub(super) fn file(point: &CertifiedLandmark, audited: &[Audited]) -> Result<String, Undecided> {
    let mut solution = CoqSolution::new(&CoqRoot::of_landmark(point)?)?;
    solution.values.push(("title", title(point.landmark())));
    solution.values.extend(state(point, &solution));
    let mut theorems = Vec::new();
    if point.isolated().system().equations.contains(&Equation::DoubleThickness) {
        theorems.push(include_str!("templates/radicand.v"));
    }
    theorems.push(include_str!("templates/signs.v"));
    if !landmark_ties(point).is_empty() {
        theorems.push(include_str!("templates/ties.v"));
    }
    theorems.push(include_str!("templates/stands.v"));
    theorems.push(include_str!("templates/least_at_landmark.v"));
    if point.landmark().is_limited() {
        theorems.push(include_str!("templates/less_friction.v"));
    }
    let file = solution.between(include_str!("templates/landmark.v"), &theorems);
    Ok(file + &printed::corollaries(point, audited, &solution.symbols))
}

/// Claims on the arch of the landmark: all signs that its modes ask for, and the theorem of one of them.
fn state(point: &CertifiedLandmark, solution: &CoqSolution) -> Holes {
    let (landmark, system) = (point.landmark(), point.isolated().system());
    let signs = signs(landmark.conditions(point.weight()), system);
    let ties = landmark_ties(point);
    let args = solution.symbols.join(" ");
    let tied = match ties.is_empty() {
        true => String::new(),
        false => format!("\n  pose proof (ties {args} W E) as Z."),
    };
    let mut values = vec![
        ("signs", conjunction(&signs)),
        ("looked_at", "what the theorem of each of its modes asks for, and is not zero".into()),
        ("ties", conjunction(&ties)),
        ("tied", tied),
        ("less_friction", "less_friction".into()),
    ];
    values.extend(admissibility(mode(landmark, system), landmark.is_limited(), system));
    values
}

fn landmark_ties(point: &CertifiedLandmark) -> Vec<String> {
    ties(point.landmark().ties(point.weight()), point.isolated().system())
}

/// The first mode of the landmark whose own equations are among those of the landmark: with a rotational joint at
/// the crown it is the one without a haunch, as (5) divides by its sine.
fn mode(landmark: Landmark, system: &System) -> Mode {
    let is_at_crown = system.fixed_value(Unknown::RotationJoint) == Some(Fixed::Integer(0));
    let modes = landmark.modes();
    modes.iter().copied().find(|mode| mode.has_haunch() != is_at_crown).unwrap_or(modes[0])
}

/// A landmark as a title.
pub(super) fn title(landmark: Landmark) -> String {
    format!("The point {landmark}: {}", landmark.name())
}
