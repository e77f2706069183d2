//! The command as a user meets it: output, exit codes, one line for each wrong input.

#[path = "common/program.rs"]
mod program;

use couplet::number::Decimal;
use program::{Scratch, couplet};
use rug::Rational;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let output = couplet(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn exact(text: &Value) -> Rational {
    text.as_str().unwrap().parse::<Decimal>().unwrap().to_rational()
}

fn entry<'a>(file: &'a Value, list: &str, keys: &[(&str, &str)]) -> &'a Value {
    let all = file[list].as_array().unwrap();
    all.iter().find(|e| keys.iter().all(|(key, value)| e[*key] == **value)).unwrap()
}

impl Scratch {
    fn files(&self) -> usize {
        std::fs::read_dir(&self.0).unwrap().count()
    }
}

#[test]
fn the_default_table_has_every_landmark_proved() {
    let output = couplet(&["constants"]);
    assert_eq!(output.status.code(), Some(0));
    let text = stdout(&output);
    assert_eq!(text.matches("proved: one solution").count(), 14);
    for line in [
        "0.618318241074323446374432256517",
        "0.679604732098885514787534896210",
        "= 2(2√3−3)",
        "= √3−1",
        "= 2/3",
        "inf",
    ] {
        assert!(text.contains(line), "{line}");
    }
}

#[test]
fn json_is_stable_and_its_bounds_enclose() {
    let file = json(&["constants", "--digits", "25", "--format", "json"]);
    assert_eq!(file["schema"], "couplet.constants/1");
    assert_eq!(file["digits"], 25);
    let more = json(&["constants", "--digits", "60", "--format", "json"]);
    let (few, many) =
        (file["constants"].as_array().unwrap(), more["constants"].as_array().unwrap());
    assert_eq!(few.len(), many.len());
    assert_eq!(few.len(), 2 * (6 * 13 + 8));
    for (few, many) in few.iter().zip(many) {
        for key in ["weight", "landmark", "quantity", "exact"] {
            assert_eq!(few[key], many[key]);
        }
        if few["value"] == "inf" {
            assert_eq!(few["exact"], "inf");
            continue;
        }
        let (lower, value, upper) =
            (exact(&few["lower"]), exact(&few["value"]), exact(&few["upper"]));
        let truth = exact(&many["value"]);
        assert!(lower <= truth && truth <= upper, "{few} {many}");
        let unit = upper.clone() - &lower;
        assert!((value.clone() - truth).abs() * 2 <= unit, "correctly rounded: {few}");
        assert!(value == lower || value == upper);
        let digits =
            few["value"].as_str().unwrap().parse::<Decimal>().unwrap().significant_digits();
        assert!(digits == 25 || few["exact"] != Value::Null, "{few}");
    }
    for proof in file["proofs"].as_array().unwrap() {
        assert_eq!(proof["verdict"], "proved");
        for radius in proof["box_relative_radius"].as_object().unwrap().values() {
            assert!(radius.as_f64().unwrap() > 1e-3, "a macroscopic box: {proof}");
        }
    }
}

#[test]
fn landmarks_and_weights_are_selected() {
    let file = json(&[
        "constants",
        "T",
        "B",
        "--weight",
        "milankovitch",
        "--digits",
        "1000",
        "--format",
        "json",
    ]);
    let constants = file["constants"].as_array().unwrap();
    assert_eq!(constants.len(), 26);
    let thickness = entry(&file, "constants", &[("landmark", "T"), ("quantity", "thickness")]);
    let text = thickness["value"].as_str().unwrap();
    assert!(text.starts_with("0.61831824107432344637443225651706527335"));
    assert_eq!(text.len(), 1002);
    let border = entry(&file, "constants", &[("landmark", "B"), ("quantity", "thickness")]);
    assert_eq!((&border["value"], &border["exact"]), (&"2".into(), &"2".into()));
}

#[test]
fn csv_has_a_row_for_each_constant() {
    let text = stdout(&couplet(&["constants", "L", "--digits", "5", "--format", "csv"]));
    assert_eq!(text.lines().count(), 27);
    assert!(text.starts_with("weight,landmark,quantity,value,lower,upper,exact\n"));
    assert!(text.contains("heyman,L,half_opening,2.7865,2.7864,2.7865,\n"), "{text}");
    assert!(text.contains("milankovitch,L,A,0.66667,0.66666,0.66667,2/3\n"), "{text}");
}

#[test]
fn the_audit_finds_what_the_tables_got_wrong() {
    let file = json(&["audit", "--format", "json"]);
    assert_eq!(file["schema"], "couplet.audit/1");
    let printed = |place, landmark, quantity| {
        entry(&file, "printed", &[("place", place), ("landmark", landmark), ("quantity", quantity)])
    };
    let thickness = printed("Table 1", "T", "thickness");
    assert_eq!(thickness["printed"], "0.6796047320988860");
    assert_eq!(thickness["error_units"], "4.85");
    assert_eq!(thickness["correct_digits"], 14);
    assert_eq!(thickness["verdict"], "wrong");
    assert_eq!(printed("Table 2", "J", "sliding_joint")["verdict"], "correctly rounded");
    assert_eq!(printed("Table 1", "T", "friction")["verdict"], "faithful");
    assert_eq!(printed("Table 4", "l", "A")["verdict"], "correctly rounded");
    let comparison = |landmark, quantity| {
        entry(&file, "comparisons", &[("landmark", landmark), ("quantity", quantity)])["verdict"]
            .clone()
    };
    assert_eq!(comparison("T", "friction"), "proved");
    assert_eq!(comparison("B", "thickness"), "refuted", "both are 2");
}

#[test]
fn wrong_input_is_told_in_one_line_with_what_is_possible() {
    let cases: [(&[&str], &str); 19] = [
        (&["constants", "X"], "one of T, S, J, B, l, L, sb"),
        (&["constants", "t"], "one of T, S, J, B, l, L, sb"),
        (&["constants", "--weight", "both"], "one of heyman, milankovitch"),
        (&["constants", "--format", "yaml"], "one of table, json, csv"),
        (&["audit", "--format", ""], "one of table, json, csv"),
        (&["constants", "--digits", "0"], "from 1 to 1000000"),
        (&["constants", "--digits", "-5"], "from 1 to 1000000"),
        (&["constants", "--digits", "ten"], "from 1 to 1000000"),
        (&["constants", "--digits", "1000001"], "from 1 to 1000000"),
        (&["constants", "--digits", "99999999999999999999999"], "from 1 to 1000000"),
        (&["constants", "--digits", "30.5"], "from 1 to 1000000"),
        (&["constants", "--digits"], "a value is required"),
        (&["constants", "--digit", "3"], "--digits"),
        (&["constant"], "constants"),
        (&["prove", "eq-99"], "the claims are eq-2, eq-3"),
        (&["prove", "eq-"], "the claims are eq-2, eq-3"),
        (&["prove", "--format", "csv"], "one of text, json, latex"),
        (&["study", "accuracy", "--only", "T"], "there are eta-cubic, A-cubic"),
        (&["study", "stability", "--only", "state"], "there are alpha-to-zero"),
    ];
    for (arguments, possible) in cases {
        let output = couplet(arguments);
        let message = String::from_utf8(output.stderr.clone()).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
        assert!(message.contains(possible), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn a_path_that_cannot_be_written_is_a_resource_failure() {
    let scratch = Scratch::new("paths");
    for path in [scratch.path("missing/file.json"), scratch.path("")] {
        let output = couplet(&["constants", "L", "--output", &path]);
        let message = String::from_utf8(output.stderr.clone()).unwrap();
        assert_eq!(output.status.code(), Some(3), "{path}");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains(&path), "{message}");
    }
}

#[test]
fn a_file_appears_whole_and_alone() {
    let scratch = Scratch::new("whole");
    let path = scratch.path("constants.json");
    std::fs::write(&path, "old").unwrap();
    let output = couplet(&["constants", "L", "--format", "json", "--output", &path]);
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stdout.is_empty());
    let file: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!(file["schema"], "couplet.constants/1");
    assert_eq!(scratch.files(), 1, "nothing is left beside it");
    let refused = couplet(&["constants", "L", "--digits", "0", "--output", &path]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(std::fs::read_to_string(&path).unwrap().contains("couplet.constants/1"), "kept");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing() {
    let scratch = Scratch::new("interrupt");
    let path = scratch.path("million.json");
    let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
        .args(["constants", "T", "--digits", "1000000", "--output", &path])
        .spawn()
        .unwrap();
    // The unfinished file is there from the start; the work itself takes many seconds.
    while scratch.files() == 0 {
        std::thread::sleep(std::time::Duration::from_millis(10));
        assert!(child.try_wait().unwrap().is_none(), "the run ended too early to be interrupted");
    }
    std::thread::sleep(std::time::Duration::from_millis(200));
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(130));
    assert_eq!(scratch.files(), 0, "neither a half-written file nor a temporary one");
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_not_replaced() {
    let output = couplet(&["constants", "L", "--output", "/dev/null"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
}

/// A reader that stops early has what it wanted, in every format.
#[test]
fn a_closed_pipe_is_no_failure() {
    for format in ["table", "json", "csv"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
            .args(["constants", "--digits", "5000", "--format", format])
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), message.as_str()), (Some(0), ""), "{format}");
    }
}

#[test]
fn help_goes_to_standard_output() {
    for arguments in
        [&["--help"][..], &["constants", "--help"], &["audit", "--help"], &["--version"]]
    {
        let output = couplet(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(output.stderr.is_empty() && !output.stdout.is_empty());
    }
    assert_eq!(couplet(&[]).status.code(), Some(2));
}

#[test]
fn a_state_has_its_proof_and_its_schema() {
    let query = ["--half-opening", "2.45", "--friction", "1.35", "--weight", "milankovitch"];
    let state = json(&[&["state"], &query[..], &["--digits", "40", "--format", "json"]].concat());
    assert_eq!(state["schema"], "couplet.state/1");
    assert_eq!((&state["half_opening"], &state["friction"]), (&"2.45".into(), &"1.35".into()));
    assert_eq!(
        (&state["verdict"], &state["stands"], &state["mode"]),
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
        (&falls["stands"], &falls["mode"], &falls["reason"]),
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
    assert_eq!((&found["schema"], &found["stands"]), (&"couplet.assess/1".into(), &true.into()));
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
    use std::io::Write;
    let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
        .arg("states")
        .args(arguments)
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || {
        // A command that refuses its input closes the pipe.
        let _ = stdin.write_all(input.as_bytes());
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    output
}

#[test]
fn many_states_keep_their_order_and_bad_rows_their_line() {
    let mut input = String::from("weight,alpha,mu\n");
    for i in 1..=3000 {
        input += &format!("milankovitch,{i}/1200,2\n");
    }
    input += "heyman,banana,1\nheyman,1\nheyman,pi/2,0.38\n";
    let output = states(&[], &input);
    assert_eq!(output.status.code(), Some(2), "two rows are bad");
    let text = stdout(&output);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3004);
    for i in [1, 1500, 3000] {
        assert!(lines[i].starts_with(&format!("milankovitch,{i}/1200,2,proved,")), "{}", lines[i]);
    }
    assert!(
        lines[3001].contains("3002,'banana' is not a number")
            || lines[3001].contains("3002,\"'banana'"),
        "{}",
        lines[3001]
    );
    assert!(lines[3002].contains("3003,2 columns are too few"));
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
        assert_eq!((&line["schema"], &line["stands"]), (&"couplet.assess/1".into(), &true.into()));
    }
}

#[test]
fn claims_are_decided_and_a_misprint_is_no_failure() {
    let file = json(&["prove", "--format", "json"]);
    assert_eq!(file["schema"], "couplet.claims/1");
    let claims = file["claims"].as_array().unwrap();
    assert!(claims.len() >= 30);
    assert!(claims.iter().all(|claim| claim["verdict"] == "proved"), "{claims:?}");
    let claim = |id: &str| claims.iter().find(|claim| claim["id"] == *id).unwrap();
    assert_eq!(claim("eq-8")["as_printed"], "proved");
    assert_eq!(claim("eq-2-4-imply-3")["as_printed"], "not stated");
    let misprint = claim("eq-16");
    assert_eq!(misprint["as_printed"], "refuted");
    assert!(misprint["counterexample"].as_str().unwrap().contains("7−4√3 is not 0"));
    assert!(misprint["corrected"].as_str().unwrap().contains("delta_M eta/6"));
    assert!(misprint.get("derivation").is_none(), "only where it is asked for");
}

#[test]
fn a_derivation_can_be_followed() {
    let text = stdout(&couplet(&["prove", "eq-7", "--show"]));
    for line in [
        "S delta eta^3 + 3 (f + g) eta^2 - 12 (g - S) eta - 12 (f - g)",
        "let    cofactor u of P",
        "given  S != 0, 2 - eta != 0",
        "4 claims: 3 proved as printed, 1 proved, not stated in the paper",
    ] {
        assert!(text.contains(line), "{line}");
    }
    let file = json(&["prove", "eq-8", "--show", "--format", "json"]);
    let steps = file["claims"][0]["derivation"].as_array().unwrap();
    assert!(steps.iter().all(|step| step["support"] == "algebra"));
    let document = stdout(&couplet(&["prove", "eq-7-eta", "--show", "--format", "latex"]));
    assert!(document.starts_with("\\documentclass") && document.ends_with("\\end{document}\n"));
    assert!(document.contains(r"S \delta_M {\eta}^{3} + 3 (f + g) {\eta}^{2}"));
}

#[test]
fn a_study_writes_its_numbers_and_what_figures_are_built_in() {
    let scratch = Scratch::new("study");
    let folder = scratch.path("out");
    let output =
        couplet(&["study", "stability", "--quick", "--only", "eta-to-two", "--output", &folder]);
    let table = stdout(&output);
    assert!(table.contains("lost by the problem itself") && table.contains("(15) as printed"));
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}")).unwrap();
    let rows = read("stability.csv");
    assert_eq!(rows.matches(",proved").count(), 5, "{rows}");
    assert!(read("README.md").contains("study stability --quick --only eta-to-two"));
    let figures = ["svg", "png"].map(|kind| Path::new(&folder).join(format!("digits-lost.{kind}")));
    assert!(figures.iter().all(|figure| figure.exists() == cfg!(feature = "plots")));
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(said.is_empty(), cfg!(feature = "plots"), "{said}");
    if cfg!(feature = "plots") {
        assert!(read("digits-lost.svg").starts_with("<svg"));
    } else {
        assert!(said.lines().count() == 1 && said.contains("no figures"), "{said}");
    }
    let table = stdout(&couplet(&["study", "accuracy", "--quick", "--only", "half-opening"]));
    assert!(table.contains("half-opening  certified balls"), "{table}");
    assert!(!table.contains("fail"), "{table}");
}

#[test]
fn absurd_input_is_refused_quickly() {
    let digits = format!("0.{}", "1".repeat(1_000_000));
    for arguments in [
        &["state", "--alpha", "0", "--mu", "1"][..],
        &["state", "--alpha", "-1", "--mu", "1"],
        &["state", "--alpha", "3.2", "--mu", "1"],
        &["state", "--alpha", "180deg", "--mu", "1"],
        &["state", "--alpha", "nan", "--mu", "1"],
        &["state", "--alpha", "1e-1000000000", "--mu", "1"],
        &["state", "--alpha", "1", "--mu", "-1"],
        &["state", "--alpha", "1", "--mu", "1e1000000000"],
        &["state", "--alpha", "1", "--friction-angle", "91deg"],
        &["state", "--alpha", "1", "--friction-angle", "-1deg"],
        &["state", "--alpha", "1"],
        &["state", "--alpha", "1", "--mu", "1", "--digits", "0"],
        &["assess", "--alpha", "1", "--mu", "1", "--thickness", "2.5"],
        &["assess", "--alpha", "1", "--mu", "1", "--thickness", "0"],
        &["assess", "--alpha", "1", "--mu", "1"],
    ] {
        let output = couplet(arguments);
        let message = String::from_utf8(output.stderr.clone()).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {message}");
        assert_eq!(message.lines().count(), 1, "{arguments:?} {message}");
    }
    // Longer than a command line may be, but not than a file.
    let output = states(&[], &format!("weight,alpha,mu\nheyman,{digits},1\n"));
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).contains("a number of 1000002 characters is too long"));
    for input in ["", "\n", "a,b\n1,2\n"] {
        assert_eq!(states(&[], input).status.code(), Some(2), "{input:?}");
    }
}

/// The README shows real output.
#[test]
fn the_readme_tells_the_truth() {
    let readme = include_str!("../README.md");
    let point = stdout(&couplet(&["constants", "T", "--weight", "milankovitch"]));
    let shown: String =
        point.lines().map(|line| format!("    {line}\n").replace("    \n", "\n")).collect();
    assert!(readme.contains(&shown), "{shown}");
    let state = stdout(&couplet(&[
        "state",
        "--half-opening",
        "2.45",
        "--friction",
        "1.35",
        "--digits",
        "20",
    ]));
    let block = readme.split("--digits 20\n").nth(1).unwrap().split("    …").next().unwrap();
    for line in block.lines().map(str::trim) {
        assert!(state.contains(line), "{line}");
    }
    let audit = stdout(&couplet(&["audit"]));
    let block = readme.split("$ couplet audit\n").nth(1).unwrap().split("\n\n").next().unwrap();
    for line in block.lines().map(str::trim).filter(|line| *line != "…") {
        assert!(audit.contains(line), "{line}");
    }
    let claims = stdout(&couplet(&["prove", "eq-16"]));
    let block =
        readme.split("$ couplet prove eq-16\n").nth(1).unwrap().split("\n\n").next().unwrap();
    // The first line has a time.
    for line in block.lines().skip(1).map(str::trim) {
        assert!(claims.contains(line), "{line}");
    }
    let scratch = Scratch::new("readme");
    let file = scratch.path("T.json");
    couplet(&["certify", "T", "--digits", "1000", "-o", &file]);
    let verdict = stdout(&couplet(&["check", &file])).replace(&file, "T.json");
    assert!(readme.contains(verdict.trim()), "{verdict}");
}

/// Claims are decided in parallel, and many of them wait for the same comparison of the weights.
#[test]
fn no_claim_waits_for_one_that_waits_for_it() {
    for _ in 0..10 {
        for threads in ["3", "6", "12"] {
            let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
                .args(["prove", "weights", "friction"])
                .env("RAYON_NUM_THREADS", threads)
                .stdout(std::process::Stdio::null())
                .spawn()
                .unwrap();
            let start = std::time::Instant::now();
            let status = loop {
                if let Some(status) = child.try_wait().unwrap() {
                    break status;
                }
                if start.elapsed() > std::time::Duration::from_secs(60) {
                    child.kill().unwrap();
                    panic!("{threads} threads wait for one another");
                }
                std::thread::sleep(std::time::Duration::from_millis(5));
            };
            assert!(status.success());
        }
    }
}
