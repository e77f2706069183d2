//! `couplet map`: what it writes, and what it refuses.

use crate::program::{Json, Scratch, ended, object, printed, refused, rows};
use serde_json::Value;
use std::collections::BTreeMap;

#[test]
fn every_curve_is_summed_up() {
    let (output, error) = ended(0, "map --weight both --tolerance 1e-3", "");
    assert_eq!(error, "");
    // Eleven of each weight, and sliding.
    let lines: Vec<&str> = output.lines().skip(3).take_while(|line| !line.is_empty()).collect();
    assert_eq!(lines.len(), 23, "{output}");
    assert!(output.ends_with("exactly one solution in the tube, from end to end\n"));
}

#[test]
fn csv_and_json_say_the_same() {
    let line = "map --curve rrr/srr,limit --weight heyman";
    let (table, document) = (printed(format!("{line} --format csv")), object(line));
    let curves = document["curves"].list();
    let nodes: Vec<(&Value, &Value)> = curves
        .iter()
        .flat_map(|curve| curve["nodes"].list().iter().map(move |n| (curve, n)))
        .collect();
    let rows = rows(table);
    assert_eq!(rows.len(), nodes.len());
    for (row, (curve, node)) in rows.iter().zip(nodes) {
        for (name, cell) in row {
            let value = match &name[..] {
                "weight" | "curve" => &curve[name],
                "node" => continue,
                "mode" => &Value::Null,
                _ => &node[name],
            };
            let said = match value {
                Value::Null => String::new(),
                Value::String(text) => text.clone(),
                Value::Number(number) => {
                    let (number, cell) = (number.as_f64().unwrap(), cell.parse::<f64>());
                    assert_eq!(number, cell.unwrap(), "{name}");
                    continue;
                }
                other => other.to_string(),
            };
            assert_eq!(&said, cell, "{name}");
        }
    }
}

/// Bounds of the ends are those of the landmark.
#[test]
fn the_ends_are_the_landmarks() {
    let table = printed("map --curve rrr/rrs --format csv");
    let rows = rows(table);
    let of = |row: usize, name: &str| rows[row][name].clone();
    let last = rows.len() - 1;
    assert_eq!((&of(0, "end")[..], &of(last, "end")[..]), ("T", "l"));
    // As `couplet constants T` has it, to the precision of a double.
    let eta: f64 = "0.618318241074323446374432256517".parse().unwrap();
    let [low, high] = ["thickness_lower", "thickness_upper"].map(|name| of(0, name));
    assert!(low.parse::<f64>().unwrap() <= eta && eta <= high.parse::<f64>().unwrap());
    assert_eq!((&of(last, "friction_lower")[..], &of(last, "friction_upper")[..]), ("inf", "inf"));
    assert_eq!(of(last, "tube"), "", "no piece begins at the end");
}

/// A point of a line is what `find boundary` finds there.
#[test]
fn a_point_is_on_the_boundary() {
    let point = object("map point rrr/srr --at 80deg --digits 25");
    let found = object("find boundary rrr/srr --alpha 80deg --digits 25");
    for name in ["friction", "thickness", "thrust", "rotation_joint"] {
        let value = &point["values"][name]["value"];
        assert!(value.is_string() && *value == found[name]["value"], "{name}");
    }
}

#[test]
fn a_file_of_data_comes_with_a_line() {
    let scratch = Scratch::new();
    let file = scratch.path("map.csv");
    let output = printed(format!("map --curve limit --format csv -o {file}"));
    assert!(output.contains("map.csv: 1 curve, ") && output.contains("; proved: "), "{output}");
    assert_eq!(output.lines().count(), 1);
    assert!(scratch.read("map.csv").starts_with("weight,curve,mode,node,end,parameter,"));
}

/// On each line of a level the states of the arches have its modes, and what it is a line of.
#[test]
fn levels_are_states_of_arches() {
    for (option, value, expected) in [
        ("--half-opening", "2.58", &["[s,s]", "[r,s]", "[r,s,r]", "[r,r,s]", "[r,r,r]"][..]),
        ("--thickness", "0.92", &["[r,s]", "[r,s,r]", "[r,r,s]", "[r,r,r]"]),
        ("--thickness", "0.1", &["[s,r,r]", "[r,r,r]"]),
        ("--friction", "1.6", &["[r,r,s]", "[r,s,r]", "[r,s]", "[s,s]"]),
        ("--friction", "tan(20deg)", &["[s,r,r]", "[s,s]"]),
    ] {
        let rows = rows(printed(format!("map {option} {value} --tolerance 1e-6 --format csv")));
        let of = |row: &BTreeMap<String, String>, name: &str| row[name].clone();
        let mut modes: Vec<String> = rows.iter().map(|row| of(row, "mode")).collect();
        modes.dedup();
        assert_eq!(modes, expected, "{value}");
        let name = option.trim_start_matches('-').replace('-', " ");
        assert!(rows.iter().all(|row| of(row, "curve") == format!("{name} {value}")));
        for row in rows.iter().filter(|row| of(row, "proved") == "true").step_by(4).skip(1) {
            let [alpha, mu, low, high] =
                ["half_opening_lower", "friction_upper", "thickness_lower", "thickness_upper"]
                    .map(|name| of(row, name));
            let alpha = if option == "--half-opening" { value } else { &alpha };
            let state = object(format!("state --alpha {alpha} --mu {mu} --digits 14"));
            if state["mode"] != of(row, "mode") {
                // The first node of a part lies on the line to the next mode.
                assert!(modes.contains(&state["mode"].text().to_owned()), "{value} {mu}");
            }
            let eta = state["thickness"].value();
            let [low, high] = [low, high].map(|bound| bound.parse::<f64>().unwrap());
            assert!(low - 1e-11 < eta && eta < high + 1e-11, "{value}, {mu}: {low} {eta} {high}");
        }
    }
}

#[cfg(feature = "parquet")]
#[test]
fn a_point_has_no_parquet() {
    let line = "map point limit --at 1.5 --format parquet -o no.parquet";
    refused(line, "", "a format is one of table, json, csv");
}
