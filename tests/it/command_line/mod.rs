//! The command as a user meets it: output, exit codes, one line for each wrong input.

mod claims;
mod constants;
mod files;
mod grids;
#[cfg(unix)]
mod interrupts;
mod language;
mod measured;
#[cfg(unix)]
mod owners;
mod ranged_rows;
mod ranges;
mod rows;
mod states;
mod study;

use crate::program::{Json, text};
use couplet::number::Decimal;
use rug::Rational;
use serde_json::Value;
use std::process::Output;

fn stdout(output: &Output) -> String {
    text(&output.stdout)
}

fn exact(text: &Value) -> Rational {
    text.text().parse::<Decimal>().unwrap().to_rational()
}
