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
    assert_eq!((&json["schema"], &json["outcome"]), (&"couplet.tilt/2".into(), &"stands".into()));
    let largest = json["largest_tilt"]["value"].as_str().unwrap();
    assert_eq!(largest, "0.35650792");
    assert!(of("csv").contains(largest) && of("table").contains(largest));
    assert!(of("table").contains("without dilatancy may let"));
    assert_eq!(json["may_move"], true);
    assert!(of("csv").contains("may_move") && of("csv").ends_with(",true,\n"));
}

/// What it says depends on the friction, and on whether anything is left.
#[test]
fn outcomes_are_told_apart() {
    for (arguments, outcome) in [
        ("--alpha pi/2 --mu inf --eta 0.15 --tilt 0.1", "stands, proved"),
        (
            "--alpha pi/2 --mu 0.7 --eta 0.15 --tilt 0.1",
            "stands, proved: an admissible state exists",
        ),
        ("--alpha pi/2 --mu 0.4 --eta 0.15 --tilt 0.1", "collapses, proved: no state"),
        ("--alpha pi/2 --mu 0.7 --eta 0.1 --tilt 0", "without tilt either"),
        ("--alpha 0.5 --mu 2 --eta 0.7 --tilt 10", "unbounded"),
    ] {
        let (code, out, error) = of(&format!("{arguments} --digits 4"));
        assert_eq!(code, Some(0), "{arguments}: {error}");
        assert!(out.contains(outcome), "{arguments}: {out}");
        let stands = outcome.starts_with("stands") || outcome == "unbounded";
        let may_move = stands && !arguments.contains("--mu inf");
        assert_eq!(out.contains("may let such an arch move"), may_move, "{arguments}: {out}");
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
        ("--mu 1 --tilt 0.1 --quantity least_thickness", "leave out --quantity"),
    ] {
        let (code, _, error) = of(&format!("{arch} {arguments}"));
        assert_eq!(code, Some(2), "{arguments}");
        assert!(error.lines().count() == 1 && error.contains(why), "{arguments}: {error}");
    }
}

/// Arches of stones under an acceleration, in every format.
#[test]
fn stones_are_tilted() {
    let of = |line: &str| {
        let words: Vec<&str> = ["voussoirs"].into_iter().chain(line.split(' ')).collect();
        let output = couplet(&words);
        let [out, error] =
            [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        (output.status.code(), out, error)
    };
    let arch = "--alpha pi/2 --mu 0.4 --eta 0.15 --stones 11 --digits 8";
    let (code, words, error) = of(&format!("{arch} --tilt 0.05"));
    assert_eq!(code, Some(0), "{error}");
    assert!(words.contains("11 equal stones") && words.contains("at joint"), "{words}");
    assert!(
        words.contains("stands, proved: an admissible state exists, between the stones"),
        "{words}"
    );
    let json: Value =
        serde_json::from_str(&of(&format!("{arch} --tilt 0.05 --format json")).1).unwrap();
    let largest = json["largest_tilt"]["value"].as_str().unwrap();
    assert!(words.contains(largest) && json["stones"] == "11 equal stones", "{json}");
    // With a joint at every angle it bears less.
    assert!(largest.parse::<f64>().unwrap() > 0.052_468, "{largest}");
    assert!(of(&format!("{arch} --tilt 0.2")).1.contains("collapses, proved: no state"));
    assert!(of(&format!("{arch} --tilt 0.05 --format csv")).1.ends_with(",11 equal stones\n"));
    let joints = "--joints 0,0.5,1,pi/2 --mu inf --eta 0.15 --tilt 0.05";
    assert!(of(joints).1.contains("stands, proved"));
    let thin = of("--alpha pi/2 --mu 0.4 --eta 0.01 --stones 11 --tilt 0.05");
    assert!(thin.1.contains("without tilt either"), "{thin:?}");
    for (line, why) in [
        ("--alpha 1 --mu 1 --stones 9 --tilt 0.1", "--thickness"),
        ("--alpha 1 --mu 1 --stones 9..11 --eta 0.1 --tilt 0.1", "one number"),
        ("--alpha 1 --mu 1 --stones 2002 --eta 0.1 --tilt 0.1", "at most 2001"),
        ("--alpha 1 --mu 0 --stones 9 --eta 0.1 --tilt 0.1", "friction above 0"),
        ("--alpha 1 --mu 1 --stones 9 --eta 0.1 --tilt -1", "is negative"),
        ("--alpha 1 --mu 1 --stones 9 --eta 0.1 --tilt 0.1 --format svg", "svg"),
    ] {
        let (code, _, error) = of(line);
        assert_eq!(code, Some(2), "{line}");
        assert!(error.lines().count() == 1 && error.contains(why), "{line}: {error}");
    }
}

/// An acceleration is a ratio: forces in kilonewtons are not told with it.
#[test]
fn a_tilt_has_no_dimension() {
    let arch = "--alpha 1 --mu 1 --radius 3m --eta 0.6m --tilt 0.1";
    let (code, out, error) = of(arch);
    assert_eq!(code, Some(0), "{error}");
    assert!(out.contains("thickness 0.6m = 0.181818 r"), "{out}");
    let (code, out, error) = of(&format!("{arch} --density 2000kg/m3 --depth 1m"));
    assert_eq!((code, &out[..]), (Some(2), ""));
    assert!(error.lines().count() == 1 && error.contains("--tilt tells no forces"), "{error}");
}

/// Beside a verdict, what stays open is named: the largest acceleration, and not whether there is a state.
#[test]
fn what_stays_open_beside_a_verdict_is_named() {
    let line = "voussoirs --alpha pi/6 --mu 30deg --stones 2 --eta 0.3 --tilt 0.1";
    let output = couplet(&line.split(' ').collect::<Vec<_>>());
    let [out, error] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(out.contains("stands, proved: an admissible state exists"), "{out}");
    let open = output.status.code() == Some(1);
    assert_eq!(open, error.contains("undecided: the largest tilt: "), "{error}");
    assert_eq!(open, !out.contains("falls from the tilt"), "{out}");
    assert!(!error.contains("whether any state"), "{error}");
}
