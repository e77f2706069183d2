//! The program `couplet-check` on files: its lines, and its exit codes.

use std::process::{Command, Output};

const PROOFS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs");

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_couplet-check")).args(arguments).output().unwrap()
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

/// The stored certificates of a folder.
fn stored(folder: &str) -> Vec<String> {
    let files = std::fs::read_dir(format!("{PROOFS}/{folder}")).unwrap();
    let files = files.map(|file| file.unwrap().path().to_str().unwrap().to_owned());
    files.filter(|name| name.ends_with(".json")).collect()
}

#[test]
fn every_stored_certificate_is_accepted() {
    let files = ["constants", "states", "asymmetric"].map(stored).concat();
    let names: Vec<&str> = files.iter().map(String::as_str).collect();
    let output = run(&names);
    let lines = text(output.stdout);
    assert_eq!(output.status.code(), Some(0), "{lines}");
    assert_eq!((names.len(), lines.matches(": accepted  ").count()), (33, 33), "{lines}");
}

#[test]
fn the_exit_code_says_what_became_of_the_files() {
    let good = format!("{PROOFS}/states/sliding.json");
    let refused = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let cases: [(&[&str], i32, &str); 5] = [
        (&[&good, "no such file"], 3, "1 of 2 not checked"),
        (&[&good, refused], 1, "1 of 2 refused"),
        (&[refused, "no such file"], 1, "1 of 2 refused, 1 not checked"),
        (&[], 2, "<FILE>... is missing; usage: couplet-check FILE..."),
        (&["--engine", "mpfr", &good], 2, "unexpected argument '--engine' found"),
    ];
    for (arguments, code, said) in cases {
        let output = run(arguments);
        let error = text(output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {error}");
        assert!(error.starts_with("couplet-check: ") && error.contains(said), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
    assert_eq!(text(run(&["--version"]).stdout), "couplet-check 0.1.0\n");
}
