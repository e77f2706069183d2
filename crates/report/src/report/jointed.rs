//! All solutions of the complementarity problem (19) between equal stones: lines for a person, rows, and an object.

use super::bounds::bounds;
use super::fields::Fields;
use crate::arch::whole::Side;
use crate::certify::{Enumeration, JointedMotion, JointedSolution, Standing, Undecided};
use crate::problem::{Arch, Extent};
use std::io;

/// How many joints have conditions.
pub(super) fn joints(extent: Extent, stones: u64) -> u64 {
    match extent {
        Extent::Whole => stones + 1,
        Extent::Half => stones / 2 + 1,
    }
}

/// In a word.
pub(super) fn extent(extent: Extent) -> &'static str {
    match extent {
        Extent::Whole => "whole",
        Extent::Half => "half",
    }
}

fn side(motion: &JointedMotion) -> &'static str {
    match motion.side {
        Some(Side::Right) => "right",
        Some(Side::Left) => "left",
        None => "crown",
    }
}

pub(super) fn table(all: &Enumeration, out: &mut dyn io::Write) -> io::Result<()> {
    let joints = joints(all.extent, all.stones);
    let (whole, each) = match all.extent {
        Extent::Whole => ("the whole arch", "triples"),
        Extent::Half => ("the half arch: symmetric states", "pairs"),
    };
    writeln!(
        out,
        "All solutions of (19) between {} equal stones, {joints} joints of {whole}",
        all.stones
    )?;
    match &all.standing {
        Standing::Never => {
            return writeln!(
                out,
                "   none, proved: at no thickness up to 2 anything is admissible"
            );
        }
        Standing::Always => writeln!(out, "   there are admissible states at every thickness")?,
        Standing::From(eta) => {
            writeln!(out, "   there are admissible states from the thickness {eta} on")?
        }
    }
    for solution in &all.solutions {
        match solution {
            Ok(solution) => one(solution, out)?,
            Err(undecided) => writeln!(out, "\n   a solution that is {undecided}")?,
        }
    }
    writeln!(out)?;
    for [low, high] in all.open_bounds() {
        writeln!(out, "   from {low} to {high} nothing is proved")?;
    }
    let triples = all.triples;
    let rest = match (all.open.is_empty(), all.extent) {
        (true, Extent::Whole) => {
            "no other thickness up to 2 has a solution but mirror images, proved"
        }
        (true, Extent::Half) => "no other thickness up to 2 has a symmetric solution, proved",
        (false, _) => "elsewhere up to 2 there is no other solution, proved",
    };
    let (complete, range) = match all.open.is_empty() {
        true => ("complete for these joints, as each", "on all of the range"),
        false => ("it is not complete for these joints; each", "there"),
    };
    writeln!(out, "   {rest}: {complete}")?;
    writeln!(out, "   of the {triples} {each} of conditions is decided by signs in balls, {range}")
}

fn one(solution: &JointedSolution, out: &mut dyn io::Write) -> io::Result<()> {
    let kind = match solution.is_symmetric {
        true => "symmetric: the least thickness",
        false => "asymmetric; its mirror image is a solution too",
    };
    writeln!(out, "\n   {}  {kind}", solution.thickness)?;
    for (name, symbol, figure) in [
        ("thrust", "h = H/(w r)", &solution.thrust),
        ("crown_moment", "p", &solution.crown_moment),
        ("vertical_force", "v", &solution.vertical_force),
    ] {
        writeln!(out, "      {name:<20} {symbol:<12} {figure}")?;
    }
    let angles: Vec<String> = solution.joints.iter().map(|joint| joint.angle.to_string()).collect();
    let width = angles.iter().map(String::len).max().unwrap_or(0).max(16);
    writeln!(out, "      {:<22} {:<7} {:<width$}  rate", "joint", "", "angle from crown")?;
    solution.joints.iter().zip(&angles).try_for_each(|(joint, angle)| {
        let (how, side) = (joint.contact.name(), side(joint));
        writeln!(out, "      {how:<22} {side:<7} {angle:<width$}  {}", joint.rate)
    })
}

/// Rows as those of the other solutions, with the stones; and each piece on which nothing is proved, from its thickness until another.
pub(super) fn rows(arch: &Arch, found: &Result<Enumeration, Undecided>) -> Vec<Vec<String>> {
    let row = |[symmetric, thickness, thrust, moment, vertical, stones, outcome, until]: [String;
                   8]| {
        vec![
            arch.weight().name().to_owned(),
            arch.half_opening().to_string(),
            arch.friction().to_string(),
            symmetric,
            "jointed".to_owned(),
            thickness,
            thrust,
            moment,
            vertical,
            stones,
            outcome,
            until,
            String::new(),
            String::new(),
        ]
    };
    let nothing = String::new;
    let Ok(all) = found else {
        let [a, b, c, d, e, f] = std::array::from_fn(|_| nothing());
        return vec![row([a, b, c, d, e, f, "undecided".to_owned(), nothing()])];
    };
    let stones = all.stones.to_string();
    let solution = |found: &Result<JointedSolution, Undecided>| match found {
        Ok(found) => row([
            found.is_symmetric.to_string(),
            found.thickness.to_string(),
            found.thrust.to_string(),
            found.crown_moment.to_string(),
            found.vertical_force.to_string(),
            stones.clone(),
            "solution".to_owned(),
            nothing(),
        ]),
        Err(_) => {
            let [a, b, c, d, e] = std::array::from_fn(|_| nothing());
            row([a, b, c, d, e, stones.clone(), "undecided".to_owned(), nothing()])
        }
    };
    let open = |[low, high]: [String; 2]| {
        let [a, b, c, d] = std::array::from_fn(|_| nothing());
        row([a, low, b, c, d, stones.clone(), "open".to_owned(), high])
    };
    all.solutions.iter().map(solution).chain(all.open_bounds().map(open)).collect()
}

pub(super) fn fields(found: &Result<Enumeration, Undecided>) -> Fields {
    let mut fields = Fields::default();
    let all = match found {
        Ok(all) => all,
        Err(undecided) => {
            fields.add("outcome", "undecided");
            fields.add("reason", undecided.reason.to_string());
            return fields;
        }
    };
    let outcome = match (&all.standing, all.first_open()) {
        (Standing::Never, _) => "nothing_admissible",
        (_, None) => "complete",
        (_, Some(_)) => "open",
    };
    fields.add("outcome", outcome);
    fields.add("reason", all.first_open().map(|open| open.reason.to_string()));
    fields.add("stones", all.stones);
    fields.add("extent", extent(all.extent));
    let from = match &all.standing {
        Standing::From(eta) => Some(bounds(eta)),
        _ => None,
    };
    fields.add_fields("least_thickness", from);
    fields.add_list("solutions", all.solutions.iter().flatten().map(solved).collect());
    let piece = |[lower, upper]: [String; 2]| {
        let mut fields = Fields::default();
        fields.add("lower", lower);
        fields.add("upper", upper);
        fields
    };
    fields.add_list("open", all.open_bounds().map(piece).collect());
    fields.add("looked_at", all.triples);
    fields
}

fn solved(solution: &JointedSolution) -> Fields {
    let mut fields = Fields::default();
    fields.add("symmetric", solution.is_symmetric);
    fields.add_fields("thickness", Some(bounds(&solution.thickness)));
    fields.add_fields("thrust", Some(bounds(&solution.thrust)));
    fields.add_fields("crown_moment", Some(bounds(&solution.crown_moment)));
    fields.add_fields("vertical_force", Some(bounds(&solution.vertical_force)));
    let joint = |joint: &JointedMotion| {
        let mut fields = Fields::default();
        fields.add("contact", joint.contact.name());
        fields.add("side", side(joint));
        fields.add_fields("angle", Some(bounds(&joint.angle)));
        fields.add_fields("rate", Some(bounds(&joint.rate)));
        fields
    };
    fields.add_list("joints", solution.joints.iter().map(joint).collect());
    fields
}
