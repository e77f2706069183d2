//! `couplet certify` and `couplet check`.

use crate::program::{Scratch, couplet, ended, said, tells};

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
    let (output, _) = ended(0, "check -", std::fs::read(&good).unwrap());
    assert_eq!(output, format!("-: {ACCEPTED}"));
}

#[test]
fn a_refused_one_does_not_keep_the_others_from_being_checked() {
    let (scratch, good) = certified();
    let (bad, empty) = (scratch.path("bad.json"), scratch.path("empty.json"));
    scratch.write("bad.json", scratch.read("good.json").replace("\"T\"", "\"Q\""));
    scratch.write("empty.json", "");
    let (output, message) = ended(1, ["check", &bad, &good, &empty], "");
    assert_eq!(message, "couplet: 2 of 3 refused\n");
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
    let (output, message) = ended(3, ["check", &path, &good], "");
    assert_eq!(message, "couplet: 1 of 2 not checked\n", "{path}");
    let lines: Vec<&str> = output.lines().collect();
    assert!(lines[0].starts_with(&format!("{path}: not read: ")), "{output}");
    assert_eq!(lines[1..], [format!("{good}: {}", ACCEPTED.trim_end())]);
    scratch.write("bad.json", "{}");
    let bad = scratch.path("bad.json");
    let (output, message) = ended(1, ["check", &bad, &path, &good], "");
    assert_eq!(message, "couplet: 1 of 3 refused, 1 not checked\n");
    assert_eq!(output.lines().count(), 3);
}

/// More digits than the arithmetic is meant for say nothing against a certificate.
#[test]
fn a_certificate_beyond_the_limit_is_not_checked_and_not_refused() {
    let (scratch, good) = certified();
    let beyond = scratch.path("beyond.json");
    let text = scratch.read("good.json").replace("\"digits\": 60,", "\"digits\": 60000,");
    scratch.write("beyond.json", text);
    let (output, message) = ended(3, ["check", &beyond, &good], "");
    assert_eq!(message, "couplet: 1 of 2 not checked\n");
    let line = "not checked: 60000 digits are more than the 50000 of this check; --engine mpfr checks up to 1000000";
    assert!(output.starts_with(&format!("{beyond}: {line}\n")), "{output}");
    // It is spoiled, which is seen where it is looked at.
    tells(&ended(1, ["check", "--engine", "mpfr", &beyond], "").0, [": refused: values: "]);
}

#[test]
fn a_missing_file_a_folder_and_a_file_without_a_name_cannot_be_read() {
    ["missing.json", ".", ""].into_iter().for_each(cannot_be_read);
}
