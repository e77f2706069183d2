//! What is told of arches of stones, in every format, and what is refused.

use crate::program::{Json, object, printed, says, tells};
use serde_json::json;

#[test]
fn a_million_stones_are_told_in_every_format() {
    let line = "voussoirs --alpha pi/2 --mu 0.35 --stones 1000000";
    let json = object(line);
    says(&json, json!({"schema": "couplet.voussoirs/1", "mode": "[s,r,r]"}));
    let eta = json["thickness"]["value"].text();
    for format in ["csv", "table"] {
        assert!(printed(format!("{line} --format {format}")).contains(eta), "{format}");
    }
}

/// A value without a bound is `inf` in a row, as of every arch, and one that there is not is empty.
#[test]
fn what_has_no_bound_is_inf_in_a_row() {
    let row = |line: &str| {
        let text = printed(format!("assess {line} --format csv"));
        let (header, row) = text.split_once('\n').unwrap();
        let cells: Vec<String> = header
            .split(',')
            .map(str::to_owned)
            .zip(row.split(','))
            .map(|(name, x)| format!("{name}={x}"))
            .collect();
        cells.join(" ")
    };
    let unbounded = [
        "geometric_safety=inf",
        "required_friction=0",
        "friction_safety=inf",
        "largest_thrust=inf",
    ];
    tells(&row("--alpha 0.7 --mu 2 --eta 0.369 --stones 2"), unbounded);
    tells(
        &row("--alpha pi/2 --mu 0.6 --eta 0.05 --stones 7"),
        ["geometric_safety=0.", "least_thrust= largest_thrust= "],
    );
}

/// A range has what each number has, and what it loses; the figure has a mark for each.
#[test]
fn a_range_of_stones_is_told_in_every_format() {
    let line = "voussoirs --mu 0.35 --alpha pi/2 --digits 12 --stones";
    let of = |stones, format| printed(format!("{line} {stones} --format {format}"));
    let rows = object(format!("{line} 3..12"));
    assert_eq!(rows.list().len(), 10);
    let (table, csv) = (of("3..12", "table"), of("3..12", "csv"));
    for row in rows.list() {
        let stones = row["stones"].as_u64().unwrap();
        let mut alone = object(format!("{line} {stones}"));
        let asked = alone.as_object_mut().unwrap().remove("asked").unwrap();
        assert_eq!(asked["stones"], stones.to_string());
        assert_eq!(*row, alone, "{stones}");
        let Some(eta) = row["thickness"]["value"].as_str() else { continue };
        assert!(table.contains(eta) && csv.contains(eta), "{stones}");
        let whole = row["continuous_thickness"].value();
        let loss = whole - row["thickness"].value();
        assert!((row["loss"].value() - loss).abs() < 1e-3 * loss, "{stones}");
        assert!((row["relative_loss"].value() * whole - loss).abs() < 1e-3 * loss, "{stones}");
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
        let parts = [
            "<title>The least thickness",
            "<desc>By which share of",
            ">odd n<",
            ">even n<",
            "role=\"img\"",
        ];
        tells(&svg, parts);
        assert_eq!(svg.matches("id=\"caption\"").count(), 1);
        let texts = svg.split("<text").skip(1).filter_map(|text| text.split('>').nth(1));
        assert_eq!(texts.filter(|text| text.starts_with("Command: ")).count(), commands);
    }
    assert!(!svg("--no-caption").contains("id=\"caption\""));
}
