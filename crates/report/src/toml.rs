//! TOML: the document that lists each value, of landmarks the same as in JSON.

use super::answers::Answers;
use super::document::document;
use std::io;

/// Landmarks or arches.
pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    let text = ::toml::to_string(&document(report)).map_err(io::Error::other)?;
    out.write_all(text.as_bytes())
}
