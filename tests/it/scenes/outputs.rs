//! What is written, and what cannot be.

use super::{HEAD, column, scene_in};
use crate::program::{Scratch, couplet, text};
use couplet::problem::Quantity;
use serde_json::Value;
use std::fs;

#[test]
fn an_output_does_not_depend_on_what_else_is_asked() {
    let scratch = Scratch::new();
    let item = "[[constants]]\nlandmarks = [\"T\", \"l\"]\ndigits = 12\noutput = \"a.json\"\n\
                [[arches]]\nhalf_opening = [1, 2]\nfriction = 0.7\ndigits = 8\noutput = \"a.csv\"\n\
                quantities = \"thickness\"\n";
    let others = "[[constants]]\ndigits = 300\noutput = \"b.csv\"\n\
                  [[arches]]\nhalf_opening = [2, 1]\nfriction = \"7/10\"\ndigits = 90\noutput = \"c.json\"\n";
    let alone = scene_in(&scratch, item);
    assert_eq!(couplet(&["run", &alone, "-o", &scratch.path("alone")]).status.code(), Some(0));
    let among = scene_in(&scratch, &format!("{others}{item}"));
    assert_eq!(couplet(&["run", &among, "-o", &scratch.path("among")]).status.code(), Some(0));
    for name in ["a.json", "a.csv"] {
        let (alone, among) =
            (scratch.read(&format!("alone/{name}")), scratch.read(&format!("among/{name}")));
        assert_eq!(alone, among, "{name}");
    }
}

/// An item whose format has the errors of doubles has each arch proved alone; without it those of one half opening
/// share its proofs.
#[test]
fn a_grid_has_the_digits_of_each_of_its_arches_alone() {
    let scratch = Scratch::new();
    // Below, between and next to the frictions at which the mode changes, on one of them as printed, and beyond.
    let arches = "[[arches]]\nweight = \"heyman\"\nhalf_opening = [\"pi/2\", \"80deg\", 2.45, 2.85]\n\
                  friction = [0, 0.1, \"0.21939417869493803\", 0.3, 0.6, 1, 1.33, 2, \"inf\"]\n";
    for asked in ["digits = 17\n", "digits = 32\nquantities = \"thrust\"\n"] {
        let grid = |output: &str| format!("{arches}{asked}output = \"{output}\"\n");
        let shared = grid("a.csv") + &grid("a.json");
        for (scene, out) in [(shared.clone(), "shared"), (shared + &grid("a.toml"), "alone")] {
            let scene = scene_in(&scratch, &scene);
            let out = scratch.path(out);
            assert_eq!(couplet(&["run", &scene, "-o", &out]).status.code(), Some(0));
        }
        for name in ["a.csv", "a.json"] {
            let read = |of: &str| scratch.read(&format!("{of}/{name}"));
            let (shared, alone) = (read("shared"), read("alone"));
            assert!(shared == alone && shared.contains("[r,r,r]"), "{shared}\n{alone}");
        }
    }
}

#[test]
fn a_file_of_arches_has_what_is_asked_and_null_for_the_rest() {
    let scratch = Scratch::new();
    let scene = scene_in(
        &scratch,
        "digits = 17\n[[arches]]\nhalf_opening = 1\nfriction = 1\nquantities = \"thrust\"\noutput = \"a.json\"\n\
         [[arches]]\nhalf_opening = 1\nfriction = 1\nthickness = 0.1\nquantities = \"largest_thrust\"\n\
         output = \"b.json\"\n",
    );
    let out = scratch.path("out");
    assert_eq!(couplet(&["run", &scene, "--output", &out]).status.code(), Some(0));
    for (name, asked, others) in [
        ("a.json", "thrust", &Quantity::STATE[..]),
        ("b.json", "largest_thrust", &Quantity::ASSESSMENT[..]),
    ] {
        let file: Value = serde_json::from_str(&scratch.read(&format!("out/{name}"))).unwrap();
        assert_eq!(file["schema"], "couplet.arches/2");
        assert_eq!(file["quantities"], serde_json::json!([asked]));
        let arch = &file["arches"][0];
        for value in others.iter().map(|quantity| quantity.name()) {
            assert_eq!(arch[value].is_object(), value == asked, "{name} {value}");
        }
    }
    let state: Value = serde_json::from_str(&scratch.read("out/a.json")).unwrap();
    assert!(state["arches"][0]["thrust"]["hex"].as_str().unwrap().starts_with("0x1."));
}

#[test]
fn what_cannot_be_decided_is_said_and_tried_again() {
    let scratch = Scratch::new();
    // A friction nearer to the one at which the mode changes than any precision that is tried can tell.
    let state = ["state", "--half-opening", "pi/2", "--friction", "1", "--weight", "heyman"];
    let output = couplet(&[&state[..], &["--digits", "3000", "--format", "json"]].concat());
    let state: Value = serde_json::from_slice(&output.stdout).unwrap();
    let critical = state["rotational_friction"]["value"].as_str().unwrap();
    let scene = scene_in(
        &scratch,
        &format!(
            "[arches]\nhalf_opening = \"pi/2\"\nweight = \"heyman\"\nfriction = [1, 2, 3, {critical}]\ndigits = 5\n\
         output = \"a.csv\"\n"
        ),
    );
    let out = scratch.path("out");
    for _ in 0..2 {
        let output = couplet(&["run", &scene, "--output", &out, "--resume"]);
        assert_eq!(output.status.code(), Some(1));
        let stderr = text(&output.stderr);
        assert!(stderr.starts_with("written "), "{stderr}");
        let last = format!("couplet: not everything was proved: 1 of 4 arches in {out}/a.csv\n");
        assert!(stderr.ends_with(&last), "{stderr}");
        let verdicts = ["proved", "proved", "proved", "undecided"];
        assert_eq!(column(&scratch.read("out/a.csv"), "verdict"), verdicts);
    }
}

/// Work that would take long.
const SLOW: &str = "[constants]\ndigits = 1_000_000\noutput = \"a.csv\"\n";

/// Known before any work: a file where a folder should be.
fn cannot_be_a_folder(folder: &str) {
    let scratch = Scratch::new();
    scratch.write("file", "");
    let scene = scene_in(&scratch, SLOW);
    let output = couplet(&["run", &scene, "--output", &scratch.path(folder)]);
    assert_eq!(output.status.code(), Some(3), "{folder}");
    assert_eq!(text(&output.stderr).lines().count(), 1);
}

#[test]
fn a_file_as_the_folder_of_outputs_is_known_before_any_work() {
    cannot_be_a_folder("file");
}

#[test]
fn a_folder_below_a_file_is_known_before_any_work() {
    cannot_be_a_folder("file/below");
}

#[test]
fn a_folder_as_an_output_is_known_before_any_work() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, SLOW);
    fs::create_dir_all(scratch.path("out/a.csv")).unwrap();
    let output = couplet(&["run", &scene, "--output", &scratch.path("out")]);
    assert_eq!(output.status.code(), Some(3));
}

#[test]
fn a_missing_scene_is_a_resource_failure() {
    let output = couplet(&["run", &Scratch::new().path("none.toml")]);
    assert_eq!(output.status.code(), Some(3));
}

#[test]
fn the_scene_itself_is_not_written_over() {
    let scratch = Scratch::new();
    scratch.write("a.csv", format!("{HEAD}{SLOW}"));
    let output = couplet(&["run", &scratch.path("a.csv"), "--output", &scratch.path("")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(scratch.read("a.csv").contains("1_000_000"));
}
