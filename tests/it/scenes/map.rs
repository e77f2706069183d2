//! Maps and figures in scenes: as the commands write them, each curve once, and kept.

use super::{HEAD, faults, scene_in};
use crate::program::{Scratch, couplet, text};
use couplet::scene::{Plan, SceneRun, read};

const MAPS: &str = "[[map]]\ntolerance = 1e-2\nlines = true\noutput = \"lines.svg\"\n\
    [[map]]\ntolerance = 0.01\ncurves = [\"limit\", \"[s,r,r]/[r,r,r]\"]\nalpha = \"2.58\"\noutput = \"some.csv\"\n\
    [[figure]]\nnumber = 5\ntolerance = \"1e-2\"\nweight = \"milankovitch\"\noutput = \"five.svg\"\n\
    [[map]]\ntolerance = 1e-2\nweight = \"milankovitch\"\noutput = \"page.html\"\n";

#[test]
fn a_scene_writes_what_the_commands_write() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, MAPS);
    let run = ["run", &scene, "--output", &scratch.path("out"), "--explain", "--resume"];
    let output = couplet(&run);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let tree = text(&output.stderr);
    for line in [
        "4 items; to compute: 7 landmarks, 40 curves, each once",
        "│  ├─ rrr/srr milankovitch, in tubes of 0.01",
        "│  ├─ half opening 2.58 milankovitch, in tubes of 0.01",
        "│  └─ 2 curves: computed for the item in line 2",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    // But for the command in the caption.
    let drawn = |svg: &str| svg.split("<g id=\"caption\">").next().unwrap().to_owned();
    let body = |svg: &str| drawn(svg).lines().skip(3).collect::<Vec<_>>().join("\n");
    let lines = couplet(&["map", "--lines", "--tolerance", "1e-2", "--format", "svg"]);
    assert_eq!(body(&scratch.read("out/lines.svg")), body(&text(&lines.stdout)));
    assert_eq!(body(&scratch.read("out/five.svg")), body(&text(&lines.stdout)));
    let some = ["map", "--curve", "rrr/srr,limit", "--alpha", "2.58", "--tolerance", "1e-2"];
    let some = couplet(&[&some[..], &["--format", "csv"]].concat());
    assert_eq!(scratch.read("out/some.csv"), text(&some.stdout));
    assert!(scratch.read("out/page.html").contains("0.618318241074323"));
    let again = couplet(&run);
    let said = text(&again.stderr);
    assert_eq!(said.matches("kept ").count(), 4, "{said}");
    assert!(said.contains("nothing to compute"), "{said}");
}

/// The caption names a command that draws the same picture.
#[test]
fn a_picture_says_which_command_draws_it() {
    let scene = read(&format!("{HEAD}[[figure]]\nnumber = 3\ntolerance = 1e-2\n")).unwrap();
    let plan = Plan::new(&scene, vec![false]);
    assert_eq!(plan.parts.len(), 24, "all curves of both weights");
    let mut picture = Vec::new();
    let mut run = SceneRun::new(&plan);
    run.item(0, &|| ()).write(&mut picture).unwrap();
    let picture = text(&picture);
    let command = picture.split("Command: couplet ").nth(1).unwrap().split('<').next().unwrap();
    let words: Vec<&str> = command.split(' ').collect();
    assert_eq!(text(&couplet(&words).stdout), picture);
}

/// What asymmetric branches reach is there too; and a level that no arch has is no question, as at the command.
#[test]
fn asymmetric_lines_are_those_of_the_command_and_no_level_is_bad_input() {
    let scratch = Scratch::new();
    let scene = scene_in(
        &scratch,
        "[[map]]\ntolerance = 1e-2\nasymmetric = true\noutput = \"lines.csv\"\n",
    );
    assert_eq!(couplet(&["run", &scene, "-o", &scratch.path("out")]).status.code(), Some(0));
    let lines = ["map", "--asymmetric", "--tolerance", "1e-2", "--format", "csv"];
    assert_eq!(scratch.read("out/lines.csv"), text(&couplet(&lines).stdout));
    let scene = scene_in(&scratch, "[[map]]\nalpha = \"170deg\"\noutput = \"none.csv\"\n");
    let none = couplet(&["run", &scene, "-o", &scratch.path("none")]);
    let command = couplet(&["map", "--alpha", "170deg", "--format", "csv"]);
    for output in [none, command] {
        assert_eq!(output.status.code(), Some(2));
        let said = text(&output.stderr);
        assert!(said.contains("no arch of the half opening 170deg stands"), "{said}");
    }
}

/// Axes, ranges, a scale and marks are those of the command.
#[test]
fn a_map_has_axes_and_marks() {
    let scratch = Scratch::new();
    let table = "[[map]]\ntolerance = 1e-1\nbare = true\nfriction_unit = \"mu\"\nfriction_range = \"0..3\"\n\
        scale = \"log\"\nthickness_range = \"0.01..2\"\nmarks = [\"80deg,0.6,0.15\"]\noutput = \"axes.svg\"\n";
    let scene = scene_in(&scratch, table);
    assert_eq!(couplet(&["run", &scene, "-o", &scratch.path("out")]).status.code(), Some(0));
    let drawn = scratch.read("out/axes.svg");
    let command = drawn.split("Command: couplet ").nth(1).unwrap().split('<').next().unwrap();
    let words: Vec<&str> = command.split(' ').collect();
    let again = text(&couplet(&[&words[..], &["--format", "svg"]].concat()).stdout);
    // But for the command in the caption.
    let body = |svg: &str| {
        let drawn = svg.split("<g id=\"caption\">").next().unwrap().to_owned();
        drawn.lines().skip(3).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(body(&drawn), body(&again));
    assert!(drawn.contains("mark-1") && drawn.contains("in decades of η"));
}

#[test]
fn faults_of_maps_have_their_places() {
    for (table, fault) in [
        ("[[map]]\ncurves = \"rrr\"", "3:10: curves \"rrr\" is not one of rotation, overturning"),
        ("[[map]]\ntolerance = 0", "3:13: tolerance 0 is not a number from 1e-12 to 1"),
        ("[[map]]\ntolerance = true", "3:13: tolerance true is not a number from 1e-12 to 1"),
        ("[[map]]\nplane = \"mine\"", "3:9: plane \"mine\" is not one of thickness-friction"),
        ("[[map]]\nlines = true", "2:1: plane, lines and bare are for a picture, svg, png or pdf"),
        (
            "[[map]]\nlines = true\nplane = \"opening-friction\"\nformat = \"svg\"",
            "2:1: lines are drawn over thickness and friction",
        ),
        ("[[map]]\nscale = \"loga\"\nformat = \"svg\"", "3:9: scale \"loga\" is not one of linear"),
        (
            "[[map]]\nfriction_range = \"3\"\nformat = \"svg\"",
            "3:18: friction_range: '3' is no range",
        ),
        ("[[map]]\nmarks = [\"1\"]\nformat = \"svg\"", "3:10: marks: a mark is a half opening"),
        (
            "[[map]]\nscale = \"log\"\nformat = \"csv\"",
            "2:1: units, ranges and a scale are for a map as svg, png or pdf",
        ),
        (
            "[[map]]\nhalf_opening_unit = \"A\"\nformat = \"svg\"",
            "2:1: the plane thickness-friction has no",
        ),
        (
            "[[map]]\nlines = true\nscale = \"log\"\nformat = \"svg\"",
            "2:1: units, ranges and a scale are for",
        ),
        ("[[map]]\nweight = \"both\"\noutput = \"x.svg\"", "2:1: a map shows one weight"),
        (
            "[[map]]\neta = 1\noutput = \"x.svg\"",
            "2:1: over thickness and friction lines of a half opening",
        ),
        ("[[map]]\nalpha = 4", "3:9: the half opening 4 is not between 0 and pi"),
        ("[[map]]\ncurves = \"limit\"\noutput = \"x.html\"", "2:1: a page shows the whole map"),
        ("[[map]]\nnumber = 5", "3:1: unknown key \"number\" in [[map]]"),
        ("[[figure]]\noutput = \"x.svg\"", "2:1: number is missing; a figure is one of 1 to 12"),
        ("[[figure]]\nnumber = 0", "3:10: number 0 is not a whole number from 1 to 12"),
        ("[[figure]]\nnumber = 6\nweight = \"both\"", "2:1: figure 6 shows one weight"),
        ("[[figure]]\nnumber = 5\noutput = \"x.csv\"", "4:10: output \"x.csv\" does not tell"),
    ] {
        let found = faults(table);
        assert!(found.len() == 1 && found[0].starts_with(fault), "{table}: {found:?}");
    }
}
