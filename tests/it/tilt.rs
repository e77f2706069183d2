//! Arches under a horizontal acceleration, on the command line.

use crate::program::{Json, Scratch, couplet, object, printed, said, tells};
use serde_json::Value;

fn of(arguments: &str) -> String {
    printed(format!("assess {arguments}"))
}

/// The drawings that the manual promises of a tilted arch are those that there are.
#[test]
fn the_manual_names_the_drawings_of_a_tilted_arch() {
    let manual = include_str!("../../docs/commands.md");
    let (_, told) = manual.split_once("alone, and with `-o arch").unwrap();
    let (told, _) = told.split_once("the answer is a drawing").unwrap();
    let promised: Vec<&str> = told.split('`').filter_map(|end| end.strip_prefix('.')).collect();
    assert_eq!(promised, ["svg", "png", "pdf", "dxf"]);
    let scratch = Scratch::new();
    for end in promised {
        let is_there = cfg!(feature = "plots") || !["png", "pdf"].contains(&end);
        let file = scratch.path(&format!("arch.{end}"));
        let line = format!("assess --alpha 1 --mu 1 --eta 0.2 --tilt 0.1 -o {file}");
        let (code, out, error) = said(&couplet(line));
        assert_eq!((code, &out[..]), (Some(if is_there { 0 } else { 2 }), ""), "{end}: {error}");
    }
}

/// An acceleration is a ratio and an angle; the forces at the crown are ratios times `w r`, which the weight tells.
#[test]
fn a_tilted_arch_has_forces_and_angles() {
    for joints in ["", " --stones 21"] {
        let arch =
            format!("--alpha 1 --mu 1 --radius 3m --eta 0.6m --tilt 0.1 --digits 12{joints}");
        tells(&of(&arch), ["thickness 0.6m = 0.181818 r", "as measured"]);
        let loaded = format!("{arch} --density 2000kg/m3 --depth 1m");
        let json = object(format!("assess {loaded}"));
        let is = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-10, "{a} {b}: {json}");
        // 2 w r alpha, where alpha is one radian and w r = 19.6133 x 0.6 x 3.3 kN.
        let unit = json["weight_kn"].value() / 2.0;
        is(unit, 19.6133 * 0.6 * 3.3);
        is(json["thrust_kn"].value(), unit * json["thrust"].value());
        is(json["vertical_force_kn"].value(), unit * json["vertical_force"].value());
        is(json["largest_tilt_degrees"].value().to_radians().tan(), json["largest_tilt"].value());
        for joint in json["gives_way"].list() {
            is(joint["angle_degrees"].value().to_radians(), joint["angle"].value());
        }
        tells(&of(&format!("{loaded} --format csv")), [json["thrust_kn"]["value"].text()]);
    }
}

/// On steep ground an arch with unlimited friction comes apart at a springing: both its hinges are there, and no slip
/// is asked for. A large friction differs by little, however large it is.
#[test]
fn the_largest_tilt_is_found_whatever_the_friction() {
    let largest = |mu: &str| {
        let arch = "--alpha 0.994 --eta 0.504 --weight heyman --tilt 0.3 --digits 12";
        object(format!("assess {arch} --mu {mu}"))
    };
    let json = largest("inf");
    assert_eq!(json["largest_tilt"]["value"], "7.10159604237", "a linear programme has 7.10160");
    let springing = |joint: &&Value| joint["side"] == "left" && joint["angle"].value() == 0.994;
    let there: Vec<&Value> = json["gives_way"].list().iter().filter(springing).collect();
    let [one, other] = &there[..] else { panic!("{json}") };
    assert_eq!(one["happens"], "hinge at the extrados");
    assert_eq!(other["happens"], "hinge at the intrados");
    for mu in ["1e6", "1e12", "1e30", "1e100"] {
        let near = largest(mu)["largest_tilt"].value();
        assert!((near / json["largest_tilt"].value() - 1.0).abs() < 1e-7, "{mu}: {near}");
    }
}

/// Beside a verdict, what stays open is named: the largest acceleration, and not whether there is a state.
#[test]
fn what_stays_open_beside_a_verdict_is_named() {
    let line = "voussoirs --alpha pi/6 --mu 30deg --stones 2 --eta 0.3 --tilt 0.1";
    let (code, out, error) = said(&couplet(line));
    assert!(out.contains("stands, proved: an admissible state exists"), "{out}");
    let open = code == Some(1);
    assert_eq!(open, error.contains("undecided: the largest tilt: "), "{error}");
    assert_eq!(open, !out.contains("falls from the tilt"), "{out}");
    assert!(!error.contains("whether any state"), "{error}");
}

/// A force and its moment about the centre, on what is left of a joint: thrust, vertical force, moment.
type Load = [f64; 3];

/// The joints that are named: the forces that four of them fix put the pressure points where it says, on either side
/// within the arch everywhere else, and the acceleration is the one that is told.
#[test]
fn the_joints_that_give_way_are_named() {
    for (arch, eta, mu) in [
        ("--alpha pi/2 --mu inf --eta 0.15", 0.15, f64::INFINITY),
        ("--alpha 1.2 --mu 0.6 --eta 0.1", 0.1, 0.6),
        ("--alpha pi/2 --mu 0.4 --eta 0.15", 0.15, 0.4),
        ("--alpha pi/2 --mu 0.4 --eta 0.15 --stones 11", 0.15, 0.4),
    ] {
        let json = object(format!("assess {arch} --tilt 0.01 --digits 12"));
        let tilt = json["largest_tilt"].value();
        let fac = 1.0 + eta * eta / 12.0;
        let joint = |joint: &Value| {
            let sign = if joint["side"] == "left" { -1.0 } else { 1.0 };
            (joint["happens"].as_str().unwrap().to_owned(), sign * joint["angle"].value())
        };
        let joints: Vec<(String, f64)> = json["gives_way"].list().iter().map(joint).collect();
        assert_eq!(joints.len(), 4, "{arch}");
        assert!(joints.windows(2).all(|pair| pair[0].1 > pair[1].1), "from the right: {joints:?}");
        // What a joint asks of (h, v, p) in the crown at an acceleration: rows of a linear system, from the moments of
        // thin slices about the point where the force has to act.
        let slices = |joint: f64| -> Load {
            let count = 20_000;
            let width = joint / f64::from(count);
            let centre = |k: i32| (f64::from(k) + 0.5) * width;
            (0..count).map(centre).fold([0.0; 3], |[x, y, m], beta| {
                let at = [fac * beta.sin(), fac * beta.cos()];
                [x + tilt * width, y + width, m + width * at[0] + tilt * width * at[1]]
            })
        };
        // The forces on a joint: horizontal, vertical and the moment about the centre, without those in the crown.
        let forces = |joint: f64, [h, v, p]: Load| {
            let [x, y, m] = slices(joint);
            let (across, down) = (h + x, y - v);
            let normal = across * joint.cos() + down * joint.sin();
            let shear = down * joint.cos() - across * joint.sin();
            ((p + m) / normal, shear / normal)
        };
        // The state by Newton's method on three of the conditions.
        let gap = |(happens, joint): &(String, f64), load: Load| {
            let (radius, slope) = forces(*joint, load);
            match happens.as_str() {
                "hinge at the extrados" => radius - 1.0 - eta / 2.0,
                "hinge at the intrados" => radius - 1.0 + eta / 2.0,
                "slides outwards" => slope * joint.signum() + mu,
                "slides inwards" => slope * joint.signum() - mu,
                other => panic!("{other}"),
            }
        };
        let mut load = [0.5, 0.0, 0.5];
        for _ in 0..60 {
            let value: Vec<f64> = joints[..3].iter().map(|joint| gap(joint, load)).collect();
            let mut matrix = [[0.0; 4]; 3];
            for (row, joint) in matrix.iter_mut().zip(&joints) {
                for (k, entry) in row.iter_mut().take(3).enumerate() {
                    let mut moved = load;
                    moved[k] += 1e-7;
                    *entry = (gap(joint, moved) - gap(joint, load)) / 1e-7;
                }
            }
            (0..3).for_each(|i| matrix[i][3] = value[i]);
            for i in 0..3 {
                let pivot = (i..3)
                    .max_by(|a, b| matrix[*a][i].abs().total_cmp(&matrix[*b][i].abs()))
                    .unwrap();
                matrix.swap(i, pivot);
                for j in 0..3 {
                    if j != i {
                        let factor = matrix[j][i] / matrix[i][i];
                        let row = matrix[i];
                        matrix[j].iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
                    }
                }
            }
            (0..3).for_each(|i| load[i] -= 0.5 * matrix[i][3] / matrix[i][i]);
        }
        assert!(joints.iter().all(|joint| gap(joint, load).abs() < 1e-6), "{arch}: {load:?}");
        // And nowhere else is anything passed.
        let between: Vec<f64> = match arch.contains("stones") {
            true => (-6..6).map(|k| f64::from(2 * k + 1) / 22.0 * std::f64::consts::PI).collect(),
            false => (-40..=40).map(|k| f64::from(k) / 40.0 * joints[0].1).collect(),
        };
        for joint in between.into_iter().filter(|joint| joint.abs() <= joints[0].1 + 1e-9) {
            let (radius, slope) = forces(joint, load);
            let is_within = (radius - 1.0).abs() < eta / 2.0 + 1e-6;
            assert!(is_within && slope.abs() < mu + 1e-6, "{arch} {joint}");
        }
    }
}

/// In text, JSON and the picture alike; and which way it is pushed.
#[test]
fn a_tilted_arch_is_drawn() {
    let arch = "--alpha pi/2 --mu 0.4 --eta 0.15 --tilt 0.05";
    let scratch = Scratch::new();
    let drawn = |line: &str| {
        assert_eq!(of(&format!("{line} -o {}", scratch.path("a.svg"))), "");
        scratch.read("a.svg")
    };
    let told = of(&format!("{arch} --digits 8"));
    assert!(told.contains("hinge at the intrados on the right (54.7704 deg)"), "{told}");
    for (stones, joint) in [("", "54.77°"), (" --stones 11", "joint 4, 57.27°")] {
        let svg = drawn(&format!("{arch} --digits 8{stones}"));
        let words =
            ["pushed to the right", "hinge at the intrados", "slides outwards", "90° right", joint];
        tells(&svg, words);
        assert_eq!(svg.matches("<circle").count(), 4, "three hinges and one in the legend");
    }
    // Of one digit the words have the numbers that they have of many.
    let said = |digits: &str| {
        let svg = drawn(&format!("{arch} --digits {digits}"));
        tells(&svg, ["falls from 0.0524689 g", "which is 3.00349°"]);
        svg.replace(&format!("--digits {digits}"), "")
    };
    for digits in ["1", "2", "6"] {
        assert_eq!(said(digits), said("20"), "{digits}");
    }
    // What does not stand at all is said to fall; what nothing limits stands.
    for (arch, words) in [
        ("--alpha pi/2 --mu 0.7 --eta 0.1 --tilt 0", "does not stand: falls as [r,r,r]"),
        ("--alpha 0.5 --mu 2 --eta 0.7 --tilt 10", "stands at every tilt"),
    ] {
        assert!(drawn(arch).contains(words), "{arch}");
    }
}
