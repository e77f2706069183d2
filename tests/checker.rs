//! The command of the small program, which is in every build: it checks the stored certificates.

#[path = "common/program.rs"]
mod program;

use program::couplet;

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
    let lines = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{lines}");
    assert_eq!(lines.matches(": accepted  ").count(), 14, "{lines}");
}

#[test]
fn what_is_not_built_in_is_named_in_one_line() {
    let file = &stored()[0];
    let whole = cfg!(feature = "mpfr");
    for (arguments, message) in [
        (&["check", "--engine", "mpfr", file][..], "mpfr is not built in"),
        (&["audit"], "this build has the commands check, completions and man"),
    ] {
        let output = couplet(arguments);
        let said = String::from_utf8(output.stderr).unwrap();
        if whole {
            assert_eq!(said, "", "{arguments:?}");
        } else {
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            assert!(said.lines().count() == 1 && said.contains(message), "{arguments:?}: {said}");
        }
    }
}
