//! Drawings in scenes: as the commands write them, each arch once, and kept.

use super::{HEAD, faults, scene_in};
use crate::program::{Scratch, couplet, text};
use couplet::scene::{Plan, read};

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
    let scene = scene_in(&scratch, DRAWINGS);
    let run = ["run", &scene, "--output", &scratch.path("out"), "--explain", "--resume"];
    let output = couplet(&run);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let tree = text(&output.stderr);
    for line in [
        "7 items; to compute: 4 drawn arches, each once",
        "│  └─ T milankovitch: computed for the item in line 2",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    for (file, command) in [
        ("seven.svg", "figure 7 --weight milankovitch"),
        ("one.svg", "figure 1 --weight milankovitch"),
        ("T.svg", "draw --at T --weight milankovitch --mode [s,r,r] --amplitude 0.05"),
        (
            "a.svg",
            "draw --half-opening 80deg --friction 0.35 --weight milankovitch --stones 9 --half --arrows --animate",
        ),
        (
            "b.json",
            "draw --half-opening 80deg --friction-angle 20deg --thickness 4/25 --format json",
        ),
        (
            "c.dxf",
            "draw --half-opening 1 --thickness 1 --weight heyman --mode [s,s] --dilatant --format dxf",
        ),
    ] {
        let words: Vec<&str> = command.split(' ').collect();
        let drawn = text(&couplet(&words).stdout);
        assert_eq!(scratch.read(&format!("out/{file}")), drawn, "{file}");
    }
    let again = couplet(&run);
    let said = text(&again.stderr);
    assert_eq!(said.matches("kept ").count(), 7, "{said}");
    assert!(said.contains("nothing to compute"), "{said}");
}

/// However its numbers are written.
#[test]
fn an_arch_is_computed_once() {
    let arch = |alpha: &str, more: &str| {
        format!("[[drawing]]\nhalf_opening = {alpha}\nfriction = 1\n{more}\n")
    };
    let drawn = |all: &[String]| {
        let scene = read(&format!("{HEAD}{}", all.concat())).unwrap();
        Plan::new(&scene, vec![false; all.len()]).parts.len()
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
    let scene = scene_in(&scratch, "[[drawing]]\nalpha = 2.6\nmu = 0.3\noutput = \"a.svg\"\n");
    let output = couplet(&["run", &scene, "--output", &scratch.path("out")]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(scratch.read("out/a.svg").contains("It stands at no thickness"));
}

#[test]
fn faults_of_drawings_have_their_places() {
    for (table, fault) in [
        ("[[drawing]]\nmu = 1", "2:1: half_opening is missing; give an angle"),
        ("[[drawing]]\nalpha = 1", "2:1: friction (or friction_angle) is missing"),
        ("[[drawing]]\nalpha = [1, 2]\nmu = 1", "3:9: half_opening [1, 2] is not one value"),
        ("[[drawing]]\nalpha = 1\nmu = [1, 2]", "4:6: friction [1, 2] is not one value"),
        ("[[drawing]]\nalpha = 4\nmu = 1", "3:9: the half opening 4 is not between 0 and pi"),
        ("[[drawing]]\nalpha = 1\nmu = 1\neta = 3", "5:7: the thickness 3 is not between 0 and 2"),
        ("[[drawing]]\nat = \"X\"", "3:6: at \"X\" is not one of T, S"),
        ("[[drawing]]\nat = [\"T\", \"S\"]", "3:6: at [\"T\", \"S\"] is not one of them"),
        ("[[drawing]]\nat = \"T\"\nmu = 1", "3:6: a landmark has its half_opening"),
        ("[[drawing]]\nat = \"T\"\nmode = \"rsx\"", "4:8: mode \"rsx\" is not one of [r,r,r]"),
        ("[[drawing]]\nat = \"T\"\nweight = \"both\"", "2:1: a drawing shows one weight"),
        (
            "[[drawing]]\nat = \"T\"\namplitude = 2",
            "4:13: amplitude 2 is not a number from 0.001 to 1",
        ),
        (
            "[[drawing]]\nat = \"T\"\nstones = 1",
            "4:10: stones 1 is not a whole number from 2 to 500",
        ),
        ("[[drawing]]\nat = \"T\"\nstones = 9", "2:1: stones are of an arch"),
        (
            "[[drawing]]\nat = \"T\"\narrows = true\noutput = \"x.dxf\"",
            "2:1: only svg, png and pdf have arrows; leave out arrows",
        ),
        ("[[drawing]]\nat = \"T\"\nhalf = 1", "4:8: half 1 is not true or false"),
        (
            "[[drawing]]\nat = \"T\"\nanimate = true\nformat = \"json\"",
            "2:1: only svg moves; leave out animate",
        ),
        (
            "[[drawing]]\nalpha = 1\nmu = 1\neta = 1\nmode = \"ss\"\nformat = \"svg\"",
            "2:1: an arch as it stands does not move",
        ),
        ("[[drawing]]\nat = \"T\"\noutput = \"x.csv\"", "4:10: output \"x.csv\" does not tell"),
        ("[[figure]]\nnumber = 13", "3:10: number 13 is not a whole number from 1 to 12"),
        ("[[figure]]\nnumber = 7\nweight = \"both\"", "2:1: figure 7 shows one weight"),
        ("[[figure]]\nnumber = 7\ntolerance = 1e-2", "2:1: figure 7 has no curves of the map"),
    ] {
        let found = faults(table);
        assert!(found.len() == 1 && found[0].starts_with(fault), "{table}: {found:?}");
    }
    // All that is wrong with one is told at once.
    let all = faults(
        "[[drawing]]\nalpha = 4\nmu = -1\neta = 3\nmode = \"rsx\"\namplitude = 2\nstones = 1\nhalf = 1\nweight = \"x\"",
    );
    for part in [
        "the half opening 4",
        "the friction -1",
        "the thickness 3",
        "mode",
        "amplitude",
        "stones",
        "half 1",
        "weight",
    ] {
        assert!(all.iter().any(|fault| fault.contains(part)), "{part}: {all:?}");
    }
    assert_eq!(faults("[[drawing]]").len(), 2, "both are missing");
}

/// Keys of sizes make the arches of the command in metres.
#[test]
fn a_scene_reads_an_arch_in_metres() {
    let scratch = Scratch::new();
    let arch = "span = \"18.9m\"\nrise = \"4.2m\"\nfriction = 0.6\n";
    let scene = scene_in(
        &scratch,
        &format!(
            "[[drawing]]\n{arch}thickness = \"90cm\"\noutput = \"a.svg\"\n[[arches]]\n{arch}digits = 9\noutput = \"a.json\"\n\
             [[arches]]\n{arch}thickness = [\"90cm\", \"0.1r\"]\ndensity = \"24kN/m3\"\ndepth = \"1m\"\ndigits = 9\noutput = \"b.json\"\n"
        ),
    );
    let output = couplet(&["run", &scene, "--output", &scratch.path("out")]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = |line: &str| text(&couplet(&line.split(' ').collect::<Vec<_>>()).stdout);
    let metres = "--span 18.9m --rise 4.2m --friction 0.6";
    let drawn = printed(&format!("draw {metres} --thickness 90cm --weight milankovitch"));
    let caption = |picture: &str| picture.split_once("<desc").map(|(_, rest)| rest.to_owned());
    // The command has its options in the order of the arguments, the scene in that of the fields.
    let bare = |svg: &str| svg.lines().filter(|l| !l.contains("couplet draw")).collect::<String>();
    let made = scratch.read("out/a.svg");
    assert!(caption(&made).is_some() && made.contains("--thickness 90cm --span 18.9m --rise 4.2m"));
    assert_eq!(bare(&made), bare(&drawn));
    let json = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    let [state, assessed] = ["a", "b"].map(|of| json(&scratch.read(&format!("out/{of}.json"))));
    let same = |entry: &serde_json::Value, line: &str| {
        let alone = json(&printed(&format!("{line} --digits 9 --format json")));
        for (key, value) in alone.as_object().unwrap() {
            assert_eq!(&entry[key], value, "{line}: {key}");
        }
    };
    same(&state["arches"][0], &format!("state {metres}"));
    let kn = "--density 24kN/m3 --depth 1m";
    for (k, eta) in ["90cm", "0.1r"].iter().enumerate() {
        same(&assessed["arches"][k], &format!("assess {metres} --thickness {eta} {kn}"));
    }
    let said = |sizes: &str| faults(&format!("[arches]\n{sizes}\nfriction = 1\n"));
    assert_eq!(said("span = \"1m\""), ["3:8: span needs rise, radius or half_opening"]);
    assert_eq!(said("rise = [\"1m\", \"2m\"]"), ["3:8: rise needs span, radius or half_opening"]);
    assert!(said("span = 3\nrise = \"1m\"")[0].starts_with("3:8: '3' is not a length"));
    assert!(
        said("half_opening = 1\nspan = \"1m\"")[0]
            .contains("make a radius that is no exact number")
    );
}
