//! A row for each node of a branch, and of the line of the least thickness beside it.

use super::BranchArches;
use crate::atlas::{Branch, Stretch};
use crate::report::csv;
use crate::report::map::{MapRow, lower, upper};
use std::io;

/// Columns that a row has beside the columns of a map.
const MORE: [&str; 5] = [
    "vertical_force_lower",
    "vertical_force_upper",
    "crown_hinge_lower",
    "crown_hinge_upper",
    "admissible",
];

fn more(row: &MapRow, stretch: Option<&Stretch>) -> [String; 5] {
    let place = row.place();
    let text = |bound: Option<f64>| bound.map(|x| format!("{x:?}")).unwrap_or_default();
    let [v, b0] = [&place.vertical_force, &place.crown_hinge].map(Option::as_ref);
    [
        text(lower(v)),
        text(upper(v)),
        text(lower(b0)),
        text(upper(b0)),
        stretch.map(|of| of.is_admissible().is_ok().to_string()).unwrap_or_default(),
    ]
}

pub(in crate::report) fn csv(all: &BranchArches, out: &mut dyn io::Write) -> io::Result<()> {
    let header =
        MapRow::COLUMNS.iter().map(|(name, _)| *name).chain(MORE).map(str::to_owned).collect();
    let cells = |row: &MapRow, stretch: Option<&Stretch>| -> Vec<String> {
        MapRow::COLUMNS
            .iter()
            .map(|(_, column)| column.text(row))
            .chain(more(row, stretch))
            .collect()
    };
    let of_branch = |branch: &Branch| -> Vec<Vec<String>> {
        let parts = branch.stretches.iter().map(|(_, stretch)| stretch);
        let rows = parts.flat_map(|part| {
            MapRow::of_stretch(branch, part).into_iter().map(move |row| cells(&row, Some(part)))
        });
        rows.collect()
    };
    let rows = all.arches.iter().filter_map(|arch| arch.found.as_ref().ok()).flat_map(
        |(branch, least)| {
            let parts = least.parts.iter().flat_map(|part| MapRow::of_part(least, part));
            of_branch(branch)
                .into_iter()
                .chain(parts.map(|row| cells(&row, None)))
                .collect::<Vec<_>>()
        },
    );
    csv::write(std::iter::once(header).chain(rows), out)
}
