//! The files of bodies, read back.

use crate::program::Json;
use serde_json::Value;

/// Text of a file, and what spoils it: a face that is gone, an outline that is open.
pub(super) fn spoiled(format: &str) -> [&'static str; 2] {
    if format == "obj" { ["f 4 3 2 1\n", ""] } else { ["90\n4\n70\n1\n", "90\n4\n70\n0\n"] }
}

/// What is wrong with a file, held against its question.
pub(super) fn fault(format: &str, file: &str, question: &Value) -> Option<String> {
    let found = if format == "obj" { volumes(file) } else { areas(file) };
    let stones = question["blocks"].list();
    let all = found.len() == stones.len() + 2;
    // The prisms have chords, the outlines arcs.
    let told = |stone: &Value| match format {
        "obj" => chords(&stone["polygon"]),
        _ => stone["weight"].number(),
    };
    let radius = question["radius"].number();
    let near =
        |(found, stone): (&f64, &Value)| (found - told(stone)).abs() < 1e-6 * radius * radius;
    (!all || !found.iter().zip(stones).all(near)).then(|| format!("{found:?}"))
}

fn chords(polygon: &Value) -> f64 {
    let at = |corner: usize, axis: usize| polygon[corner % 4][axis].number();
    let cross = |i: usize| at(i, 0) * at(i + 1, 1) - at(i, 1) * at(i + 1, 0);
    (0..4).map(cross).sum::<f64>() / 2.0
}

/// Volumes of the closed bodies of an OBJ file; NaN of one whose faces leave a hole.
fn volumes(file: &str) -> Vec<f64> {
    let (mut points, mut found) = (Vec::<[f64; 3]>::new(), Vec::new());
    for line in file.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "o" => found.push((0.0, 0)),
            "v" => points.push([1, 2, 3].map(|at| words[at].parse().unwrap())),
            "f" => {
                let corners: Vec<[f64; 3]> =
                    words[1..].iter().map(|at| points[at.parse::<usize>().unwrap() - 1]).collect();
                let body = found.last_mut().unwrap();
                body.1 += 1;
                for at in 1..corners.len() - 1 {
                    let [a, b, c] = [corners[0], corners[at], corners[at + 1]];
                    let cross = [
                        b[1] * c[2] - b[2] * c[1],
                        b[2] * c[0] - b[0] * c[2],
                        b[0] * c[1] - b[1] * c[0],
                    ];
                    body.0 += (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0;
                }
            }
            _ => {}
        }
    }
    found.into_iter().map(|(volume, faces)| if faces == 6 { volume } else { f64::NAN }).collect()
}

/// Areas of the closed outlines of a DXF file, arcs included.
fn areas(file: &str) -> Vec<f64> {
    let lines: Vec<&str> = file.lines().collect();
    let pairs: Vec<(&str, &str)> = lines.chunks(2).map(|pair| (pair[0], pair[1])).collect();
    let entities = pairs.split(|pair| pair.0 == "0");
    let outlines =
        entities.filter(|of| of.contains(&("100", "AcDbPolyline")) && of.contains(&("70", "1")));
    let area = |of: &[(&str, &str)]| {
        let mut corners: Vec<[f64; 3]> = Vec::new();
        for (code, value) in of {
            match (*code, value.parse::<f64>()) {
                ("10", Ok(x)) => corners.push([x, 0.0, 0.0]),
                ("20", Ok(y)) => corners.last_mut().unwrap()[1] = y,
                ("42", Ok(bulge)) => corners.last_mut().unwrap()[2] = bulge,
                _ => {}
            }
        }
        let next = corners.iter().cycle().skip(1);
        let part = |([x, y, bulge], [u, v, _]): (&[f64; 3], &[f64; 3])| {
            let angle = 4.0 * bulge.atan();
            // The segment between chord and arc.
            let radius = (u - x).hypot(v - y) / 2.0 / (angle / 2.0).sin();
            let segment =
                if angle == 0.0 { 0.0 } else { radius * radius * (angle - angle.sin()) / 2.0 };
            (x * v - y * u) / 2.0 + segment
        };
        corners.iter().zip(next).map(part).sum()
    };
    outlines.map(area).collect()
}
