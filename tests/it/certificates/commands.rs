//! `couplet certify` and `couplet check`.

use crate::program::{Scratch, couplet, fed, said};

const ACCEPTED: &str = "accepted  T heyman  thickness 0.67960473209888551478… to 60 digits\n";

/// A folder with a certificate of T for Heyman's weight, and its path.
fn certified() -> (Scratch, String) {
    let scratch = Scratch::new();
    let good = scratch.path("good.json");
    let made = couplet(["certify", "T", "--weight", "heyman", "--digits", "60", "--output", &good]);
    assert_eq!(said(&made), (Some(0), String::new(), String::new()));
    (scratch, good)
}

#[test]
fn what_certify_makes_check_accepts_in_each_arithmetic() {
    let (_scratch, good) = certified();
    for arguments in
        [&["check"][..], &["check", "--engine", "astro"], &["check", "--engine", "mpfr"]]
    {
        let output = couplet([arguments, &[&good]].concat());
        assert_eq!(said(&output), (Some(0), format!("{good}: {ACCEPTED}"), String::new()));
    }
    let input = std::fs::read(&good).unwrap();
    let read = fed("check -", &input);
    assert_eq!(said(&read), (Some(0), format!("-: {ACCEPTED}"), String::new()));
}

#[test]
fn a_state_has_a_certificate_too() {
    let state = couplet("certify state --alpha 2.45 --mu 1.35 --digits 5");
    let (code, output, _) = said(&fed("check -", &state.stdout));
    assert_eq!(code, Some(0));
    assert!(
        output.starts_with("-: accepted  [r")
            && output.contains("half_opening 49/20 friction 27/20"),
        "{output}"
    );
}

#[test]
fn a_refused_one_does_not_keep_the_others_from_being_checked() {
    let (scratch, good) = certified();
    let (bad, empty) = (scratch.path("bad.json"), scratch.path("empty.json"));
    scratch.write("bad.json", scratch.read("good.json").replace("\"T\"", "\"Q\""));
    scratch.write("empty.json", "");
    let (code, output, message) = said(&couplet(["check", &bad, &good, &empty]));
    assert_eq!((code, message.as_str()), (Some(1), "couplet: 2 of 3 refused\n"));
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(lines[0], format!("{bad}: refused: claim: there is no landmark 'Q'"));
    assert_eq!(lines[1], format!("{good}: {}", ACCEPTED.trim_end()));
    let reason =
        "refused: the file is not a certificate: EOF while parsing a value at line 1 column 0";
    assert_eq!(lines[2..], [format!("{empty}: {reason}")]);
}

/// A file that cannot be read, in a folder of its own: the others are checked all the same, and a refusal is not
/// masked.
fn cannot_be_read(name: &str) {
    let (scratch, good) = certified();
    let path = if name.is_empty() { String::new() } else { scratch.path(name) };
    let (code, output, message) = said(&couplet(["check", &path, &good]));
    assert_eq!((code, message.as_str()), (Some(3), "couplet: 1 of 2 not checked\n"), "{path}");
    let lines: Vec<&str> = output.lines().collect();
    assert!(lines[0].starts_with(&format!("{path}: not read: ")), "{output}");
    assert_eq!(lines[1..], [format!("{good}: {}", ACCEPTED.trim_end())]);
    scratch.write("bad.json", "{}");
    let bad = scratch.path("bad.json");
    let (code, output, message) = said(&couplet(["check", &bad, &path, &good]));
    let expected = "couplet: 1 of 3 refused, 1 not checked\n";
    assert_eq!((code, message.as_str(), output.lines().count()), (Some(1), expected, 3));
}

/// More digits than the arithmetic is meant for say nothing against a certificate.
#[test]
fn a_certificate_beyond_the_limit_is_not_checked_and_not_refused() {
    let (scratch, good) = certified();
    let beyond = scratch.path("beyond.json");
    let text = scratch.read("good.json").replace("\"digits\": 60,", "\"digits\": 60000,");
    scratch.write("beyond.json", text);
    let (code, output, message) = said(&couplet(["check", &beyond, &good]));
    assert_eq!((code, message.as_str()), (Some(3), "couplet: 1 of 2 not checked\n"));
    let line = "not checked: 60000 digits are more than the 50000 of this check; --engine mpfr checks up to 1000000";
    assert!(output.starts_with(&format!("{beyond}: {line}\n")), "{output}");
    // It is spoiled, which is seen where it is looked at.
    let (code, output, _) = said(&couplet(["check", "--engine", "mpfr", &beyond]));
    assert_eq!(code, Some(1));
    assert!(output.contains(": refused: values: "), "{output}");
}

#[test]
fn a_missing_file_cannot_be_read() {
    cannot_be_read("missing.json");
}

#[test]
fn a_folder_cannot_be_read() {
    cannot_be_read(".");
}

#[test]
fn a_file_without_a_name_cannot_be_read() {
    cannot_be_read("");
}

#[test]
fn a_folder_of_certificates_is_accepted_whole() {
    let scratch = Scratch::new();
    let made = couplet(["certify", "all", "--digits", "8", "--output", &scratch.path("all")]);
    assert_eq!(made.status.code(), Some(0), "{made:?}");
    let files = scratch.files("all");
    assert_eq!(files.len(), 14);
    let paths: Vec<String> =
        files.iter().map(|name| scratch.path(&format!("all/{name}"))).collect();
    let names: Vec<&str> = paths.iter().map(String::as_str).collect();
    let (code, output, message) = said(&couplet([&["check"][..], &names].concat()));
    assert_eq!((code, message.as_str()), (Some(0), ""), "{output}");
    assert_eq!(output.matches(": accepted  ").count(), 14);
}
