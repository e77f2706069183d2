//! "Stands" means one thing, an admissible symmetric state exists; and wherever it is said, so is what that leaves
//! open.

use crate::program::{Scratch, couplet, fed, json, text};
use serde_json::Value;

const ARCH: [&str; 4] = ["--half-opening", "2.3", "--friction", "1.05"];
/// A little above the thickness at which an asymmetric mechanism of it is proved, by a search made apart from this one.
const MOVES: &str = "0.583084449604";
const MEANING: &str = "an admissible symmetric state exists";
const MAY_MOVE: &str = "friction without dilatancy may let such an arch move";

/// What a command prints about that arch.
fn of(command: &str, more: &[&str]) -> String {
    let output = couplet(&[&[command], &ARCH[..], more].concat());
    assert_eq!(output.status.code(), Some(0), "{command} {more:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

#[test]
fn every_format_of_an_arch_that_stands_tells_it() {
    for (command, thickness) in [("state", &[][..]), ("assess", &["--thickness", "0.55"])] {
        let of = |more: &[&str]| of(command, &[thickness, more].concat());
        let table = of(&[]);
        assert!(table.contains(MEANING) && table.contains(MAY_MOVE) && table.contains(MOVES));
        for (format, key) in
            [("csv", "asymmetric_thickness"), ("latex", "of (19)"), ("c", "ASYMMETRIC_THICKNESS")]
        {
            let out = of(&["--format", format]);
            assert!(out.contains(key) && out.contains(MOVES), "{command} {format}: {out}");
        }
        // Whatever is asked: it goes with the verdict.
        for more in
            [&[][..], &["--quantity", if thickness.is_empty() { "thrust" } else { "least_thrust" }]]
        {
            let found: Value =
                serde_json::from_str(&of(&[&["--format", "json"], more].concat())).unwrap();
            let of = |bound: &str| {
                found["asymmetric_thickness"][bound].as_str().unwrap()[..14].to_owned()
            };
            assert_eq!(["lower", "value", "upper"].map(of), [MOVES; 3]);
        }
    }
    let pi = json(&["state", "--half-opening", "pi/2", "--friction", "0.6", "--format", "json"]);
    assert!(pi["asymmetric_thickness"].is_null() && pi["can_stand"] == true);
    let thin =
        json(&[&["assess"], &ARCH[..], &["--thickness", "0.5", "--format", "json"]].concat());
    assert!(thin["asymmetric_thickness"].is_null() && thin["stands"] == false);
}

/// The largest is the value; the sentence has all.
#[test]
fn of_two_mechanisms_the_larger_thickness_is_the_value() {
    let two =
        ["--half-opening", "2.3", "--friction", "1.09", "--weight", "heyman", "--digits", "12"];
    let table = text(&couplet(&[&["state"], &two[..]].concat()).stdout);
    assert!(table.contains("at the thicknesses 0.652991389316 and 0.639271867997"), "{table}");
    let found = json(&[&["state"], &two[..], &["--format", "json"]].concat());
    assert_eq!(found["asymmetric_thickness"]["value"], "0.652991389316");
}

#[test]
fn rows_tell_it_and_others_have_nothing_there() {
    let table = "half_opening,friction,thickness\n2.3,1.05,\n2.3,1.05,0.55\n2.3,1.05,0.5\n1.5,0.6,\n2.3,inf,0.6\n";
    let found = text(&fed(&["states", "--digits", "12"], table).stdout);
    let columns = "weight,half_opening,friction,thickness,verdict,can_stand,stands,mode,asymmetric_thickness,";
    assert!(found.starts_with(columns), "{found}");
    let tells: Vec<bool> = found.lines().skip(1).map(|line| line.contains(MOVES)).collect();
    assert_eq!(tells, [true, true, false, false, false]);
    let lines = text(&fed(&["states", "--digits", "12", "--format", "jsonl"], table).stdout);
    let value = |line: &str| {
        serde_json::from_str::<Value>(line).unwrap()["asymmetric_thickness"]["value"].clone()
    };
    let values: Vec<Value> = lines.lines().map(value).collect();
    assert_eq!(values[..2], [MOVES, MOVES]);
    assert!(values[2..].iter().all(Value::is_null), "{values:?}");
}

#[test]
fn a_scene_tells_it() {
    let scratch = Scratch::new();
    let item = |more: &str| {
        format!("[[arches]]\nhalf_opening = 2.3\nfriction = 1.05\ndigits = 12\n{more}\n")
    };
    let scene = item("output = \"a.csv\"")
        + &item("thickness = 0.55\nquantities = \"least_thrust\"\noutput = \"b.csv\"");
    scratch.write("scene.toml", format!("schema = \"couplet.scene/1\"\n{scene}"));
    let out = scratch.path("out");
    assert_eq!(
        couplet(&["run", &scratch.path("scene.toml"), "--output", &out]).status.code(),
        Some(0)
    );
    for name in ["out/a.csv", "out/b.csv"] {
        assert!(scratch.read(name).contains(MOVES), "{name}");
    }
}

#[test]
fn what_is_found_says_of_which_arches_it_speaks() {
    for (arguments, some) in [
        ("friction --half-opening 2.3 --thickness 0.55", true),
        ("friction --half-opening 2.3", true),
        ("friction --half-opening 1.5 --thickness 0.2", false),
        ("half-opening --friction 1.05 --thickness 0.55", true),
        ("half-opening --friction 1.05 --thickness 0.3", false),
        ("half-opening --friction inf --thickness 0.55", false),
    ] {
        let all: Vec<&str> = ["find"].into_iter().chain(arguments.split(' ')).collect();
        let table = text(&couplet(&all).stdout);
        assert!(table.contains(MEANING), "{table}");
        assert_eq!(table.contains(MAY_MOVE), some, "{table}");
        assert_eq!(json(&[&all[..], &["--format", "json"]].concat())["some_may_move"], some);
    }
}

#[test]
fn an_arch_of_stones_with_limited_friction_is_not_said_to_stay() {
    let of = |friction: &str, more: &[&str]| {
        let arch = ["voussoirs", "--half-opening", "2.3", "--stones", "8", "--friction", friction];
        text(&couplet(&[&arch[..], more].concat()).stdout)
    };
    for more in [&["--thickness", "0.684422"][..], &[]] {
        let table = of("1.05", more);
        assert!(table.contains(MEANING) && table.contains(MAY_MOVE), "{table}");
        assert!(table.contains("couplet complementarity --stones 8"), "{table}");
        assert!(!of("inf", more).contains(MAY_MOVE));
        for (friction, moves) in [("1.05", true), ("inf", false)] {
            let json = of(friction, &[more, &["--format", "json"]].concat());
            assert_eq!(serde_json::from_str::<Value>(&json).unwrap()["may_move"], moves);
        }
    }
}

/// Of few stones it is decided: all solutions of (19) are found.
#[test]
fn an_arch_of_few_stones_is_said_not_to_move() {
    let all = ["voussoirs", "--half-opening", "pi/2", "--friction", "0.6", "--stones", "11"];
    for more in [&["--thickness", "0.125"][..], &[]] {
        let table = text(&couplet(&[&all[..], more].concat()).stdout);
        assert!(table.contains(MEANING) && !table.contains(MAY_MOVE), "{table}");
        assert!(table.ends_with("there nothing moves without dilatancy either\n"), "{table}");
        let found = json(&[&all[..], more, &["--format", "json"]].concat());
        assert_eq!(found["may_move"], false);
    }
}

#[test]
fn a_picture_tells_it() {
    let svg = of("draw", &["--thickness", "0.55"]);
    assert!(svg.contains(MEANING) && svg.contains(MOVES));
    let drawn: Value =
        serde_json::from_str(&of("draw", &["--thickness", "0.55", "--format", "json"])).unwrap();
    let value = drawn["arches"][0]["asymmetric_thickness"]["value"].as_str().unwrap();
    assert!(value.starts_with(MOVES));
}

/// One word with and without a tilt.
#[test]
fn without_a_tilt_and_with_none_the_word_is_the_same() {
    for more in [&["--thickness", "0.55"][..], &["--thickness", "0.55", "--tilt", "0"]] {
        let table = of("assess", more);
        assert!(table.contains("stands, proved: an admissible"), "{table}");
        assert!(table.contains(MAY_MOVE), "{table}");
    }
}

#[test]
fn the_line_of_a_certificate_says_what_its_word_means() {
    let scratch = Scratch::new();
    for (subject, more) in [("state", &[][..]), ("arch", &["--thickness", "0.55"])] {
        let file = scratch.path(subject);
        of("certify", &[&[subject, "--digits", "5", "-o", &file], more].concat());
        let line = text(&couplet(&["check", &file]).stdout);
        assert!(line.contains("stands") && line.contains(&format!("({MEANING})")), "{line}");
    }
}
