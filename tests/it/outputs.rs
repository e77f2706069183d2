//! Whole outputs of every command, stored next to the tests as a reader would see them in a terminal.
//!
//! `snapshots/<name>.txt` has each command after a `$`, what it prints, what it says on standard error after a `!`, and
//! its exit code if that is not 0. The commands are those of the file: one more is a line of it, or a file. A file that
//! is shown by `cat` before any other command is written first. When a change of an output is meant:
//!
//!     make snapshots                  UPDATE_SNAPSHOTS=1 cargo test --test it outputs::
//!     git diff tests/it/snapshots
//!
//! What changes from run to run is left out in one place, [`steady`].

use crate::house::files;
use crate::program::{Scratch, shell, text};
use rayon::prelude::*;
use std::path::Path;

/// What is seen in a terminal when the commands of a stored output are given in an empty folder.
fn seen(stored: &str) -> String {
    let scratch = Scratch::new();
    let (mut seen, mut is_begun) = (String::new(), false);
    for command in format!("\n{stored}").split("\n$ ").skip(1) {
        let (line, shown) = command.split_once('\n').unwrap_or((command, ""));
        is_begun |= !line.starts_with("cat ");
        if !is_begun {
            scratch.write(&line["cat ".len()..], format!("{}\n", shown.trim_end()));
        }
        let output = shell(line, scratch.folder());
        seen += &format!("$ {line}\n{}", text(&output.stdout));
        for line in text(&output.stderr).lines() {
            seen += &format!("! {line}\n");
        }
        match output.status.code() {
            Some(0) => seen += "\n",
            code => seen += &format!("exit code {}\n\n", code.unwrap()),
        }
    }
    steady(&seen)
}

fn compare(path: &Path) {
    let stored = std::fs::read_to_string(path).unwrap();
    let found = seen(&stored);
    if stored == found {
        return;
    }
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return std::fs::write(path, found).unwrap();
    }
    let same = stored.lines().zip(found.lines()).take_while(|(old, new)| old == new).count();
    let line = |text: &str| text.lines().nth(same).unwrap_or("(the end)").to_owned();
    let (name, old, new) = (path.display(), line(&stored), line(&found));
    panic!("{name}, line {}:\n- {old}\n+ {new}\nif it is meant: make snapshots", same + 1);
}

#[test]
fn every_stored_output_is_that_of_its_commands() {
    let files = files("tests/it/snapshots", "txt");
    assert!(files.len() > 80);
    files.par_iter().for_each(|path| compare(path));
}

/// Another answer and another exit code are seen.
#[test]
fn what_is_not_said_is_seen() {
    let found = seen("$ cat a\n1\n\n$ couplet constants X; cat a\n");
    let begins = "$ cat a\n1\n\n$ couplet constants X; cat a\n1\n! couplet: ";
    assert!(found.starts_with(begins), "{found}");
    assert_eq!(seen(&found.replace("a\n1\n!", "a\n2\n!")), found);
    assert!(seen("$ couplet constants X\n").ends_with("\nexit code 2\n"));
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
