//! Whole outputs, stored next to the tests as a reader would see them in a terminal.
//!
//! `snapshots/<name>.txt` has each command after a `$`, what it prints, what it says on standard error
//! after a `!`, and its exit code if that is not 0. A change of an output that is meant:
//!
//!     make snapshots      (UPDATE_SNAPSHOTS=1 cargo test --all-features --test it outputs::)
//!     git diff tests/it/snapshots

use crate::program::text;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A shell in an empty folder, which has `couplet`, and all that was seen in it.
pub struct Terminal {
    folder: tempfile::TempDir,
    seen: String,
}

impl Terminal {
    pub fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap(), seen: String::new() }
    }

    /// A file of the folder, which is shown.
    pub fn file(self, name: &str, content: &str) -> Self {
        std::fs::write(self.folder.path().join(name), content).unwrap();
        self.run(&format!("cat {name}"))
    }

    /// A line for the shell and what comes of it.
    pub fn run(mut self, line: &str) -> Self {
        let program = Path::new(env!("CARGO_BIN_EXE_couplet")).parent().unwrap();
        let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
        let mut shell = Command::new("sh");
        shell.args(["-c", line]).env("PATH", path).current_dir(self.folder.path());
        let output = shell.output().unwrap();
        self.seen += &format!("$ {line}\n{}", text(&output.stdout));
        for line in text(&output.stderr).lines() {
            self.seen += &format!("! {line}\n");
        }
        match output.status.code() {
            Some(0) => self.seen += "\n",
            code => self.seen += &format!("exit code {}\n\n", code.unwrap()),
        }
        self
    }

    /// What was seen is what is stored.
    pub fn is(self, name: &str) {
        compare(name, &steady(self.seen.trim_end()));
    }
}

pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/snapshots")
}

fn compare(name: &str, found: &str) {
    let (path, found) = (folder().join(format!("{name}.txt")), format!("{found}\n"));
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    if stored == found {
        return;
    }
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return std::fs::write(path, found).unwrap();
    }
    let same = stored.lines().zip(found.lines()).take_while(|(old, new)| old == new).count();
    let line = |text: &str| text.lines().nth(same).unwrap_or("(the end)").to_owned();
    let (old, new) = (line(&stored), line(&found));
    panic!("{name}.txt, line {}:\n- {old}\n+ {new}\nIf it is meant: make snapshots", same + 1);
}

/// Without what changes from run to run: the version of the program, hashes that depend on it, and times.
fn steady(text: &str) -> String {
    let text = text.replace(&format!("couplet {}", env!("CARGO_PKG_VERSION")), "couplet VERSION");
    let word = |word: &str| match word {
        hash if hash.len() == 64 && hash.bytes().all(|c| c.is_ascii_hexdigit()) => "SHA256".into(),
        other => other.to_owned(),
    };
    let end = |c: char| !c.is_ascii_alphanumeric() && c != '.';
    text.split_inclusive(end)
        .map(|piece| {
            let rest = piece.strip_suffix(end).unwrap_or(piece);
            word(rest) + &piece[rest.len()..]
        })
        .collect()
}
