//! What is handed to other programs is compiled and run by them, and compared bit for bit.

mod documents;
mod expected;
mod languages;
#[cfg(feature = "parquet")]
pub(crate) mod parquet;
mod readers;
pub(crate) mod schemas;
mod states;

use crate::program::{Scratch, couplet};
use crate::tool::has;
use std::path::Path;
use std::process::Command;

/// What `couplet constants` writes in a format, with as few digits as would show a double made of them.
fn constants(format: &str) -> Vec<u8> {
    let output = couplet(["constants", "--digits", "3", "--format", format]);
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()), "{format}");
    output.stdout
}

impl Scratch {
    /// Runs a program here; it has to succeed without a word on standard error.
    fn run(&self, program: impl AsRef<Path>, arguments: &[&str]) -> String {
        let program = program.as_ref();
        let output =
            Command::new(program).args(arguments).current_dir(self.folder()).output().unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        // Octave 7 has words on its own end.
        let stderr = stderr
            .replace("error: ignoring const execution_exception& while preparing to exit\n", "");
        let stdout = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success() && stderr.is_empty(), "{program:?} {stdout} {stderr}");
        stdout.into_owned()
    }
}
