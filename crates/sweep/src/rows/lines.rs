//! Lines of bounded length, of which some can be given back.

use super::{Input, MAX_RECORD};
use std::io::{self, BufRead};

/// The lines of an input, with their numbers.
pub(super) struct InputLines {
    input: Input,
    /// Bytes that were given back, and how many of them are read again.
    back: Vec<u8>,
    read: usize,
    /// The number of the next line.
    pub number: u64,
    /// Offset where the next line begins, in bytes from the beginning.
    pub offset: u64,
    /// The end of what was looked at, which may have been given back.
    pub looked: u64,
}

/// Result of reading a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reading {
    /// The line is there, with its end unless it is the last.
    Line,
    /// The line would make the record too long; a part of it is there.
    TooLong,
    /// There are no more lines.
    End,
}

impl InputLines {
    /// The lines of an input, of which the first has this number.
    pub(super) fn new(input: Input, number: u64) -> Self {
        Self { input, back: Vec::new(), read: 0, number, offset: 0, looked: 0 }
    }

    /// Begins a piece with the next line: its number, and where it begins (bytes).
    pub(super) fn begin(&mut self) -> (u64, u64) {
        self.looked = self.offset;
        (self.number, self.offset)
    }

    /// Adds the next line to a record, as long as that is not too long.
    pub(super) fn next_into(&mut self, record: &mut Vec<u8>) -> io::Result<Reading> {
        let before = record.len();
        loop {
            let buffer = self.buffer()?;
            if buffer.is_empty() {
                let last = record.len() > before;
                self.number += u64::from(last);
                return Ok(if last { Reading::Line } else { Reading::End });
            }
            let (length, ends) = first_line(buffer);
            if record.len() + length > MAX_RECORD {
                self.looked = self.looked.max(self.offset + length as u64);
                return Ok(Reading::TooLong);
            }
            record.extend_from_slice(&buffer[..length]);
            self.consume(length);
            if ends {
                self.number += 1;
                return Ok(Reading::Line);
            }
        }
    }

    /// Skips the rest of a line in pieces, never held.
    pub(super) fn skip(&mut self) -> io::Result<()> {
        self.number += 1;
        loop {
            let buffer = self.buffer()?;
            let ((length, ends), is_over) = (first_line(buffer), buffer.is_empty());
            self.consume(length);
            if ends || is_over {
                return Ok(());
            }
        }
    }

    /// Gives bytes back, to be read again as lines from `number` on.
    pub(super) fn give_back(&mut self, bytes: &[u8], number: u64) {
        self.back.splice(..self.read, bytes.iter().copied());
        (self.read, self.number) = (0, number);
        self.offset -= bytes.len() as u64;
    }

    /// Rest that is not read yet, and how many lines were.
    pub(super) fn into_rest(self) -> (impl BufRead + Send, u64) {
        let back = io::Cursor::new(self.back[self.read..].to_vec());
        (io::Read::chain(back, self.input), self.number)
    }

    fn buffer(&mut self) -> io::Result<&[u8]> {
        match self.back.get(self.read..) {
            Some(back) if !back.is_empty() => Ok(back),
            _ => self.input.fill_buf(),
        }
    }

    fn consume(&mut self, length: usize) {
        self.offset += length as u64;
        self.looked = self.looked.max(self.offset);
        if self.read < self.back.len() {
            self.read += length;
        } else {
            (self.back, self.read) = (Vec::new(), 0);
            self.input.consume(length);
        }
    }
}

/// The length of the first line with its end, and whether it ends.
fn first_line(buffer: &[u8]) -> (usize, bool) {
    match buffer.iter().position(|&c| c == b'\n') {
        Some(place) => (place + 1, true),
        None => (buffer.len(), false),
    }
}
