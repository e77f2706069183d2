//! Assemblies of stones near a threshold: their verdicts by a programme that knows no lemma, their bodies and proofs
//! from the file alone.

mod bodies;
mod file;

use crate::hard::config;
use crate::program::{Json, Scratch, ended, json, object, printed, refused, texts};
use crate::voussoirs::Programme;
use couplet::problem::Mode;
use couplet::strategies::{Assembly, Margin, Near, assemblies, assembly};
use file::fault;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Assemblies of every kind, as the command writes them.
static DRAWN: LazyLock<Vec<Value>> =
    LazyLock::new(|| object("sample --assemblies --count 64").list().to_vec());

/// Verdict of the programme over all joints.
fn programme_says(of: &Assembly) -> bool {
    let double = |x: &couplet::number::ExactNumber| x.nearest_double().unwrap();
    let alpha = double(of.stones.half_opening());
    let programme = Programme::new(of.stones.number(), alpha, of.weight, double(&of.friction));
    programme.stands(double(&of.thickness))
}

#[test]
fn a_programme_over_all_joints_says_the_same() {
    for pair in assemblies(2, Margin::default()).take(64) {
        for of in &pair {
            assert_eq!(programme_says(of), of.stands(), "{of:?}");
        }
        // A flipped verdict is seen.
        assert_ne!(pair[0].stands(), pair[1].stands());
    }
}

proptest! {
    #![proptest_config(config(40))]

    /// What is drawn for property tests is what the programme says too, and as far from its threshold as is said.
    #[test]
    fn a_strategy_draws_assemblies_of_both_verdicts(of in assembly()) {
        prop_assert_eq!(programme_says(&of), of.stands());
        let factor = if of.stands() { 1.001 } else { 0.999 };
        prop_assert!((of.safety.double - factor).abs() < 1e-5, "{}", of.safety);
    }
}

/// Both weights, all modes, both ways of measuring, both thresholds, and 2 to 60 stones.
#[test]
fn every_kind_is_drawn() {
    let kinds = |key| texts(&DRAWN, key).into_iter().collect::<BTreeSet<&str>>();
    assert_eq!(kinds("weight"), BTreeSet::from(["heyman", "milankovitch"]));
    assert_eq!(kinds("unit"), BTreeSet::from(["m", "r"]));
    assert_eq!(kinds("near"), BTreeSet::from_iter(Near::ALL.map(Near::name)));
    let modes = Mode::ALL.iter().map(|mode| mode.label()).collect();
    assert!(kinds("mode").is_superset(&modes), "{:?}", kinds("mode"));
    let stones = DRAWN.iter().map(|question| question["stones"].as_u64().unwrap());
    assert_eq!(stones.clone().min(), Some(2));
    assert!(stones.max().is_some_and(|most| (30..=60).contains(&most)));
}

#[test]
fn bodies_and_proofs_hold_from_the_file_alone() {
    for question in DRAWN.iter() {
        assert_eq!(fault(question), None, "{}", question["id"]);
    }
}

/// A flipped verdict, a vertex, a weight or a centroid that is moved, and another state or bound are seen.
#[test]
fn what_is_spoiled_is_seen() {
    let add = |value: &mut Value, by: f64| *value = json!(value.number() + by);
    for question in DRAWN.iter().take(32) {
        let spoiled = |spoil: &dyn Fn(&mut Value)| {
            let mut twin = question.clone();
            spoil(&mut twin);
            fault(&twin)
        };
        let by = 1e-6 * question["radius"].number();
        let stands = question["stands"].as_bool().unwrap();
        assert!(spoiled(&|of| of["stands"] = json!(!stands)).is_some());
        assert!(spoiled(&|of| add(&mut of["blocks"][1]["polygon"][2][0], by)).is_some());
        assert!(spoiled(&|of| add(&mut of["supports"][1][0][1], by)).is_some());
        assert!(spoiled(&|of| add(&mut of["joints"][1][0][1], by)).is_some());
        assert!(spoiled(&|of| add(&mut of["blocks"][0]["weight"], by)).is_some());
        assert!(spoiled(&|of| add(&mut of["blocks"][1]["centroid"][1], by)).is_some());
        let proof = |spoil: &dyn Fn(&mut Value)| spoiled(&|of| spoil(&mut of["proof"])).is_some();
        match stands {
            true => assert!(proof(&|of| of["moment"] = json!("2"))),
            false => {
                assert!(proof(&|of| of["needed"] = of["borne"].clone()));
                assert!(proof(&|of| of["borne"]["thrust"]["value"] = json!("2")));
            }
        }
    }
}

/// At every margin the numbers are as far off as is said, and a judge of verdicts tells from which margin on they are
/// right: here those of programs that call standing, or leave open, what is within 2 %.
#[test]
fn a_judge_tells_the_margin_from_which_verdicts_are_right() {
    let margins = ["0.1%", "1%", "5%", "20%"];
    let drawn = object(format!("sample --assemblies --count 16 --margin {}", margins.join(",")));
    let drawn = drawn.list();
    assert_eq!(drawn.len(), 2 * 16 * margins.len());
    let mut rows = "program,id,stands\n".to_owned();
    for of in drawn {
        assert_eq!(fault(of), None, "{}", of["id"]);
        let safety = of["safety"].value();
        let margin: f64 = of["margin"].text().trim_end_matches('%').parse().unwrap();
        assert!(((safety - 1.0).abs() - margin / 100.0).abs() < 2e-5, "{}", of["id"]);
        let (id, stands) = (of["id"].text(), of["stands"].as_bool().unwrap());
        rows += &format!("exact,{id},{stands}\nrash,{id},{}\n", stands || margin < 2.0);
        let shy = if margin < 2.0 { String::new() } else { stands.to_string() };
        rows += &format!("shy,{id},{shy}\n");
    }
    let judged = |code, rows: &str| ended(code, "judge - --assemblies --format csv", rows);
    let (table, _) = judged(1, &rows);
    let lines: Vec<&str> = table.lines().collect();
    let expected = [
        "program,margin,right,unsafe,safe,open,right_from",
        "exact,0.1%,32,0,0,0,0.1%",
        "exact,1%,32,0,0,0,0.1%",
        "exact,5%,32,0,0,0,0.1%",
        "exact,20%,32,0,0,0,0.1%",
        "rash,0.1%,16,16,0,0,5%",
        "rash,1%,16,16,0,0,5%",
        "rash,5%,32,0,0,0,5%",
        "rash,20%,32,0,0,0,5%",
        "shy,0.1%,0,0,0,32,5%",
    ];
    assert_eq!(lines[..expected.len()], expected);
    judged(0, "{\"id\": \"001-below\", \"stands\": false}\n");
}

/// The command beside a question proves the same verdict, and its threshold.
#[test]
fn the_commands_prove_the_verdicts_again() {
    for question in DRAWN.iter().take(32) {
        let command = question["command"].text();
        let mut words: Vec<&str> = command.split(' ').skip(1).collect();
        words.extend(["--format", "json", "--digits", "30"]);
        let found = json(&words);
        let assessed = &found["assessment"];
        assert_eq!(assessed["stands"], question["stands"], "{command}");
        let threshold = match question["near"].as_str() {
            Some("friction") => &assessed["required_friction"],
            _ => &found["thickness"],
        };
        let ratio = threshold.value() / question["threshold"].value();
        assert!((ratio - 1.0).abs() < 1e-11, "{command}: {threshold}");
    }
}

#[test]
fn a_seed_draws_the_same_rows() {
    let csv = |seed: &str| printed(["sample", "--assemblies", "--count", "9", "--seed", seed]);
    let first = csv("1");
    assert_eq!((first.lines().count(), &first), (19, &csv("1")));
    assert_ne!(first, csv("2"));
    for (row, question) in first.lines().skip(1).zip(DRAWN.iter()) {
        let id = question["id"].text();
        assert!(row.starts_with(&format!("{id},{},", question["stands"])), "{row}");
        assert!(row.ends_with(question["command"].text()), "{row}");
    }
}

#[test]
fn bodies_are_files_of_a_folder() {
    let scratch = Scratch::new();
    for format in ["obj", "dxf"] {
        let folder = scratch.path(format);
        let of = ["sample", "--assemblies", "--count", "2", "--format", format, "-o", &folder];
        printed(of);
        let names = ["001-above", "001-below", "002-above", "002-below"];
        let names = names.map(|name| format!("{name}.{format}")).to_vec();
        assert_eq!(scratch.files(format), [&names[..], &["assemblies.json".to_owned()]].concat());
        let answers = scratch.json(&format!("{format}/assemblies.json"));
        assert_eq!(answers.list()[..], DRAWN[..4]);
        for (name, question) in names.iter().zip(DRAWN.iter()) {
            let file = scratch.read(&format!("{format}/{name}"));
            assert_eq!(bodies::fault(format, &file, question), None, "{name}");
            let [from, to] = bodies::spoiled(format);
            let twin = file.replacen(from, to, 1);
            assert!(bodies::fault(format, &twin, question).is_some(), "{name}: false twin");
        }
        refused(of, "", "is not empty: name a new or an empty folder");
    }
}

#[test]
fn what_makes_no_sense_is_one_line() {
    assert_eq!(object("sample --assemblies --count 0"), json!([]));
}
