//! Where the library is, and programs that are compiled against it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of this crate.
pub(crate) fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn given(name: &str) -> PathBuf {
    let path = std::env::var_os(name).unwrap_or_else(|| panic!("{name} is not set: make c"));
    let path = PathBuf::from(path);
    assert!(path.exists(), "{name}: {} is not there: make c", path.display());
    path
}

/// The folder with `lib` and `include`.
pub(crate) fn built() -> PathBuf {
    given("COUPLET_C")
}

/// The command.
pub(crate) fn couplet() -> PathBuf {
    given("COUPLET")
}

/// A folder of a test's own, in which programs are compiled and run.
pub(crate) struct Scratch(tempfile::TempDir);

impl Scratch {
    pub(crate) fn new() -> Self {
        Self(tempfile::Builder::new().prefix("couplet-test-").tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    /// Runs a program here; it has to succeed without a word on standard error. What it prints.
    pub(crate) fn run(&self, program: &str, arguments: &[&str]) -> String {
        let output = Command::new(program)
            .args(arguments)
            .current_dir(self.0.path())
            .env("COUPLET", couplet())
            .output()
            .unwrap_or_else(|error| panic!("{program}: {error}"));
        let stderr = String::from_utf8_lossy(&output.stderr);
        // Octave 7 has words on its own end.
        let stderr = stderr
            .replace("error: ignoring const execution_exception& while preparing to exit\n", "");
        let stdout = String::from_utf8_lossy(&output.stdout);
        let ended = output.status;
        assert!(ended.success() && stderr.is_empty(), "{program}: {ended}\n{stdout}{stderr}");
        stdout.into_owned()
    }
}

/// The symbols that a file of the library offers.
pub(crate) fn symbols(file: &str, options: &[&str]) -> BTreeSet<String> {
    let file = built().join("lib").join(file);
    let output = Command::new("nm").args(options).arg(file).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let lines = String::from_utf8(output.stdout).unwrap();
    // An archive has the names of its objects too.
    let named = lines.lines().filter(|line| !line.ends_with(':'));
    named.filter_map(|line| line.split_whitespace().last()).map(str::to_owned).collect()
}
