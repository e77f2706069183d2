//! JSON objects: one on each line, in an array, or in the document that `couplet run` writes.

use super::csv::TextRows;
use super::lines::{InputLines, Reading};
use super::{Input, MAX_RECORD, Numbered};
use serde_json::error::Category;
use serde_json::value::RawValue;
use std::io::BufRead;

/// The objects of JSON, as they are written.
pub(super) fn objects(input: Input) -> Box<dyn Iterator<Item = Numbered<Vec<u8>>> + Send> {
    let (lines, on_lines) = begun(input);
    if on_lines {
        return Box::new(TextRows::of_lines(lines).into_bytes());
    }
    let (input, line) = lines.into_rest();
    Box::new(Elements { input, line, is_in_array: false, is_over: false })
}

/// Rows of JSON, one object on each line; none where they are in an array, or one is over several lines.
pub fn json_lines(input: Input) -> Option<TextRows> {
    let (lines, on_lines) = begun(input);
    on_lines.then(|| TextRows::of_lines(lines))
}

/// The lines of an input, and whether each is a row of its own.
fn begun(input: Input) -> (InputLines, bool) {
    let mut lines = InputLines::new(input, 1);
    let (held, on_lines) = beginning(&mut lines);
    lines.give_back(&held, 1);
    (lines, on_lines)
}

/// The first lines, and whether each line is a row of its own.
fn beginning(lines: &mut InputLines) -> (Vec<u8>, bool) {
    let mut held = Vec::new();
    let first = next_row(lines, &mut held);
    if first.starts_with(b"[") {
        return (held, false);
    }
    let on_lines = match serde_json::from_slice::<&RawValue>(&first) {
        Ok(object) => !object.get().contains("\"arches\":["),
        // An object goes on behind its first line with a key or with the rows of a document: where another
        // object follows, the first row is a bad one.
        Err(error) if error.classify() == Category::Eof => {
            !first.ends_with(b"[") && next_row(lines, &mut held).starts_with(b"{")
        }
        Err(_) => true,
    };
    (held, on_lines)
}

/// Adds the lines up to the next that is not empty, and answers that one; of a long line the beginning.
fn next_row(lines: &mut InputLines, held: &mut Vec<u8>) -> Vec<u8> {
    loop {
        let before = held.len();
        let reading = lines.next_into(held);
        let row = held[before..].trim_ascii();
        if !row.is_empty() || !matches!(reading, Ok(Reading::Line)) {
            return row.to_owned();
        }
    }
}

/// Objects over any number of lines: those of an array, those of the entry `arches` of an object, or one
/// behind the other.
struct Elements<R> {
    input: R,
    /// The line of the next character.
    line: u64,
    /// True if an array has begun and not ended.
    is_in_array: bool,
    is_over: bool,
}

impl<R: BufRead> Elements<R> {
    fn next_byte(&mut self) -> Result<Option<u8>, String> {
        let found = self.input.fill_buf().map_err(|error| error.to_string())?.first().copied();
        if found.is_some() {
            self.input.consume(1);
        }
        self.line += u64::from(found == Some(b'\n'));
        Ok(found)
    }

    /// The line of the next object, whose first character is then read; an error if something else comes.
    fn start(&mut self) -> Result<Option<u64>, String> {
        loop {
            match self.next_byte()? {
                None if self.is_in_array => return Err("the array is not closed".to_owned()),
                None => return Ok(None),
                Some(b'{') => return Ok(Some(self.line)),
                Some(b'[') => self.is_in_array = true,
                Some(b']') => self.is_in_array = false,
                Some(c) if c.is_ascii_whitespace() || b",}".contains(&c) => {}
                Some(_) => return Err("expected a JSON object".to_owned()),
            }
        }
    }

    /// An object whose first character is read; nothing for one that holds the array of the rows.
    fn object(&mut self) -> Result<Option<Vec<u8>>, String> {
        let (mut bytes, mut length) = (vec![b'{'], 1usize);
        let (mut depth, mut in_text, mut is_escaped) = (1u32, false, false);
        while let Some(c) = self.next_byte()? {
            let holds_rows = || {
                let before = bytes.trim_ascii_end().strip_suffix(b":").unwrap_or_default();
                depth == 1 && before.trim_ascii_end().ends_with(b"\"arches\"")
            };
            match c {
                _ if is_escaped => is_escaped = false,
                b'\\' if in_text => is_escaped = true,
                b'"' => in_text = !in_text,
                _ if in_text => {}
                b'[' if holds_rows() => {
                    self.is_in_array = true;
                    return Ok(None);
                }
                b'{' | b'[' => depth += 1,
                b'}' | b']' => depth -= 1,
                _ => {}
            }
            length += 1;
            // The rest of a long object is read and not held.
            if length <= MAX_RECORD {
                bytes.push(c);
            }
            if depth == 0 && length > MAX_RECORD {
                return Err(format!("an object of more than {MAX_RECORD} bytes"));
            }
            if depth == 0 {
                return Ok(Some(bytes));
            }
        }
        Err("the object is not closed".to_owned())
    }
}

impl<R: BufRead> Iterator for Elements<R> {
    type Item = Numbered<Vec<u8>>;

    fn next(&mut self) -> Option<Self::Item> {
        while !self.is_over {
            let line = match self.start() {
                Ok(Some(line)) => line,
                Ok(None) => return None,
                // What follows cannot be told apart any more.
                Err(error) => {
                    self.is_over = true;
                    return Some((self.line, Err(error)));
                }
            };
            match self.object() {
                Ok(Some(bytes)) => return Some((line, Ok(bytes))),
                Ok(None) => {}
                Err(error) => return Some((line, Err(error))),
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::super::object::JsonObject;
    use super::*;
    use std::io::Cursor;

    fn rows(text: &str) -> Vec<(u64, String)> {
        let input: Input = Box::new(Cursor::new(text.to_owned()));
        let shown = |row: Result<Option<String>, String>| match row {
            Ok(text) => text.unwrap_or_default(),
            Err(error) => format!("! {error}"),
        };
        let text = |bytes: Vec<u8>| Ok(JsonObject::parse(&bytes)?.text("a"));
        objects(input).map(|(line, row)| (line, shown(row.and_then(text)))).collect()
    }

    fn row(line: u64, text: &str) -> (u64, String) {
        (line, text.to_owned())
    }

    #[test]
    fn rows_stand_on_lines_or_in_arrays() {
        let expected = [row(1, "1"), row(3, "2")];
        assert_eq!(rows("{\"a\":1}\n\n{\"a\":2}\n"), expected);
        assert_eq!(rows("[{\"a\":1},\n\n{\"a\":2}]\n"), expected);
        assert_eq!(rows("{\"a\":\n1,\"b\":[{}]}\n{\"a\":2}")[..1], expected[..1]);
        let document =
            "{\n \"schema\": \"x\",\n \"arches\": [\n  {\"a\": 1},\n  {\"a\": \"}\"}\n ]\n}\n";
        assert_eq!(rows(document), [row(4, "1"), row(5, "}")]);
        assert_eq!(
            rows("{\"digits\":3,\"arches\":[{\"a\":1},{\"a\":2}]}"),
            [row(1, "1"), row(1, "2")]
        );
        assert_eq!(rows("[]"), []);
    }

    #[test]
    fn a_bad_row_costs_one_row() {
        let long = "x".repeat(MAX_RECORD);
        let lines = rows(&format!("{{\"a\":1}}\nx\n{{\"a\":\"{long}\"}}\n{{\"a\":2}}\n"));
        assert_eq!((lines.len(), &lines[3]), (4, &row(4, "2")), "{:?}", &lines[1]);
        let array = rows(&format!("[{{\"a\":1}},{{\"a\":\"{long}\"}},\n{{\"a\":x}},{{\"a\":2}}]"));
        assert_eq!((array.len(), &array[3]), (4, &row(2, "2")));
        assert!(array[1].1.contains("an object of more than 524288 bytes"));
        assert!(array[2].1.contains("expected value"));
    }

    #[test]
    fn what_does_not_end_is_told() {
        assert_eq!(rows("[{\"a\":1}").last(), Some(&row(1, "! the array is not closed")));
        assert_eq!(rows("[{\"a\":1").last(), Some(&row(1, "! the array is not closed")));
        assert_eq!(rows("[1,{\"a\":1}]"), [row(1, "! expected a JSON object")]);
    }
}
