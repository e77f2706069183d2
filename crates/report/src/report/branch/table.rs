//! The points of a branch, and what is proved between them, for a person.

use super::{BranchArch, BranchArches, PROOF, events, quantities, rounded};
use crate::atlas::NoBranch;
use crate::report::words::{apart, count, kind, model};
use std::io;

pub(in crate::report) fn table(all: &BranchArches, out: &mut dyn io::Write) -> io::Result<()> {
    apart(&all.arches, out, |arch, out| one(arch, all, out))
}

fn one(arch: &BranchArch, all: &BranchArches, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "Asymmetric solutions of the complementarity problem (19) over friction")?;
    writeln!(out, "half opening {}, {}\n", arch.half_opening, model(arch.weight))?;
    let (branch, least) = match &arch.found {
        Ok(found) => found,
        Err(NoBranch::Undecided(open)) => return writeln!(out, "{open}"),
        Err(nowhere) => {
            writeln!(out, "no branch leaves the least thickness: {nowhere}")?;
            return writeln!(out, "that there is no other asymmetric solution is not proved");
        }
    };
    let parts: Vec<_> = branch.stretches.iter().map(|(_, stretch)| stretch).collect();
    for (k, (meeting, event)) in events(branch).into_iter().enumerate() {
        writeln!(out, "{event}")?;
        for (name, symbol, value) in quantities(&meeting.place(), least) {
            let value =
                rounded(&value, all.digits).map_or_else(String::new, |x| x.value.to_string());
            writeln!(out, "   {name:<16} {symbol:<12} {value}")?;
        }
        let Some(part) = parts.get(k) else { continue };
        let pieces = count(part.section.pieces().count() as u64, "piece", "pieces");
        let proved = if part.is_proved() { "admissible throughout" } else { "not all proved" };
        writeln!(out, "{}: {}, {pieces}, {proved}", part.kind.name(), kind(part.kind))?;
    }
    writeln!(out, "\nin tubes of a half-width of at most {:?}", all.tolerance)?;
    for open in arch.open() {
        writeln!(out, "undecided: {open}")?;
    }
    PROOF.iter().try_for_each(|line| writeln!(out, "{line}"))
}
