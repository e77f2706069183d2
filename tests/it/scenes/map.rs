//! Maps and figures in scenes: as the commands write them, each curve once, and kept.

use super::{HEAD, body, caption, run, scene_in};
use crate::program::{Scratch, Words, ended, printed, tells, text};
use couplet::scene::{Plan, SceneRun, read};

const MAPS: &str = "[[map]]\ntolerance = 1e-2\nlines = true\noutput = \"lines.svg\"\n\
    [[map]]\ntolerance = 0.01\ncurves = [\"limit\", \"[s,r,r]/[r,r,r]\"]\nalpha = \"2.58\"\noutput = \"some.csv\"\n\
    [[figure]]\nnumber = 5\ntolerance = \"1e-2\"\nweight = \"milankovitch\"\noutput = \"five.svg\"\n\
    [[map]]\ntolerance = 1e-2\nweight = \"milankovitch\"\noutput = \"page.html\"\n";

#[test]
fn a_scene_writes_what_the_commands_write() {
    let scratch = Scratch::new();
    let tree = run(&scratch, MAPS, "--explain --resume");
    for line in [
        "4 items; to compute: 7 landmarks, 40 curves, each once",
        "│  ├─ rrr/srr milankovitch, in tubes of 0.01",
        "│  ├─ half opening 2.58 milankovitch, in tubes of 0.01",
        "│  └─ 2 curves: computed for the item in line 2",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    let lines = printed("map --lines --tolerance 1e-2 --format svg");
    assert_eq!(body(&scratch.read("out/lines.svg")), body(&lines));
    assert_eq!(body(&scratch.read("out/five.svg")), body(&lines));
    let some = printed("map --curve rrr/srr,limit --alpha 2.58 --tolerance 1e-2 --format csv");
    assert_eq!(scratch.read("out/some.csv"), some);
    assert!(scratch.read("out/page.html").contains("0.618318241074323"));
    let again = run(&scratch, MAPS, "--explain --resume");
    assert_eq!(again.matches("kept ").count(), 4, "{again}");
    assert!(again.contains("nothing to compute"), "{again}");
}

/// The caption names a command that draws the same picture.
#[test]
fn a_picture_says_which_command_draws_it() {
    let scene = read(&format!("{HEAD}[[figure]]\nnumber = 3\ntolerance = 1e-2\n")).unwrap();
    let plan = Plan::new(&scene, vec![false]);
    assert_eq!(plan.sizes().len(), 24, "all curves of both weights");
    let mut picture = Vec::new();
    let mut items = SceneRun::new(&plan);
    items.item(0, &|| ()).write(&mut picture).unwrap();
    let picture = text(&picture);
    assert_eq!(printed(caption(&picture)), picture);
}

/// What asymmetric branches reach is there too; and a level that no arch has is no question, as at the command.
#[test]
fn asymmetric_lines_are_those_of_the_command_and_no_level_is_bad_input() {
    let scratch = Scratch::new();
    let table = "[[map]]\ntolerance = 1e-2\nasymmetric = true\noutput = \"lines.csv\"\n";
    run(&scratch, table, "");
    let lines = printed("map --asymmetric --tolerance 1e-2 --format csv");
    assert_eq!(scratch.read("out/lines.csv"), lines);
    let scene = scene_in(&scratch, "[[map]]\nalpha = \"170deg\"\noutput = \"none.csv\"\n");
    let (none, level) = (scratch.path("none"), "map --alpha 170deg --format csv".words());
    for arguments in [&["run", &scene, "-o", &none][..], &level] {
        let (_, message) = ended(2, arguments, "");
        tells(&message, ["no arch of the half opening 170deg stands"]);
    }
}

/// Axes, ranges, a scale and marks are those of the command.
#[test]
fn a_map_has_axes_and_marks() {
    let scratch = Scratch::new();
    let table = "[[map]]\ntolerance = 1e-1\nbare = true\nfriction_unit = \"mu\"\nfriction_range = \"0..3\"\n\
        scale = \"log\"\nthickness_range = \"0.01..2\"\nmarks = [\"80deg,0.6,0.15\"]\noutput = \"axes.svg\"\n";
    run(&scratch, table, "");
    let drawn = scratch.read("out/axes.svg");
    assert_eq!(body(&drawn), body(&printed(format!("{} --format svg", caption(&drawn)))));
    assert!(drawn.contains("mark-1") && drawn.contains("in decades of η"));
}
