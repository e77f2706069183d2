//! `couplet state`, `couplet assess` and `couplet states`.

use super::{exact, printed, stdout};
use crate::program::{couplet, fed, json, text};
use serde_json::Value;
use std::process::Output;

/// The tangent of the half opening, to more digits than any precision that is tried.
fn tangent_of_one_half() -> String {
    let half = rug::Float::with_val(40_000, 0.5);
    half.tan().to_string_radix(10, Some(11_000))
}

/// What stays open is open alone, in every format and in the exit code.
#[test]
fn an_open_quantity_is_named_and_the_rest_is_given() {
    let friction = tangent_of_one_half();
    let asked = |format| {
        let arch = ["assess", "--alpha", "1/2", "--mu", &friction, "--thickness", "0.6"];
        couplet(&[&arch[..], &["--digits", "6", "--format", format]].concat())
    };
    let why = "whether the shoulder can slide";
    let table = asked("table");
    assert_eq!(table.status.code(), Some(1));
    assert_eq!(text(&table.stderr), format!("couplet: undecided: largest_thrust: {why}\n"));
    let lines = text(&table.stdout);
    assert!(lines.contains("stands, proved") && lines.contains(&format!("undecided: {why}")));
    assert!(lines.contains("472.002"), "the safety factor is known");
    let entry: Value = serde_json::from_str(&text(&asked("json").stdout)).unwrap();
    assert_eq!((&entry["verdict"], &entry["stands"]), (&"proved".into(), &true.into()));
    assert_eq!(entry["largest_thrust"]["undecided"], why);
    assert_eq!(entry["least_thrust"]["thrust"]["value"], "0.322101");
    assert_eq!(entry["reason"], format!("largest_thrust: {why}"));
    let csv = text(&asked("csv").stdout);
    let [header, row] =
        [0, 1].map(|line| csv.lines().nth(line).unwrap().split(',').collect::<Vec<_>>());
    let place = header.iter().position(|name| *name == "largest_thrust").unwrap();
    assert_eq!((row[place], row[place - 1]), ("undecided", "0.322101"));
}

/// What is found is text where it is given and a value where it is found, in the same columns.
#[test]
fn what_is_found_is_written_in_every_format() {
    let widest = ["find", "half-opening", "--mu", "0.6", "--eta", "0.15", "--digits", "12"];
    let asked = |format| printed(&[&widest[..], &["--format", format]].concat());
    let entry: Value = serde_json::from_str(&asked("json")).unwrap();
    assert_eq!(entry["schema"], "couplet.find/1");
    assert_eq!((&entry["friction"], &entry["thickness"]), (&"0.6".into(), &"0.15".into()));
    assert_eq!(entry["half_opening"]["value"], "1.71413299187");
    let [lower, upper] = ["lower", "upper"].map(|end| exact(&entry["half_opening"][end]));
    assert!(lower < upper);
    let csv = asked("csv");
    let columns = csv.lines().next().unwrap().split(',').take(7).collect::<Vec<_>>();
    let expected =
        ["weight", "sought", "boundary", "half_opening", "friction", "thickness", "verdict"];
    assert_eq!(columns, expected);
    assert!(csv.contains("milankovitch,half_opening,,1.71413299187,0.6,0.15,proved,\"[r,r,r]\""));
    for format in ["toml", "latex", "c", "rust", "python", "julia", "matlab", "fortran", "plain"] {
        assert!(asked(format).contains("1.71413299187"), "{format}");
    }
    // A friction that is found is one that `state` and `assess` have in other words.
    let at = |arguments: &[&str]| printed(&[arguments, &["--plain", "--digits", "12"]].concat());
    let quantity = |name| ["--quantity", name];
    let arch = ["--half-opening", "pi/2"];
    let sliding =
        at(&[&["state", "--friction", "1"], &arch[..], &quantity("sliding_friction")].concat());
    let friction = quantity("friction");
    assert_eq!(at(&[&["find", "friction"], &arch[..], &friction].concat()), sliding);
    assert_eq!(at(&[&["find", "boundary", "srr/ss"], &arch[..], &friction].concat()), sliding);
    let rotational =
        at(&[&["state", "--friction", "1"], &arch[..], &quantity("rotational_friction")].concat());
    assert_eq!(at(&[&["find", "boundary", "rrr/srr"], &arch[..], &friction].concat()), rotational);
}

#[test]
fn a_state_that_falls_says_what_would_be_enough() {
    let falls = ["state", "--alpha", "pi/2", "--mu", "0.3", "--weight", "heyman", "--digits", "6"];
    let asked = |format| printed(&[&falls[..], &["--format", format]].concat());
    let table = asked("table");
    assert!(table.contains("stands with a friction from") && table.contains("0.309215"), "{table}");
    let entry: Value = serde_json::from_str(&asked("json")).unwrap();
    assert_eq!(entry["sliding_friction"]["value"], "0.309215");
    assert_eq!(entry["enough"]["friction"]["value"], "0.309215");
    let widest = printed(&[
        "find",
        "half-opening",
        "--mu",
        "0.3",
        "--weight",
        "heyman",
        "--digits",
        "6",
        "--plain",
        "--quantity",
        "half_opening",
    ]);
    assert_eq!(entry["enough"]["half_opening"]["value"], widest.trim());
    assert!(asked("csv").contains(",0.309215,"));
}

#[test]
fn a_state_has_its_proof_and_its_schema() {
    let query = ["--half-opening", "2.45", "--friction", "1.35", "--weight", "milankovitch"];
    let state = json(&[&["state"], &query[..], &["--digits", "40", "--format", "json"]].concat());
    assert_eq!(state["schema"], "couplet.state/2");
    assert_eq!((&state["half_opening"], &state["friction"]), (&"2.45".into(), &"1.35".into()));
    assert_eq!(
        (&state["verdict"], &state["can_stand"], &state["mode"]),
        (&"proved".into(), &true.into(), &"[r,r,s]".into())
    );
    assert_eq!(state["thickness"]["value"], "0.6502437808013831727900411061821618712236");
    assert_eq!(state["reason"], Value::Null);
    for key in ["thickness", "thrust", "rotation_joint", "sliding_joint"] {
        let [lower, value, upper] = ["lower", "value", "upper"].map(|end| exact(&state[key][end]));
        assert!(lower <= value && value <= upper && lower < upper, "{key}");
    }
    let aliases =
        json(&["state", "--alpha", "2.45", "--mu", "27/20", "--digits", "40", "--format", "json"]);
    assert_eq!(aliases["thickness"], state["thickness"], "a fraction is the same number");
    let degrees =
        json(&["state", "--alpha", "90deg", "--friction-angle", "21deg", "--format", "json"]);
    let radians =
        json(&["state", "--alpha", "pi/2", "--friction-angle", "7pi/60", "--format", "json"]);
    assert_eq!(degrees["thickness"], radians["thickness"]);
    let falls = json(&["state", "--alpha", "2.6", "--mu", "0.3", "--format", "json"]);
    assert_eq!(
        (&falls["can_stand"], &falls["mode"], &falls["reason"]),
        (&false.into(), &Value::Null, &"sliding".into())
    );
    let thick = json(&["state", "--alpha", "2.65", "--mu", "9", "--format", "json"]);
    assert_eq!(thick["reason"], "thickness");
}

#[test]
fn a_landmark_lists_all_its_modes() {
    let state = json(&["state", "--at", "T", "--weight", "heyman", "--format", "json"]);
    assert_eq!(state["modes"].as_array().unwrap().len(), 4);
    assert_eq!(state["values"]["thickness"]["value"], "0.679604732098885514787534896210");
}

#[test]
fn an_arch_as_it_stands() {
    let found = json(&[
        "assess",
        "--half-opening",
        "80deg",
        "--thickness",
        "0.12",
        "--friction",
        "0.6",
        "--format",
        "json",
    ]);
    assert_eq!((&found["schema"], &found["stands"]), (&"couplet.assess/2".into(), &true.into()));
    assert!(exact(&found["geometric_safety"]["value"]) > 1);
    assert!(
        exact(&found["least_thrust"]["thrust"]["value"])
            < exact(&found["largest_thrust"]["thrust"]["value"])
    );
    let thin = json(&[
        "assess",
        "--half-opening",
        "80deg",
        "--thickness",
        "0.05",
        "--friction",
        "0.6",
        "--format",
        "json",
    ]);
    assert_eq!((&thin["stands"], &thin["least_thrust"]), (&false.into(), &Value::Null));
}

/// Runs `couplet states` on a text.
fn states(arguments: &[&str], input: &str) -> Output {
    fed(&[&["states"], arguments].concat(), input)
}

#[test]
fn many_states_keep_their_order_and_bad_rows_their_line() {
    let mut input = String::from("weight,alpha,mu\n");
    for i in 1..=3000 {
        input += &format!("milankovitch,{i}/1200,2\n");
    }
    input += "heyman,banana,1\nheyman,1\nheyman,pi/2,0.38\n";
    let output = states(&["--columns", "all"], &input);
    assert_eq!(output.status.code(), Some(2), "two rows are bad");
    let text = stdout(&output);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3004);
    // A fraction that ends is the decimal.
    for (i, alpha) in [(1, "1/1200"), (1500, "1.25"), (3000, "2.5")] {
        assert!(lines[i].starts_with(&format!("milankovitch,{alpha},2,proved,")), "{}", lines[i]);
    }
    assert!(
        lines[3001].contains("3002,'banana' is not a number")
            || lines[3001].contains("3002,\"'banana'"),
        "{}",
        lines[3001]
    );
    assert!(lines[3002].contains("3003,2 fields where the header has 3"), "{}", lines[3002]);
    // The nearest double, in decimal and in hexadecimal.
    assert!(lines[3003].contains(",0.12219158636254615,0x1.f47f2a34603cap-4,"), "{}", lines[3003]);
}

#[test]
fn json_lines_in_and_out() {
    let input = "{\"weight\":\"heyman\",\"half_opening\":\"pi/2\",\"friction\":0.38}\n\n{\"weight\":1}\nnonsense\n";
    let output = states(&["--digits", "6"], input);
    assert_eq!(output.status.code(), Some(2));
    let lines: Vec<Value> =
        stdout(&output).lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0]["thickness"]["value"], "0.122192");
    assert_eq!((lines[1]["line"].as_u64(), lines[2]["line"].as_u64()), (Some(3), Some(4)));
    // The symbols of the paper are names too, in both.
    for query in [
        "weight,alpha,mu,eta\nheyman,pi/2,0.38,0.2\n",
        "{\"weight\":\"heyman\",\"alpha\":\"pi/2\",\"mu\":0.38,\"eta\":0.2}\n",
    ] {
        let assessed = states(&["--format", "jsonl", "--digits", "6"], query);
        let line: Value = serde_json::from_str(stdout(&assessed).trim()).unwrap();
        assert_eq!((&line["schema"], &line["stands"]), (&"couplet.assess/2".into(), &true.into()));
    }
}

#[test]
fn a_number_longer_than_a_command_line_is_refused() {
    let digits = format!("0.{}", "1".repeat(100_000));
    let output = states(&[], &format!("weight,alpha,mu\nheyman,{digits},1\n"));
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).contains("a number of 100002 characters is too long"));
}

#[test]
fn a_file_without_queries_is_refused() {
    for input in ["", "\n", "a,b\n1,2\n"] {
        assert_eq!(states(&[], input).status.code(), Some(2), "{input:?}");
    }
}

/// A table for a spreadsheet or a paper has the rows of the usual one.
#[test]
fn rows_are_written_for_people_too() {
    let input = "span;rise;thickness;friction\n12m;6m;80cm;0,6\n12m;5m;80cm;0,6\n";
    let csv2 = stdout(&states(&["--format", "csv2", "--digits", "6"], input));
    assert!(csv2.contains("\nmilankovitch;pi/2;0,6;0,125;intrados;proved;"), "{csv2}");
    assert!(csv2.contains(";0,107478;1,16303;"), "{csv2}");
    let again = stdout(&states(&["--format", "csv2", "--digits", "6"], &csv2));
    assert_eq!(again.matches(";0,107478;1,16303;").count(), 1, "it reads what it writes: {again}");
    let markdown = stdout(&states(&["--format", "markdown", "--digits", "6"], input));
    assert_eq!(markdown.lines().count(), 4, "{markdown}");
    assert!(
        markdown.starts_with("| weight | alpha | mu | eta = t/r | measured at |"),
        "{markdown}"
    );
    assert!(markdown.contains("| 0.107478 | 1.16303 |"), "{markdown}");
    assert!(!markdown.contains("sliding") && !markdown.contains("line"), "empty: {markdown}");
    let latex = stdout(&states(&["--format", "latex", "--digits", "6"], input));
    assert!(latex.contains(r"\num{0.107478} & \num{1.16303}"), "{latex}");
    let with_error = states(&["--format", "markdown"], &format!("{input}12m;5m;80cm;x\n"));
    assert_eq!(with_error.status.code(), Some(2));
    let last = stdout(&with_error);
    assert!(last.contains("| 4 | 'x' is not a friction: "), "{last}");
}
