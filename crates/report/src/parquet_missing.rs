//! Stand-ins of Parquet, where it is not built in.

use super::answers::Answers;
use super::column::NamedColumn;
use super::reported::unsupported;
use super::rows::Rows;
use std::io;

/// Writes nothing, of whatever it is.
pub(super) fn answers<T>(_: &T, _: &mut dyn io::Write) -> io::Result<()> {
    unsupported()
}

/// Writes no rows.
pub fn parquet_rows<R>(
    _: &[NamedColumn<R>],
    _: &[R],
    _: impl IntoIterator<Item = (&'static str, String)>,
    _: &mut dyn io::Write,
) -> io::Result<()> {
    unsupported()
}

pub(super) fn rows(_: Answers) -> io::Result<Box<dyn Rows>> {
    unsupported()
}
