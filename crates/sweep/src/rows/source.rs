//! Sources of rows: standard input or a file, as CSV or as JSON.

use crate::check::visible_name;
use crate::failure::Failure;
use std::fs::File;
use std::io::{self, BufRead, BufReader, IsTerminal};
use std::path::Path;

/// A row of the input: its line number, and its content or its error.
pub type Numbered<T> = (u64, Result<T, String>);

/// Bytes that are read on a thread of their own.
pub type Input = Box<dyn BufRead + Send>;

/// Syntax in which rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Syntax {
    /// A table with a header.
    Csv,
    /// JSON objects: one on each line, or in an array.
    Json,
}

impl Syntax {
    /// The name of the format of rows that has the same syntax.
    pub fn format(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "jsonl",
        }
    }
}

/// Rows from standard input or from a file.
pub struct RowSource {
    input: Input,
    /// Bytes in all, where that is known.
    pub length: Option<u64>,
    /// Syntax of the rows.
    pub syntax: Syntax,
    /// True if somebody types them.
    pub is_typed: bool,
}

impl RowSource {
    /// Standard input, or the file named; `-` is standard input too.
    pub fn open(path: Option<&Path>) -> Result<Self, Failure> {
        let path = path.filter(|path| *path != Path::new("-"));
        let name = path.map_or("standard input".into(), |path| visible_name(path.as_os_str()));
        let reading = |error: io::Error| Failure::reading(&name, &error);
        let is_typed = path.is_none() && io::stdin().is_terminal();
        let mut input: Input = match path {
            None => Box::new(BufReader::new(io::stdin())),
            Some(path) => Box::new(BufReader::new(File::open(path).map_err(reading)?)),
        };
        if is_typed && io::stderr().is_terminal() {
            eprintln!("couplet: waits for rows from standard input, which Ctrl-D ends");
        }
        let syntax = match first_character(&mut input).map_err(reading)? {
            Some(b'{' | b'[') => Syntax::Json,
            _ => Syntax::Csv,
        };
        let file = std::fs::metadata(path.unwrap_or(Path::new("/dev/stdin")));
        let length = file.ok().filter(|m| m.is_file()).map(|m| m.len());
        Ok(Self { input, length, syntax, is_typed })
    }

    /// The rows as bytes.
    pub fn into_input(self) -> Input {
        self.input
    }
}

/// Mark that some programs write before the text.
pub const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Skips a byte order mark and empty lines before the first row of JSON; in a table they count as lines.
/// Answers the first character of the text.
fn first_character(input: &mut Input) -> io::Result<Option<u8>> {
    if input.fill_buf()?.starts_with(BYTE_ORDER_MARK) {
        input.consume(BYTE_ORDER_MARK.len());
    }
    let buffer = input.fill_buf()?;
    Ok(buffer.iter().find(|c| !c.is_ascii_whitespace()).copied())
}
