//! Drawings in scenes: as the commands write them, each arch once, and kept.

use super::{HEAD, caption, run};
use crate::program::{Scratch, object, printed};
use couplet::scene::{Plan, read};
use serde_json::Value;

const DRAWINGS: &str = "[[figure]]\nnumber = 7\noutput = \"seven.svg\"\n\
    [[figure]]\nnumber = 8\noutput = \"eight.svg\"\n\
    [[figure]]\nnumber = 1\noutput = \"one.svg\"\n\
    [[drawing]]\nat = \"triple\"\nmode = \"srr\"\namplitude = \"0.05\"\noutput = \"T.svg\"\n\
    [[drawing]]\nalpha = \"80deg\"\nmu = 0.35\nstones = 9\nhalf = true\narrows = true\nanimate = true\noutput = \"a.svg\"\n\
    [[drawing]]\nhalf_opening = \"80deg\"\nfriction_angle = \"20deg\"\nthickness = \"4/25\"\noutput = \"b.json\"\n\
    [[drawing]]\nhalf_opening = 1\nthickness = 1\nmode = \"[s,s]\"\ndilatant = true\nweight = \"heyman\"\noutput = \"c.dxf\"\n";

#[test]
fn a_scene_draws_what_the_commands_draw() {
    let scratch = Scratch::new();
    let tree = run(&scratch, DRAWINGS, "--explain --resume");
    for line in [
        "7 items; to compute: 4 drawn arches, each once",
        "│  └─ T milankovitch: computed for the item in line 2",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    let arch = "draw --half-opening 80deg";
    for (file, command) in [
        ("seven.svg", "figure 7 --weight milankovitch"),
        ("one.svg", "figure 1 --weight milankovitch"),
        ("T.svg", "draw --at T --weight milankovitch --mode [s,r,r] --amplitude 0.05"),
        (
            "a.svg",
            &format!(
                "{arch} --friction 0.35 --weight milankovitch --stones 9 --half --arrows --animate"
            ),
        ),
        ("b.json", &format!("{arch} --friction-angle 20deg --thickness 4/25 --format json")),
        (
            "c.dxf",
            "draw --half-opening 1 --thickness 1 --weight heyman --mode [s,s] --dilatant --format dxf",
        ),
    ] {
        assert_eq!(scratch.read(&format!("out/{file}")), printed(command), "{file}");
    }
    let again = run(&scratch, DRAWINGS, "--explain --resume");
    assert_eq!(again.matches("kept ").count(), 7, "{again}");
    assert!(again.contains("nothing to compute"), "{again}");
}

/// However its numbers are written.
#[test]
fn an_arch_is_computed_once() {
    let arch = |alpha: &str, more: &str| {
        format!("[[drawing]]\nhalf_opening = {alpha}\nfriction = 1\n{more}\n")
    };
    let drawn = |all: &[String]| {
        let scene = read(&format!("{HEAD}{}", all.concat())).unwrap();
        Plan::new(&scene, vec![false; all.len()]).sizes().len()
    };
    let one = || arch("1.5", "");
    assert_eq!(drawn(&[one(), arch("\"3/2\"", "half = true")]), 1);
    for other in ["dilatant = true", "stones = 9", "weight = \"heyman\"", "thickness = 0.2"] {
        assert_eq!(drawn(&[one(), arch("1.5", other)]), 2, "{other}");
    }
}

#[test]
fn what_falls_is_drawn() {
    let scratch = Scratch::new();
    run(&scratch, "[[drawing]]\nalpha = 2.6\nmu = 0.3\noutput = \"a.svg\"\n", "");
    assert!(scratch.read("out/a.svg").contains("It stands at no thickness"));
}

/// Keys of sizes make the arches of the command in metres.
#[test]
fn a_scene_reads_an_arch_in_metres() {
    let scratch = Scratch::new();
    let arch = "span = \"18.9m\"\nrise = \"4.2m\"\nfriction = 0.6\n";
    let scene = format!(
        "[[drawing]]\n{arch}thickness = \"90cm\"\noutput = \"a.svg\"\n[[arches]]\n{arch}digits = 9\noutput = \"a.json\"\n\
         [[arches]]\n{arch}thickness = [\"90cm\", \"0.1r\"]\ndensity = \"24kN/m3\"\ndepth = \"1m\"\ndigits = 9\noutput = \"b.json\"\n"
    );
    run(&scratch, &scene, "");
    let metres = "--span 18.9m --rise 4.2m --friction 0.6";
    let drawn = printed(format!("draw {metres} --thickness 90cm --weight milankovitch"));
    // The command has its options in the order of the arguments, the scene in that of the fields.
    let bare = |svg: &str| svg.lines().filter(|l| !l.contains("couplet draw")).collect::<String>();
    let made = scratch.read("out/a.svg");
    assert!(caption(&made).contains("--thickness 90cm --span 18.9m --rise 4.2m"));
    assert_eq!(bare(&made), bare(&drawn));
    let [state, assessed] = ["a", "b"].map(|of| scratch.json(&format!("out/{of}.json")));
    let same = |entry: &Value, line: &str| {
        for (key, value) in object(format!("{line} --digits 9")).as_object().unwrap() {
            assert_eq!(&entry[key], value, "{line}: {key}");
        }
    };
    same(&state["arches"][0], &format!("state {metres}"));
    let kn = "--density 24kN/m3 --depth 1m";
    for (k, eta) in ["90cm", "0.1r"].iter().enumerate() {
        same(&assessed["arches"][k], &format!("assess {metres} --thickness {eta} {kn}"));
    }
}
