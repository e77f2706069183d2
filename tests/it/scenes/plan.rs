//! What will be computed, and what it has cost.

use super::{ONE_THICKNESS, THREE, scene_in};
use crate::program::{Scratch, couplet, text};

#[test]
fn a_plan_is_printed_and_nothing_is_written() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, THREE);
    let output = couplet(["run", &scene, "--output", &scratch.path("out"), "--plan"]);
    assert_eq!(output.status.code(), Some(0));
    let tree = text(&output.stdout);
    for line in [
        "4 items; to compute: 2 landmarks, 19 arches, 5 claims, each once",
        "├─ constants in line 3 -> constants.json (json)",
        "│  ├─ T heyman",
        "│  │  from (2), (4), (5), (17), (18), beta_s^2 = h (1 - h)",
        "   ├─ landmarks S, J, B, l, L, sb heyman: not asked for",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    assert!(!tree.contains(" ms"), "nothing is computed");
    assert_eq!(scratch.files("."), ["scene.toml"]);
}

#[test]
fn what_was_computed_is_explained_with_its_cost() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, ONE_THICKNESS);
    let output = couplet(["run", &scene, "--explain"]);
    assert!(text(&output.stdout).contains("0.107478038107476"));
    let tree = text(&output.stderr);
    assert!(tree.contains("evaluations: (2) "), "{tree}");
    assert!(
        tree.contains("sliding_friction, rotational_friction of 1 arch: not asked for"),
        "{tree}"
    );
    assert!(!tree.contains("as proved for another"), "{tree}");
    assert!(tree.contains("in all, processor time of the program: "), "{tree}");
}

#[test]
fn an_arch_that_shares_a_proof_is_said_to_do_so() {
    let scratch = Scratch::new();
    let many = "[arches]\nhalf_opening = \"pi/2\"\nfriction = [1, 2, 3, 4]\nformat = \"csv\"\n";
    let output = couplet(["run", &scene_in(&scratch, many), "--explain", "--threads", "1"]);
    let tree = text(&output.stderr);
    // Two are proved alone, and what the third makes is shared.
    assert_eq!(
        tree.matches("as proved for another friction of its half opening").count(),
        1,
        "{tree}"
    );
}
