//! The command of the small program, which is in every build: it checks the stored certificates.

use crate::program::{couplet, text};

fn stored() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/constants");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|e| e == "json"));
    files.map(|path| path.to_str().unwrap().to_owned()).collect()
}

#[test]
fn the_stored_certificates_are_accepted() {
    let files = stored();
    let names: Vec<&str> = files.iter().map(String::as_str).collect();
    let output = couplet(&[&["check"][..], &names].concat());
    let lines = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{lines}");
    assert_eq!(lines.matches(": accepted  ").count(), 14, "{lines}");
}

/// Not one word in the whole program; one line in the program that lacks it.
fn named_where_it_is_not_built_in(arguments: &[&str], is_built_in: bool, message: &str) {
    let output = couplet(arguments);
    let said = text(&output.stderr);
    if is_built_in {
        assert_eq!(said, "", "{arguments:?}");
    } else {
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(said.lines().count() == 1 && said.contains(message), "{arguments:?}: {said}");
    }
}

#[test]
fn the_engine_that_is_not_built_in_is_named() {
    let arguments = ["check", "--engine", "mpfr", &stored()[0]];
    named_where_it_is_not_built_in(&arguments, true, "mpfr is not built in; here are astro");
}
