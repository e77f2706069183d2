//! `couplet map`: what it writes, and what it refuses.

use crate::program::{Scratch, couplet, json, refused, said, text};
use serde_json::Value;

/// The cells of a table by the names in its header.
fn cells(table: &str) -> Vec<Vec<(String, String)>> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let row =
        |row: csv::StringRecord| names.iter().cloned().zip(row.iter().map(str::to_owned)).collect();
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    rows.into_iter().map(row).collect()
}

#[test]
fn every_curve_is_summed_up() {
    let (code, output, error) = said(&couplet(&["map", "--weight", "both", "--tolerance", "1e-3"]));
    assert_eq!((code, &error[..]), (Some(0), ""));
    // Eleven of each weight, and sliding.
    let lines: Vec<&str> = output.lines().skip(3).take_while(|line| !line.is_empty()).collect();
    assert_eq!(lines.len(), 23, "{output}");
    assert!(output.ends_with("exactly one solution in the tube, from end to end\n"));
}

#[test]
fn csv_and_json_say_the_same() {
    let line = ["map", "--curve", "rrr/srr,limit", "--weight", "heyman", "--format"];
    let table = text(&couplet(&[&line[..], &["csv"]].concat()).stdout);
    let document = json(&[&line[..], &["json"]].concat());
    let curves = document["curves"].as_array().unwrap();
    let nodes: Vec<(&Value, &Value)> = curves
        .iter()
        .flat_map(|curve| curve["nodes"].as_array().unwrap().iter().map(move |n| (curve, n)))
        .collect();
    let rows = cells(&table);
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
    let table = text(&couplet(&["map", "--curve", "rrr/rrs", "--format", "csv"]).stdout);
    let rows = cells(&table);
    let of = |row: usize, name: &str| -> String {
        rows[row].iter().find(|(n, _)| n == name).unwrap().1.clone()
    };
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
    let at = ["map", "point", "rrr/srr", "--at", "80deg", "--digits", "25", "--format", "json"];
    let point = json(&at);
    let find =
        ["find", "boundary", "rrr/srr", "--alpha", "80deg", "--digits", "25", "--format", "json"];
    let found = json(&find);
    for name in ["friction", "thickness", "thrust", "rotation_joint"] {
        let value = &point["values"][name]["value"];
        assert!(value.is_string() && *value == found[name]["value"], "{name}");
    }
}

#[test]
fn a_file_of_data_comes_with_a_line() {
    let scratch = Scratch::new();
    let file = scratch.path("map.csv");
    let line = ["map", "--curve", "limit", "--format", "csv", "-o", &file];
    let (code, output, _) = said(&couplet(&line));
    assert_eq!(code, Some(0));
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
        let line = ["map", option, value, "--tolerance", "1e-6", "--format", "csv"];
        let table = text(&couplet(&line).stdout);
        let rows = cells(&table);
        let of = |row: &[(String, String)], name: &str| -> String {
            row.iter().find(|(n, _)| n == name).unwrap().1.clone()
        };
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
            let state =
                ["state", "--alpha", alpha, "--mu", &mu, "--digits", "14", "--format", "json"];
            let state = json(&state);
            if state["mode"] != of(row, "mode") {
                // The first node of a part lies on the line to the next mode.
                assert!(
                    modes.contains(&state["mode"].as_str().unwrap().to_owned()),
                    "{value} {mu}"
                );
            }
            let eta: f64 = state["thickness"]["value"].as_str().unwrap().parse().unwrap();
            let [low, high] = [low, high].map(|bound| bound.parse::<f64>().unwrap());
            assert!(low - 1e-11 < eta && eta < high + 1e-11, "{value}, {mu}: {low} {eta} {high}");
        }
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (arguments, words) in [
        (&["--curve", "rrr"][..], "a curve is one of rotation, overturning, sliding, rrr/srr"),
        (&["--curve", "limits"], "did you mean \"limit\"?"),
        (&["--tolerance", "0"], "a tolerance is a number from 1e-12 to 1"),
        (&["--tolerance", "1e-13"], "a tolerance is a number from 1e-12 to 1"),
        (&["--tolerance", "-1"], "a tolerance is a number from 1e-12 to 1"),
        (&["--tolerance", "NaN"], "a tolerance is a number from 1e-12 to 1"),
        (&["--weight", "mine"], "a weight is one of"),
        (&["point", "limit"], "--at <PARAMETER> is missing"),
        (&["point", "limit,rotation", "--at", "1"], "a curve is one of rotation"),
        (&["point", "rotation", "--at", "3"], "half_opening 3 is not on the curve"),
        (&["point", "rs/ss", "--at", "2"], "thickness 2 is not on the curve"),
        (&["point", "rotation", "--at", "x"], "'x' is not a number"),
        (&["point", "rotation", "--at", "inf"], "is not a number"),
        (&["point", "rotation", "--at", "1", "--digits", "0"], "digits are a whole number"),
        (&["--alpha", "3"], "no arch of the half opening 3 stands at a thickness up to 2"),
        (&["--alpha", "0"], "no arch of the half opening 0 stands at a thickness up to 2"),
        (&["--alpha", "x"], "'x' is not a number"),
        (&["--thickness", "0"], "the thickness 0 is not between 0 and 2"),
        (&["--eta", "2"], "the thickness 2 is not between 0 and 2"),
        (&["--friction", "inf"], "the friction inf is not positive and finite"),
        (&["--mu", "0.4,-1"], "the friction -1 is not positive and finite"),
        (&["--mu", "0.4", "point", "limit", "--at", "1"], "cannot be used with"),
        (&["point", "limit", "--at", "1", "--alpha", "1"], "unexpected argument '--alpha'"),
        (&["--digits", "5"], "unexpected argument '--digits'"),
        (&["--format", "svgz"], "a format is one of"),
    ] {
        refused(&[&["map"], arguments].concat(), "", words);
    }
}

#[cfg(feature = "parquet")]
#[test]
fn a_point_has_no_parquet() {
    let line = ["map", "point", "limit", "--at", "1.5", "--format", "parquet", "-o", "no.parquet"];
    refused(&line, "", "a format is one of table, json, csv");
}
