//! Rows in columns: CSV for programs and spreadsheets; tables for a paper are made of them.

use super::column::NamedColumn;
use super::record::{NOTE, Record};
use super::words::printable;
use std::borrow::Cow;
use std::{io, iter};

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

    /// Writes the table.
    pub(super) fn write(&self, separated: Separated, out: &mut dyn io::Write) -> io::Result<()> {
        out.write_all(&separated.lines(|lines| {
            iter::once(&self.header).chain(&self.rows).try_for_each(|row| lines.all(row))
        })?)
    }
}

/// Sign between the cells of a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Separated {
    /// A comma: for programs.
    Comma,
    /// A semicolon: for a spreadsheet that has commas in its numbers.
    Semicolon,
}

/// Lines of cells.
pub(super) struct Lines {
    csv: csv::Writer<Vec<u8>>,
    separated: Separated,
}

impl Separated {
    /// The bytes of some lines.
    pub(super) fn lines(
        self,
        write: impl FnOnce(&mut Lines) -> csv::Result<()>,
    ) -> io::Result<Vec<u8>> {
        let separator = match self {
            Self::Comma => b',',
            Self::Semicolon => b';',
        };
        // Often of one line, for which the usual buffer is long.
        let mut csv = csv::WriterBuilder::new();
        let csv = csv.delimiter(separator).buffer_capacity(1 << 10).from_writer(Vec::new());
        let mut lines = Lines { csv, separated: self };
        write(&mut lines).map_err(io_error)?;
        lines.csv.into_inner().map_err(|error| error.into_error())
    }
}

impl Lines {
    /// Adds a cell.
    pub(super) fn cell(&mut self, text: &str) -> csv::Result<()> {
        let text = match self.separated {
            Separated::Comma => text.into(),
            Separated::Semicolon => with_comma(text),
        };
        self.csv.write_field(printable(&text, |c| c.escape_debug().to_string()).as_bytes())
    }

    /// Adds what columns find in a row, or an empty cell for each.
    pub(super) fn found<'a, R: 'a>(
        &mut self,
        mut columns: impl Iterator<Item = &'a NamedColumn<R>>,
        row: Option<&R>,
    ) -> csv::Result<()> {
        let mut text = String::new();
        columns.try_for_each(|(_, column)| {
            text.clear();
            row.into_iter().for_each(|row| column.write(row, &mut text));
            self.cell(&text)
        })
    }

    /// Ends a line.
    pub(super) fn end(&mut self) -> csv::Result<()> {
        self.csv.write_record(None::<&[u8]>)
    }

    /// Adds a line.
    pub(super) fn all(&mut self, cells: impl IntoIterator<Item: AsRef<str>>) -> csv::Result<()> {
        cells.into_iter().try_for_each(|cell| self.cell(cell.as_ref()))?;
        self.end()
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
        let written = |separated: Separated| {
            let mut out = Vec::new();
            table.write(separated, &mut out).unwrap();
            String::from_utf8(out).unwrap()
        };
        assert_eq!(written(Separated::Semicolon), "of;x;arch;n;none\n[r,r,s];-1,5e-9;pi/2;0,1;\n");
        assert_eq!(written(Separated::Comma), "of,x,arch,n,none\n\"[r,r,s]\",-1.5e-9,pi/2,0.1,\n");
    }
}
