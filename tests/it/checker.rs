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
    let engines = [("mpfr", true), ("malachite", cfg!(feature = "malachite"))];
    for (engine, is_built_in) in engines {
        let arguments = ["check", "--engine", engine, &stored()[0]];
        let message = format!("{engine} is not built in; here are astro");
        named_where_it_is_not_built_in(&arguments, is_built_in, &message);
    }
}

/// That it is no independent witness stands in the line itself.
#[cfg(feature = "malachite")]
#[test]
fn what_malachite_accepts_is_said_to_be_no_witness_beside_mpfr() {
    let files = stored();
    let names: Vec<&str> = files.iter().map(String::as_str).collect();
    let output = couplet(&[&["check", "--engine", "malachite"][..], &names].concat());
    let lines = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{lines}");
    let remark = "  (by malachite, which is no witness beside mpfr)";
    assert_eq!(lines.lines().filter(|line| line.ends_with(remark)).count(), 14, "{lines}");
    let spoiled = std::fs::read(names[0]).unwrap();
    let spoiled =
        String::from_utf8(spoiled).unwrap().replacen("\"digits\": 100", "\"digits\": 101", 1);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("spoiled.json");
    std::fs::write(&path, spoiled).unwrap();
    let output = couplet(&["check", "--engine", "malachite", path.to_str().unwrap()]);
    let line = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{line}");
    assert!(line.contains(": refused: values: ") && !line.contains("by malachite"), "{line}");
}
