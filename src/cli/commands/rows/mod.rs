//! Files of many rows: read as they come, answered on all cores, in the order in which they stand.

mod object;
mod read;
mod stream;

pub use object::{JsonObject, json_error};
pub use read::{Line, Source, Syntax, csv_records, json_lines};
pub use stream::{CHUNK, Progress, in_order};
