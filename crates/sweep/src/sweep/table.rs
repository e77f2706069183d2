//! The rows of a part by columns: those that are asked, and those that are answered.

use super::query::{Listed, PartArches, PartGrid, PartQueries};
use super::read::ReadCells;
use crate::arch::SelfWeight;
use crate::certify::batch::{Batch, BatchRow, RowVerdict};
use crate::problem::Mode;
use ::parquet::data_type::ByteArray;
use std::sync::Arc;

/// The cell of each row of a column. A column is never there as a whole: some rows are written at a time.
pub(super) type CellOf<'a, T> = Box<dyn Fn(usize) -> Option<T> + 'a>;

/// A column that is written.
pub(super) enum PartColumn<'a> {
    /// A text of a few: a name.
    Name(CellOf<'a, ByteArray>),
    Text(CellOf<'a, ByteArray>),
    Double(CellOf<'a, f64>),
    Whole(CellOf<'a, i64>),
    /// A whole number of one byte.
    Short(CellOf<'a, i32>),
}

/// Rows of a part that are held in memory, by columns, with the names of these.
pub(super) struct PartTable<'a> {
    pub rows: usize,
    /// Columns of numbers that come again with every half opening.
    pub again: &'static [&'static str],
    pub columns: Vec<(String, PartColumn<'a>)>,
}

impl<'a> PartTable<'a> {
    /// The columns that are asked: row, file and line of a data set, texts and doubles.
    pub(super) fn asked(queries: &'a PartQueries<'a>) -> Self {
        let whole = |number: u64| i64::try_from(number).ok();
        let first = queries.first;
        let mut columns =
            vec![("row".to_owned(), PartColumn::whole(move |row| whole(first + row as u64)))];
        let origin = match &queries.arches {
            PartArches::Listed(listed) => listed.origin.as_ref(),
            PartArches::Grid(_) => None,
        };
        if let Some((file, lines)) = origin {
            columns.push(("file".into(), PartColumn::name(|_| Some(file.clone()))));
            columns.push(("line".into(), PartColumn::whole(move |row| whole(lines[row]))));
        }
        let given = match &queries.arches {
            PartArches::Grid(PartGrid { columns, frictions, .. }) => {
                let names = SelfWeight::ALL.map(|weight| (weight, ByteArray::from(weight.name())));
                let name = move |weight: SelfWeight| {
                    Some(names.iter().find(|(of, _)| *of == weight)?.1.clone())
                };
                let length = frictions.len();
                let column = move |row: usize| &columns[row / length];
                let friction = move |row: usize| &frictions[row % length];
                [
                    PartColumn::name(move |row| name(column(row).0)),
                    PartColumn::text(move |row| Some(column(row).1.text.clone())),
                    PartColumn::text(move |row| Some(friction(row).text.clone())),
                    PartColumn::double(move |row| column(row).1.double),
                    PartColumn::double(move |row| friction(row).double),
                ]
            }
            PartArches::Listed(listed) => {
                let Listed { texts: [weights, alphas, mus], doubles: [alpha, mu], .. } =
                    listed.as_ref();
                [
                    PartColumn::name(weights.cells()),
                    PartColumn::text(alphas.cells()),
                    PartColumn::text(mus.cells()),
                    PartColumn::double(|row| alpha[row]),
                    PartColumn::double(|row| mu[row]),
                ]
            }
        };
        let names = ["weight", "half_opening", "friction", "half_opening_rad", "friction_double"];
        columns.extend(names.map(str::to_owned).into_iter().zip(given));
        let again: &[&str] = match &queries.arches {
            PartArches::Grid(_) => &["friction", "friction_double"],
            PartArches::Listed(_) => &[],
        };
        Self { rows: queries.len(), again, columns }
    }

    /// All columns.
    pub(super) fn new(
        batch: &Batch,
        queries: &'a PartQueries<'a>,
        found: &'a [Arc<BatchRow>],
    ) -> Self {
        let Self { rows, again, mut columns } = Self::asked(queries);
        columns.extend(Self::answered(batch, found).columns);
        Self { rows, again, columns }
    }

    /// The columns that are answered.
    pub(super) fn answered(batch: &Batch, found: &'a [Arc<BatchRow>]) -> Self {
        // The texts of names are shared.
        let verdicts = RowVerdict::ALL.map(|verdict| ByteArray::from(verdict.name()));
        let modes = Mode::ALL.map(|mode| (mode, ByteArray::from(mode.label())));
        let mode = move |row: usize| {
            let mode = found[row].mode?;
            Some(modes.iter().find(|(of, _)| *of == mode)?.1.clone())
        };
        let verdict = move |row: usize| Some(verdicts[found[row].verdict as usize].clone());
        let mut columns = vec![
            ("verdict".to_owned(), PartColumn::name(verdict)),
            ("mode".to_owned(), PartColumn::name(mode)),
        ];
        for (place, quantity) in batch.quantities.iter().enumerate() {
            let value = move |row: usize| found[row].values[place].as_ref();
            let name = quantity.name();
            columns
                .push((name.to_owned(), PartColumn::double(move |row| Some(value(row)?.double))));
            columns
                .push((format!("{name}_side"), PartColumn::short(move |row| value(row)?.side())));
            if batch.has_texts {
                let text = move |row| value(row)?.text.as_deref().map(ByteArray::from);
                columns.push((format!("{name}_text"), PartColumn::text(text)));
            }
        }
        let reason = |row: usize| found[row].reason.as_deref().map(ByteArray::from);
        columns.push(("reason".into(), PartColumn::text(reason)));
        Self { rows: found.len(), again: &[], columns }
    }
}

impl<'a> PartColumn<'a> {
    fn name(cell: impl Fn(usize) -> Option<ByteArray> + 'a) -> Self {
        Self::Name(Box::new(cell))
    }

    fn text(cell: impl Fn(usize) -> Option<ByteArray> + 'a) -> Self {
        Self::Text(Box::new(cell))
    }

    fn double(cell: impl Fn(usize) -> Option<f64> + 'a) -> Self {
        Self::Double(Box::new(cell))
    }

    fn whole(cell: impl Fn(usize) -> Option<i64> + 'a) -> Self {
        Self::Whole(Box::new(cell))
    }

    fn short(cell: impl Fn(usize) -> Option<i32> + 'a) -> Self {
        Self::Short(Box::new(cell))
    }

    /// Tells whether a cell is one that was read, bit for bit.
    pub(super) fn is_same(&self, row: usize, there: &ReadCells, place: usize) -> bool {
        match (self, there) {
            (Self::Name(cell) | Self::Text(cell), ReadCells::Text(there)) => {
                there.get(place) == Some(&cell(row))
            }
            (Self::Double(cell), ReadCells::Double(there)) => {
                let bits = |cell: &Option<f64>| cell.map(f64::to_bits);
                there.get(place).map(bits) == Some(bits(&cell(row)))
            }
            (Self::Whole(cell), ReadCells::Whole(there)) => there.get(place) == Some(&cell(row)),
            (Self::Short(cell), ReadCells::Short(there)) => there.get(place) == Some(&cell(row)),
            _ => false,
        }
    }
}
