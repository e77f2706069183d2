//! What every language has in common: comments by lines, and one subject after the other.

use super::names::about;
use super::{Export, Exported, Subject};
use std::io;

/// Lines as comments, without spaces at their ends.
pub fn comments(
    lines: impl IntoIterator<Item = String>,
    mark: &str,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    lines.into_iter().try_for_each(|line| writeln!(out, "{}", format!("{mark}{line}").trim_end()))
}

/// Each subject after an empty line: what is said of it, as comments, and its values as `value` writes
/// them.
pub fn subjects(
    export: &Export,
    mark: &str,
    out: &mut dyn io::Write,
    value: impl Fn(&Subject, &Exported, &mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    for subject in &export.subjects {
        writeln!(out)?;
        comments(about(subject), mark, out)?;
        subject.values.iter().try_for_each(|one| value(subject, one, out))?;
    }
    Ok(())
}
