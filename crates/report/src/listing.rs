//! Parts common to every language: comments by lines, and one subject after the other.

use super::answers::Answers;
use super::names::{Named, about};
use std::io;

/// Lines as comments, without spaces at their ends.
pub(super) fn comments(
    lines: impl IntoIterator<Item = String>,
    mark: &str,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    lines.into_iter().try_for_each(|line| writeln!(out, "{}", format!("{mark}{line}").trim_end()))
}

/// Writes each answer after an empty line: its comments, and its values as `value` writes them.
pub(super) fn listing(
    report: &Answers,
    mark: &str,
    out: &mut dyn io::Write,
    value: impl Fn(&Named, &mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    for answer in &report.list {
        writeln!(out)?;
        comments(about(answer), mark, out)?;
        Named::all(answer).try_for_each(|named| value(&named, out))?;
    }
    Ok(())
}
