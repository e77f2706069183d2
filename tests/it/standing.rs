//! "Stands" means one thing, an admissible symmetric state exists; and wherever it is said, so is what that leaves
//! open.

use crate::program::{Json, Scratch, ended, lines, object, printed, tells};

const ARCH: &str = "--half-opening 2.3 --friction 1.05";
/// A little above the thickness at which an asymmetric mechanism of it is proved, by a search made apart from this one.
const MOVES: &str = "0.583084449604";
const MEANING: &str = "an admissible symmetric state exists";
const MAY_MOVE: &str = "friction without dilatancy may let such an arch move";

/// What a command prints about that arch.
fn of(command: &str, more: &str) -> String {
    printed(format!("{command} {ARCH} {more}"))
}

#[test]
fn every_format_of_an_arch_that_stands_tells_it() {
    let asked = [("state", "", "thrust"), ("assess", "--thickness 0.55", "least_thrust")];
    for (command, thickness, quantity) in asked {
        let of = |more: &str| of(command, &format!("{thickness} {more}"));
        tells(&of(""), [MEANING, MAY_MOVE, MOVES]);
        let keys =
            [("csv", "asymmetric_thickness"), ("latex", "of (19)"), ("c", "ASYMMETRIC_THICKNESS")];
        for (format, key) in keys {
            tells(&of(&format!("--format {format}")), [key, MOVES]);
        }
        // Whatever is asked: it goes with the verdict.
        for more in [String::new(), format!("--quantity {quantity}")] {
            let found = object(format!("{command} {ARCH} {thickness} {more}"));
            let of = |bound: &str| found["asymmetric_thickness"][bound].text()[..14].to_owned();
            assert_eq!(["lower", "value", "upper"].map(of), [MOVES; 3]);
        }
    }
    let pi = object("state --half-opening pi/2 --friction 0.6");
    assert!(pi["asymmetric_thickness"].is_null() && pi["can_stand"] == true);
    let thin = object(format!("assess {ARCH} --thickness 0.5"));
    assert!(thin["asymmetric_thickness"].is_null() && thin["stands"] == false);
}

/// The largest is the value; the sentence has all.
#[test]
fn of_two_mechanisms_the_larger_thickness_is_the_value() {
    let two = "state --half-opening 2.3 --friction 1.09 --weight heyman --digits 12";
    let table = printed(two);
    assert!(table.contains("at the thicknesses 0.652991389316 and 0.639271867997"), "{table}");
    assert_eq!(object(two)["asymmetric_thickness"]["value"], "0.652991389316");
}

#[test]
fn rows_tell_it_and_others_have_nothing_there() {
    let table = "half_opening,friction,thickness\n2.3,1.05,\n2.3,1.05,0.55\n2.3,1.05,0.5\n1.5,0.6,\n2.3,inf,0.6\n";
    let (found, _) = ended(0, "states --digits 12", table);
    let columns = "weight,half_opening,friction,thickness,verdict,can_stand,stands,mode,asymmetric_thickness,";
    assert!(found.starts_with(columns), "{found}");
    let tells: Vec<bool> = found.lines().skip(1).map(|line| line.contains(MOVES)).collect();
    assert_eq!(tells, [true, true, false, false, false]);
    let found = lines("states --digits 12", table);
    let values = found.iter().map(|row| row["asymmetric_thickness"]["value"].as_str());
    assert_eq!(values.collect::<Vec<_>>(), [Some(MOVES), Some(MOVES), None, None, None]);
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
    printed(["run", &scratch.path("scene.toml"), "--output", &scratch.path("out")]);
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
        ("half-opening --friction 1e100 --thickness 0.05", false),
        ("friction --half-opening 1e-100 --thickness 0.5", false),
    ] {
        let table = printed(format!("find {arguments}"));
        assert!(table.contains(MEANING), "{table}");
        assert_eq!(table.contains(MAY_MOVE), some, "{table}");
        assert_eq!(object(format!("find {arguments}"))["some_may_move"], some);
    }
}

#[test]
fn an_arch_of_stones_with_limited_friction_is_not_said_to_stay() {
    for more in ["--thickness 0.684422", ""] {
        let arch = format!("voussoirs --half-opening 2.3 --stones 8 {more} --friction");
        let table = printed(format!("{arch} 1.05"));
        tells(&table, [MEANING, MAY_MOVE, "couplet complementarity --stones 8"]);
        let of_many = printed("voussoirs --half-opening 2.3 --stones 61 --friction 1.05");
        assert!(of_many.contains(MAY_MOVE) && !of_many.contains("complementarity"), "{of_many}");
        assert!(!printed(format!("{arch} inf")).contains(MAY_MOVE));
        for (friction, moves) in [("1.05", true), ("inf", false)] {
            assert_eq!(object(format!("{arch} {friction}"))["may_move"], moves);
        }
    }
}

/// Of few stones it is decided: all solutions of (19) are found.
#[test]
fn an_arch_of_few_stones_is_said_not_to_move() {
    for more in ["--thickness 0.125", ""] {
        let line = format!("voussoirs --half-opening pi/2 --friction 0.6 --stones 11 {more}");
        let table = printed(&line);
        assert!(table.contains(MEANING) && !table.contains(MAY_MOVE), "{table}");
        assert!(table.ends_with("there nothing moves without dilatancy either\n"), "{table}");
        assert_eq!(object(line)["may_move"], false);
    }
}

#[test]
fn a_picture_tells_it() {
    tells(&of("draw", "--thickness 0.55"), [MEANING, MOVES]);
    let drawn = object(format!("draw {ARCH} --thickness 0.55"));
    let value = drawn["arches"][0]["asymmetric_thickness"]["value"].text();
    assert!(value.starts_with(MOVES));
}

/// One word with and without a tilt.
#[test]
fn without_a_tilt_and_with_none_the_word_is_the_same() {
    for more in ["", "--tilt 0"] {
        let table = of("assess", &format!("--thickness 0.55 {more}"));
        tells(&table, ["stands, proved: an admissible", MAY_MOVE]);
    }
}

#[test]
fn the_line_of_a_certificate_says_what_its_word_means() {
    let scratch = Scratch::new();
    for (subject, more) in [("state", ""), ("arch", "--thickness 0.55")] {
        let file = scratch.path(subject);
        printed(format!("certify {subject} {ARCH} --digits 5 -o {file} {more}"));
        tells(&printed(["check", &file]), ["stands", &format!("({MEANING})")]);
    }
}
