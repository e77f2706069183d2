//! What one command writes, another reads.

use super::{rows, verdicts};
use crate::program::{Scratch, ended, fed, printed, says};
use serde_json::json;

/// Arches that stand and that do not, with and without a thickness, given in every way.
const QUERIES: &str = "weight,half_opening,friction,thickness\nheyman,1.5,0.6,0.3\nheyman,1.5,0.6,0.05\n\
    milankovitch,1140/199deg,35deg,\nheyman,90deg,0.3,0.1\nmilankovitch,2.62,inf,\nheyman,80deg,tan(0.5),1.9\n\
    heyman,2.6,0.3,\nmilankovitch,1,inf,0.01\nmilankovitch,pi/2,3/5,1/7\n";

/// The same without the column for the thickness, and all of them with one.
fn queries() -> [String; 3] {
    let without = QUERIES.lines().map(|row| format!("{}\n", row.rsplit_once(',').unwrap().0));
    let given = QUERIES.lines().filter(|row| !row.ends_with(',')).map(|row| format!("{row}\n"));
    [QUERIES.to_owned(), without.collect(), given.collect()]
}

/// Everything that is written is accepted, and as many rows as there were.
fn is_judged_right(written: &[u8], count: usize, what: &str) {
    let (code, found) = rows("", written);
    let bad = found.iter().find(|row| row["accepted"] == false);
    assert_eq!((code, bad), (Some(0), None), "{what}");
    assert_eq!(found.len(), count, "{what}");
    let standing = found.iter().filter(|row| row["verdict"] == "correctly rounded");
    assert!(standing.count() > 0, "{what}: numbers were compared");
}

#[test]
fn judge_reads_what_states_writes() {
    for input in queries() {
        let count = input.lines().count() - 1;
        for digits in ["3", "17"] {
            for format in ["csv", "jsonl"] {
                let written = fed(format!("states --digits {digits} --format {format}"), &input);
                let what = format!("{format} {digits} {input}");
                is_judged_right(&written.stdout, count, &what);
            }
        }
    }
}

#[test]
fn a_given_thickness_is_not_the_least() {
    let written = fed("states --format jsonl --digits 5", QUERIES);
    let (_, found) = rows("", &written.stdout);
    says(&found[0], json!({"thickness": "0.3", "stands": true}));
    says(&found[1], json!({"thickness": "0.05", "stands": false}));
    says(&found[2], json!({"thickness": null, "stands": null}));
    assert!(found[0]["numbers"]["geometric_safety"].is_object());
    assert!(found[2]["numbers"]["thickness"].is_object());
    // The same claims with one of them wrong.
    let spoiled = |from: &str, to: &str| {
        let (text, _) = ended(0, "states --format csv --digits 5", QUERIES);
        let (first, rest) = text.split_once("heyman,1.5,0.6,0.3").unwrap();
        let rest = format!("heyman,1.5,0.6,0.3{}", rest.replacen(from, to, 1));
        verdicts(&rows("", format!("{first}{rest}")).1)[0].to_owned()
    };
    assert_eq!(spoiled(",true,", ",false,"), "claims that an arch falls which stands");
    assert_eq!(spoiled(",0.090141,", ",0.090138,"), "thinner than the least thickness");
    assert_eq!(spoiled(",3.3281,", ",3.3291,"), "inaccurate");
}

#[test]
fn judge_and_states_read_what_state_and_assess_write() {
    for format in ["csv", "json"] {
        for (command, question) in [("state", "can_stand"), ("assess --thickness 0.12", "stands")] {
            let what =
                format!("{command} --alpha 80deg --phi 35deg --weight both --format {format}");
            let written = printed(&what);
            is_judged_right(written.as_bytes(), 2, &what);
            asks_again(written.as_bytes(), &what, question);
        }
    }
}

/// What is written asks the same again.
fn asks_again(written: &[u8], what: &str, question: &str) {
    let (text, _) = ended(0, "states --format jsonl --digits 4", written);
    assert!(text.lines().all(|row| row.contains(&format!("\"{question}\":"))), "{what}: {text}");
}

#[test]
fn judge_and_states_read_what_a_scene_writes() {
    let scratch = Scratch::new();
    let item = |more: &str, output: &str| {
        format!(
            "[[arches]]\nhalf_opening = {{ from = \"5deg\", to = \"140deg\", steps = 7 }}\n\
             friction_angle = [\"20deg\", \"35deg\"]\n{more}output = \"{output}\"\n"
        )
    };
    let given = "thickness = [0.1, \"1/7\"]\n";
    let some = "thickness = 0.3\nquantities = \"geometric_safety\"\n";
    let mut scene = String::from("schema = \"couplet.scene/1\"\ndigits = 9\n");
    for end in ["csv", "json"] {
        scene += &item("", &format!("state.{end}"));
        scene += &item(given, &format!("given.{end}"));
        scene += &item(some, &format!("some.{end}"));
    }
    scratch.write("scene.toml", scene);
    let out = scratch.path("out");
    printed(["run", &scratch.path("scene.toml"), "-o", &out]);
    for end in ["csv", "json"] {
        for (name, count, question) in
            [("state", 14, "can_stand"), ("given", 28, "stands"), ("some", 14, "stands")]
        {
            let written = scratch.read(&format!("out/{name}.{end}"));
            let what = format!("{name}.{end}");
            is_judged_right(written.as_bytes(), count, &what);
            asks_again(written.as_bytes(), &what, question);
        }
    }
}
