//! JSON with a line for each field of an object and none for each element of a list: points take most of a drawing.

use crate::report::Record;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use std::io;

/// Depth of a writer in objects.
#[derive(Default)]
struct Lean {
    depth: usize,
}

impl Lean {
    fn line<W: ?Sized + io::Write>(&self, out: &mut W) -> io::Result<()> {
        out.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| out.write_all(b"  "))
    }
}

impl Formatter for Lean {
    fn begin_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.depth += 1;
        out.write_all(b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.depth -= 1;
        self.line(out)?;
        out.write_all(b"}")
    }

    fn begin_object_key<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        if !first {
            out.write_all(b",")?;
        }
        self.line(out)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }

    fn begin_array_value<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        if first { Ok(()) } else { out.write_all(b", ") }
    }
}

/// Writes a value and ends the line.
fn write(value: &impl Serialize, out: &mut dyn io::Write) -> io::Result<()> {
    value.serialize(&mut Serializer::with_formatter(&mut *out, Lean::default()))?;
    writeln!(out)
}

/// Writes records: one as an object, several as a list.
pub(crate) fn write_lean(records: &[Record], out: &mut dyn io::Write) -> io::Result<()> {
    match records {
        [one] => write(one, out),
        all => write(&all, out),
    }
}

#[cfg(test)]
mod tests {
    use super::write;

    #[test]
    fn lists_are_on_one_line() {
        let value =
            serde_json::json!({ "a": [[1, 2.5], [3, 4]], "b": [{ "c": null }, {}], "d": {} });
        let mut text = Vec::new();
        write(&value, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(
            text.starts_with(
                "{\n  \"a\": [[1, 2.5], [3, 4]],\n  \"b\": [{\n    \"c\": null\n  }, {"
            ),
            "{text}"
        );
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), value);
    }
}
