//! Files of many rows: read as they come, answered on all cores, in the order in which they stand.

mod arch;
mod columns;
mod csv;
mod dialect;
mod json;
mod keep;
mod lines;
mod object;
mod roles;
mod source;
mod spelling;
mod stream;

pub(super) use arch::Reader;
pub(super) use columns::{Cells, Columns};
pub(super) use csv::Table;
pub(super) use json::objects;
pub(super) use keep::{Keep, Row};
pub(super) use roles::{Purpose, Role};
pub(super) use source::{Input, Line, Source, Syntax};
pub(super) use spelling::Spelling;
pub(super) use stream::{CHUNK, Progress, Together, in_order};

/// The most bytes of a row: one without end would fill the memory.
const MAX_RECORD: usize = 1 << 19;
