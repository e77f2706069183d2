//! The faults of a scene file and their places.

use crate::report::words::shortened;
use std::ops::Range;

/// A line and a column of a file, both from 1; a column is a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The character of the line.
    pub column: usize,
}

/// A fault and what is allowed instead: one line of text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fault {
    /// Place where it begins.
    pub place: Position,
    /// Message that says what it is.
    pub message: String,
}

/// The text of a scene file.
pub(super) struct SceneText<'s> {
    text: &'s str,
    /// The place of every [`STRIDE`]-th byte, so that many faults do not mean many readings of the file.
    marks: Vec<Position>,
}

/// Bytes between two marks.
const STRIDE: usize = 1 << 10;

impl<'s> SceneText<'s> {
    /// Source of a text.
    pub(super) fn new(text: &'s str) -> Self {
        // Editors do not count a byte order mark.
        let column = if text.starts_with('\u{feff}') { 0 } else { 1 };
        let mut marks = vec![Position { line: 1, column }];
        for piece in text.as_bytes().chunks_exact(STRIDE) {
            marks.push(marks[marks.len() - 1].after(piece));
        }
        Self { text, marks }
    }

    /// The place of a byte.
    pub(super) fn place(&self, offset: usize) -> Position {
        let offset = offset.min(self.text.len());
        let mark = offset / STRIDE;
        let place = self.marks[mark].after(&self.text.as_bytes()[mark * STRIDE..offset]);
        Position { column: place.column.max(1), ..place }
    }

    /// A value as it is written, on one line, with escapes, and not too long.
    pub(super) fn shown(&self, span: Range<usize>) -> String {
        shortened(self.text.get(span).unwrap_or_default())
    }
}

impl Position {
    /// The place behind some bytes that begin here.
    fn after(mut self, bytes: &[u8]) -> Self {
        for byte in bytes {
            match byte {
                b'\n' => self = Self { line: self.line + 1, column: 1 },
                // A character of several bytes counts where it begins.
                0x80..=0xBF => {}
                _ => self.column += 1,
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_in_characters() {
        let source = SceneText::new("\u{feff}ä = 1\nβ = \"x\"\n");
        assert_eq!(source.place(0), Position { line: 1, column: 1 });
        assert_eq!(source.place(3), Position { line: 1, column: 1 });
        assert_eq!(source.place(5), Position { line: 1, column: 2 });
        let x = source.text.find('"').unwrap();
        assert_eq!(source.place(x), Position { line: 2, column: 5 });
        assert_eq!(source.place(1_000), Position { line: 3, column: 1 });
    }

    #[test]
    fn a_place_far_into_a_text_is_counted_from_its_beginning() {
        let text = "äx\n".repeat(STRIDE) + &"β".repeat(3 * STRIDE);
        let source = SceneText::new(&text);
        for (offset, _) in text.char_indices().step_by(97) {
            let before = &text[..offset];
            let line = before.rsplit('\n').next().unwrap();
            let (line, column) = (before.matches('\n').count() + 1, line.chars().count() + 1);
            assert_eq!(source.place(offset), Position { line, column }, "{offset}");
        }
        let end = Position { line: STRIDE + 1, column: 3 * STRIDE + 1 };
        assert_eq!(source.place(text.len()), end);
    }

    #[test]
    fn a_value_is_shown_on_one_short_line() {
        assert_eq!(SceneText::new("a\nb").shown(0..3), r"a\nb");
        let long = "1".repeat(100);
        assert_eq!(SceneText::new(&long).shown(0..100).chars().count(), 40);
    }
}
