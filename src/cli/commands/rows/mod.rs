//! Files of many rows: read as they come, answered on all cores, in the order in which they stand.

mod object;
mod read;
mod stream;

pub(super) use object::{JsonObject, json_error};
pub(super) use read::{Line, Source, Syntax, csv_records, json_lines};
pub(super) use stream::{CHUNK, Progress, in_order};
