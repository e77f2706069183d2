//! The rows of a part by columns: those that are asked, and those that are answered.

use super::listed::Listed;
use super::queries::{PartArches, PartQueries};
use crate::arch::SelfWeight;
use crate::certify::batch::{BatchArches, BatchColumns, RowVerdict};
use crate::problem::{Mode, Quantity};
use crate::report::{ParquetColumn, ParquetTable};
use ::parquet::data_type::ByteArray;

/// The columns that are asked: row, file and line of a data set, texts and doubles.
pub(super) fn asked<'a>(queries: &'a PartQueries<'a>) -> ParquetTable<'a> {
    let first = queries.first;
    let mut columns =
        vec![("row".to_owned(), ParquetColumn::whole(move |row| Some(first + row as u64)))];
    let (given, again): (_, &[&str]) = match &queries.arches {
        PartArches::Grid(grid) => {
            let names = SelfWeight::ALL.map(|weight| (weight, ByteArray::from(weight.name())));
            let name = move |weight: SelfWeight| {
                Some(names.iter().find(|(of, _)| *of == weight)?.1.clone())
            };
            let given = [
                ParquetColumn::Name(Box::new(move |row| name(grid.at(row).0))),
                ParquetColumn::Text(Box::new(|row| Some(grid.at(row).1.text.clone()))),
                ParquetColumn::Text(Box::new(|row| Some(grid.at(row).2.text.clone()))),
                ParquetColumn::Double(Box::new(|row| grid.at(row).1.double)),
                ParquetColumn::Double(Box::new(|row| grid.at(row).2.double)),
            ];
            (given, &["friction", "friction_double"])
        }
        PartArches::Listed(listed) => {
            if let Some((file, lines)) = &listed.origin {
                columns
                    .push(("file".into(), ParquetColumn::Name(Box::new(|_| Some(file.clone())))));
                columns.push(("line".into(), ParquetColumn::whole(move |row| Some(lines[row]))));
            }
            let Listed { texts: [weights, alphas, mus], doubles: [alpha, mu], .. } =
                listed.as_ref();
            let given = [
                ParquetColumn::Name(Box::new(weights.cells())),
                ParquetColumn::Text(Box::new(alphas.cells())),
                ParquetColumn::Text(Box::new(mus.cells())),
                ParquetColumn::Double(Box::new(|row| alpha[row])),
                ParquetColumn::Double(Box::new(|row| mu[row])),
            ];
            (given, &[])
        }
    };
    let names = ["weight", "half_opening", "friction", "half_opening_rad", "friction_double"];
    columns.extend(names.map(str::to_owned).into_iter().zip(given));
    ParquetTable { rows: queries.count(), again, once: &["row"], columns }
}

/// The columns that are answered.
pub(super) fn answered<'a>(quantities: &[Quantity], found: &'a BatchColumns) -> ParquetTable<'a> {
    // The texts of names are shared.
    let verdicts = RowVerdict::ALL.map(|verdict| ByteArray::from(verdict.name()));
    let modes = Mode::ALL.map(|mode| ByteArray::from(mode.label()));
    let verdict = move |row: usize| Some(verdicts[found.verdicts[row] as usize].clone());
    let mode = move |row: usize| modes.get(usize::from(found.modes[row])).cloned();
    let mut columns = vec![
        ("verdict".to_owned(), ParquetColumn::Name(Box::new(verdict))),
        ("mode".to_owned(), ParquetColumn::Name(Box::new(mode))),
    ];
    for (place, quantity) in quantities.iter().enumerate() {
        let name = quantity.name();
        let double = move |row| found.double(place, row);
        columns.push((name.to_owned(), ParquetColumn::Double(Box::new(double))));
        let side = move |row| found.side(place, row);
        columns.push((format!("{name}_side"), ParquetColumn::Short(Box::new(side))));
        if let Some(texts) = found.texts.get(place) {
            let text = |row: usize| texts[row].as_deref().map(ByteArray::from);
            columns.push((format!("{name}_text"), ParquetColumn::Text(Box::new(text))));
        }
    }
    let reason = |row| found.reasons.get(&row).map(|why| ByteArray::from(why.as_str()));
    columns.push(("reason".into(), ParquetColumn::Text(Box::new(reason))));
    ParquetTable { rows: found.verdicts.len(), again: &[], once: &[], columns }
}

/// Tells whether a cell of a column is one that was read, bit for bit.
pub(super) fn is_same(
    (column, row): (&ParquetColumn, usize),
    (there, place): (&ParquetColumn, usize),
) -> bool {
    use ParquetColumn as Column;
    match (column, there) {
        (Column::Name(cell) | Column::Text(cell), Column::Text(there)) => cell(row) == there(place),
        (Column::Double(cell), Column::Double(there)) => {
            cell(row).map(f64::to_bits) == there(place).map(f64::to_bits)
        }
        (Column::Whole(cell), Column::Whole(there)) => cell(row) == there(place),
        (Column::Short(cell), Column::Short(there)) => cell(row) == there(place),
        _ => false,
    }
}
