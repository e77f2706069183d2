//! Every row with its verdict, as CSV.

use super::row::{JudgedColumns, JudgedRow, NUMBER};
use crate::column::NamedColumn;
use crate::columns::{kept_cell, kept_names};
use crate::csv::line;
use crate::judge::Judged;
use crate::problem::Quantity;
use crate::tabular::Separated;
use std::io;

/// The columns of a number: its bounds, the third and the fourth, have none.
fn numbers() -> impl Iterator<Item = &'static NamedColumn<Judged>> {
    NUMBER[..2].iter().chain(&NUMBER[4..])
}

/// The header, with the columns of some quantities, and with what is handed on before them.
pub(super) fn header((quantities, kept): JudgedColumns) -> io::Result<Vec<u8>> {
    let columns = |of: &Quantity| {
        let name = of.name();
        // The value has the name of its quantity.
        numbers().map(move |(of, _)| match *of {
            "value" => name.to_owned(),
            field => format!("{name}_{field}"),
        })
    };
    // The thickness of the arch is not the least one that is claimed.
    let given = |name: &'static str| if name == "thickness" { "given_thickness" } else { name };
    let row = JudgedRow::COLUMNS.iter().map(|(name, _)| given(name).to_owned());
    let own: Vec<String> = row.chain(quantities.iter().flat_map(columns)).collect();
    line([kept_names(kept, &own), own].concat())
}

/// Writes one row.
pub(super) fn row(row: &JudgedRow, (quantities, kept): JudgedColumns) -> io::Result<Vec<u8>> {
    Separated::Comma.lines(|lines| {
        kept.iter().try_for_each(|name| lines.cell(kept_cell(&row.kept, name)))?;
        lines.found(JudgedRow::COLUMNS.iter(), Some(row))?;
        for &quantity in quantities {
            lines.found(numbers(), row.number(quantity))?;
        }
        lines.end()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn no_two_columns_have_one_name() {
        let quantities = [&Quantity::STATE[..], &Quantity::ASSESSMENT].concat();
        let header = header((&quantities, &["friction".to_owned(), "x".to_owned()])).unwrap();
        let header = String::from_utf8(header).unwrap();
        let names: Vec<&str> = header.trim_end().split(',').collect();
        assert!(names.contains(&"thickness") && names.contains(&"given_thickness"), "{header}");
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{header}");
        let is_bound = |name: &&str| name.ends_with("_lower") || name.ends_with("_upper");
        assert!(!names.iter().any(is_bound) && names.contains(&"thrust_error"), "{header}");
    }
}
