//! `couplet map difference`: beside the arches of both weights, in every format, and refused.

use crate::program::{Scratch, object, printed};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The thickness on a line at a friction, by the equations of its landmarks, and of the arch that is there.
fn thickness(line: &Value, weight: &str, friction: f64) -> f64 {
    let mu = format!("{friction:?}");
    let of = format!("--mu {mu} --weight {weight} --digits 16");
    let modes = line.as_str().unwrap();
    let found = object(format!("find boundary {modes} {of}"));
    let eta: f64 = found["thickness"]["value"].as_str().unwrap().parse().unwrap();
    if !modes.ends_with("/ss") {
        // Below such a line nothing stands, and a rounding of the half opening may be there.
        let alpha = found["half_opening"]["value"].as_str().unwrap();
        let state = object(format!("state --alpha {alpha} {of}"));
        let least: f64 = state["thickness"]["value"].as_str().unwrap().parse().unwrap();
        assert!((least - eta).abs() < 1e-11, "{line} {weight} {mu}: {least} {eta}");
    }
    eta
}

/// At some frictions of each curve, and not if one line is moved by a millionth.
#[test]
fn the_difference_is_that_of_the_arches() {
    let report = object("map difference --tolerance 1e-7");
    let mut pairs = Vec::new();
    for difference in report["differences"].as_array().unwrap() {
        assert!(number(&difference["widest_tube"]) <= 1e-7);
        let nodes = difference["nodes"].as_array().unwrap();
        let step = (nodes.len() / 5).max(1);
        for node in nodes.iter().skip(step / 2 + 1).step_by(step) {
            let (Some(_), lines) =
                (node["tube"].as_f64(), ["line_heyman", "line_milankovitch"].map(|l| &node[l]))
            else {
                continue;
            };
            let mu = (number(&node["friction_lower"]) + number(&node["friction_upper"])) / 2.0;
            let [heyman, milankovitch] =
                [thickness(lines[0], "heyman", mu), thickness(lines[1], "milankovitch", mu)];
            let [low, high] = ["difference_lower", "difference_upper"].map(|of| number(&node[of]));
            let room = 1e-9 * (1.0 + mu * mu);
            let is_there = |x: f64| low - room <= x && x <= high + room;
            assert!(is_there(milankovitch - heyman), "{lines:?} {mu}: {low} {high}");
            assert!(!is_there(milankovitch - heyman + 1e-6), "false twin");
            assert!(number(&difference["least"]) <= low && high <= number(&difference["most"]));
            pairs.push(lines.map(|line| line.as_str().unwrap().to_owned()));
        }
    }
    pairs.dedup();
    assert!(pairs.len() > 6 && pairs.iter().any(|[one, other]| one != other), "{pairs:?}");
}

#[test]
fn a_picture_has_each_curve_and_its_tube() {
    let scratch = Scratch::new();
    let file = scratch.path("d.svg");
    let output = printed(["map", "difference", "-o", &file]);
    assert!(output.contains("d.svg: 4 curves, ") && output.contains("; proved: "), "{output}");
    assert_eq!(output.lines().count(), 1);
    let picture = scratch.read("d.svg");
    for divide in ["shoulder", "inner", "joints", "crown"] {
        assert!(picture.contains(&format!("id=\"difference-{divide}\"")), "{divide}");
    }
    for name in [">Tₘ<", ">Tₕ<", ">Sₕ, Jₕ<", ">Bₘ<", ">ℓ<", "in η of where it is drawn"]
    {
        assert!(picture.contains(name), "{name}");
    }
    let table = printed("map difference --format csv");
    assert!(table.starts_with("divide,node,line_heyman,line_milankovitch,parameter,"));
}
