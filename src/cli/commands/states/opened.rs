//! Rows that are read, and where their answers go.

use super::arguments::Arguments;
use crate::cli::commands::given_rows::source;
use crate::cli::commands::output::Output;
use crate::cli::commands::stream::Progress;
use crate::report::{Beside, Content, Format};
use crate::sweep::failure::Failure;
use crate::sweep::rows::{Columns, GivenRows, Keep, Purpose, Syntax};

/// Rows that are read, and the file in which they are answered.
pub(super) struct Opened {
    pub(super) given: GivenRows,
    pub(super) progress: Progress,
    pub(super) output: Output,
    pub(super) format: &'static Format,
    pub(super) syntax: Syntax,
    /// Columns that a table has beside what is asked and told.
    pub(super) beside: Beside,
}

impl Opened {
    /// Opens the file that is read, and the one that is written, in a format of rows.
    pub(super) fn new(arguments: &Arguments, content: Content) -> Result<Option<Self>, Failure> {
        let source = source(arguments.file.as_deref(), &arguments.output)?;
        let (progress, syntax) = (Progress::new(&source), source.syntax);
        let format = match arguments.format {
            None => arguments.output.by_name(content)?,
            given => given,
        };
        let format = format.or_else(|| Format::named(content, syntax.format()));
        let Some(format) = format else { return Ok(None) };
        let output = arguments.output.open_for(format)?;
        let input = progress.counted(source.into_input());
        let (keep, in_lines) = (Keep::new(&arguments.keep), format.name == "jsonl");
        let mut beside = Beside::default();
        let named = arguments.columns.iter().filter(|name| !beside.add(name));
        let named: Vec<String> = named.cloned().collect();
        let columns = Columns::named(&named, Purpose::Ask).map_err(Failure::Input)?;
        let given = GivenRows::new((syntax, input), columns, keep, in_lines)?;
        Ok(Some(Self { given, progress, output, format, syntax, beside }))
    }
}
