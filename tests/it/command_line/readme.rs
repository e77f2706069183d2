//! The README shows real output.

use super::printed;
use crate::program::{Scratch, couplet};

#[test]
fn the_readme_tells_the_truth() {
    let readme = include_str!("../../../README.md");
    let point = printed(&["constants", "T", "--weight", "milankovitch"]);
    let shown: String =
        point.lines().map(|line| format!("    {line}\n").replace("    \n", "\n")).collect();
    assert!(readme.contains(&shown), "{shown}");
    let state =
        printed(&["state", "--half-opening", "2.45", "--friction", "1.35", "--digits", "20"]);
    let block = readme.split("--digits 20\n").nth(1).unwrap().split("    …").next().unwrap();
    for line in block.lines().map(str::trim) {
        assert!(state.contains(line), "{line}");
    }
    let audit = printed(&["audit"]);
    let block = readme.split("$ couplet audit\n").nth(1).unwrap().split("\n\n").next().unwrap();
    for line in block.lines().map(str::trim).filter(|line| *line != "…") {
        assert!(audit.contains(line), "{line}");
    }
    let claims = printed(&["prove", "eq-16"]);
    let block =
        readme.split("$ couplet prove eq-16\n").nth(1).unwrap().split("\n\n").next().unwrap();
    // The first line has a time.
    for line in block.lines().skip(1).map(str::trim) {
        assert!(claims.contains(line), "{line}");
    }
    let scratch = Scratch::new();
    let file = scratch.path("T.json");
    couplet(&["certify", "T", "--digits", "1000", "-o", &file]);
    let verdict = printed(&["check", &file]).replace(&file, "T.json");
    assert!(readme.contains(verdict.trim()), "{verdict}");
}
