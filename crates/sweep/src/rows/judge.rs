//! A row of results: its arch, and what it claims.

use super::arch::ArchReader;
use super::columns::Cells;
use super::keep::ReadRow;
use super::roles::Role;
use super::source::Numbered;
use crate::ask::{Field, notes};
use crate::judge::{Demand, ReadClaim, RowClaim, Said, judge_all};
use crate::parse::thickness;
use crate::problem::{Arch, Quantity};
use crate::report::judged::JudgedRow;
use rayon::prelude::*;

/// Reader and judge of rows.
pub struct Judge {
    /// Reader of the arches.
    pub reader: ArchReader,
    /// Demand on what is claimed.
    pub demand: Demand,
}

impl Judge {
    /// Judges some rows, in their order, on all cores.
    pub fn rows(&self, rows: Vec<Numbered<ReadRow>>) -> Vec<JudgedRow> {
        let read = |(_, row): &Numbered<ReadRow>| {
            let mut note = None;
            let mut asked = || {
                let cells = &row.as_ref().map_err(Clone::clone)?.cells;
                let (arch, ..) = self.reader.arch(cells)?;
                note = notes([arch.friction()]).pop();
                Ok((arch, self.claim(cells)?))
            };
            let asked: ReadClaim = asked();
            (asked, note)
        };
        let (all, notes): (Vec<_>, Vec<_>) = rows.par_iter().map(read).unzip();
        let judged = judge_all(&all, self.demand);
        let row = |((line, row), asked, note, outcome): (_, Result<_, _>, _, _)| {
            let row: Result<ReadRow, String> = row;
            let described = row.as_ref().map(|row| self.reader.described(&row.cells));
            let [weight, half_opening, friction] = described.unwrap_or_default();
            let claim = asked.ok().map(|(_, claim): (Arch, _)| claim);
            let kept = row.map_or_else(|_| Vec::new(), |row| row.kept);
            JudgedRow { line, weight, half_opening, friction, claim, note, kept, outcome }
        };
        (rows, all, notes, judged).into_par_iter().map(row).collect()
    }

    fn claim(&self, cells: &Cells) -> Result<RowClaim, String> {
        let text = |role| self.reader.said(cells, role).map(|(text, _)| text);
        let columns = || self.reader.columns.all.iter().zip(cells);
        // Beside what is said of an arch that has a thickness, `thickness` is that one.
        let has_one =
            columns().any(|(column, cell)| column.role.is_of_thickness() && cell.is_some());
        let role = match text(Role::Given(Field::Thickness)) {
            None if has_one => Role::Number(Quantity::Thickness),
            _ => Role::Given(Field::Thickness),
        };
        let given = self.reader.given(cells, role);
        let given = given.map(|said| thickness(&self.reader.exact(said))).transpose()?;
        let numbers: Vec<_> = columns()
            .filter(|(column, _)| column.role != role)
            .filter_map(|(column, cell)| {
                let Role::Number(quantity) = column.role else { return None };
                let text = self.reader.spelling.decimal(cell.as_deref()?);
                Some((quantity, text, column.unit == "deg"))
            })
            .collect();
        let numbers = numbers.iter().map(|(of, text, degrees)| (*of, &**text, *degrees)).collect();
        let said = Said {
            can_stand: text(Role::CanStand),
            thickness: given,
            stands: text(Role::Stands),
            mode: text(Role::Mode),
            numbers,
        };
        RowClaim::read(&said).map_err(|error| error.to_string())
    }
}
