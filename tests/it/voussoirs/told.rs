//! What is told of arches of stones, in every format, and what is refused.

use crate::program::couplet;
use serde_json::Value;

#[test]
fn a_million_stones_are_told_in_every_format() {
    let of = |format| {
        let words = "voussoirs --alpha pi/2 --mu 0.35 --stones 1000000 --format";
        let words: Vec<&str> = words.split(' ').chain([format]).collect();
        let output = couplet(&words);
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).unwrap()
    };
    let json: Value = serde_json::from_str(&of("json")).unwrap();
    assert_eq!(
        (&json["schema"], &json["mode"]),
        (&"couplet.voussoirs/1".into(), &"[s,r,r]".into())
    );
    let eta = json["thickness"]["value"].as_str().unwrap();
    assert!(of("csv").contains(eta) && of("table").contains(eta));
}

/// A range has what each number has, and what it loses; the figure has a mark for each.
#[test]
fn a_range_of_stones_is_told_in_every_format() {
    let of = |stones: &str, format| {
        let words = ["voussoirs", "--mu", "0.35", "--alpha", "pi/2", "--digits", "12", "--stones"];
        let output = couplet(&[&words[..], &[stones, "--format", format]].concat());
        assert_eq!(output.status.code(), Some(0), "{stones} {format}");
        String::from_utf8(output.stdout).unwrap()
    };
    let rows: Value = serde_json::from_str(&of("3..12", "json")).unwrap();
    assert_eq!(rows.as_array().unwrap().len(), 10);
    let (table, csv) = (of("3..12", "table"), of("3..12", "csv"));
    for row in rows.as_array().unwrap() {
        let stones = row["stones"].as_u64().unwrap();
        let mut alone: Value = serde_json::from_str(&of(&stones.to_string(), "json")).unwrap();
        let asked = alone.as_object_mut().unwrap().remove("asked").unwrap();
        assert_eq!(asked["stones"], stones.to_string());
        assert_eq!(*row, alone, "{stones}");
        let Some(eta) = row["thickness"]["value"].as_str() else { continue };
        assert!(table.contains(eta) && csv.contains(eta), "{stones}");
        let double = |value: &Value| value["value"].as_str().unwrap().parse::<f64>().unwrap();
        let whole = double(&row["continuous_thickness"]);
        let loss = whole - double(&row["thickness"]);
        assert!((double(&row["loss"]) - loss).abs() < 1e-3 * loss, "{stones}");
        assert!((double(&row["relative_loss"]) * whole - loss).abs() < 1e-3 * loss, "{stones}");
    }
}

/// A figure as all others: told to who does not see it, and fit for a column.
#[test]
fn the_figure_of_many_numbers_has_the_page_of_all_figures() {
    let line =
        ["voussoirs", "--alpha", "pi/2", "--mu", "0.6", "--stones", "2..40", "--format", "svg"];
    let svg = |more: &[&str]| {
        let output = couplet(&[&line[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{more:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    for more in [&[][..], &["--width", "84mm", "--full-caption"]] {
        let svg = svg(more);
        for part in [
            "role=\"img\"",
            "<title>The least thickness",
            "<desc>By which share of",
            ">odd n<",
            ">even n<",
        ] {
            assert!(svg.contains(part), "{part}");
        }
        assert_eq!(svg.matches("id=\"caption\"").count(), 1);
        let texts = svg.split("<text").skip(1).filter_map(|text| text.split('>').nth(1));
        assert_eq!(texts.filter(|text| text.starts_with("Command: ")).count(), more.len() / 3);
    }
    assert!(!svg(&["--no-caption"]).contains("id=\"caption\""));
}

#[test]
fn wrong_stones_are_one_line() {
    for (arguments, why) in [
        ("--alpha 1 --stones 1", "from 2 to"),
        ("--alpha 1 --stones -3", "from 2 to"),
        ("--alpha 1 --stones many", "from 2 to"),
        ("--alpha 1", "--stones (or --joints)"),
        ("--joints 0.5", "too few"),
        ("--joints 0,1,0.5", "do not rise from 1 to 0.5"),
        ("--joints 0,1,1", "do not rise"),
        ("--joints=-0.1,1", "above the crown"),
        ("--joints 0,1,4", "half opening 4"),
        ("--joints 0,x", "'x' is not a number"),
        ("--stones 5 --joints 0,1", "say the same"),
        ("--alpha 180deg --stones 5", "half opening 180deg"),
        ("--alpha 1 --stones 5..3", "from 2 to"),
        ("--alpha 1 --stones 1..3", "from 2 to"),
        ("--alpha 1 --stones 2..", "as in 2..200"),
        ("--alpha 1 --stones 2..10002", "at most 10000"),
        ("--alpha 1 --stones 2..9 --thickness 0.1", "one number of stones"),
        ("--alpha 1 --stones 5 --thickness 0", "not between 0 and 2"),
        ("--alpha 1 --stones 5 --thickness pi", "no ratio"),
        ("--alpha 1 --stones 5 --thickness=-1", "not between 0 and 2"),
    ] {
        let words = ["voussoirs", "--mu", "1"].into_iter().chain(arguments.split(' '));
        let output = couplet(&words.collect::<Vec<&str>>());
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(error.lines().count() == 1 && error.contains(why), "{arguments}: {error}");
    }
}
