//! The record of a branch: its points in order, its parts with their nodes, and what is proved.

use super::picture::picture;
use super::{BranchArch, BranchArches, PROOF, events, quantities, rounded};
use crate::arch::SelfWeight;
use crate::atlas::{Branch, Level, NoBranch, Stretch, Variable};
use crate::map::{MapRow, node, parts};
use crate::picture::Print;
use crate::report::words::{count, kind, model};
use crate::report::{Content, Record, Reported, Symbol, Tabular};
use std::io;

impl Reported for BranchArches {
    fn content() -> Content {
        Content::DRAWN_RECORDS
    }

    fn records(&self) -> Vec<Record> {
        self.arches.iter().map(|arch| of(arch, self)).collect()
    }

    /// A row for each node of a branch, and of the line of the least thickness beside it.
    fn tabular(&self) -> Tabular {
        let found = self.arches.iter().filter_map(|arch| arch.found.as_ref().ok());
        let rows = found.flat_map(|(branch, least)| {
            let parts = branch.stretches.iter().map(|(_, stretch)| stretch);
            let of_branch = parts.flat_map(|part| MapRow::of_stretch(branch, part));
            let of_least = least.parts.iter().flat_map(|part| MapRow::of_part(least, part));
            of_branch.chain(of_least).collect::<Vec<_>>()
        });
        Tabular::of_columns(MapRow::COLUMNS.iter().chain(&MapRow::OF_BRANCHES), rows)
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        picture(self, print)
    }
}

fn of(arch: &BranchArch, all: &BranchArches) -> Record {
    let mut record = Record::of("couplet.branch/1");
    record.say("Asymmetric solutions of the complementarity problem (19) over friction");
    record.say(format!("half opening {}, {}\n", arch.half_opening, model(arch.weight)));
    record.add("weight", arch.weight.name());
    record.add("half_opening", arch.half_opening.to_string());
    record.add("tolerance", all.tolerance);
    record.add("verdict", arch.verdict());
    let reason = match &arch.found {
        Err(NoBranch::Nowhere(why)) => Some((*why).to_owned()),
        _ => arch.open().first().cloned(),
    };
    record.add("reason", reason);
    let found = arch.found.as_ref().ok();
    let points = found.into_iter().flat_map(|found| points(found, all.digits));
    record.add_list("points", points);
    match &arch.found {
        Ok(_) => {
            record.say(format!("\nin tubes of a half-width of at most {:?}", all.tolerance));
            record.say_all(arch.open().iter().map(|open| format!("undecided: {open}")));
            record.say_all(PROOF);
        }
        Err(NoBranch::Undecided(open)) => record.say(open.to_string()),
        Err(nowhere) => {
            record.say(format!("no branch leaves the least thickness: {nowhere}"));
            record.say(match arch.weight {
                SelfWeight::Milankovitch => {
                    "and there is no asymmetric solution at all (couplet prove asymmetric-number)"
                }
                SelfWeight::Heyman => {
                    "that there is no asymmetric solution between 124 and 144 degrees is not proved; \
                     below and above there is none (couplet prove asymmetric-number)"
                }
            });
        }
    }
    let of_branch = found
        .into_iter()
        .flat_map(|(branch, _)| branch.stretches.iter().map(|(_, stretch)| part(branch, stretch)));
    record.add_list("parts", of_branch);
    record.add_list("least", found.into_iter().flat_map(|(_, least)| parts(least)));
    record.add("proof", PROOF.join(" "));
    record
}

/// The points of a branch in their order, each with its quantities and the part that begins there.
fn points((branch, least): &(Branch, Level), digits: usize) -> impl Iterator<Item = Record> {
    events(branch).into_iter().enumerate().map(move |(k, (meeting, event))| {
        let mut point = Record::default();
        point.say(event);
        point.add("event", event);
        point.add("symmetric", meeting.is_symmetric());
        for (name, text, value) in quantities(&meeting.place(), least) {
            let symbol = Symbol { text, width: 12, name_width: 16 };
            match rounded(&value, digits) {
                Some(value) => point.show_as(name, symbol, &value),
                None => point.add(name, None::<&str>),
            }
        }
        if let Some((_, part)) = branch.stretches.get(k) {
            point.say(along(part));
        }
        point
    })
}

/// A part in words.
fn along(part: &Stretch) -> String {
    let pieces = count(part.section.pieces().count() as u64, "piece", "pieces");
    let proved = if part.is_proved() { "admissible throughout" } else { "not all proved" };
    format!("{}: {}, {pieces}, {proved}", part.kind.name(), kind(part.kind))
}

fn part(branch: &Branch, stretch: &Stretch) -> Record {
    let mut record = Record::default();
    record.add("kind", stretch.kind.name());
    record.add("parameter", Variable::VerticalForce.name());
    record.add("falls", stretch.falls());
    record.add("admissible", stretch.is_admissible().is_ok());
    record.add("pieces", stretch.section.pieces().count());
    record.add_list("nodes", MapRow::of_stretch(branch, stretch).iter().map(node));
    record
}
