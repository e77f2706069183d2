//! Every row with its verdict, as CSV.

use super::row::{JudgedRow, NUMBER, ROW, number};
use crate::problem::Quantity;
use crate::report::columns::{kept_cells, kept_names};
use crate::report::csv::line;
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
        |&quantity: &Quantity| NUMBER.into_iter().filter_map(move |field| column(quantity, field));
    let row = ROW.into_iter().map(str::to_owned);
    let own: Vec<String> = row.chain(quantities.iter().flat_map(columns)).collect();
    line([kept_names(kept, &own), own].concat())
}

/// One row.
pub(super) fn row(
    row: &JudgedRow,
    quantities: &[Quantity],
    kept: &[String],
) -> io::Result<Vec<u8>> {
    let mut record: Vec<String> = kept_cells(kept, &row.kept).collect();
    record.extend(row.fields().texts());
    for &quantity in quantities {
        let texts = row.number(quantity).map(|judged| number(judged).texts().collect());
        let texts: Vec<String> = texts.unwrap_or_else(|| vec![String::new(); NUMBER.len()]);
        let texts = NUMBER.into_iter().zip(texts);
        record.extend(texts.filter_map(|(field, text)| column(quantity, field).map(|_| text)));
    }
    line(record)
}
