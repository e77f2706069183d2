//! Arches of voussoirs as CSV: a row for each.

use super::arch::{VoussoirArch, VoussoirArches};
use super::{given, json};
use crate::report::csv;
use std::io;

const COLUMNS: &str = "weight half_opening stones friction outcome mode thickness thrust rotation_joint sliding_joint \
                       continuous_thickness loss relative_loss may_move";

pub(crate) fn csv(
    VoussoirArches { arches, .. }: &VoussoirArches,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let row = |arch: &VoussoirArch| {
        let mut row = json::entry(arch);
        row.append(arch.given.as_ref().map(|given| given::cells(arch, given)).unwrap_or_default());
        row
    };
    let rows = arches.iter().map(row);
    match arches.iter().any(|arch| arch.given.is_some()) {
        true => csv::table(&[COLUMNS, given::COLUMNS].join(" "), rows, out),
        false => csv::table(COLUMNS, rows, out),
    }
}
