//! `couplet judge`: other people's results, right and wrong ones, and files that make no sense.

mod columns;
mod errors;
mod input;
mod results;
mod round_trip;
mod summary;
mod verdicts;

use crate::program::{fed, text};
use serde_json::Value;

/// The exit code and the rows that `couplet judge -` makes of an input.
fn rows(arguments: &[&str], input: impl AsRef<[u8]>) -> (Option<i32>, Vec<Value>) {
    let all = [&["judge", "-", "--format", "jsonl"], arguments].concat();
    let output = fed(&all, input.as_ref());
    (
        output.status.code(),
        text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect(),
    )
}

fn verdicts(rows: &[Value]) -> Vec<&str> {
    rows.iter().map(|row| row["verdict"].as_str().unwrap()).collect()
}
