//! Rows of a text, one at a time, each with the number of its line: those of a table with a header, or lines of JSON.

use super::dialect::{Dialect, QuoteState};
use super::lines::{InputLines, Reading};
use super::{Input, MAX_RECORD, Numbered};
use crate::failure::Failure;
use std::io;

/// Rows of a text, one after the other: of a table, or objects of JSON, one on each line.
pub struct TextRows {
    /// The names of the columns of a table.
    pub header: Vec<String>,
    lines: InputLines,
    /// Dialect of a table; lines of JSON have none.
    dialect: Option<Dialect>,
    /// True if lines that begin with `#` are remarks, as before the header.
    has_remarks: bool,
    is_broken: bool,
    /// Places of the fields that are read, if not all are.
    read: Option<Vec<usize>>,
}

/// A row as it is written.
struct RawRecord {
    bytes: Vec<u8>,
    /// The number of its first line.
    line: u64,
    /// The ends of its lines.
    ends: Vec<usize>,
}

impl RawRecord {
    /// Gives back what is read behind one of its lines: a quote too many has swallowed it.
    fn give_back(&self, lines: &mut InputLines, line: u64) {
        let swallowed = &self.bytes[self.ends[(line - self.line) as usize]..];
        // What is given back moves all that was given back before.
        if !swallowed.is_empty() {
            lines.give_back(swallowed, line + 1);
        }
    }
}

/// Quotes of a row, as far as it has been read.
struct Quotes {
    state: QuoteState,
    /// The line in which the last of them opens.
    opened: u64,
    /// True if one closes within a field.
    is_spoiled: bool,
}

impl Quotes {
    /// Goes past a line of the row. Without a quote it neither opens a field that goes on nor spoils the row, and most
    /// lines have none.
    fn pass(&mut self, text: &[u8], line: u64, separators: &[u8]) {
        let is_plain = self.state == QuoteState::Start && !text.contains(&b'"');
        for &c in text.iter().filter(|_| !is_plain) {
            match (self.state, self.state.pass(c, separators)) {
                (QuoteState::Start, QuoteState::Quoted) => self.opened = line,
                (QuoteState::Closing, QuoteState::Field) => {
                    self.is_spoiled |= !c.is_ascii_whitespace()
                }
                _ => {}
            }
        }
    }
}

/// Marks after which a field of a header may begin before it is known what separates them.
const SEPARATORS: &[u8] = b",;\t";

impl TextRows {
    /// Reads the header. It is the first line, or the last of the remarks (`# alpha mu eta`) if a row of
    /// numbers with as many fields follows, as NumPy writes.
    pub fn open(mut input: Input) -> Result<Self, Failure> {
        // A unit of UTF-16 has two bytes, one of which is zero in most letters.
        if let Ok([0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] | [0, _, ..] | [_, 0, ..]) = input.fill_buf()
        {
            let message =
                "the file is UTF-16, which is not read: save it as UTF-8 (\"CSV UTF-8\" in Excel)";
            return Err(Failure::Input(message.to_owned()));
        }
        let mut separator = None;
        let mut lines = InputLines::new(input, 1);
        let mut remark: Option<RawRecord> = None;
        let failed = |error: String| Failure::Input(format!("the header: {error}"));
        let first = loop {
            let record =
                next(&mut lines, Some(SEPARATORS)).map_err(|error| failed(error.to_string()))?;
            match record.transpose().map_err(failed)? {
                None => break None,
                Some(record) if is_remark(&record.bytes) => remark = Some(record),
                Some(record) if is_blank(&record.bytes) => {}
                Some(record) if separator.is_none() && separator_of(&record.bytes).is_some() => {
                    separator = separator_of(&record.bytes);
                }
                Some(record) => break Some(record),
            }
        };
        let has_remarks = remark.is_some();
        let names = remark.map(|record| {
            let start = record.bytes.iter().position(|&c| c == b'#').map_or(0, |place| place + 1);
            record.bytes[start..].trim_ascii_start().to_owned()
        });
        let bytes = match (names, first) {
            (Some(names), Some(row)) if is_header_of(&names, &row.bytes) => {
                lines.give_back(&row.bytes, row.line);
                names
            }
            (_, Some(row)) => row.bytes,
            (Some(names), None) => names,
            (None, None) => return Err(Failure::Input("the file is empty".to_owned())),
        };
        let dialect = separator.map_or_else(|| Dialect::of(&bytes), Dialect::Separated);
        // A name that nobody reads may have any encoding.
        let bytes = String::from_utf8_lossy(&bytes);
        let header = dialect.fields(bytes.as_bytes(), |_| true).map_err(failed)?;
        let dialect = Some(dialect);
        Ok(Self { header, lines, dialect, has_remarks, is_broken: false, read: None })
    }

    /// Objects of JSON, one on each line, of which the first has this number.
    pub fn of_objects(input: Input, line: u64) -> Self {
        Self::of_lines(InputLines::new(input, line))
    }

    /// Objects of JSON on some lines.
    pub(super) fn of_lines(lines: InputLines) -> Self {
        let (header, dialect, has_remarks) = (Vec::new(), None, false);
        Self { header, lines, dialect, has_remarks, is_broken: false, read: None }
    }

    /// Tells whether they are the rows of a table.
    pub fn is_table(&self) -> bool {
        self.dialect.is_some()
    }

    /// The rows as they are written.
    pub fn into_bytes(mut self) -> impl Iterator<Item = Numbered<Vec<u8>>> {
        std::iter::from_fn(move || {
            let (line, record) = self.record()?;
            Some((line, record.map(|record| record.bytes)))
        })
    }

    /// Reads the fields of these places alone.
    pub fn read_only(&mut self, places: impl IntoIterator<Item = usize>) {
        self.read = Some(places.into_iter().collect());
    }

    /// Table with the same header over rows of another input, of which the first line has this number.
    pub fn with_rows(self, input: Input, line: u64) -> Self {
        Self { lines: InputLines::new(input, line), is_broken: false, ..self }
    }

    /// Begins a piece with the next row: the number of its first line, and where that begins (bytes).
    pub fn begin(&mut self) -> (u64, u64) {
        self.lines.begin()
    }

    /// End of the bytes that were looked at since the beginning or that of a piece (bytes). It alone decides
    /// what the rows of the piece are, and may be more than they are: a quote that is not closed is looked
    /// for far beyond.
    pub fn looked(&self) -> u64 {
        self.lines.looked
    }

    /// Tells whether numbers may have a decimal comma: where a semicolon separates.
    pub fn has_decimal_commas(&self) -> bool {
        self.dialect == Some(Dialect::Separated(b';'))
    }

    /// The next row as it is written, or why it cannot be read, with its line.
    fn record(&mut self) -> Option<Numbered<RawRecord>> {
        while !self.is_broken {
            let line = self.lines.number;
            match next(&mut self.lines, self.dialect.as_ref().map(Dialect::separators)) {
                Ok(Some(Ok(record))) if is_blank(&record.bytes) => {}
                Ok(Some(Ok(record))) if self.has_remarks && is_remark(&record.bytes) => {}
                Ok(record) => return record.map(|record| (line, record)),
                Err(error) => {
                    self.is_broken = true;
                    return Some((line, Err(error.to_string())));
                }
            }
        }
        None
    }

    /// Goes past the next row and answers its line. The fields of a row of one line are not looked for: they do not
    /// change where the next one begins.
    pub fn pass(&mut self) -> Option<u64> {
        let (line, record) = self.record()?;
        if let Some(record) = record.ok().filter(|record| record.ends.len() > 1) {
            // Whether they are a row decides what is read again.
            let _ = self.fields(&record);
        }
        Some(line)
    }

    /// The fields of a row, as many as the header has. What is read over several lines and makes no row is
    /// given back but for its first line: a quote too many has swallowed the others.
    fn fields(&mut self, record: &RawRecord) -> Result<Vec<String>, String> {
        let (width, count) = (self.header.len(), record.ends.len());
        let is_read = |place: usize| self.read.as_ref().is_none_or(|read| read.contains(&place));
        let Some(dialect) = self.dialect else { return Ok(Vec::new()) };
        let fields = dialect.fields(&record.bytes, is_read);
        if fields.as_ref().is_ok_and(|fields| fields.len() == width) {
            return fields;
        }
        record.give_back(&mut self.lines, record.line);
        let why = match count {
            1 => "; a field with commas has to be quoted".to_owned(),
            _ => format!(", up to a quote that closes in line {}", record.line + count as u64 - 1),
        };
        Err(format!("{} fields where the header has {width}{why}", fields?.len()))
    }
}

impl Iterator for TextRows {
    type Item = Numbered<Vec<String>>;

    fn next(&mut self) -> Option<Self::Item> {
        let (line, record) = self.record()?;
        Some((line, record.and_then(|record| self.fields(&record))))
    }
}

/// Separator that a first line says, as Excel writes it: `sep=;`.
fn separator_of(bytes: &[u8]) -> Option<u8> {
    let line = bytes.trim_ascii();
    let line = line.strip_prefix(b"\"").and_then(|rest| rest.strip_suffix(b"\"")).unwrap_or(line);
    match line {
        [name @ .., b'=', separator] if name.eq_ignore_ascii_case(b"sep") => Some(*separator),
        // A tab is a blank at the end.
        name if name.eq_ignore_ascii_case(b"sep=") => Some(b'\t'),
        _ => None,
    }
}

fn is_blank(bytes: &[u8]) -> bool {
    bytes.iter().all(u8::is_ascii_whitespace)
}

fn is_remark(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().starts_with(b"#")
}

/// Tells whether a remark names the fields of a row of numbers.
fn is_header_of(remark: &[u8], row: &[u8]) -> bool {
    let dialect = Dialect::of(remark);
    let (Ok(names), Ok(row)) = (dialect.fields(remark, |_| true), dialect.fields(row, |_| true))
    else {
        return false;
    };
    let is_number =
        |field: &String| field.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    names.len() == row.len() && row.iter().any(is_number)
}

/// The next row as it is written, or why it cannot be read. Behind an error of the input there is no other. Without
/// separators each line is a row, whatever quotes it has.
fn next(
    lines: &mut InputLines,
    separators: Option<&[u8]>,
) -> io::Result<Option<Result<RawRecord, String>>> {
    let first = lines.number;
    let fault = |message: String| Ok(Some(Err(message)));
    let mut record = RawRecord { bytes: Vec::new(), line: first, ends: Vec::new() };
    let mut quotes = Quotes { state: QuoteState::Start, opened: first, is_spoiled: false };
    loop {
        let (line, passed) = (lines.number, record.bytes.len());
        match lines.next_into(&mut record.bytes)? {
            Reading::Line => {}
            Reading::End if record.bytes.is_empty() => return Ok(None),
            Reading::TooLong if record.ends.is_empty() => {
                lines.skip()?;
                return fault(format!("a line of more than {MAX_RECORD} bytes"));
            }
            reading => {
                // What has been read of the line that is too long is held in the record.
                let within = match reading {
                    Reading::TooLong => format!(" within {MAX_RECORD} bytes"),
                    _ => String::new(),
                };
                record.give_back(lines, quotes.opened);
                return fault(format!(
                    "the quote that opens in line {} is not closed{within}",
                    quotes.opened
                ));
            }
        }
        record.ends.push(record.bytes.len());
        if let Some(separators) = separators {
            quotes.pass(&record.bytes[passed..], line, separators);
        }
        if quotes.is_spoiled {
            record.give_back(lines, first);
            return fault(format!(
                "a quote that opens in line {} closes within a field",
                quotes.opened
            ));
        }
        if quotes.state != QuoteState::Quoted {
            return Ok(Some(Ok(record)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{BufReader, Read};

    fn table(input: impl Read + Send + 'static) -> TextRows {
        TextRows::open(Box::new(BufReader::new(input))).unwrap()
    }

    fn rows(text: &str) -> Vec<(u64, String)> {
        let shown = |row: Result<Vec<String>, String>| {
            row.map_or_else(|error| format!("! {error}"), |fields| fields.join("|"))
        };
        let table = table(io::Cursor::new(text.to_owned()));
        table.map(|(line, row)| (line, shown(row))).collect()
    }

    fn row(line: u64, text: &str) -> (u64, String) {
        (line, text.to_owned())
    }

    proptest::proptest! {
        #![proptest_config(crate::number::test_config::config(256))]
        /// A reader that goes past rows finds them at the lines of one that reads them.
        #[test]
        fn rows_that_are_passed_are_those_that_are_read(text in "[a\"\n,]{0,24}") {
            let open = || table(io::Cursor::new("a,b\n".to_owned() + &text));
            let mut passed = open();
            let passed: Vec<u64> = std::iter::from_fn(|| passed.pass()).collect();
            proptest::prop_assert_eq!(passed, open().map(|(line, _)| line).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_row_may_have_several_lines() {
        let found = rows("a,b\n\n1,\"x\ny\"\n  \n2,z\n");
        assert_eq!(found, [row(3, "1|x\ny"), row(6, "2|z")]);
    }

    #[test]
    fn a_quote_that_is_not_closed_costs_one_row() {
        let found = rows("a,b\n1,2\n3,\"4\n5,6\n7,8\n");
        let error = "! the quote that opens in line 3 is not closed";
        assert_eq!(found, [row(2, "1|2"), row(3, error), row(4, "5|6"), row(5, "7|8")]);
        let long = format!("a,b\n1,\"x\ny\"\n3,\"4\n{}", "5,6\n".repeat(MAX_RECORD / 2));
        let found = rows(&long);
        assert_eq!(found.len(), MAX_RECORD / 2 + 2);
        let error = "! the quote that opens in line 4 is not closed within 524288 bytes";
        assert_eq!(found[..3], [row(2, "1|x\ny"), row(4, error), row(5, "5|6")]);
    }

    #[test]
    fn a_quote_that_closes_too_late_costs_one_row() {
        let found = rows("a,b\n1,\"2\n3,4\n5,\"6\"\n7,8\n");
        let error = "! a quote that opens in line 2 closes within a field";
        assert_eq!(found, [row(2, error), row(3, "3|4"), row(4, "5|6"), row(5, "7|8")]);
        let found = rows("a,b\n1,\"2\n3,4\n\",6,8\n7,8\n");
        let error = "! 4 fields where the header has 2, up to a quote that closes in line 4";
        assert_eq!(found[..2], [row(2, error), row(3, "3|4")]);
        assert_eq!(found.last(), Some(&row(5, "7|8")));
    }

    #[test]
    fn a_line_without_end_costs_one_row() {
        let long = format!("a,b\n1,2\n{}\n3,4\n", "x".repeat(3 * MAX_RECORD));
        let error = "! a line of more than 524288 bytes";
        assert_eq!(rows(&long), [row(2, "1|2"), row(3, error), row(4, "3|4")]);
        let endless = io::Cursor::new("a,b\n1,2\n").chain(io::repeat(b'x').take(1 << 24));
        assert_eq!(table(endless).count(), 2);
        let header = Box::new(BufReader::new(io::repeat(b'a').take(1 << 24)));
        assert!(TextRows::open(header).is_err(), "nor is a header without end");
    }

    #[test]
    fn a_file_without_a_header_is_empty() {
        for file in ["", "\n\r\n", " \n"] {
            let Err(Failure::Input(message)) = TextRows::open(Box::new(io::Cursor::new(file)))
            else {
                panic!("{file:?}")
            };
            assert_eq!(message, "the file is empty");
        }
    }

    #[test]
    fn what_is_no_text_is_told_by_its_field() {
        let header = table(io::Cursor::new(&b"a,alpha [\xB0]\n"[..])).header;
        assert_eq!(header, ["a", "alpha [\u{FFFD}]"], "a name that nobody reads may be anything");
        let mut rows = table(io::Cursor::new(&b"a,b\n1,2\n\xFF,1\n"[..]));
        assert!(rows.next().unwrap().1.is_ok());
        assert_eq!(rows.next(), Some((3, Err("field 1 is not valid UTF-8".to_owned()))));
    }

    #[test]
    fn remarks_name_columns_where_numbers_follow() {
        let header = |text: &str| table(io::Cursor::new(text.to_owned())).header;
        assert_eq!(header("# made by hand\n# alpha mu\n1.0 2.0\n"), ["alpha", "mu"]);
        assert_eq!(rows("# made by hand\n# alpha mu\n1.0  2.0\n# end\n"), [row(3, "1.0|2.0")]);
        assert_eq!(header("# one, two\nalpha,mu\n1,2\n"), ["alpha", "mu"]);
        assert_eq!(header("#alpha;mu\n1,5;2\n"), ["alpha", "mu"]);
        assert_eq!(rows("alpha,mu\n#1,2\n"), [row(2, "#1|2")], "no remark where none came before");
    }
}
