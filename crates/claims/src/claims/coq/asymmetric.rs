//! The file of an asymmetric solution of (19): its one root, and that it is admissible on the whole arch.

use super::BITS;
use super::given::given;
use super::numeral::{down, exact, text, unit, up};
use super::root::Root;
use super::solution::Solution;
use super::table::DECIMALS;
use super::template::fill;
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
/// How wide it may be on either side, in thousandths.
const WIDTHS: [u32; 9] = [500, 400, 300, 200, 100, 50, 20, 10, 5];

/// The name and the content of the file, for a root of the kind with an inner joint that slides.
pub(super) fn file(root: &Root, arch: &Arch) -> Result<(String, String), Undecided> {
    let given = given(&root.system, arch);
    let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
    let mut solution = Solution::new(root, &names)?;
    let definitions = given.iter().map(|(name, x)| format!("Definition {name} : R := {x}."));
    let definitions = definitions.collect::<Vec<_>>().join("\n");
    let thickness = root.system.index(Unknown::Thickness).map(|k| text(&solution.table.centre[k]));
    let symbols: Vec<&str> = solution.symbols.iter().collect();
    let witness = symbols.join(" & ");
    solution.values.extend([
        ("arch", definitions),
        ("thickness", thickness.unwrap_or_default()),
        ("witness", witness),
        ("radius", text(&unit(DECIMALS))),
    ]);
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
    let [heading, theorems] =
        [include_str!("templates/asymmetric.v"), include_str!("templates/asymmetric_solution.v")]
            .map(|template| fill(template, &solution.values));
    let name = format!("Asymmetric{:?}{:?}.v", AsymmetricMode::InnerSliding, arch.weight());
    Ok((name, [heading, solution.text(), theorems].concat()))
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
