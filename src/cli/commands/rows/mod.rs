//! Files of many rows: read as they come, answered on all cores, in the order in which they stand.

mod read;
mod stream;

pub use read::{Kind, Line, Source, csv_records, json_lines};
pub use stream::{Progress, in_order};
