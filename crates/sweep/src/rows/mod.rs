//! Files of many rows: read as they come, answered on all cores, in the order in which they stand.

mod answers;
mod arch;
mod columns;
mod csv;
mod dialect;
mod given;
mod json;
mod judge;
mod keep;
mod lines;
mod number_style;
mod object;
mod roles;
mod source;

pub use answers::RowQuestion;
pub use arch::ArchReader;
pub use columns::{Cells, Columns, RowColumn, unanswered};
pub use csv::TextRows;
pub use given::GivenRows;
pub use json::json_lines;
pub use judge::Judge;
pub use keep::{Keep, ReadRow};
pub use number_style::NumberStyle;
pub use roles::{Purpose, Role};
pub use source::{BYTE_ORDER_MARK, Input, Numbered, RowSource, Syntax};

/// The most bytes of a row: one without end would fill the memory.
const MAX_RECORD: usize = 1 << 19;
