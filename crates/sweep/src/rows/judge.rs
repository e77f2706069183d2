//! A row of results: its arch, and what it claims.

use super::arch::ArchReader;
use super::columns::Cells;
use super::keep::ReadRow;
use super::roles::Role;
use crate::ask::{Field, notes};
use crate::judge::{Demand, RowClaim, Said, judge};
use crate::parse::thickness;
use crate::problem::Quantity;
use crate::report::judged::JudgedRow;

/// Reader and judge of rows.
pub struct Judge {
    /// Reader of the arches.
    pub reader: ArchReader,
    /// Demand on what is claimed.
    pub demand: Demand,
}

impl Judge {
    /// Judges a row.
    pub fn row(&self, line: u64, row: Result<ReadRow, String>) -> JudgedRow {
        let (cells, kept) = match row {
            Ok(ReadRow { cells, kept }) => (Ok(cells), kept),
            Err(error) => (Err(error), Vec::new()),
        };
        let described = cells.as_ref().map(|cells| self.reader.described(cells));
        let [weight, half_opening, friction] = described.unwrap_or_default();
        let (mut note, mut claim) = (None, None);
        let outcome = cells.and_then(|cells| {
            let (arch, ..) = self.reader.arch(&cells)?;
            note = notes([arch.friction()]).pop();
            Ok(judge(&arch, claim.insert(self.claim(&cells)?), self.demand))
        });
        JudgedRow { line, weight, half_opening, friction, claim, note, kept, outcome }
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
