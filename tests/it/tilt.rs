//! Arches under a horizontal acceleration, on the command line.

use crate::program::couplet;
use serde_json::Value;

fn of(arguments: &str) -> (Option<i32>, String, String) {
    let words: Vec<&str> = ["assess"].into_iter().chain(arguments.split(' ')).collect();
    let output = couplet(&words);
    let [out, error] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code(), out, error)
}

#[test]
fn a_tilt_is_told_in_every_format() {
    let of = |format| {
        let (code, out, _) =
            of(&format!("--alpha 1.2 --mu 0.6 --eta 0.1 --tilt 0.3 --digits 8 --format {format}"));
        assert_eq!(code, Some(0));
        out
    };
    let json: Value = serde_json::from_str(&of("json")).unwrap();
    assert_eq!(
        (&json["schema"], &json["outcome"]),
        (&"couplet.tilt/1".into(), &"admissible".into())
    );
    let largest = json["largest_tilt"]["value"].as_str().unwrap();
    assert_eq!(largest, "0.35650792");
    assert!(of("csv").contains(largest) && of("table").contains(largest));
    assert!(of("table").contains("does not exclude a motion"));
}

/// What it says depends on the friction, and on whether anything is left.
#[test]
fn outcomes_are_told_apart() {
    for (arguments, outcome) in [
        ("--alpha pi/2 --mu inf --eta 0.15 --tilt 0.1", "stands, proved"),
        ("--alpha pi/2 --mu 0.7 --eta 0.15 --tilt 0.1", "has an admissible state, proved"),
        ("--alpha pi/2 --mu 0.4 --eta 0.15 --tilt 0.1", "collapses, proved: no state"),
        ("--alpha pi/2 --mu 0.7 --eta 0.1 --tilt 0", "without tilt either"),
        ("--alpha 0.5 --mu 2 --eta 0.7 --tilt 10", "unbounded"),
    ] {
        let (code, out, error) = of(&format!("{arguments} --digits 4"));
        assert_eq!(code, Some(0), "{arguments}: {error}");
        assert!(out.contains(outcome), "{arguments}: {out}");
        assert_eq!(
            out.contains("exclude a motion"),
            outcome.starts_with("has") || outcome == "unbounded"
        );
    }
}

#[test]
fn a_wrong_tilt_is_one_line() {
    let arch = "--alpha 1 --eta 0.2";
    for (arguments, why) in [
        ("--mu 0 --tilt 0.1", "friction above 0"),
        ("--friction-angle 0deg --tilt 0.1", "friction above 0"),
        ("--mu 1 --tilt -0.1", "is negative"),
        ("--mu 1 --tilt inf", "no acceleration"),
        ("--mu 1 --tilt 90deg", "below 90deg"),
        ("--mu 1 --tilt much", "'much'"),
        ("--mu 1 --tilt 0.1 --plain", "table, json, csv"),
        ("--mu 1 --tilt 0.1 --quantity least_thickness", "cannot be used"),
    ] {
        let (code, _, error) = of(&format!("{arch} {arguments}"));
        assert_eq!(code, Some(2), "{arguments}");
        assert!(error.lines().count() == 1 && error.contains(why), "{arguments}: {error}");
    }
}
