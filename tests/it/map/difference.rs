//! `couplet map difference`: beside the arches of both weights, in every format, and refused.

use crate::program::{Json, Scratch, object, printed, tells};
use serde_json::Value;

/// The thickness on a line at a friction, by the equations of its landmarks, and of the arch that is there.
fn thickness(line: &Value, weight: &str, friction: f64) -> f64 {
    let mu = format!("{friction:?}");
    let of = format!("--mu {mu} --weight {weight} --digits 16");
    let modes = line.text();
    let found = object(format!("find boundary {modes} {of}"));
    let eta = found["thickness"].value();
    if !modes.ends_with("/ss") {
        // Below such a line nothing stands, and a rounding of the half opening may be there.
        let alpha = found["half_opening"]["value"].text();
        let state = object(format!("state --alpha {alpha} {of}"));
        let least = state["thickness"].value();
        assert!((least - eta).abs() < 1e-11, "{line} {weight} {mu}: {least} {eta}");
    }
    eta
}

/// At some frictions of each curve, and not if one line is moved by a millionth.
#[test]
fn the_difference_is_that_of_the_arches() {
    let report = object("map difference --tolerance 1e-7");
    let mut pairs = Vec::new();
    for difference in report["differences"].list() {
        assert!(difference["widest_tube"].number() <= 1e-7);
        let nodes = difference["nodes"].list();
        let step = (nodes.len() / 5).max(1);
        for node in nodes.iter().skip(step / 2 + 1).step_by(step) {
            let (Some(_), lines) =
                (node["tube"].as_f64(), ["line_heyman", "line_milankovitch"].map(|l| &node[l]))
            else {
                continue;
            };
            let mu = (node["friction_lower"].number() + node["friction_upper"].number()) / 2.0;
            let [heyman, milankovitch] =
                [thickness(lines[0], "heyman", mu), thickness(lines[1], "milankovitch", mu)];
            let [low, high] = ["difference_lower", "difference_upper"].map(|of| node[of].number());
            let room = 1e-9 * (1.0 + mu * mu);
            let is_there = |x: f64| low - room <= x && x <= high + room;
            assert!(is_there(milankovitch - heyman), "{lines:?} {mu}: {low} {high}");
            assert!(!is_there(milankovitch - heyman + 1e-6), "false twin");
            assert!(difference["least"].number() <= low && high <= difference["most"].number());
            pairs.push(lines.map(|line| line.text().to_owned()));
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
    let divides = ["shoulder", "inner", "joints", "crown"];
    tells(&picture, divides.map(|divide| format!("id=\"difference-{divide}\"")));
    tells(&picture, [">Tₘ<", ">Tₕ<", ">Sₕ, Jₕ<", ">Bₘ<", ">ℓ<", "in η of where it is drawn"]);
    let table = printed("map difference --format csv");
    assert!(table.starts_with("divide,node,line_heyman,line_milankovitch,parameter,"));
}
