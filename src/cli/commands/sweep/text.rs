//! Pieces of a table of text.

use super::pieces::{CHANGED, bytes_of, columns, hash_of, hash_of_pieces};
use super::query::Listed;
use crate::arch::SelfWeight;
use crate::cli::commands::rows::{Cells, Reader, Spelling, Table};
use crate::cli::failure::reason;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Seek, SeekFrom};
use std::mem;
use std::path::Path;

/// What stands before every piece when it is read: the header, and where a remark is the header the first row, which
/// tells that it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Head {
    offset: u64,
    bytes: u64,
    /// Its lines, and how many rows are among them.
    lines: u64,
    rows: usize,
    sha256: String,
}

/// A piece.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TextSlice {
    pub rows: u64,
    /// The number of its first line, from 1.
    line: u64,
    offset: u64,
    bytes: u64,
    sha256: String,
}

/// What some programs write before the text.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Where the text of a file begins.
fn start(file: &mut File) -> io::Result<u64> {
    let mark = bytes_of(file, 0, BYTE_ORDER_MARK.len() as u64)?;
    Ok(if mark == BYTE_ORDER_MARK { mark.len() as u64 } else { 0 })
}

/// The pieces of a file, with at most so many rows each; or what is wrong with the file.
pub(super) fn slices(path: &Path, rows: u64) -> Result<(Head, Vec<TextSlice>), String> {
    let read = |error: io::Error| reason(&error);
    let mut file = File::open(path).map_err(read)?;
    let start = start(&mut file).map_err(read)?;
    file.seek(SeekFrom::Start(start)).map_err(read)?;
    let mut input = BufReader::new(file.try_clone().map_err(read)?);
    let first = input.fill_buf().map_err(read)?.trim_ascii_start().first();
    if matches!(first, Some(b'{' | b'[')) {
        return Err("it is JSON; a sweep reads tables of text and Parquet".into());
    }
    let mut table = Table::open(Box::new(input)).map_err(|error| error.to_string())?;
    columns(&table.header)?;
    // The lines at which the pieces begin, and their rows.
    let mut pieces: Vec<(u64, u64)> = Vec::new();
    let mut head = None;
    let mut next = None;
    while let Some(line) = table.pass() {
        let first = *next.get_or_insert(line);
        match pieces.last_mut() {
            Some((_, count)) if *count < rows => *count += 1,
            _ => pieces.push((first, 1)),
        }
        head.get_or_insert_with(|| match table.has_remarks() {
            true => (table.next_line(), 1),
            false => (line, 0),
        });
        next = Some(table.next_line());
    }
    let (head_end, head_rows) = head.unwrap_or((1, 0));
    let lines: Vec<u64> = pieces.iter().map(|(line, _)| *line).chain([head_end]).collect();
    let (offsets, end) = offsets(&mut file, start, &lines).map_err(read)?;
    let head_bytes = offsets[pieces.len()] - start;
    let head = Head {
        offset: start,
        bytes: head_bytes,
        lines: head_end - 1,
        rows: head_rows,
        sha256: hash_of_pieces(&mut file, &[(start, head_bytes)]).map_err(read)?,
    };
    let ends = offsets[..pieces.len()].iter().copied().skip(1).chain([end]);
    let slices = pieces.iter().zip(&offsets).zip(ends).map(|((&(line, rows), &offset), end)| {
        let bytes = end - offset;
        let sha256 = hash_of_pieces(&mut file, &[(offset, bytes)])?;
        Ok(TextSlice { rows, line, offset, bytes, sha256 })
    });
    Ok((head, slices.collect::<io::Result<_>>().map_err(read)?))
}

/// Where lines begin, and where the file ends; the first line begins at `start`.
fn offsets(file: &mut File, start: u64, lines: &[u64]) -> io::Result<(Vec<u64>, u64)> {
    file.seek(SeekFrom::Start(start))?;
    let mut input = BufReader::new(file);
    let mut found = vec![start; lines.len()];
    // In the order of the file.
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by_key(|&place| lines[place]);
    let mut order = order.into_iter().skip_while(|&place| lines[place] <= 1).peekable();
    let (mut line, mut offset) = (1, start);
    loop {
        let buffer = input.fill_buf()?;
        if buffer.is_empty() {
            // A line that begins where the file ends.
            order.for_each(|place| found[place] = offset);
            return Ok((found, offset));
        }
        for (place, _) in buffer.iter().enumerate().filter(|(_, c)| **c == b'\n') {
            line += 1;
            while let Some(of) = order.next_if(|&of| lines[of] == line) {
                found[of] = offset + place as u64 + 1;
            }
        }
        let length = buffer.len();
        offset += length as u64;
        input.consume(length);
    }
}

/// The rows of a piece, and their lines.
pub(super) fn read(
    path: &Path,
    head: &Head,
    slice: &TextSlice,
    weight: SelfWeight,
) -> Result<(Vec<u64>, Listed), String> {
    let read = |error: io::Error| reason(&error);
    let mut file = File::open(path).map_err(read)?;
    let mut bytes = bytes_of(&mut file, head.offset, head.bytes).map_err(read)?;
    let rows = bytes_of(&mut file, slice.offset, slice.bytes).map_err(read)?;
    if hash_of(&bytes) != head.sha256 || hash_of(&rows) != slice.sha256 {
        return Err(CHANGED.into());
    }
    bytes.extend(rows);
    let table = Table::open(Box::new(Cursor::new(bytes))).map_err(|error| error.to_string())?;
    let (columns, places) = columns(&table.header)?;
    let spelling = Spelling { decimal_comma: table.has_decimal_commas() };
    let reader = Reader { columns, weight, doubles: false, spelling };
    let (mut lines, mut listed) = (Vec::new(), Listed::default());
    for (line, row) in table.skip(head.rows) {
        lines.push(line - head.lines - 1 + slice.line);
        match row {
            Ok(mut fields) => {
                let cells: Cells =
                    places.iter().map(|&place| fields.get_mut(place).map(mem::take)).collect();
                listed.push_row(&reader, &cells);
            }
            Err(error) => listed.refuse(&Default::default(), error),
        }
    }
    Ok((lines, listed))
}
