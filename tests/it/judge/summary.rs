//! What is said of all rows, and of rows without end.

use super::rows;
use crate::program::{Json, Scratch, couplet, ended, says, start, text};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::thread;

/// What is written does not wait for the end of the file.
#[test]
fn a_file_without_end_is_judged_as_it_comes() {
    let mut child = start("judge - --weight heyman --format csv --worst 0");
    let mut stdin = child.stdin.take().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    // Who writes on and on is stopped by the program alone.
    let writer = thread::spawn(move || {
        let rows = "1,0.5,0.0211\n".repeat(1000);
        stdin.write_all(b"half_opening,friction,thickness\n").unwrap();
        while stdin.write_all(rows.as_bytes()).is_ok() {}
    });
    let first: Vec<String> = lines.by_ref().take(2000).map(Result::unwrap).collect();
    assert!(first[0].starts_with("line,weight,") && first[1999].starts_with("2000,heyman,1,0.5,"));
    // The reader goes away while the file still grows: that is no failure.
    drop(lines);
    writer.join().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
}

/// The verdicts beside the rows are said to who runs the command within itself, as to standard error.
#[test]
fn who_runs_it_hears_the_verdicts() {
    let scratch = Scratch::new();
    scratch.write("in.csv", "half_opening,friction,thickness\n1,0.5,0.0211\npi/2,0.38,0.9\n");
    let line = format!("judge {} --weight heyman --accept 3 --format csv", scratch.path("in.csv"));
    let output = couplet(line.as_str());
    let (code, heard) = couplet::cli::heard(line.split(' ').map(Into::into).collect());
    assert_eq!(output.status.code(), Some(code.into()));
    assert_eq!(heard.written, output.stdout);
    assert!(heard.said.len() > 2, "{heard:?}");
    assert_eq!(heard.said.join("\n") + "\n", text(&output.stderr));
}

#[test]
fn a_summary_keeps_the_worst_and_counts_all() {
    let mut input = String::from("half_opening,friction,thickness\n");
    for i in 0..3000 {
        input += &format!("pi/2,0.38,0.12219{:04}\n", i % 1000);
    }
    input += "pi/2,0.38,0.121\npi/2,0.38,0.100\npi/2,0.3,0.1\npi/2,0.38,0.9\n";
    let scratch = Scratch::new();
    scratch.write("in.csv", &input);
    let (file, found) = (scratch.path("in.csv"), scratch.path("out.json"));
    let demand = "--weight heyman --accept 3 --format json --worst 4";
    let (_, message) = ended(1, format!("judge {file} {demand} -o {found}"), "");
    assert_eq!(message, "couplet: 4 of 3004 rows are not accepted\n");
    let found = scratch.json("out.json");
    says(&found, json!({"schema": "couplet.judge/2", "rows": 3004, "accepted": 3000}));
    let whole = |of: &Value| of.as_u64().unwrap();
    let lines: Vec<_> = found["worst"].list().iter().map(|row| whole(&row["line"])).collect();
    // It cannot stand; too thin, with fewer digits first; too thick.
    assert_eq!(lines, [3004, 3003, 3002, 3005]);
    let rows: u64 = found["correct_digits"].list().iter().map(|bar| whole(&bar["rows"])).sum();
    assert_eq!(rows, 3003, "all but the one without a number");
    let counted: u64 = found["verdicts"].as_object().unwrap().values().map(whole).sum();
    assert_eq!(counted, 3004);
    assert_eq!(found["numbers"]["thickness"]["judged"], 3003);
}

#[test]
fn accept_asks_for_digits() {
    let input = "half_opening,friction,thickness\npi/2,0.38,0.12\npi/2,0.38,0.12219158\n";
    let asked = |digits: &str| {
        let (code, rows) = rows(&format!("--weight heyman {digits}"), input);
        let accepted: Vec<bool> = rows.iter().map(|r| r["accepted"].as_bool().unwrap()).collect();
        (code, accepted)
    };
    assert_eq!(asked(""), (Some(1), vec![false, true]), "two digits, rounded to the unsafe side");
    assert_eq!(asked("--accept 2"), (Some(0), vec![true, true]));
    assert_eq!(asked("--accept 3"), (Some(1), vec![false, true]));
    assert_eq!(asked("--accept 7"), (Some(1), vec![false, true]));
    assert_eq!(asked("--accept 8"), (Some(1), vec![false, false]));
}
