//! `[[arches]]` between two ends, and ranges that are cut into boxes.

use super::{column, run, scene_in};
use crate::program::{Json, Scratch, ended, json, object, printed, tells, texts};
use serde_json::Value;

/// What a scene of one item writes, as JSON.
fn answer(item: &str) -> Value {
    let scratch = Scratch::new();
    let text = format!("[[arches]]\n{item}\nformat = \"json\"\n");
    json(["run", &scene_in(&scratch, &text)])
}

/// Ranges beside lists and steps, of both weights.
#[test]
fn an_item_has_an_answer_for_each_choice() {
    let all = answer(
        "alpha = [\"1..1.2\", 1.5]\nmu = { from = 0.6, to = 0.7, steps = 2 }\nweight = \"both\"",
    );
    let all = all.list();
    assert_eq!(all.len(), 8);
    assert_eq!((&all[3]["weight"], &all[4]["weight"]), (&"heyman".into(), &"milankovitch".into()));
    assert_eq!(all[1]["asked"]["friction"], "0.7");
}

const BOXES: &str = "alpha = { from = \"78deg\", to = \"84deg\", boxes = 3 }\n\
    mu = { from = 0.2, to = 0.6, boxes = 4 }\neta = { from = 0.05, to = 0.11, boxes = 3 }\n";

/// Each box is the answer to its own question; the boxes touch and are all of it, and the counts are theirs.
#[test]
fn boxes_are_counted_by_what_is_proved_of_each() {
    let all = answer(BOXES);
    let cells = all["cells"].list();
    assert_eq!((all["boxes"].as_u64(), cells.len()), (Some(36), 36));
    let mut counts = std::collections::BTreeMap::new();
    for cell in cells {
        let asked = |name: &str| cell[name].text().to_owned();
        let [alpha, mu, eta] = ["half_opening", "friction", "thickness"].map(asked);
        let alone = object(format!("assess --alpha {alpha} --mu {mu} --eta {eta}"));
        assert_eq!(cell["outcome"], alone["outcome"]);
        for range in alone["ranges"].list() {
            let name = range["quantity"].text();
            for side in ["lower", "upper"] {
                let value = &range[side]["value"];
                let told = &cell[format!("{name}_{side}")];
                assert!(told == value || range[side]["bound"] == "unbounded" && told == "inf");
            }
        }
        *counts.entry(cell["outcome"].text()).or_insert(0u64) += 1;
    }
    assert!(counts.len() == 3, "all three occur: {counts:?}");
    for outcome in all["outcomes"].list() {
        let name = outcome["outcome"].text();
        assert_eq!(outcome["boxes"].as_u64().unwrap(), counts.get(name).copied().unwrap_or(0));
    }
    // The last key is the fastest.
    assert_eq!(texts(&cells[..3], "thickness"), ["0.05..0.07", "0.07..0.09", "0.09..0.11"]);
}

/// Half the width of each box, and so eight of them, decide no less.
#[test]
fn finer_boxes_leave_less_open() {
    let both = |item: &str| {
        let all = answer(item);
        let of = |name: &str| {
            let mut all = all["outcomes"].list().iter();
            all.find(|outcome| outcome["outcome"] == name).unwrap()["boxes"].as_u64().unwrap()
        };
        ["all_stand", "none_stands", "both_occur"].map(of)
    };
    let coarse = both(BOXES);
    let fine = both(&BOXES.replace("boxes = 3", "boxes = 6").replace("boxes = 4", "boxes = 8"));
    assert!(fine[0] >= 8 * coarse[0] && fine[1] >= 8 * coarse[1], "{coarse:?} {fine:?}");
    assert!(fine[2] < 8 * coarse[2], "{coarse:?} {fine:?}");
}

#[test]
fn boxes_are_a_summary_a_table_and_lengths_too() {
    let scratch = Scratch::new();
    let item = "[[arches]]\nspan = { from = \"9.9m\", to = \"10.1m\", boxes = 2 }\nrise = \"3m\"\nmu = \"0.5..0.6\"\n\
        eta = { from = \"12cm\", to = \"0.2m\", boxes = 4 }\nweight = \"heyman\"\n";
    let scene = scene_in(&scratch, &format!("{item}{item}output = \"a.csv\"\n"));
    let table = printed(["run", &scene, "-o", &scratch.path("out")]);
    tells(&table, ["8 boxes: thickness in 4, span in 2"]);
    let csv = scratch.read("out/a.csv");
    assert_eq!(column(&csv, "thickness")[..2], ["0.12m..0.14m", "0.12m..0.14m"]);
    let outcomes = column(&csv, "outcome");
    assert_eq!(outcomes.len(), 8);
    let row = |words: &str| {
        let line = table.lines().find(|line| line.contains(words)).unwrap();
        line.split_whitespace().last().unwrap().parse::<usize>().unwrap()
    };
    let told = |name: &str| outcomes.iter().filter(|outcome| *outcome == name).count();
    assert_eq!(row("every arch stands"), told("all_stand"));
    assert_eq!(row("no arch stands"), told("none_stands"));
}

/// Arches without a thickness can stand or not; a table has each column once.
#[test]
fn boxes_without_a_thickness_can_stand_or_not() {
    let item = "alpha = { from = \"100deg\", to = \"150deg\", boxes = 5 }\nmu = { from = 0.3, to = 1.5, boxes = 4 }\n\
        weight = \"both\"";
    let all = answer(item);
    let counts = |of: &Value| -> Vec<u64> {
        of["outcomes"].list().iter().map(|of| of["boxes"].as_u64().unwrap()).collect()
    };
    let words = ["all_can_stand", "none_can_stand", "both_occur", "undecided"];
    for (of, weight) in all.list().iter().zip(["heyman", "milankovitch"]) {
        assert_eq!(of["weight"], weight);
        assert_eq!(texts(of["outcomes"].list(), "outcome"), words);
        assert_eq!(counts(of).iter().sum::<u64>(), 20);
    }
    let scratch = Scratch::new();
    run(&scratch, &format!("[[arches]]\n{item}\noutput = \"a.csv\"\n"), "");
    let csv = scratch.read("out/a.csv");
    let header: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    let each: std::collections::BTreeSet<&&str> = header.iter().collect();
    assert_eq!(each.len(), header.len(), "{header:?}");
    let told = |name: &str| column(&csv, "outcome").iter().filter(|of| *of == name).count() as u64;
    for (place, word) in words.into_iter().enumerate() {
        let sum: u64 = all.list().iter().map(|of| counts(of)[place]).sum();
        assert_eq!(told(word), sum, "{word}");
    }
}

/// An output is kept if the same was asked, and not if the boxes are others, though the whole is the same.
#[test]
fn boxes_are_kept_or_computed_again() {
    let scratch = Scratch::new();
    let run = |item: &str| {
        let told = run(&scratch, &format!("[[arches]]\n{item}output = \"a.json\"\n"), "--resume");
        (told, scratch.read("out/a.json"))
    };
    let (first, bytes) = run(BOXES);
    assert!(first.contains("written"), "{first}");
    let (again, same) = run(&BOXES.replace("mu =", "friction  =").replace("0.2,", "\"0.2\","));
    assert!(again.contains("kept") && same == bytes, "{again}");
    let (other, finer) = run(&BOXES.replace("boxes = 4", "boxes = 5"));
    assert!(other.contains("written") && finer != bytes, "{other}");
    let (list, _) = run("alpha = [\"78deg..81deg\", \"81deg..84deg\"]\nmu = 0.5\neta = 0.1\n");
    let (boxes, _) =
        run("alpha = { from = \"78deg\", to = \"84deg\", boxes = 2 }\nmu = 0.5\neta = 0.1\n");
    assert!(list.contains("written") && boxes.contains("written"), "a summary is another answer");
}

#[cfg(feature = "parquet")]
#[test]
fn a_sweep_refuses_boxes_with_what_takes_them() {
    let scratch = Scratch::new();
    let plan = "schema = \"couplet.sweep/1\"\n[grid]\nfriction = 1\n\
        half_opening = { from = 1, to = 2, boxes = 4 }\n";
    scratch.write("plan.toml", plan);
    let words = "is cut into boxes, which [[arches]] of a scene takes alone; give steps here";
    let asked = ["sweep", &scratch.path("plan.toml"), "-o", &scratch.path("out")];
    let (_, told) = ended(2, asked, "");
    assert_eq!(told.lines().count(), 2, "{told}");
    assert!(told.contains(&format!("plan.toml:4:16: half_opening {words}")), "{told}");
}
