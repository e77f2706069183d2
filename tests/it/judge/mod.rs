//! `couplet judge`: other people's results, right and wrong ones, and files that make no sense.

mod columns;
mod errors;
mod input;
mod results;
mod round_trip;
mod summary;
mod verdicts;

use crate::program::{Json, fed, of_lines, text};
use serde_json::Value;

/// The exit code and the rows that `couplet judge -` makes of an input.
fn rows(arguments: &str, input: impl AsRef<[u8]>) -> (Option<i32>, Vec<Value>) {
    let output = fed(format!("judge - --format jsonl {arguments}"), input);
    (output.status.code(), of_lines(&text(&output.stdout)))
}

fn verdicts(rows: &[Value]) -> Vec<&str> {
    rows.iter().map(|row| row["verdict"].text()).collect()
}
