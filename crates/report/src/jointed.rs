//! All solutions of the complementarity problem (19) between equal stones.

use super::record::Record;
use super::words::padded;
use crate::arch::whole::Side;
use crate::certify::Undecided;
use crate::problem::Extent;
use couplet_stones::{Enumeration, JointedMotion, JointedSolution, Standing};
use serde_json::Value as Json;

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

/// Rows for the solutions, and for each piece on which nothing is proved, from its thickness until another; one row
/// with the outcome where there are none.
pub(super) fn rows(stones: u64, found: &Result<Enumeration, Undecided>) -> Vec<Record> {
    let row = |mut row: Record, outcome: &str| {
        row.add("mode", "jointed");
        row.add("outcome", outcome);
        row.add("stones", stones);
        row
    };
    let Ok(all) = found else { return vec![row(Record::default(), "undecided")] };
    if all.solutions.is_empty() && all.open.is_empty() {
        return vec![row(Record::default(), outcome(all))];
    }
    let solution = |found: &Result<JointedSolution, Undecided>| match found {
        Ok(found) => row(solved(found), "solution"),
        Err(_) => row(Record::default(), "undecided"),
    };
    let open =
        |piece: [String; 2]| row(Record::named("thickness until", piece.map(Json::from)), "open");
    all.solutions.iter().map(solution).chain(all.open_bounds().map(open)).collect()
}

/// Outcome in a word.
fn outcome(all: &Enumeration) -> &'static str {
    match (&all.standing, all.first_open()) {
        (Standing::Never, _) => "nothing_admissible",
        (_, None) => "complete",
        (_, Some(_)) => "open",
    }
}

/// The solutions, with what a person reads of them.
pub(super) fn record(found: &Result<Enumeration, Undecided>) -> Record {
    let mut record = Record::default();
    let all = match found {
        Ok(all) => all,
        Err(undecided) => {
            record.say(format!("the solutions between equal stones are {undecided}"));
            record.add("outcome", "undecided");
            record.add("reason", undecided.reason.to_string());
            return record;
        }
    };
    let (stones, joints) = (all.stones, joints(all.extent, all.stones));
    let whole = match all.extent {
        Extent::Whole => "the whole arch",
        Extent::Half => "the half arch: symmetric states",
    };
    record.say(format!(
        "All solutions of (19) between {stones} equal stones, {joints} joints of {whole}"
    ));
    record.say(match &all.standing {
        Standing::Never => "   none, proved: at no thickness up to 2 anything is admissible".into(),
        Standing::Always => "   there are admissible states at every thickness".into(),
        Standing::From(eta) => {
            format!("   there are admissible states from the thickness {eta} on")
        }
    });
    record.add("outcome", outcome(all));
    record.add("reason", all.first_open().map(|open| open.reason.to_string()));
    record.add("stones", stones);
    record.add("extent", extent(all.extent));
    let from = match &all.standing {
        Standing::From(eta) => Some(&**eta),
        _ => None,
    };
    record.add_bounds("least_thickness", from);
    record.add_list("solutions", all.solutions.iter().flatten().map(solved));
    let undecided = all.solutions.iter().filter_map(|solution| solution.as_ref().err());
    record.say_all(undecided.map(|undecided| format!("\n   a solution that is {undecided}")));
    if !matches!(all.standing, Standing::Never) {
        record.say_all(rest(all));
    }
    let piece = |bounds: [String; 2]| Record::named("lower upper", bounds.map(Json::from));
    record.add_list("open", all.open_bounds().map(piece));
    record.add("looked_at", all.triples);
    record
}

/// Lines on what is proved of the other thicknesses.
fn rest(all: &Enumeration) -> Vec<String> {
    let mut lines = vec![String::new()];
    let open = |[low, high]: [String; 2]| format!("   from {low} to {high} nothing is proved");
    lines.extend(all.open_bounds().map(open));
    let kind = match (all.extent, all.solutions.is_empty()) {
        (Extent::Whole, false) => "a solution but mirror images",
        (Extent::Whole, true) => "a solution",
        (Extent::Half, _) => "a symmetric solution",
    };
    // Another one than those that are listed.
    let other = if all.solutions.is_empty() { "" } else { "other " };
    let rest = match all.open.is_empty() {
        true => format!("no {other}thickness up to 2 has {kind}, proved"),
        false => format!("elsewhere up to 2 there is no {other}solution, proved"),
    };
    let (complete, range) = match all.open.is_empty() {
        true => ("complete for these joints, as each", "on all of the range"),
        false => ("it is not complete for these joints; each", "there"),
    };
    let each = if all.extent == Extent::Whole { "triples" } else { "pairs" };
    lines.push(format!("   {rest}: {complete}"));
    let triples = all.triples;
    lines.push(format!(
        "   of the {triples} {each} of conditions is decided by signs in balls, {range}"
    ));
    lines
}

fn solved(solution: &JointedSolution) -> Record {
    let kind = match solution.is_symmetric {
        true => "symmetric: the least thickness",
        false => "asymmetric; its mirror image is a solution too",
    };
    let mut record = Record::default();
    record.say(format!("\n   {}  {kind}", solution.thickness));
    record.add("symmetric", solution.is_symmetric);
    record.add_bounds("thickness", Some(&solution.thickness));
    for (name, symbol, figure) in [
        ("thrust", "h = H/(w r)", &solution.thrust),
        ("crown_moment", "p", &solution.crown_moment),
        ("vertical_force", "v", &solution.vertical_force),
    ] {
        record.say(format!("      {name:<20} {symbol:<12} {figure}"));
        record.add_bounds(name, Some(figure));
    }
    let angles: Vec<String> = solution.joints.iter().map(|joint| joint.angle.to_string()).collect();
    let width = angles.iter().map(String::len).max().unwrap_or(0).max(16);
    let heading = padded("angle from crown", width);
    record.say(format!("      {:<22} {:<7} {heading}  rate", "joint", ""));
    let joint = |(joint, angle): (&JointedMotion, &String)| {
        let (how, side) = (joint.contact.name(), side(joint));
        let mut record = Record::named("contact side", [how.into(), side.into()]);
        record.say(format!("      {how:<22} {side:<7} {}  {}", padded(angle, width), joint.rate));
        record.add_bounds("angle", Some(&joint.angle));
        record.add_bounds("rate", Some(&joint.rate));
        record
    };
    record.add_list("joints", solution.joints.iter().zip(&angles).map(joint));
    record
}
