//! A row for each node of a branch, and of the line of the least thickness beside it.

use super::BranchArches;
use crate::report::csv;
use crate::report::map::MapRow;
use std::io;

pub(in crate::report) fn csv(all: &BranchArches, out: &mut dyn io::Write) -> io::Result<()> {
    let found = all.arches.iter().filter_map(|arch| arch.found.as_ref().ok());
    let rows = found.flat_map(|(branch, least)| {
        let parts = branch.stretches.iter().map(|(_, stretch)| stretch);
        let of_branch = parts.flat_map(|part| MapRow::of_stretch(branch, part));
        let of_least = least.parts.iter().flat_map(|part| MapRow::of_part(least, part));
        of_branch.chain(of_least).collect::<Vec<_>>()
    });
    csv::columns(MapRow::COLUMNS.iter().chain(&MapRow::OF_BRANCHES), rows, out)
}
