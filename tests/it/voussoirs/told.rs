//! What is told of arches of stones, in every format, and what is refused.

use crate::program::{object, printed};
use serde_json::Value;

#[test]
fn a_million_stones_are_told_in_every_format() {
    let line = "voussoirs --alpha pi/2 --mu 0.35 --stones 1000000";
    let json = object(line);
    assert_eq!(
        (&json["schema"], &json["mode"]),
        (&"couplet.voussoirs/1".into(), &"[s,r,r]".into())
    );
    let eta = json["thickness"]["value"].as_str().unwrap();
    for format in ["csv", "table"] {
        assert!(printed(format!("{line} --format {format}")).contains(eta), "{format}");
    }
}

/// A range has what each number has, and what it loses; the figure has a mark for each.
#[test]
fn a_range_of_stones_is_told_in_every_format() {
    let line = "voussoirs --mu 0.35 --alpha pi/2 --digits 12 --stones";
    let of = |stones, format| printed(format!("{line} {stones} --format {format}"));
    let rows = object(format!("{line} 3..12"));
    assert_eq!(rows.as_array().unwrap().len(), 10);
    let (table, csv) = (of("3..12", "table"), of("3..12", "csv"));
    for row in rows.as_array().unwrap() {
        let stones = row["stones"].as_u64().unwrap();
        let mut alone = object(format!("{line} {stones}"));
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
    let svg = |more: &str| {
        printed(format!("voussoirs --alpha pi/2 --mu 0.6 --stones 2..40 --format svg {more}"))
    };
    for (more, commands) in [("", 0), ("--width 84mm --full-caption", 1)] {
        let svg = svg(more);
        let parts =
            ["<title>The least thickness", "<desc>By which share of", ">odd n<", ">even n<"];
        for part in parts.into_iter().chain(["role=\"img\""]) {
            assert!(svg.contains(part), "{part}");
        }
        assert_eq!(svg.matches("id=\"caption\"").count(), 1);
        let texts = svg.split("<text").skip(1).filter_map(|text| text.split('>').nth(1));
        assert_eq!(texts.filter(|text| text.starts_with("Command: ")).count(), commands);
    }
    assert!(!svg("--no-caption").contains("id=\"caption\""));
}
