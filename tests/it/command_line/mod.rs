//! The command as a user meets it: output, exit codes, one line for each wrong input.

mod claims;
mod constants;
mod files;
mod grids;
#[cfg(unix)]
mod interrupts;
mod language;
mod measured;
mod notes;
#[cfg(unix)]
mod owners;
mod ranged_rows;
mod ranges;
mod rows;
mod states;
mod study;

use crate::program::{couplet, text};
use couplet::number::Decimal;
use rug::Rational;
use serde_json::Value;
use std::process::Output;

fn stdout(output: &Output) -> String {
    text(&output.stdout)
}

fn exact(text: &Value) -> Rational {
    text.as_str().unwrap().parse::<Decimal>().unwrap().to_rational()
}

#[test]
fn help_goes_to_standard_output() {
    for arguments in ["--help", "constants --help", "audit --help", "--version"] {
        let output = couplet(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments}");
        assert!(output.stderr.is_empty() && !output.stdout.is_empty());
    }
    assert_eq!(couplet("").status.code(), Some(2));
}
