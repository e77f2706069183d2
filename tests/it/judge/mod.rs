//! `couplet judge`: other people's results, right and wrong ones, and files that make no sense.

mod common;
#[path = "common/program.rs"]
mod program;

use common::config;
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Arch, Digits, Friction, Outcome};
use couplet::judge::{Claim, CorrectDigits, Demand, Measure, Said, Verdict, judge};
use couplet::number::{Decimal, ExactNumber};
use couplet::problem::Mode;
use program::{fed, start};
use proptest::prelude::*;
use rug::{Integer, Rational};
use serde_json::Value;
use std::io::{BufRead, BufReader, Write};

/// The exit code and the rows that `couplet judge -` makes of an input.
fn rows(arguments: &[&str], input: impl AsRef<[u8]>) -> (Option<i32>, Vec<Value>) {
    let all = [&["judge", "-", "--format", "jsonl"], arguments].concat();
    let output = fed(&all, input.as_ref());
    let text = String::from_utf8(output.stdout).unwrap();
    (output.status.code(), text.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

fn verdicts(rows: &[Value]) -> Vec<&str> {
    rows.iter().map(|row| row["verdict"].as_str().unwrap()).collect()
}

/// Cocchetti & Rizzi, Frattura ed Integrità Strutturale 51 (2020): the Heyman-like semicircle.
const LITERATURE: &str = "alpha,mu,t_over_r,mode\n\
    90,0.5,0.107426,rrr\n90,0.39,0.112750,srr\n90,0.38,0.122192,srr\n90,0.37,0.132031,srr\n\
    90,0.36,0.142273,srr\n90,0.35,0.152920,srr\n90,0.34,0.163977,srr\n90,0.33,0.175448,srr\n\
    90,0.32,0.187338,srr\n90,0.31,0.199653,srr\n90,0.309,,\n";
const THEIRS: &str = "alpha=half_opening:deg,mu=friction,t_over_r=thickness,mode";

#[test]
fn the_literature_is_right() {
    let arguments = ["--weight", "heyman", "--columns", THEIRS];
    let (code, rows) = rows(&arguments, LITERATURE);
    assert_eq!(code, Some(0));
    assert_eq!(rows.len(), 11);
    assert!(verdicts(&rows[..10]).iter().all(|verdict| *verdict == "correctly rounded"));
    assert_eq!((&rows[10]["verdict"], &rows[10]["reason"]), (&"correct".into(), &"sliding".into()));
    let first = &rows[0]["numbers"]["thickness"];
    assert_eq!(
        (&first["value"], &first["error"]),
        (&"0.10742645275542448".into(), &"0.000000453".into())
    );
    assert_eq!((&first["error_units"], &first["correct_digits"]), (&"0.453".into(), &"6".into()));
    assert_eq!(rows[0]["side"], "thinner");
    let table = fed(&[&["judge", "-"], &arguments[..]].concat(), LITERATURE.as_bytes());
    let table = String::from_utf8(table.stdout).unwrap();
    assert!(table.starts_with("11 rows: 11 accepted"), "{table}");
    assert!(
        table.contains(
            "thickness                  10        10         0         0         0       6"
        ),
        "{table}"
    );
}

fn queries() -> String {
    let mut text = String::from("weight,half_opening,friction\n");
    // The rarer modes.
    for arch in ["2.45,1.35", "2.533,1.545", "2.57,1.75", "2.62,inf"] {
        text += &format!("milankovitch,{arch}\n");
    }
    for weight in ["heyman", "milankovitch"] {
        for i in (1..=60).step_by(2) {
            for friction in ["0.2", "1/3", "0.7", "1.3", "1.6", "40"] {
                text += &format!("{weight},{i}/23,{friction}\n");
            }
            text += &format!("{weight},{i}e-30,{i}e-80\n{weight},{}deg,inf\n", i * 3 - 1);
        }
    }
    text
}

#[test]
fn our_own_states_are_right() {
    for (digits, format) in
        [("1", "csv"), ("6", "csv"), ("17", "csv"), ("17", "jsonl"), ("40", "csv")]
    {
        let states = fed(&["states", "--digits", digits, "--format", format], queries().as_bytes());
        assert_eq!(states.status.code(), Some(0));
        let (code, rows) = rows(&["--accept", digits], &states.stdout);
        assert_eq!((code, rows.len()), (Some(0), 484), "{digits} {format}");
        let wrong = rows.iter().find(|row| {
            row["verdict"] != if row["stands"] == true { "correctly rounded" } else { "correct" }
        });
        assert_eq!(wrong, None, "{digits} {format}");
        let count = |mode: &str| rows.iter().filter(|row| row["mode"] == *mode).count();
        let met = Mode::ALL.into_iter().filter(|mode| count(mode.label()) > 0);
        assert_eq!(met.count(), 6, "all but [s,s], in which nothing stands");
        let falls = rows.iter().filter(|row| row["stands"] == false).count();
        assert!(falls > 50 && rows.len() - falls > 100);
    }
}

/// The same columns with the last digit of each number moved by one: none is the correct rounding.
#[test]
fn a_wrong_last_digit_is_seen_everywhere() {
    let states = fed(&["states", "--digits", "12"], queries().as_bytes());
    let mut reader = csv::Reader::from_reader(&states.stdout[..]);
    let header = reader.headers().unwrap().clone();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&header).unwrap();
    for record in reader.records() {
        let record = record.unwrap();
        let moved = header.iter().zip(&record).map(|(name, field)| {
            let is_number = Measure::ALL.iter().any(|m| m.name() == name);
            // Exact values end early, and a hundredth is then no small change.
            let full = field.parse::<Decimal>().is_ok_and(|x| x.significant_digits() == 12);
            let (mantissa, exponent) = field.split_at(field.find('e').unwrap_or(field.len()));
            match mantissa.chars().last().and_then(|c| c.to_digit(10)) {
                Some(digit) if is_number && full => {
                    let other = if digit == 9 { 8 } else { digit + 1 };
                    format!("{}{other}{exponent}", &mantissa[..mantissa.len() - 1])
                }
                _ => field.to_owned(),
            }
        });
        writer.write_record(moved).unwrap();
    }
    let (code, rows) = rows(&[], writer.into_inner().unwrap());
    assert_eq!(code, Some(0), "three digits are still right");
    let mut seen = 0;
    for number in rows.iter().flat_map(|row| row["numbers"].as_object().unwrap().values()) {
        if number["claimed"]
            .as_str()
            .unwrap()
            .parse::<Decimal>()
            .is_ok_and(|x| x.significant_digits() == 12)
        {
            assert!(number["rounding"] == "faithful" || number["rounding"] == "wrong", "{number}");
            let digits: usize = number["correct_digits"].as_str().unwrap().parse().unwrap();
            assert!((10..=12).contains(&digits), "{number}");
            seen += 1;
        }
    }
    assert!(seen > 1500, "{seen}");
    assert!(verdicts(&rows).iter().all(|verdict| *verdict == "correct"));
}

#[test]
fn every_verdict_is_given() {
    // The arch of the first rows stands from 0.122191586362546 on, as [s,r,r], with thrust 0.5969.
    let cases = [
        ("heyman,pi/2,0.38,,\"[s,r,r]\",0.122192,0.596903", "correctly rounded"),
        ("heyman,pi/2,0.38,yes,srr,0.122193,0.5969", "correct"),
        ("heyman,pi/2,0.38,,,0.12219158636254615,0.590", "inaccurate"),
        ("heyman,pi/2,0.38,,srr,0.12219158636254615,none", "inaccurate"),
        ("heyman,pi/2,0.38,,srr,0.124,0.590", "thicker than the least thickness"),
        ("heyman,pi/2,0.38,,rrr,0.122192,", "wrong mode"),
        ("heyman,pi/2,0.38,,rrr,0.124,", "wrong mode"),
        ("heyman,pi/2,0.38,,ss,0.122192,", "wrong mode"),
        ("heyman,pi/2,0.38,no,,,", "claims that an arch falls which stands"),
        ("heyman,pi/2,0.38,,,NaN,", "claims that an arch falls which stands"),
        ("heyman,pi/2,0.38,,ss,,", "claims that an arch falls which stands"),
        ("heyman,pi/2,0.38,,rrr,0.120,", "thinner than the least thickness"),
        ("heyman,pi/2,0.38,,srr,0,", "thinner than the least thickness"),
        ("heyman,pi/2,0.30,true,,,", "claims an arch that cannot stand"),
        ("heyman,pi/2,0.30,,,0.2,", "claims an arch that cannot stand"),
        ("milankovitch,2.65,inf,,[r],1.99,", "claims an arch that cannot stand"),
        ("heyman,pi/2,0.30,,none,nan,nan", "correct"),
        ("milankovitch,2.65,inf,0,,,", "correct"),
        ("heyman,pi/2,0.38,,,,", "no claim"),
        ("heyman,pi/2,0.38,no,,0.1,", "bad row"),
        ("heyman,pi/2,0.38,,rrrr,0.1,", "bad row"),
        ("Couplet,pi/2,0.38,,rrr,0.1,", "bad row"),
        ("heyman,4,0.38,,rrr,0.1,", "bad row"),
    ];
    let mut input = String::from("weight,half_opening,friction,stands,mode,thickness,thrust\n");
    cases.iter().for_each(|(row, _)| input += &format!("{row}\n"));
    let (code, rows) = rows(&[], &input);
    assert_eq!(code, Some(2), "some rows are bad");
    for ((text, verdict), row) in cases.iter().zip(&rows) {
        assert_eq!(row["verdict"], **verdict, "{text}: {row}");
        let good = ["correctly rounded", "correct"].contains(verdict);
        assert_eq!(row["accepted"], good);
    }
    let met: std::collections::BTreeSet<_> = verdicts(&rows).into_iter().collect();
    let all = Verdict::ALL.map(Verdict::name);
    let missing: Vec<_> = all.iter().filter(|name| !met.contains(*name)).collect();
    assert_eq!(missing, [&"undecided"], "which is tested below");
    // Without the bad rows.
    let judged: String = input.lines().take(20).map(|line| format!("{line}\n")).collect();
    assert_eq!(self::rows(&[], judged).0, Some(1));
}

fn number(text: &str) -> ExactNumber {
    text.parse().unwrap()
}

const USUAL: Demand = Demand { digits: 3, or_all_printed: true };

#[test]
fn what_cannot_be_told_is_accepted_of_nobody() {
    let arch = |friction: &str| {
        let friction = Friction::Coefficient(number(friction));
        Arch::new(SelfWeight::Heyman, number("pi/2"), friction).unwrap()
    };
    // Nearer to the line than any precision that is tried can tell.
    let critical = match arch("1").state(12_000) {
        Ok(Outcome::Stands(state)) => state.frictions.unwrap().rotational.unwrap(),
        other => panic!("{other:?}"),
    };
    let line = arch(&critical.mid().to_string_radix(10, Some(3_300)));
    let verdict = |mode: &str, thickness: &str| {
        let numbers = vec![(Measure::Thickness, thickness, false)];
        let said = Said { stands: Some("yes"), mode: Some(mode), numbers };
        judge(&line, &Claim::read(&said).unwrap(), USUAL).verdict
    };
    // Even of the two modes that meet at the line: nearer than can be told is not on it.
    assert_eq!(verdict("rrr", ""), Verdict::Undecided);
    assert_eq!(verdict("srr", ""), Verdict::Undecided);
    assert_eq!(verdict("rrs", ""), Verdict::Undecided);
    assert_eq!(verdict("srr", "0.107"), Verdict::Undecided);
}

#[test]
fn accept_asks_for_digits() {
    let input = "half_opening,friction,thickness\npi/2,0.38,0.12\npi/2,0.38,0.12219158\n";
    let asked = |digits: &[&str]| {
        let (code, rows) = rows(&[&["--weight", "heyman"], digits].concat(), input);
        let accepted: Vec<bool> = rows.iter().map(|r| r["accepted"].as_bool().unwrap()).collect();
        (code, accepted)
    };
    assert_eq!(asked(&[]), (Some(0), vec![true, true]), "two digits, correctly rounded");
    assert_eq!(asked(&["--accept", "2"]), (Some(0), vec![true, true]));
    assert_eq!(asked(&["--accept", "3"]), (Some(1), vec![false, true]));
    assert_eq!(asked(&["--accept", "7"]), (Some(1), vec![false, true]));
    assert_eq!(asked(&["--accept", "8"]), (Some(1), vec![false, false]));
}

/// A program in double precision computes with the double next to 0.1, which is more than 0.1.
#[test]
fn inputs_are_exact_or_doubles() {
    let thickness = |half_opening: ExactNumber, friction: ExactNumber| {
        let friction = Friction::Coefficient(friction);
        let arch = Arch::new(SelfWeight::Milankovitch, half_opening, friction).unwrap();
        match arch.certify(25) {
            Ok(Answer::Stands(state)) => state.thickness.decimal.value.to_string(),
            other => panic!("{other:?}"),
        }
    };
    let double = |x: f64| ExactNumber::rational(Rational::from_f64(x).unwrap());
    let table = [
        ("0.1", thickness(number("0.1"), number("0.7")), thickness(double(0.1), double(0.7))),
        (
            "50.1deg",
            thickness(number("50.1").degrees(), number("0.7")),
            thickness(double(double(50.1).degrees().nearest_double().unwrap()), double(0.7)),
        ),
    ];
    for (half_opening, exact, doubles) in table {
        for (inputs, right) in [("exact", &exact), ("double", &doubles)] {
            let input = format!(
                "half_opening,friction,thickness\n{half_opening},0.7,{exact}\n{half_opening},0.7,{doubles}\n"
            );
            let arguments = ["--weight", "milankovitch", "--inputs", inputs];
            let (_, rows) = rows(&arguments, input);
            let found = rows.iter().find(|row| row["verdict"] == "correctly rounded").unwrap();
            assert_eq!(found["numbers"]["thickness"]["claimed"], **right);
            assert_eq!(verdicts(&rows).iter().filter(|v| **v == "correctly rounded").count(), 1);
        }
    }
}

#[test]
fn angles_may_be_in_degrees() {
    let input = "a,phi,joint\n80,30,52.9\n80deg,30,0.9233\n";
    let columns = "a=half_opening:deg,phi=friction_angle:deg,joint=rotation_joint:deg";
    let (_, rows) = rows(&["--weight", "heyman", "--columns", columns], input);
    let value = rows[0]["numbers"]["rotation_joint"]["value"].as_str().unwrap();
    let arch = Arch::new(SelfWeight::Heyman, number("80").degrees(), Friction::Infinite).unwrap();
    let Ok(Answer::Stands(state)) = arch.certify(20) else { panic!() };
    let degrees = state.rotation_joint.double.to_degrees();
    approx::assert_relative_eq!(value.parse::<f64>().unwrap(), degrees, max_relative = 1e-14);
    assert_eq!(
        (&rows[0]["half_opening"], &rows[0]["friction"]),
        (&"80deg".into(), &"tan(30deg)".into())
    );
    assert_eq!(rows[1]["half_opening"], "80deg", "not twice");
    assert_eq!(rows[1]["verdict"], "inaccurate", "radians where degrees were named");
}

#[test]
fn wrong_columns_are_refused_before_anything_is_computed() {
    let csv = "a,b,c,c,d\n1,0.5,0.1,0.1,heyman\n";
    let json = "{\"a\":1,\"b\":0.5,\"c\":0.1}\n";
    let good = ["--weight", "heyman", "--columns"];
    let cases: &[(&str, &[&str], &str)] = &[
        (
            csv,
            &[&good[..], &["a=half_opening,b=friction,x=thickness"]].concat(),
            "the file has no column 'x'; its columns are 'a', 'b', 'c', 'c', 'd'",
        ),
        (csv, &[&good[..], &["a=half_opening,b=friction,c=thickness"]].concat(), "two columns 'c'"),
        (
            csv,
            &[&good[..], &["a=half_opening,b=friction,d=thick"]].concat(),
            "'thick' is no column of ours: weight",
        ),
        (
            csv,
            &[&good[..], &["a=half_opening,b=friction,d=friction"]].concat(),
            "both named friction",
        ),
        (csv, &[&good[..], &["a=half_opening,b=friction,a=thickness"]].concat(), "named twice"),
        (csv, &[&good[..], &["a=half_opening,b=friction"]].concat(), "anything to judge"),
        (csv, &[&good[..], &["a=half_opening,d=mode"]].concat(), "no column for the friction"),
        (csv, &[&good[..], &["b=friction,d=mode"]].concat(), "no column for the half opening"),
        (csv, &[&good[..], &["a=half_opening:turns,b=friction,d=mode"]].concat(), "rad or deg"),
        (csv, &[&good[..], &["a=half_opening,b=friction:deg,d=mode"]].concat(), "has no unit"),
        (
            csv,
            &[&good[..], &["a=half_opening,b=friction,d=friction_angle,c=mode"]].concat(),
            "name one of them",
        ),
        (csv, &["--columns", "a=half_opening,b=friction,d=mode"], "the weight is missing"),
        (
            csv,
            &[&good[..], &["a=half_opening,b=friction,c=mode,d=weight"]].concat(),
            "two columns 'c'",
        ),
        (
            "a,b,c,d\n",
            &[&good[..], &["a=half_opening,b=friction,c=mode,d=weight"]].concat(),
            "--weight is not needed",
        ),
        (csv, &["--weight", "heyman"], "no column for the half opening"),
        (
            "half_opening;friction;eta\n",
            &["--weight", "heyman"],
            "--columns theirs=half_opening; its columns are 'half_opening;friction;eta'",
        ),
        (
            "alpha,half_opening,mu,eta\n",
            &["--weight", "heyman"],
            "'half_opening' and 'alpha', which are the same",
        ),
        (
            json,
            &[&good[..], &["a=half_opening,b=friction,x=thickness"]].concat(),
            "the first rows have no column 'x'",
        ),
        (json, &["--weight", "heyman"], "no column for the half opening"),
        (json, &["--columns", "a=half_opening,b=friction,c=thickness"], "the weight is missing"),
        ("", &["--weight", "heyman"], "the file is empty"),
        ("[{}]", &["--weight", "heyman"], "a JSON array is not read"),
        (csv, &["--weight", "both"], "one of heyman, milankovitch"),
        (csv, &["--accept", "0"], "from 1 to 10000"),
        (csv, &["--worst", "-1"], "--worst"),
        (csv, &["--inputs", "single"], "exact, double"),
    ];
    for (input, arguments, why) in cases {
        let all = [&["judge", "-", "--format", "csv"], *arguments].concat();
        let output = fed(&all, input.as_bytes());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
        assert!(message.contains(why), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
    let output = fed(&["judge", "missing.csv"], b"");
    assert_eq!(output.status.code(), Some(3));

    let file = tempfile::NamedTempFile::new().unwrap();
    let results = "weight,half_opening,friction,thickness\nheyman,1,0.5,0.0190\n";
    std::fs::write(file.path(), results).unwrap();
    let name = file.path().to_str().unwrap();
    let output = fed(&["judge", name, "--output", name], b"");
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message, format!("couplet: {name} is what is judged and is not written over\n"));
    assert_eq!(std::fs::read_to_string(file.path()).unwrap(), results);

    if cfg!(target_os = "linux") {
        let output = fed(&["judge", name, "--output", "/dev/full"], b"");
        assert_eq!(output.status.code(), Some(3));
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.starts_with("couplet: cannot write /dev/full: "), "{message}");
    }
}

#[test]
fn bad_rows_do_not_stop_the_others() {
    let long = format!("0.{}", "1".repeat(20_001));
    let mut input: Vec<u8> = b"\xEF\xBB\xBFhalf_opening , friction,thickness\r\n".to_vec();
    let bad: [&[u8]; 17] = [
        b"1,1,\xFF\xFE",
        b"1,1",
        b"1,1,1,1",
        b"nan,1,1",
        b"1,NaN,1",
        b",1,1",
        b"1,,1",
        b"1,1,1e-999999999",
        b"1,1,1e999999999999999999999999",
        b"1,1,1e5001",
        b"1e400,1,1",
        b"1e-999999999,1,1",
        b"1,1e1000000,1",
        b"1,1,\"0,1\"",
        b"1,1,0x1p-3",
        b"0,1,1",
        long.as_bytes(),
    ];
    for row in bad {
        input.extend(row);
        input.extend(b"\r\n\"1\",\"0.5\",\"1e-9\"\r\n");
    }
    input.extend(b"1,1,1e3000\n1,1,1e-5000\n1,1,-1\n1,\"0.5\",0.02");
    let (code, rows) = rows(&["--weight", "heyman"], &input);
    assert_eq!(code, Some(2));
    assert_eq!(rows.len(), 2 * bad.len() + 4);
    for (index, row) in rows.iter().take(2 * bad.len()).enumerate() {
        assert_eq!(row["line"], index + 2);
        let verdict = if index % 2 == 0 { "bad row" } else { "thinner than the least thickness" };
        assert_eq!(row["verdict"], verdict, "{row}");
        assert!(index % 2 == 1 || !row["reason"].as_str().unwrap().is_empty());
    }
    let last = &verdicts(&rows)[2 * bad.len()..];
    let thicker = "thicker than the least thickness";
    let thinner = "thinner than the least thickness";
    assert_eq!(last, [thicker, thinner, thinner, "correctly rounded"]);
}

#[test]
fn json_lines_are_read_as_they_are_written() {
    let input = "\u{FEFF}{\"a\":1,\"b\":0.5,\"t\":null}\n\n{\"a\":1,\"b\":0.50,\"t\":1.9e-2,\"u\":[]}\n\
        {\"a\":1,\"b\":0.5}\n{\"a\":1,\"a\":2}\n[1]\n{\"a\":{},\"b\":1,\"t\":1}\n{\"a\":1,\"b\":1,\"t\":\"\\ud800\"}\nx\n";
    let columns = "a=half_opening,b=friction,t=thickness";
    let (code, rows) = rows(&["--weight", "heyman", "--columns", columns], input);
    assert_eq!(code, Some(2));
    let falls = "claims that an arch falls which stands";
    let bad = "bad row";
    assert_eq!(verdicts(&rows), [falls, "correctly rounded", "no claim", bad, bad, bad, bad, bad]);
    let lines: Vec<_> = rows.iter().map(|row| row["line"].as_u64().unwrap()).collect();
    assert_eq!(lines, [1, 3, 4, 5, 6, 7, 8, 9]);
    assert_eq!(rows[1]["numbers"]["thickness"]["claimed"], "1.9e-2");
}

/// What is written does not wait for the end of the file.
#[test]
fn a_file_without_end_is_judged_as_it_comes() {
    let mut child = start(&["judge", "-", "--weight", "heyman", "--format", "csv", "--worst", "0"]);
    let mut stdin = child.stdin.take().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let rows = "1,0.5,0.0211\n".repeat(6000);
    stdin.write_all(b"half_opening,friction,thickness\n").unwrap();
    stdin.write_all(rows.as_bytes()).unwrap();
    stdin.flush().unwrap();
    let first: Vec<String> = lines.by_ref().take(2000).map(Result::unwrap).collect();
    assert!(first[0].starts_with("line,weight,") && first[1999].starts_with("2000,heyman,1,0.5,"));
    // The reader goes away while the file still grows: that is no failure.
    drop(lines);
    let _ = stdin.write_all(rows.as_bytes());
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), message.as_str()), (Some(0), ""));
}

#[test]
fn a_summary_keeps_the_worst_and_counts_all() {
    let mut input = String::from("half_opening,friction,thickness\n");
    for i in 0..3000 {
        input += &format!("pi/2,0.38,0.12219{:04}\n", i % 1000);
    }
    input += "pi/2,0.38,0.121\npi/2,0.38,0.100\npi/2,0.3,0.1\npi/2,0.38,0.9\n";
    let folder = std::env::temp_dir().join(format!("couplet-judge-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (file, path) = (folder.join("in.csv"), folder.join("out.json"));
    std::fs::write(&file, &input).unwrap();
    let names = [&file, &path].map(|path| path.to_str().unwrap());
    let output = fed(
        &[
            "judge", names[0], "--weight", "heyman", "--format", "json", "--worst", "4", "-o",
            names[1],
        ],
        b"",
    );
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message, "couplet: 4 of 3004 rows are not accepted\n");
    let found: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!((&found["schema"], &found["rows"]), (&"couplet.judge/1".into(), &3004.into()));
    assert_eq!(found["accepted"], 3000);
    let lines: Vec<_> =
        found["worst"].as_array().unwrap().iter().map(|r| r["line"].as_u64().unwrap()).collect();
    // It cannot stand; too thin, with fewer digits first; too thick.
    assert_eq!(lines, [3004, 3003, 3002, 3005]);
    let bars = found["correct_digits"].as_array().unwrap();
    let rows: u64 = bars.iter().map(|bar| bar["rows"].as_u64().unwrap()).sum();
    assert_eq!(rows, 3003, "all but the one without a number");
    let counted: u64 =
        found["verdicts"].as_object().unwrap().values().map(|v| v.as_u64().unwrap()).sum();
    assert_eq!(counted, 3004);
    assert_eq!(found["numbers"]["thickness"]["judged"], 3003);
}

fn semicircle() -> (Arch, Box<Digits>) {
    let friction = Friction::Coefficient(number("0.38"));
    let arch = Arch::new(SelfWeight::Heyman, number("pi/2"), friction).unwrap();
    match arch.certify(80) {
        Ok(Answer::Stands(state)) => (arch, state),
        other => panic!("{other:?}"),
    }
}

fn power_of_ten(exponent: i64) -> Rational {
    let power = Rational::from(Integer::from(Integer::u_pow_u(10, exponent.unsigned_abs() as u32)));
    if exponent < 0 { power.recip() } else { power }
}

proptest! {
    #![proptest_config(config(100))]

    /// Claims beside the truth by a known error of any size: what is told of it is so.
    #[test]
    fn errors_are_what_they_are(
        error in 1u32..1_000_000, places in 1i64..40, below in any::<bool>(), extra in 0usize..8,
    ) {
        let (arch, state) = semicircle();
        let truth = state.thickness.decimal.value.to_rational();
        let step = Rational::from(error) * power_of_ten(-6 - places);
        let moved = if below { truth.clone() - &step } else { truth.clone() + &step };
        // Written with a few digits more than the error needs.
        let written = couplet::number::Rounded::from_rational(&moved, places as usize + 7 + extra).unwrap();
        let text = written.value.to_string();
        let numbers = vec![(Measure::Thickness, text.as_str(), false)];
        let claim = Claim::read(&Said { numbers, ..Said::default() }).unwrap();
        let found = judge(&arch, &claim, USUAL);
        let thickness = &found.numbers[0];
        let claimed = written.value.to_rational();
        let size = Rational::from(&claimed - &truth).abs();
        let errors = thickness.errors.as_ref().unwrap();
        let near = |shown: &Decimal, exact: Rational| {
            let slack = exact.clone() / 199u32;
            (shown.to_rational() - exact).abs() <= slack
        };
        prop_assert!(near(&errors.absolute, size.clone()));
        prop_assert!(near(errors.relative.as_ref().unwrap(), size.clone() / &truth));
        prop_assert!(near(&errors.units, size.clone() * power_of_ten(-written.value.exponent())));
        // 0.122 is in [2^-4, 2^-3), where doubles are 2^-56 apart.
        prop_assert!(near(errors.ulp.as_ref().unwrap(), size.clone() << 56u32));
        let CorrectDigits::Digits(digits) = thickness.correct_digits else { panic!() };
        let within = |k: i64| Rational::from(&size * 2u32) <= power_of_ten(-k);
        let rounded = size <= power_of_ten(written.value.exponent()) / 2u32;
        prop_assert_eq!(thickness.is_correctly_rounded(), rounded);
        if !rounded {
            prop_assert!(digits == 0 || within(digits as i64));
            prop_assert!(!within(digits as i64 + 1));
        }
        prop_assert_eq!(thickness.order.unwrap() == std::cmp::Ordering::Less, claimed < truth);
    }

    /// Every mode but the certified one is wrong.
    #[test]
    fn another_mode_is_wrong(place in 0usize..7) {
        let (arch, state) = semicircle();
        let mode = Mode::ALL[place];
        let text = state.thickness.decimal.value.to_string();
        let numbers = vec![(Measure::Thickness, text.as_str(), false)];
        let said = Said { mode: Some(mode.label()), numbers, ..Said::default() };
        let found = judge(&arch, &Claim::read(&said).unwrap(), USUAL);
        prop_assert_eq!(found.verdict == Verdict::WrongMode, mode != state.mode);
        prop_assert_eq!(found.verdict == Verdict::CorrectlyRounded, mode == state.mode);
    }
}
