//! All solutions of the complementarity problem (19) between equal stones: lines for a person, rows, and an object.

use super::record::Record;
use crate::arch::whole::Side;
use crate::certify::{Enumeration, JointedMotion, JointedSolution, Standing, Undecided};
use crate::problem::Extent;
use serde_json::Value as Json;
use std::io;

/// Number of joints that have conditions.
pub(super) fn joints(extent: Extent, stones: u64) -> u64 {
    match extent {
        Extent::Whole => stones + 1,
        Extent::Half => stones / 2 + 1,
    }
}

/// Extent in a word.
pub(super) fn extent(extent: Extent) -> &'static str {
    match extent {
        Extent::Whole => "whole",
        Extent::Half => "half",
    }
}

fn side(motion: &JointedMotion) -> &'static str {
    motion.side.map_or("crown", Side::name)
}

fn table(all: &Enumeration, out: &mut dyn io::Write) -> io::Result<()> {
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

/// Rows for the solutions, and for each piece on which nothing is proved, from its thickness until another.
pub(super) fn rows(found: &Result<Enumeration, Undecided>) -> Vec<Record> {
    let row = |mut row: Record, outcome: &str| {
        row.add("mode", "jointed");
        row.add("outcome", outcome);
        row.add("stones", found.as_ref().ok().map(|all| all.stones));
        row
    };
    let Ok(all) = found else { return vec![row(Record::default(), "undecided")] };
    let solution = |found: &Result<JointedSolution, Undecided>| match found {
        Ok(found) => row(solved(found), "solution"),
        Err(_) => row(Record::default(), "undecided"),
    };
    let open =
        |piece: [String; 2]| row(Record::named("thickness until", piece.map(Json::from)), "open");
    all.solutions.iter().map(solution).chain(all.open_bounds().map(open)).collect()
}

/// The solutions, with what a person reads of them.
pub(super) fn record(found: &Result<Enumeration, Undecided>) -> Record {
    let mut record = fields(found);
    match found {
        Ok(all) => {
            let mut lines = Vec::new();
            let _ = table(all, &mut lines);
            record.say(String::from_utf8_lossy(&lines).trim_end());
        }
        Err(undecided) => record.say(format!("the solutions between equal stones are {undecided}")),
    }
    record
}

fn fields(found: &Result<Enumeration, Undecided>) -> Record {
    let mut fields = Record::default();
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
        Standing::From(eta) => Some(&**eta),
        _ => None,
    };
    fields.add_bounds("least_thickness", from);
    fields.add_list("solutions", all.solutions.iter().flatten().map(solved));
    let piece = |bounds: [String; 2]| Record::named("lower upper", bounds.map(Json::from));
    fields.add_list("open", all.open_bounds().map(piece));
    fields.add("looked_at", all.triples);
    fields
}

fn solved(solution: &JointedSolution) -> Record {
    let mut fields = Record::default();
    fields.add("symmetric", solution.is_symmetric);
    fields.add_bounds("thickness", Some(&solution.thickness));
    fields.add_bounds("thrust", Some(&solution.thrust));
    fields.add_bounds("crown_moment", Some(&solution.crown_moment));
    fields.add_bounds("vertical_force", Some(&solution.vertical_force));
    let joint = |joint: &JointedMotion| {
        let mut fields = Record::default();
        fields.add("contact", joint.contact.name());
        fields.add("side", side(joint));
        fields.add_bounds("angle", Some(&joint.angle));
        fields.add_bounds("rate", Some(&joint.rate));
        fields
    };
    fields.add_list("joints", solution.joints.iter().map(joint));
    fields
}
