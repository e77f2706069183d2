//! The file of rows that a command reads.

use super::output::OutputFile;
use crate::check::visible_name;
use crate::sweep::failure::Failure;
use crate::sweep::rows::RowSource;
use std::path::Path;

/// Opens a file, standard input if none is named, which is not the one that is written.
pub(super) fn source(file: Option<&Path>, output: &OutputFile) -> Result<RowSource, Failure> {
    let source = RowSource::open(file)?;
    let file = file.unwrap_or(Path::new("-"));
    match output.is_same_file(file) {
        true => {
            let name = visible_name(file.as_os_str());
            Err(format!("refusing to overwrite the input {name}").into())
        }
        false => Ok(source),
    }
}
