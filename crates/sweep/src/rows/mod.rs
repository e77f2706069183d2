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

pub use arch::Reader;
pub use columns::{Cells, Columns};
pub use csv::Table;
pub use json::objects;
pub use keep::{Keep, Row};
pub use roles::{Purpose, Role};
pub use source::{Input, Line, Source, Syntax};
pub use spelling::Spelling;

/// The most bytes of a row: one without end would fill the memory.
const MAX_RECORD: usize = 1 << 19;
