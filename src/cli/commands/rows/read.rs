//! CSV with a header, or JSON lines: one row at a time, each with the number of its line.

use crate::cli::failure::Failure;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

/// A row of the input: its line number, and its content or its error.
pub(crate) type Line<T> = (u64, Result<T, String>);

/// What the rows are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Syntax {
    /// CSV with a header.
    Csv,
    /// A JSON object on each line.
    JsonLines,
}

impl Syntax {
    /// The name of the format that has the same syntax.
    pub(crate) fn format(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::JsonLines => "jsonl",
        }
    }
}

/// Rows from standard input or from a file.
pub(crate) struct Source {
    input: Box<dyn BufRead>,
    /// Bytes in all, where that is known.
    pub length: Option<u64>,
    /// What the rows are written in.
    pub syntax: Syntax,
}

impl Source {
    /// Standard input, or the file named; `-` is standard input too.
    pub(crate) fn open(path: Option<&Path>) -> Result<Self, Failure> {
        let path = path.filter(|path| *path != Path::new("-"));
        let name = path.map_or("standard input".into(), |path| path.display().to_string());
        let reading = |error: io::Error| Failure::reading(&name, &error);
        let mut input: Box<dyn BufRead> = match path {
            None => Box::new(BufReader::new(io::stdin())),
            Some(path) => Box::new(BufReader::new(File::open(path).map_err(reading)?)),
        };
        let file = std::fs::metadata(path.unwrap_or(Path::new("/dev/stdin")));
        let length = file.ok().filter(|m| m.is_file()).map(|m| m.len());
        let syntax = match first_character(&mut input).map_err(reading)? {
            Some(b'{') => Syntax::JsonLines,
            Some(b'[') => {
                let message =
                    "JSON arrays are not supported: give JSON lines, one object on each line";
                return Err(Failure::Input(message.into()));
            }
            _ => Syntax::Csv,
        };
        Ok(Self { input, length, syntax })
    }

    /// The rows as bytes.
    pub(crate) fn into_reader(self) -> impl Read + 'static {
        self.input
    }
}

/// What some programs write before the text.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// The first character that is neither white space nor a byte order mark, which is left unread.
fn first_character(input: &mut impl BufRead) -> io::Result<Option<u8>> {
    loop {
        let buffer = input.fill_buf()?;
        if buffer.is_empty() {
            return Ok(None);
        }
        let skipped = |c: &u8| c.is_ascii_whitespace() || BYTE_ORDER_MARK.contains(c);
        match buffer.iter().position(|c| !skipped(c)) {
            Some(place) => return Ok(Some(buffer[place])),
            None => {
                let length = buffer.len();
                input.consume(length);
            }
        }
    }
}

/// Lines longer than this are refused one by one; nothing that is read needs as much.
const MAX_LINE: u64 = 1 << 17;

/// The rows of JSON lines, each read by `parse`. An error of the stream itself ends them.
pub(crate) fn json_lines<T>(
    input: impl Read,
    parse: impl Fn(&[u8]) -> Result<T, String>,
) -> impl Iterator<Item = Line<T>> {
    let mut input = BufReader::new(input);
    let (mut number, mut broken) = (0, false);
    std::iter::from_fn(move || {
        while !broken {
            let mut bytes = Vec::new();
            number += 1;
            let read = input.by_ref().take(MAX_LINE).read_until(b'\n', &mut bytes);
            match read {
                Ok(0) => return None,
                Err(error) => {
                    broken = true;
                    return Some((number, Err(error.to_string())));
                }
                Ok(_) if bytes.len() as u64 == MAX_LINE && bytes.last() != Some(&b'\n') => {
                    // The rest of the line is skipped in pieces, never held.
                    skip_line(&mut input);
                    return Some((number, Err(format!("a line of more than {MAX_LINE} bytes"))));
                }
                Ok(_) if bytes.iter().all(u8::is_ascii_whitespace) => {}
                Ok(_) => {
                    let marked = bytes.strip_prefix(BYTE_ORDER_MARK).filter(|_| number == 1);
                    return Some((number, parse(marked.unwrap_or(&bytes))));
                }
            }
        }
        None
    })
}

fn skip_line(input: &mut impl BufRead) {
    while let Ok(buffer) = input.fill_buf() {
        if buffer.is_empty() {
            return;
        }
        let (length, ends) = match buffer.iter().position(|&c| c == b'\n') {
            Some(place) => (place + 1, true),
            None => (buffer.len(), false),
        };
        input.consume(length);
        if ends {
            return;
        }
    }
}

/// The most bytes of a line of CSV: one without end would fill the memory.
const MAX_RECORD: usize = 1 << 24;

/// A stream that fails in a line without end, and ends there.
struct Lines<R> {
    inner: R,
    /// Bytes since the last end of a line.
    length: usize,
}

impl<R: Read> Read for Lines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.length > MAX_RECORD {
            return Ok(0);
        }
        let read = self.inner.read(buffer)?;
        self.length = match buffer[..read].iter().rposition(|&c| c == b'\n') {
            Some(end) => read - end - 1,
            None => self.length + read,
        };
        if self.length > MAX_RECORD {
            let message = format!("a line of more than {MAX_RECORD} bytes; reading stops there");
            return Err(io::Error::other(message));
        }
        Ok(read)
    }
}

/// The error of a row of CSV.
fn csv_error(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Utf8 { err, .. } => {
            format!("field {} is not valid UTF-8", err.field() + 1)
        }
        _ => error.to_string(),
    }
}

/// The header of a CSV file, and its rows.
pub(crate) fn csv_records(
    input: impl Read + 'static,
) -> Result<(csv::StringRecord, impl Iterator<Item = Line<csv::StringRecord>>), Failure> {
    // A carriage return before the end of a line is trimmed away like a space; as a terminator of its
    // own it would make the numbers of the lines one too small.
    let mut reader = csv::ReaderBuilder::new()
        .flexible(true)
        .trim(csv::Trim::All)
        .terminator(csv::Terminator::Any(b'\n'))
        .from_reader(Lines { inner: input, length: 0 });
    let header = reader
        .headers()
        .map_err(|error| Failure::Input(format!("the header: {}", csv_error(&error))))?
        .clone();
    let columns = header.len();
    let rows = reader.into_records().filter_map(move |record| match record {
        Err(error) => {
            let line = error.position().map_or(0, csv::Position::line);
            Some((line, Err(csv_error(&error))))
        }
        // A line of white space.
        Ok(record) if columns > 1 && record.len() == 1 && record[0].is_empty() => None,
        Ok(record) => Some((record.position().map_or(0, csv::Position::line), Ok(record))),
    });
    Ok((header, rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_without_end_ends_the_rows() {
        let rows = |input: Box<dyn Read>| -> Vec<_> {
            let (header, rows) = csv_records(input).unwrap();
            assert_eq!(header.len(), 2);
            rows.collect()
        };
        let found = rows(Box::new(b"a,b\n1,2\n".chain(io::repeat(b'x'))));
        assert_eq!(found.len(), 2);
        assert!(found[0].1.is_ok());
        assert!(found[1].1.as_ref().unwrap_err().contains("more than 16777216 bytes"), "{found:?}");
        // Many short lines are fine.
        let many = Box::new(io::Cursor::new("a,b\n".repeat(MAX_RECORD / 3)));
        assert_eq!(rows(many).iter().filter(|(_, row)| row.is_ok()).count(), MAX_RECORD / 3 - 1);
        assert!(csv_records(io::repeat(b'a')).is_err(), "nor is a header without end");
    }

    #[test]
    fn what_is_no_text_is_told_by_its_field() {
        let Err(Failure::Input(message)) = csv_records(&b"a,alpha [\xB0]\n"[..]) else { panic!() };
        assert_eq!(message, "the header: field 2 is not valid UTF-8");
        let (_, mut rows) = csv_records(&b"a,b\n1,2\n\xFF,1\n"[..]).unwrap();
        assert!(rows.next().unwrap().1.is_ok());
        assert_eq!(rows.next(), Some((3, Err("field 1 is not valid UTF-8".to_owned()))));
    }
}
