//! The `couplet` command: parse, call, print, exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    couplet::cli::run()
}
