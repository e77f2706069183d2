//! `couplet state`, `couplet assess` and `couplet states`.

use super::exact;
use crate::arches::tangent_of_one_half;
use crate::program::{Json, ended, object, of_lines, printed, rows, says, tells};
use serde_json::{Value, json};

/// What stays open is open alone, in every format and in the exit code.
#[test]
fn an_open_quantity_is_named_and_the_rest_is_given() {
    let friction = tangent_of_one_half();
    let line = format!("assess --alpha 1/2 --mu {friction} --thickness 0.6 --digits 6 --format");
    let asked = |format| ended(1, format!("{line} {format}"), "");
    let why = "whether the shoulder can slide";
    let (lines, error) = asked("table");
    assert_eq!(error, format!("couplet: undecided: largest_thrust: {why}\n"));
    tells(&lines, ["stands, proved", &format!("undecided: {why}"), "472.002"]);
    let entry: Value = serde_json::from_str(&asked("json").0).unwrap();
    let expected = json!({
        "verdict": "proved", "stands": true, "reason": format!("largest_thrust: {why}"),
        "largest_thrust": {"undecided": why}, "least_thrust": {"thrust": {"value": "0.322101"}},
    });
    says(&entry, expected);
    let row = &rows(asked("csv").0)[0];
    let cells = ["least_thrust", "largest_thrust"].map(|name| row[name].as_str());
    assert_eq!(cells, ["0.322101", "undecided"]);
}

/// What is found is text where it is given and a value where it is found, in the same columns.
#[test]
fn what_is_found_is_written_in_every_format() {
    let widest = "find half-opening --mu 0.6 --eta 0.15 --digits 12";
    let asked = |format| printed(format!("{widest} --format {format}"));
    let entry = object(widest);
    says(&entry, json!({"schema": "couplet.find/1", "friction": "0.6", "thickness": "0.15"}));
    assert_eq!(entry["half_opening"]["value"], "1.71413299187");
    let [lower, upper] = ["lower", "upper"].map(|end| exact(&entry["half_opening"][end]));
    assert!(lower < upper);
    let csv = asked("csv");
    let columns = "weight,sought,boundary,half_opening,friction,thickness,verdict,";
    assert!(csv.starts_with(columns), "{csv}");
    assert!(csv.contains("milankovitch,half_opening,,1.71413299187,0.6,0.15,proved,\"[r,r,r]\""));
    for format in ["toml", "latex", "c", "rust", "python", "julia", "matlab", "fortran", "plain"] {
        assert!(asked(format).contains("1.71413299187"), "{format}");
    }
    // A friction that is found is one that `state` and `assess` have in other words.
    let at = |asked, quantity| {
        printed(format!("{asked} --half-opening pi/2 --quantity {quantity} --plain --digits 12"))
    };
    let sliding = at("state --friction 1", "sliding_friction");
    assert_eq!(at("find friction", "friction"), sliding);
    assert_eq!(at("find boundary srr/ss", "friction"), sliding);
    let rotational = at("state --friction 1", "rotational_friction");
    assert_eq!(at("find boundary rrr/srr", "friction"), rotational);
}

#[test]
fn a_state_has_its_proof_and_its_schema() {
    let state =
        object("state --half-opening 2.45 --friction 1.35 --weight milankovitch --digits 40");
    let expected = json!({
        "schema": "couplet.state/2", "half_opening": "2.45", "friction": "1.35",
        "verdict": "proved", "can_stand": true, "mode": "[r,r,s]", "reason": null,
        "thickness": {"value": "0.6502437808013831727900411061821618712236"},
    });
    says(&state, expected);
    for key in ["thickness", "thrust", "rotation_joint", "sliding_joint"] {
        let [lower, value, upper] = ["lower", "value", "upper"].map(|end| exact(&state[key][end]));
        assert!(lower <= value && value <= upper && lower < upper, "{key}");
    }
    let aliases = object("state --alpha 2.45 --mu 27/20 --digits 40");
    assert_eq!(aliases["thickness"], state["thickness"], "a fraction is the same number");
    let degrees = object("state --alpha 90deg --friction-angle 21deg");
    let radians = object("state --alpha pi/2 --friction-angle 7pi/60");
    assert_eq!(degrees["thickness"], radians["thickness"]);
    let falls = object("state --alpha 2.6 --mu 0.3");
    says(&falls, json!({"can_stand": false, "mode": null, "reason": "sliding"}));
    says(&object("state --alpha 2.65 --mu 9"), json!({"reason": "thickness"}));
}

#[test]
fn a_landmark_lists_all_its_modes() {
    let state = object("state --at T --weight heyman");
    assert_eq!(state["modes"].list().len(), 4);
    assert_eq!(state["values"]["thickness"]["value"], "0.679604732098885514787534896210");
}

#[test]
fn many_states_keep_their_order_and_bad_rows_their_line() {
    let mut input = String::from("weight,alpha,mu\n");
    for i in 1..=3000 {
        input += &format!("milankovitch,{i}/1200,2\n");
    }
    input += "heyman,banana,1\nheyman,1\nheyman,pi/2,0.38\n";
    // Two rows are bad.
    let (text, _) = ended(2, "states --columns all", &input);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3004);
    // A fraction that ends is the decimal.
    for (i, alpha) in [(1, "1/1200"), (1500, "1.25"), (3000, "2.5")] {
        assert!(lines[i].starts_with(&format!("milankovitch,{alpha},2,proved,")), "{}", lines[i]);
    }
    assert!(lines[3001].contains("3002,\"'banana' is not a number"), "{}", lines[3001]);
    assert!(lines[3002].contains("3003,2 fields where the header has 3"), "{}", lines[3002]);
    // The nearest double, in decimal and in hexadecimal.
    assert!(lines[3003].contains(",0.12219158636254615,0x1.f47f2a34603cap-4,"), "{}", lines[3003]);
}

#[test]
fn json_lines_in_and_out() {
    let input = "{\"weight\":\"heyman\",\"half_opening\":\"pi/2\",\"friction\":0.38}\n\n{\"weight\":1}\nnonsense\n";
    let lines = of_lines(&ended(2, "states --digits 6", input).0);
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0]["thickness"]["value"], "0.122192");
    assert_eq!((lines[1]["line"].as_u64(), lines[2]["line"].as_u64()), (Some(3), Some(4)));
    // The symbols of the paper are names too, in both.
    for query in [
        "weight,alpha,mu,eta\nheyman,pi/2,0.38,0.2\n",
        "{\"weight\":\"heyman\",\"alpha\":\"pi/2\",\"mu\":0.38,\"eta\":0.2}\n",
    ] {
        let line = &crate::program::lines("states --digits 6", query)[0];
        assert_eq!((&line["schema"], &line["stands"]), (&"couplet.assess/2".into(), &true.into()));
    }
}

#[test]
fn a_number_longer_than_a_command_line_is_refused() {
    let digits = format!("0.{}", "1".repeat(100_000));
    let (output, _) = ended(2, "states", format!("weight,alpha,mu\nheyman,{digits},1\n"));
    tells(&output, ["a number of 100002 characters is too long"]);
}
