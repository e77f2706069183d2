//! What is written, and what cannot be.

use super::{HEAD, column, run, scene_in};
use crate::program::{Json, Scratch, ended, object, says};
use couplet::problem::Quantity;
use serde_json::json;
use std::fs;

#[test]
fn an_output_does_not_depend_on_what_else_is_asked() {
    let scratch = Scratch::new();
    let item = "[[constants]]\nlandmarks = [\"T\", \"l\"]\ndigits = 12\noutput = \"a.json\"\n\
                [[arches]]\nhalf_opening = [1, 2]\nfriction = 0.7\ndigits = 8\noutput = \"a.csv\"\n\
                quantities = \"thickness\"\n";
    let others = "[[constants]]\ndigits = 300\noutput = \"b.csv\"\n\
                  [[arches]]\nhalf_opening = [2, 1]\nfriction = \"7/10\"\ndigits = 90\noutput = \"c.json\"\n";
    let written = |scene: &str| {
        run(&scratch, scene, "");
        ["a.json", "a.csv"].map(|name| scratch.read(&format!("out/{name}")))
    };
    assert_eq!(written(item), written(&format!("{others}{item}")));
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
        let written = |scene: &str| {
            run(&scratch, scene, "");
            ["a.csv", "a.json"].map(|name| scratch.read(&format!("out/{name}")))
        };
        let (together, alone) = (written(&shared), written(&(shared.clone() + &grid("a.toml"))));
        assert_eq!(together, alone);
        assert!(together.iter().all(|text| text.contains("[r,r,r]")), "{together:?}");
    }
}

#[test]
fn a_file_of_arches_has_what_is_asked_and_null_for_the_rest() {
    let scratch = Scratch::new();
    let scene = "digits = 17\n[[arches]]\nhalf_opening = 1\nfriction = 1\nquantities = \"thrust\"\noutput = \"a.json\"\n\
                 [[arches]]\nhalf_opening = 1\nfriction = 1\nthickness = 0.1\nquantities = \"largest_thrust\"\n\
                 output = \"b.json\"\n";
    run(&scratch, scene, "");
    for (name, asked, others) in [
        ("a.json", "thrust", &Quantity::STATE[..]),
        ("b.json", "largest_thrust", &Quantity::ASSESSMENT[..]),
    ] {
        let file = scratch.json(&format!("out/{name}"));
        says(&file, json!({"schema": "couplet.arches/2", "quantities": [asked]}));
        let arch = &file["arches"][0];
        for value in others.iter().map(|quantity| quantity.name()) {
            assert_eq!(arch[value].is_object(), value == asked, "{name} {value}");
        }
    }
    let state = scratch.json("out/a.json");
    assert!(state["arches"][0]["thrust"]["hex"].text().starts_with("0x1."));
}

#[test]
fn what_cannot_be_decided_is_said_and_tried_again() {
    let scratch = Scratch::new();
    // A friction nearer to the one at which the mode changes than any precision that is tried can tell.
    let state = object("state --half-opening pi/2 --friction 1 --weight heyman --digits 3000");
    let critical = state["rotational_friction"]["value"].text();
    let text = format!(
        "[arches]\nhalf_opening = \"pi/2\"\nweight = \"heyman\"\nfriction = [1, 2, 3, {critical}]\ndigits = 5\n\
         output = \"a.csv\"\n"
    );
    let scene = scene_in(&scratch, &text);
    let out = scratch.path("out");
    for _ in 0..2 {
        let (_, stderr) = ended(1, ["run", &scene, "--output", &out, "--resume"], "");
        assert!(stderr.starts_with("written "), "{stderr}");
        let last = format!("couplet: not everything was proved: 1 of 4 arches in {out}/a.csv\n");
        assert!(stderr.ends_with(&last), "{stderr}");
        let verdicts = ["proved", "proved", "proved", "undecided"];
        assert_eq!(column(&scratch.read("out/a.csv"), "verdict"), verdicts);
    }
}

/// Work that would take long.
const SLOW: &str = "[constants]\ndigits = 1_000_000\noutput = \"a.csv\"\n";

/// A file as the folder of outputs, a folder below a file, and a folder in the place of an output.
#[test]
fn what_cannot_be_written_is_known_before_any_work() {
    let scratch = Scratch::new();
    scratch.write("file", "");
    let scene = scene_in(&scratch, SLOW);
    fs::create_dir_all(scratch.path("out/a.csv")).unwrap();
    for folder in ["file", "file/below", "out"] {
        let (_, message) = ended(3, ["run", &scene, "--output", &scratch.path(folder)], "");
        assert_eq!(message.lines().count(), 1, "{folder}: {message}");
    }
}

#[test]
fn the_scene_itself_is_not_written_over() {
    let scratch = Scratch::new();
    scratch.write("a.csv", format!("{HEAD}{SLOW}"));
    ended(2, ["run", &scratch.path("a.csv"), "--output", &scratch.path("")], "");
    assert!(scratch.read("a.csv").contains("1_000_000"));
}
