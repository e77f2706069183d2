//! Every row with its verdict, as CSV.

use super::row::{JudgedRow, NUMBER, ROW, number};
use crate::columns::{kept_cells, kept_names};
use crate::csv::line;
use crate::problem::Quantity;
use std::io;

/// Bounds have no columns, and the value has the name of its quantity.
fn column(quantity: Quantity, field: &str) -> Option<String> {
    match field {
        "lower" | "upper" => None,
        "value" => Some(quantity.name().to_owned()),
        field => Some(format!("{}_{field}", quantity.name())),
    }
}

/// The header, with the columns of some quantities, and with what is handed on before them.
pub(super) fn header(quantities: &[Quantity], kept: &[String]) -> io::Result<Vec<u8>> {
    let columns =
        |&quantity: &Quantity| NUMBER.split(' ').filter_map(move |field| column(quantity, field));
    let row = ROW.split(' ').map(str::to_owned);
    let own: Vec<String> = row.chain(quantities.iter().flat_map(columns)).collect();
    line([kept_names(kept, &own), own].concat())
}

/// Writes one row.
pub(super) fn row(
    row: &JudgedRow,
    quantities: &[Quantity],
    kept: &[String],
) -> io::Result<Vec<u8>> {
    let mut record: Vec<String> = kept_cells(kept, &row.kept).collect();
    record.extend(row.fields().texts());
    for &quantity in quantities {
        let texts = row.number(quantity).map(number).unwrap_or_default();
        let fields = NUMBER.split(' ').filter(|field| column(quantity, field).is_some());
        record.extend(fields.map(|field| texts.text(field)));
    }
    line(record)
}
