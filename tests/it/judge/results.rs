//! Results from the literature and our own, right and with a wrong last digit.

use super::{rows, verdicts};
use crate::program::{Json, ended, fed, says, tells, text};
use couplet::number::Decimal;
use couplet::problem::{Mode, Quantity};
use serde_json::json;

/// Cocchetti & Rizzi, Frattura ed Integrità Strutturale 51 (2020): the Heyman-like semicircle.
const LITERATURE: &str = "alpha,mu,t_over_r,mode\n\
    90,0.5,0.107426,rrr\n90,0.39,0.112750,srr\n90,0.38,0.122192,srr\n90,0.37,0.132031,srr\n\
    90,0.36,0.142273,srr\n90,0.35,0.152920,srr\n90,0.34,0.163977,srr\n90,0.33,0.175448,srr\n\
    90,0.32,0.187338,srr\n90,0.31,0.199653,srr\n90,0.309,,\n";
const THEIRS: &str = "alpha=half_opening:deg,mu=friction,t_over_r=thickness,mode";

#[test]
fn the_literature_is_right() {
    let arguments = format!("--weight heyman --columns {THEIRS}");
    let (code, rows) = rows(&arguments, LITERATURE);
    assert_eq!(code, Some(0));
    assert_eq!(rows.len(), 11);
    assert!(verdicts(&rows[..10]).iter().all(|verdict| *verdict == "correctly rounded"));
    says(&rows[10], json!({"verdict": "correct", "reason": "sliding"}));
    let first = &rows[0]["numbers"]["thickness"];
    let expected = json!({
        "value": "0.10742645275542448", "error": "0.000000453", "error_units": "0.453",
        "correct_digits": "6",
    });
    says(first, expected);
    assert_eq!(rows[0]["side"], "thinner");
    let table = text(&fed(format!("judge - {arguments}"), LITERATURE).stdout);
    assert!(table.starts_with("11 rows: 11 accepted"), "{table}");
    tells(
        &table,
        ["thickness                  10        10         0         0         0       6"],
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
    let asked = [("1", "csv"), ("6", "csv"), ("17", "csv"), ("17", "jsonl"), ("40", "csv")];
    for (digits, format) in asked {
        let line = format!("states --digits {digits} --format {format}");
        let (states, _) = ended(0, line, queries());
        let (code, rows) = rows(&format!("--accept {digits}"), &states);
        assert_eq!((code, rows.len()), (Some(0), 484), "{digits} {format}");
        let wrong = rows.iter().find(|row| {
            row["verdict"] != if row["can_stand"] == true { "correctly rounded" } else { "correct" }
        });
        assert_eq!(wrong, None, "{digits} {format}");
        let count = |mode: &str| rows.iter().filter(|row| row["mode"] == *mode).count();
        let met = Mode::ALL.into_iter().filter(|mode| count(mode.label()) > 0);
        assert_eq!(met.count(), 6, "all but [s,s], in which nothing stands");
        let falls = rows.iter().filter(|row| row["can_stand"] == false).count();
        assert!(falls > 50 && rows.len() - falls > 100);
    }
}

/// The same columns with the last digit of each number moved by one: none is the correct rounding.
#[test]
fn a_wrong_last_digit_is_seen_everywhere() {
    let states = fed("states --digits 12", queries().as_bytes());
    let mut reader = csv::Reader::from_reader(&states.stdout[..]);
    let header = reader.headers().unwrap().clone();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&header).unwrap();
    for record in reader.records() {
        let record = record.unwrap();
        let moved = header.iter().zip(&record).map(|(name, field)| {
            let is_number = Quantity::STATE.iter().any(|m| m.name() == name);
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
    let (code, rows) = rows("--accept 3", writer.into_inner().unwrap());
    assert_eq!(code, Some(0), "three digits are still right");
    let mut seen = 0;
    for number in rows.iter().flat_map(|row| row["numbers"].as_object().unwrap().values()) {
        if number["claimed"].text().parse::<Decimal>().is_ok_and(|x| x.significant_digits() == 12) {
            assert!(number["rounding"] == "faithful" || number["rounding"] == "wrong", "{number}");
            let digits: usize = number["correct_digits"].text().parse().unwrap();
            assert!((10..=12).contains(&digits), "{number}");
            seen += 1;
        }
    }
    assert!(seen > 1500, "{seen}");
    assert!(verdicts(&rows).iter().all(|verdict| *verdict == "correct"));
}

/// A wrong mode is wrong; but it is said if the other is met within the rounding of what is given.
#[test]
fn a_mode_next_to_a_boundary_is_told_with_its_distance() {
    let judged = |friction: &str| {
        let input = format!("alpha,mu,eta,mode\npi/2,{friction},0.10742645,rrr\n");
        rows("--weight heyman", input).1.remove(0)
    };
    let expected = json!({
        "verdict": "wrong mode", "mode": "[s,r,r]", "boundary": "friction",
        "boundary_within": "5e-17",
    });
    says(&judged("0.3958320381380695"), expected);
    assert_eq!(judged("0.3958")["boundary_within"], "0.00005");
    assert!(judged("0.3950")["boundary"].is_null(), "it is not that near");
    let table = text(&fed("judge -", "alpha,mu,mode\npi/2,0.39500,rrr\n").stdout);
    tells(&table, ["weight: milankovitch, as neither the rows nor --weight say any"]);
}

/// What joins the output with the input beside the line.
#[test]
fn what_is_kept_is_handed_on() {
    let input = "id,alpha,mu,eta,mode\n7,1.5,0.6,0.0901407,\n8,x,1,1,\n";
    let judged = fed("judge - --format csv --keep id,mode", input);
    let table = text(&judged.stdout);
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("id,input_mode,line,weight,"), "{table}");
    assert!(lines[1].starts_with("7,,2,milankovitch,") && lines[2].starts_with("8,,3,"), "{table}");
    let (_, rows) = rows("--keep all", input);
    assert_eq!((&rows[0]["kept"]["id"], &rows[1]["kept"]["id"]), (&"7".into(), &"8".into()));
}
