//! The file of an asymmetric solution of (19): its one root, and that it is admissible on the whole arch.

use super::names::BITS;
use super::numeral::{down, exact, text, up};
use super::root::CoqRoot;
use super::solution::CoqSolution;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::mechanism::Contact;
use crate::arch::whole::margin_along;
use crate::arch::{Ring, Unknown};
use crate::certify::{Undecided, between};
use crate::number::{Angle, Ball, Enclosure};
use crate::problem::Arch;
use rug::Rational;

/// Decimals of the ends of a neighbourhood.
const PLACES: u32 = 3;
/// Widths that it may have on either side, in thousandths.
const WIDTHS: [u32; 9] = [500, 400, 300, 200, 100, 50, 20, 10, 5];

/// The name and the content of the file, for a root of the kind with an inner joint that slides.
pub(super) fn file(root: &CoqRoot, arch: &Arch) -> Result<(String, String), Undecided> {
    let mut solution = CoqSolution::of_arch(root, arch)?;
    solution.values.push(("thickness", solution.centre(&root.system, Unknown::Thickness)));
    let at = Asymmetric::from(&root.system.place(root.given.clone(), &root.values));
    for (low, high, contact, joint) in [
        ("crown_low", "crown_high", Contact::Extrados, at.crown_hinge.rad.clone()),
        ("haunch_low", "haunch_high", Contact::Intrados, -at.haunch.rad.clone()),
        ("inner_low", "inner_high", Contact::Outwards, -at.sliding_joint.rad.clone()),
    ] {
        let [from, to] = neighbourhood(arch, &at, contact, &joint, false)?;
        solution.values.extend([(low, end(&from)), (high, end(&to))]);
    }
    let shoulder = at.half_opening.rad.clone();
    let [from, _] = neighbourhood(arch, &at, Contact::Outwards, &shoulder, true)?;
    solution.values.push(("shoulder_low", end(&from)));
    let name = format!("Asymmetric{:?}{:?}.v", AsymmetricMode::InnerSliding, arch.weight());
    let heading = include_str!("templates/asymmetric.v");
    let theorems = [include_str!("templates/asymmetric_solution.v")];
    Ok((name, solution.between(heading, &theorems)))
}

/// An end of a neighbourhood, in parentheses as it may be negative.
fn end(x: &Rational) -> String {
    format!("({})", text(x))
}

/// Around a joint where a margin is zero, where it bends away from zero; at the springing, where it falls to it.
fn neighbourhood(
    arch: &Arch,
    at: &Asymmetric<Ball>,
    contact: Contact,
    joint: &Ball,
    is_springing: bool,
) -> Result<[Rational; 2], Undecided> {
    let ring = Ring::new(arch.weight(), &at.thickness);
    let centre = exact(joint.mid());
    let found = WIDTHS.into_iter().find_map(|width| {
        let width = Rational::from((width, 1000));
        let ends =
            [down(&(centre.clone() - &width), PLACES), up(&(centre.clone() + width), PLACES)];
        let near = Angle::new(between(&ends[0], &ends[1]).with_precision(BITS));
        let along = margin_along(contact, &near, &ring, &at.grip, &at.forces);
        let holds = if is_springing { -along.coefficient(1) } else { along.coefficient(2) };
        holds.is_positive().is_proved().then_some(ends)
    });
    found.ok_or_else(|| {
        Undecided::new("for Coq: a joint at its limit is not told from those beside it")
    })
}
