//! Equations of the paper at a rotational joint, on the command line.

use crate::program::{couplet, text};
use serde_json::Value;

fn of(arguments: &str) -> (Option<i32>, String, String) {
    let words: Vec<&str> = ["equation"].into_iter().chain(arguments.split(' ')).collect();
    let output = couplet(&words);
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

fn json(arguments: &str) -> Value {
    let (code, out, error) = of(&format!("{arguments} --format json"));
    assert_eq!(code, Some(0), "{arguments}: {error}");
    serde_json::from_str(&out).unwrap()
}

/// The closed forms and the roots of the cubics are one, to many digits; the other branch is another.
#[test]
fn any_digits_of_a_closed_form_are_those_of_the_root() {
    for (number, place, index) in [(9, 0, 2), (10, 1, 1), (11, 2, 2)] {
        let arguments = "--rotation-joint 57deg --digits 200";
        let closed = &json(&format!("{number} {arguments}"))["branches"][0];
        let roots = &json(&format!("7 {arguments}"))["polynomials"][place]["real_roots"];
        let root = &roots[index];
        assert_eq!(root["branch"], "upper");
        assert_eq!(closed["printed"]["value"], root["root"]["value"]);
        assert_eq!(closed["trigonometric"], closed["printed"]);
        assert_ne!(closed["printed"]["value"], roots[3 - index]["root"]["value"], "false twin");
        assert!(root["root"]["value"].as_str().unwrap().len() > 200);
    }
}

/// Each root is a state of `couplet state` with that joint, and the state of its half opening.
#[test]
fn each_branch_is_a_state_with_the_joint() {
    let state = |arguments: &str| -> Value {
        let words: Vec<&str> = ["state"].into_iter().chain(arguments.split(' ')).collect();
        let output = couplet(&[&words[..], &["--digits", "25", "--format", "json"]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        serde_json::from_str(&text(&output.stdout)).unwrap()
    };
    let found = state("--rotation-joint 1.0");
    let roots = &json("7 --rotation-joint 1.0 --digits 25")["polynomials"][1]["real_roots"];
    let states = found["states"].as_array().unwrap();
    assert_eq!(states.len(), 2);
    for (index, of) in states.iter().enumerate() {
        assert_eq!(of["thickness"], roots[index + 1]["root"]);
        assert_ne!(of["thickness"], roots[2 - index]["root"], "false twin");
        let alpha = of["half_opening"]["value"].as_str().unwrap();
        let back = state(&format!("--half-opening {alpha} --friction inf"));
        let joint: f64 = back["rotation_joint"]["value"].as_str().unwrap().parse().unwrap();
        assert!((joint - 1.0).abs() < 1e-15, "{joint}");
    }
}

#[test]
fn the_sign_of_the_radicand_tells_whether_there_are_states() {
    for (joint, is_positive, states) in [("1.1198", false, 2), ("1.1199", true, 0)] {
        let found = json(&format!("12 --beta {joint}"));
        assert_eq!(found["is_positive"], is_positive, "{joint}");
        let polynomials = json(&format!("7 --beta {joint}"));
        let roots = polynomials["polynomials"][1]["real_roots"].as_array().unwrap();
        assert_eq!(roots.iter().filter(|root| !root["branch"].is_null()).count(), states);
    }
}

#[test]
fn what_stays_open_has_a_reason_and_exit_code_1() {
    let output = couplet(&[
        "constants",
        "sb",
        "--quantity",
        "rotation_joint",
        "--digits",
        "2600",
        "--weight",
        "milankovitch",
        "--plain",
    ]);
    let joint = text(&output.stdout).trim().to_owned();
    let (code, out, error) = of(&format!("12 --beta {joint}"));
    assert_eq!(code, Some(1));
    assert!(out.contains("undecided: the sign of (12)"), "{out}");
    assert!(error.contains("undecided"), "{error}");
    let (code, out, _) = of(&format!("7 --beta {joint} --digits 5"));
    assert_eq!(code, Some(1));
    assert!(out.contains("coefficient of A^3") && !out.contains("root  "), "{out}");
    assert_eq!(of(&format!("12 --beta {}", &joint[..40])).0, Some(0), "false twin");
}
