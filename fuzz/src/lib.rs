//! What the fuzz targets share.

use couplet_check::arch::SelfWeight;
use couplet_sweep::rows::{
    ArchReader, Columns, GivenRows, Keep, Numbered, Purpose, ReadRow, Syntax,
};
use std::io::Cursor;

/// Longest reason for which something is refused.
const LONGEST: usize = 2000;

/// Checks that a reason is one line that can be shown, of a length that is read.
pub fn is_told(reason: impl ToString) {
    let words = reason.to_string();
    assert!(!words.is_empty(), "no reason");
    assert!(!words.contains(char::is_control), "{words:?}");
    assert!(words.len() < LONGEST, "{} bytes of reason: {words:?}", words.len());
}

/// Rows of a file and the reader of their arches; nothing where the file has a fault, which is told.
pub fn rows(
    syntax: Syntax,
    purpose: Purpose,
    bytes: &[u8],
) -> Option<(ArchReader, impl Iterator<Item = Numbered<ReadRow>>)> {
    let columns = Columns::named(&[], purpose).expect("our own names");
    let input = Box::new(Cursor::new(bytes.to_owned()));
    let given = GivenRows::new((syntax, input), columns, Keep::All, true);
    let GivenRows { columns, spelling, rows, .. } = given.map_err(is_told).ok()?;
    let reader = ArchReader { columns, weight: SelfWeight::Milankovitch, doubles: false, spelling };
    Some((reader, rows.take(1000)))
}

/// Reads the arch of each row, of one arch and of a range; what is wrong is told.
pub fn arches(syntax: Syntax, bytes: &[u8]) {
    let Some((reader, rows)) = rows(syntax, Purpose::Ask, bytes) else { return };
    let mut last = 0;
    for (line, row) in rows {
        assert!(line >= last, "line {line} after {last}");
        last = line;
        let Ok(ReadRow { cells, .. }) = row.map_err(is_told) else { continue };
        let _ = reader.arch(&cells).map_err(is_told);
        let _ = reader.ranged(&cells).map_err(is_told);
        reader.described(&cells);
    }
}
