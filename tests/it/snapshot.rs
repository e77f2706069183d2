//! Whole outputs, stored next to the tests as a reader would see them in a terminal.
//!
//! `snapshots/<name>.txt` has each command after a `$`, what it prints, what it says on standard error
//! after a `!`, and its exit code if that is not 0. When a change of an output is meant:
//!
//!     make snapshots                  UPDATE_SNAPSHOTS=1 cargo test --test it outputs::
//!     git diff tests/it/snapshots
//!
//! What changes from run to run is left out in one place, [`steady`].

use crate::program::text;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A shell in an empty folder, which knows `couplet`, and all that was seen in it.
pub(crate) struct Terminal {
    folder: tempfile::TempDir,
    seen: String,
}

impl Terminal {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap(), seen: String::new() }
    }

    /// With a file in the folder, which is shown.
    pub(crate) fn file(self, name: &str, content: &str) -> Self {
        std::fs::write(self.folder.path().join(name), content).unwrap();
        self.run(&format!("cat {name}"))
    }

    /// A line for the shell, and what comes of it.
    pub(crate) fn run(mut self, line: &str) -> Self {
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

    /// Several lines for the shell.
    pub(crate) fn each(self, lines: &[&str]) -> Self {
        lines.iter().fold(self, |terminal, line| terminal.run(line))
    }

    /// What was seen is what is stored under this name.
    pub(crate) fn is(self, name: &str) {
        compare(name, &steady(&self.seen));
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/snapshots")
}

fn is_update() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some()
}

/// The stored outputs that are none of these, and so are compared with nothing.
pub(crate) fn left_behind(names: &[&str]) -> Vec<String> {
    let files = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let is_left = |path: &PathBuf| !names.iter().any(|name| *name == path.file_stem().unwrap());
    let left: Vec<PathBuf> = files.filter(is_left).collect();
    if is_update() {
        left.iter().for_each(|path| std::fs::remove_file(path).unwrap());
        return Vec::new();
    }
    left.iter().map(|path| path.display().to_string()).collect()
}

fn compare(name: &str, found: &str) {
    let path = folder().join(format!("{name}.txt"));
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    if stored == found {
        return;
    }
    if is_update() {
        return std::fs::write(path, found).unwrap();
    }
    let same = stored.lines().zip(found.lines()).take_while(|(old, new)| old == new).count();
    let line = |text: &str| text.lines().nth(same).unwrap_or("(the end)").to_owned();
    let (old, new) = (line(&stored), line(found));
    panic!("{name}.txt, line {}:\n- {old}\n+ {new}\nif it is meant: make snapshots", same + 1);
}

/// Without what changes from run to run, or with the machine: the version of the program, hashes, which
/// depend on it, times and costs at the ends of lines, and the radii of boxes, which follow a start value in
/// double precision.
fn steady(text: &str) -> String {
    let text = text.replace(&format!("couplet {}", env!("CARGO_PKG_VERSION")), "couplet VERSION");
    let mut in_radii = false;
    let line = |line: &str| {
        in_radii = line.contains("box_relative_radius") || in_radii && line.contains([':', '=']);
        let number = line.find(|c: char| c.is_ascii_digit()).filter(|_| in_radii);
        let line = number.map_or(line.to_owned(), |at| format!("{}RADIUS", &line[..at]));
        without_hashes(&without_costs(&line)) + "\n"
    };
    text.trim_end().lines().map(line).collect()
}

/// `a claim   12.3 ms, 64 bits` as `a claim COST`, and `"seconds": 0.1,` as `"seconds": COST`.
fn without_costs(line: &str) -> String {
    let before = match (line.split_once("\"seconds\":"), line.split_once(" ms")) {
        (Some((before, _)), _) => format!("{before}\"seconds\":"),
        (_, Some((before, _))) => {
            let rest = before.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
            if rest.len() == before.len() {
                return line.to_owned();
            }
            rest.trim_end().to_owned()
        }
        _ => return line.to_owned(),
    };
    before + " COST"
}

fn without_hashes(line: &str) -> String {
    let end = |c: char| !c.is_ascii_alphanumeric();
    let is_hash = |word: &str| word.len() == 64 && word.bytes().all(|c| c.is_ascii_hexdigit());
    let words = line.split_inclusive(end).map(|piece| {
        let word = piece.trim_end_matches(end);
        if is_hash(word) { piece.replace(word, "HASH") } else { piece.to_owned() }
    });
    words.collect()
}

#[test]
fn what_changes_from_run_to_run_is_left_out() {
    let (version, hash) = (env!("CARGO_PKG_VERSION"), "0123456789abcdef".repeat(4));
    for (seen, left) in [
        (format!("couplet {version} a"), "couplet VERSION a"),
        ("claim    0.2 ms".to_owned(), "claim COST"),
        ("│  2.1 ms, 64 bits".to_owned(), "│ COST"),
        ("some ms".to_owned(), "some ms"),
        ("  \"seconds\": 0.1,".to_owned(), "  \"seconds\": COST"),
        (format!("\"{hash}\", 1"), "\"HASH\", 1"),
        (
            "\"box_relative_radius\": {\n a: 0.1,\n}\nb: 2".to_owned(),
            "\"box_relative_radius\": {\n a: RADIUS\n}\nb: 2",
        ),
    ] {
        assert_eq!(steady(&seen), format!("{left}\n"));
    }
}
