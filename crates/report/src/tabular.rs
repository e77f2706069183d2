//! Rows in columns: CSV for programs and spreadsheets; tables for a paper are made of them.

use super::column::NamedColumn;
use super::record::{NOTE, Record};
use super::words::printable;
use std::borrow::Cow;
use std::io;

/// Rows of cells below the names of their columns.
#[derive(Debug, Default)]
pub struct Tabular {
    /// Names of the columns.
    pub header: Vec<String>,
    /// Cells of each row.
    pub rows: Vec<Vec<String>>,
}

impl Tabular {
    /// Cells of records in some columns, whose names are given in one text.
    pub fn of(columns: &str, records: impl IntoIterator<Item = Record>) -> Self {
        let records: Vec<Record> = records.into_iter().collect();
        // A note has a column where there is one.
        let has_note = records.iter().any(|record| record.names().any(|name| name == NOTE));
        let names = columns.split(' ').chain(has_note.then_some(NOTE));
        let header: Vec<String> = names.map(str::to_owned).collect();
        let cells = |record: Record| header.iter().map(|name| record.text(name)).collect();
        Self { rows: records.into_iter().map(cells).collect(), header }
    }

    /// All cells of records that have the same names.
    pub fn of_all(records: impl IntoIterator<Item = Record>) -> Self {
        let records: Vec<Record> = records.into_iter().collect();
        let names = |record: &Record| record.names().map(str::to_owned).collect();
        let header = records.first().map_or(Vec::new(), names);
        Self { header, rows: records.into_iter().map(|record| record.texts().collect()).collect() }
    }

    /// Cells that columns find in rows.
    pub fn of_columns<'a, R: 'a>(
        columns: impl Iterator<Item = &'a NamedColumn<R>> + Clone,
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        let header = columns.clone().map(|(name, _)| (*name).to_owned()).collect();
        let cells = |row| columns.clone().map(|(_, column)| column.text(&row)).collect();
        Self { header, rows: rows.into_iter().map(cells).collect() }
    }

    /// The columns that have a value in any row: another says nothing to a person.
    pub(super) fn without_empty(self) -> Self {
        let is_shown = |k: usize| self.rows.iter().any(|row| !row[k].is_empty());
        let shown: Vec<bool> = (0..self.header.len()).map(is_shown).collect();
        let of = |row: Vec<String>| {
            row.into_iter().zip(&shown).filter_map(|(cell, shown)| shown.then_some(cell)).collect()
        };
        Self { header: of(self.header), rows: self.rows.into_iter().map(of).collect() }
    }

    /// Writes CSV.
    pub(super) fn csv(&self, out: &mut dyn io::Write) -> io::Result<()> {
        self.separated(b',', |cell| cell.into(), out)
    }

    /// Writes CSV for a spreadsheet that has commas in its numbers: semicolons stand between the cells.
    pub(super) fn csv_with_commas(&self, out: &mut dyn io::Write) -> io::Result<()> {
        self.separated(b';', with_comma, out)
    }

    fn separated(
        &self,
        separator: u8,
        cell: fn(&str) -> Cow<'_, str>,
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        let mut csv = csv::WriterBuilder::new().delimiter(separator).from_writer(out);
        let mut records = std::iter::once(&self.header).chain(&self.rows);
        let escape = |c: char| c.escape_debug().to_string();
        let mut written = |record: &Vec<String>| {
            for text in record {
                csv.write_field(printable(&cell(text), escape).as_bytes())?;
            }
            csv.write_record(None::<&[u8]>)
        };
        records.try_for_each(&mut written).map_err(io_error)?;
        csv.flush()
    }
}

/// A cell, with a decimal comma if it is a number.
fn with_comma(cell: &str) -> Cow<'_, str> {
    if is_decimal(cell) { cell.replace('.', ",").into() } else { cell.into() }
}

/// Tells whether a cell is a decimal number: digits, a sign, a point, a power of ten.
fn is_decimal(cell: &str) -> bool {
    cell.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
        && cell.parse::<f64>().is_ok()
}

impl FromIterator<Self> for Tabular {
    fn from_iter<I: IntoIterator<Item = Self>>(all: I) -> Self {
        let mut whole = Self::default();
        for Self { header, rows } in all {
            whole.header = header;
            whole.rows.extend(rows);
        }
        whole
    }
}

/// The error of the stream itself: its kind tells a closed pipe from a full disk.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spreadsheet_with_commas_takes_every_number_and_nothing_else() {
        let row = [("of", "[r,r,s]"), ("x", "-1.5e-9"), ("arch", "pi/2"), ("n", "0.1")];
        let record: Record = row.into_iter().map(|(name, text)| (name, text.into())).collect();
        let table = Tabular::of("of x arch n none", [record]);
        let written = |write: fn(&Tabular, &mut dyn io::Write) -> io::Result<()>| {
            let mut out = Vec::new();
            write(&table, &mut out).unwrap();
            String::from_utf8(out).unwrap()
        };
        assert_eq!(
            written(Tabular::csv_with_commas),
            "of;x;arch;n;none\n[r,r,s];-1,5e-9;pi/2;0,1;\n"
        );
        assert_eq!(written(Tabular::csv), "of,x,arch,n,none\n\"[r,r,s]\",-1.5e-9,pi/2,0.1,\n");
    }
}
