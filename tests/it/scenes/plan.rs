//! What will be computed, and what it has cost.

use super::{ONE_THICKNESS, THREE, scene_in};
use crate::program::{Scratch, ended, printed, tells};

#[test]
fn a_plan_is_printed_and_nothing_is_written() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, THREE);
    let tree = printed(["run", &scene, "--output", &scratch.path("out"), "--plan"]);
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
    let (table, tree) = ended(0, ["run", &scene, "--explain"], "");
    tells(&table, ["0.107478038107476"]);
    let told = [
        "evaluations: (2) ",
        "sliding_friction, rotational_friction of 1 arch: not asked for",
        "in all, processor time of the program: ",
    ];
    tells(&tree, told);
    assert!(!tree.contains("as proved for another"), "{tree}");
}

#[test]
fn an_arch_that_shares_a_proof_is_said_to_do_so() {
    let scratch = Scratch::new();
    let many = "[arches]\nhalf_opening = \"pi/2\"\nfriction = [1, 2, 3, 4]\nformat = \"csv\"\n";
    let scene = scene_in(&scratch, many);
    let (_, tree) = ended(0, ["run", &scene, "--explain", "--threads", "1"], "");
    // Two are proved alone, and what the third makes is shared.
    let shared = "as proved for another friction of its half opening";
    assert_eq!(tree.matches(shared).count(), 1, "{tree}");
}
