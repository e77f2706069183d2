//! JSON: the points of a branch, its parts with their nodes, and the line of the least thickness.

use super::{BranchArch, BranchArches, PROOF, events, quantities, rounded};
use crate::atlas::{Branch, NoBranch, Stretch, Variable};
use crate::report::fields::Fields;
use crate::report::json as file;
use crate::report::map::{MapRow, node, parts};
use std::io;

pub(in crate::report) fn json(all: &BranchArches, out: &mut dyn io::Write) -> io::Result<()> {
    file::write_all(all.arches.iter().map(|arch| entry(arch, all)), out)
}

fn entry(arch: &BranchArch, all: &BranchArches) -> Fields {
    let mut fields = Fields::of("couplet.branch/1");
    fields.add("weight", arch.weight.name());
    fields.add("half_opening", arch.half_opening.to_string());
    fields.add("tolerance", all.tolerance);
    fields.add("verdict", arch.verdict());
    let reason = match &arch.found {
        Err(NoBranch::Nowhere(why)) => Some((*why).to_owned()),
        _ => arch.open().first().cloned(),
    };
    fields.add("reason", reason);
    let found = arch.found.as_ref().ok();
    let points = found.into_iter().flat_map(|(branch, least)| {
        events(branch).into_iter().map(move |(meeting, event)| {
            let mut fields = Fields::default();
            fields.add("event", event);
            fields.add("symmetric", meeting.is_symmetric());
            for (name, _, value) in quantities(&meeting.place(), least) {
                fields.add_rounded(name, rounded(&value, all.digits).as_ref());
            }
            fields
        })
    });
    fields.add_list("points", points);
    let of_branch = found
        .into_iter()
        .flat_map(|(branch, _)| branch.stretches.iter().map(|(_, stretch)| part(branch, stretch)));
    fields.add_list("parts", of_branch);
    fields.add_list("least", found.into_iter().flat_map(|(_, least)| parts(least)));
    fields.add("proof", PROOF.join(" "));
    fields
}

fn part(branch: &Branch, stretch: &Stretch) -> Fields {
    let mut fields = Fields::default();
    fields.add("kind", stretch.kind.name());
    fields.add("parameter", Variable::VerticalForce.name());
    fields.add("falls", stretch.falls());
    fields.add("admissible", stretch.is_admissible().is_ok());
    fields.add("pieces", stretch.section.pieces().count());
    fields.add_list("nodes", MapRow::of_stretch(branch, stretch).iter().map(node));
    fields
}
