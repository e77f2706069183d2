//! `couplet complementarity`: its branches, and what stays open. What it says of arches is among the stored outputs.

use crate::program::{Json, ended, object, printed, says, tells};
use serde_json::{Value, json};

/// The branch meets what `state` says, at its ends and between them; CSV and JSON have the same nodes.
#[test]
fn a_branch_begins_and_ends_on_the_least_thickness() {
    let line = "complementarity --half-opening 2.3 --branch --digits 20";
    let found = object(line);
    assert_eq!(found["verdict"], "proved");
    let points = found["points"].list();
    let value = |point: &Value, name: &str| point[name]["value"].text().to_owned();
    let thicknesses = ["thickness", "least_thickness"];
    let [first, change, last] = points else { panic!("{points:?}") };
    for end in [first, last] {
        let [own, least] = thicknesses.map(|name| value(end, name));
        assert_eq!((own, end["symmetric"].as_bool()), (least, Some(true)));
    }
    assert_eq!(value(change, "thickness"), "0.60334349864365555821");
    let mu = value(change, "friction");
    let state = printed(format!("state --alpha 2.3 --mu {mu} --digits 15 --plain"));
    let least = value(change, "least_thickness")[..14].to_owned();
    assert!(state.lines().any(|line| line.starts_with(&least)), "{least}: {state}");
    // Of one friction the solution is between the two.
    let both = object("complementarity --half-opening 2.3 --friction 1.06 --digits 8");
    let [symmetric, other] = both["solutions"].list() else { panic!("{both}") };
    assert_eq!([symmetric, other].map(|of| of["symmetric"] == true), [true, false]);
    let other = value(other, "thickness");
    assert!(value(first, "thickness") < other && other < value(change, "thickness"));
    let parts = found["parts"].list();
    let nodes = parts.iter().chain(found["least"].list());
    let nodes: usize = nodes.map(|part| part["nodes"].list().len()).sum();
    let table = printed(format!("{line} --format csv"));
    assert_eq!(table.lines().count(), nodes + 1);
    assert!(parts.iter().all(|part| part["admissible"] == true), "{parts:?}");
}

/// Its parts, its ends and what is not proved are in the picture.
#[test]
fn a_branch_is_drawn_beside_the_least_thickness() {
    let drawn = printed("complementarity --half-opening 2.21 --branch --format svg");
    let ids = ["least", "inner_sliding", "shoulder_sliding", "legend"];
    tells(&drawn, ids.map(|id| format!("id=\"{id}\"")));
    assert!(!drawn.contains("id=\"shoulder_opening\""), "there is none");
    assert!(drawn.contains("Milankovitch's weight there are no others"));
}

/// An arch so flat that doubles tell nothing of it is undecided soon, in one line.
#[test]
fn a_tiny_arch_between_stones_is_undecided_in_a_line() {
    for (alpha, stones) in [("1e-7", "6"), ("1e-9", "8")] {
        let line = format!("complementarity --alpha {alpha} --mu 0.6 --stones {stones}");
        let (_, error) = ended(1, line, "");
        assert_eq!(error.lines().count(), 1, "{error}");
        tells(&error, ["undecided: whether there is a solution at a thickness"]);
    }
}

/// What stays open is said with its place, on the error stream and as a row.
#[test]
fn open_pieces_are_listed() {
    let line = "complementarity --alpha 0.001 --mu 0.3 --stones 4 --half --format csv";
    let (rows, error) = ended(1, line, "");
    let pieces = rows.lines().filter(|row| row.contains(",open,"));
    let pieces: Vec<Vec<&str>> = pieces.map(|row| row.split(',').collect()).collect();
    assert_eq!(pieces.len(), 1, "{rows}");
    let words = format!("at a thickness from {} to {}\n", pieces[0][5], pieces[0][11]);
    assert!(error.ends_with(&words), "{words}");
}

/// Where only a lower bound of the least value is proved, every format tells it.
#[test]
fn a_lower_bound_of_the_least_value_is_told_in_every_format() {
    let told = |arch: &str, format| printed(format!("complementarity {arch} --format {format}"));
    let programme = |arch: &str| object(format!("complementarity {arch}"))["programme"].clone();
    let flat = |thickness| {
        format!("--weight heyman --alpha 1.066 --mu 0.303 --stones 5 --digits 9 --eta {thickness}")
    };
    let line = |thickness, format| told(&flat(thickness), format);
    let of = |thickness| programme(&flat(thickness));
    let enclosed = programme("--alpha 2.3 --mu 1.05 --stones 8 --eta 0.6 --digits 6");
    assert_eq!(enclosed["least_value_lower"], enclosed["least_value"]["lower"], "{enclosed}");
    assert!(enclosed["least_value_lower"].is_string());
    let bounded = of("1.096");
    assert!(bounded["least_value"].is_null() && bounded["outcome"] == "positive", "{bounded}");
    let lower = bounded["least_value_lower"].text();
    assert!(bounded["least_value_lower"].decimal() > 0.1249);
    assert!(line("1.096", "table").contains(&format!("least value at least {lower}\n")));
    assert!(line("1.096", "csv").trim_end().ends_with(&format!(",positive,,,{lower}")));
    assert_eq!(of("least")["least_value_lower"], "0");
    says(&of("0.01"), json!({"outcome": "nothing_admissible", "least_value_lower": null}));
}
