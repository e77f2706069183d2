//! Nothing is computed that is not needed, and nothing twice.

use super::{HEAD, ONE_THICKNESS, scene_in};
use crate::arches::{M, arch};
use crate::program::{Scratch, ended, tells};
use couplet::certify::state::Certify;
use couplet::problem::{Equation, tally};
use couplet::scene::{Costs, Plan, SceneRun, read};

/// What a scene costs: evaluations of each equation for each arch and each landmark.
fn costs(scene: &str) -> Costs {
    let scene = read(&format!("{HEAD}{scene}")).unwrap();
    let plan = Plan::new(&scene, vec![false; scene.items.len()]);
    let mut run = SceneRun::new(&plan);
    for index in 0..scene.items.len() {
        let found = run.item(index, &|| ());
        assert!(found.undecided.is_empty() && found.write(&mut std::io::sink()).is_ok());
    }
    run.costs().clone()
}

/// Whatever is computed once in a process and then kept is kept from here on.
fn warm() {
    costs(
        "weight = \"milankovitch\"\n[arches]\nhalf_opening = [0.5, \"pi/2\", 2.5]\nfriction = [0.5, 1, \"inf\"]\n",
    );
}

#[test]
fn the_thickness_of_a_rotational_arch_needs_its_proof_and_no_more() {
    warm();
    let costs = costs(ONE_THICKNESS);
    let [Some(cost)] = costs.0[..] else { panic!() };
    let found = cost.tally;
    let rotational = [Equation::LowerThrust, Equation::WholeThrust, Equation::Tangency];
    let count: u64 = rotational.iter().map(|equation| found.of(*equation)).sum();
    assert!((3..40).contains(&count) && count == found.evaluations(), "{found:?}");
    for equation in [
        Equation::UpperThrust,
        Equation::TangencyAtCrown,
        Equation::DoubleThickness,
        Equation::ShoulderSliding,
        Equation::InnerSliding,
        Equation::Steepest,
    ] {
        assert_eq!(found.of(equation), 0, "{}", equation.label());
    }
    assert_eq!(found.landmarks, 0);
    // The same as the library's own proof of this arch alone.
    let (_, alone) = tally::measure(|| arch(M, "pi/2", "inf").certify_alone(30));
    assert_eq!(found, alone);
}

#[test]
fn an_item_adds_its_own_cost_only() {
    warm();
    let one = costs(ONE_THICKNESS);
    let other = "[[arches]]\nhalf_opening = 1.2\nfriction = 0.32\n";
    let both = costs(&format!("{ONE_THICKNESS}{other}"));
    assert_eq!(both.0.len(), 2);
    assert_eq!(both.0[0].unwrap().tally, one.0[0].unwrap().tally);
    assert_eq!(both.0[1].unwrap().tally, costs(other).0[0].unwrap().tally);
    let landmark =
        "[[constants]]\nlandmarks = \"T\"\nquantities = \"thickness\"\nweight = \"heyman\"\n";
    let with_landmark = costs(&format!("{ONE_THICKNESS}{landmark}"));
    assert_eq!(with_landmark.0[0].unwrap().tally, one.0[0].unwrap().tally);
    assert_eq!(with_landmark.0[1].unwrap().tally, costs(landmark).0[0].unwrap().tally);
}

#[test]
fn what_two_items_share_is_computed_once() {
    warm();
    // The same arch in other words, and the same landmark to fewer digits, cost nothing more.
    let again = ONE_THICKNESS.replace("\"pi/2\"", "\"90deg\"");
    let twice = costs(&format!("{ONE_THICKNESS}{again}"));
    assert_eq!(twice.0.len(), 1);
    assert_eq!(twice.total().tally, costs(ONE_THICKNESS).total().tally);
    let landmark = "[[constants]]\nlandmarks = \"T\"\nweight = \"heyman\"\n";
    let many = format!("{landmark}digits = 100\n");
    let few = format!("{landmark}digits = 10\nquantities = \"thrust\"\n");
    for both in [format!("{many}{few}"), format!("{few}{many}")] {
        assert_eq!(costs(&both).total().tally, costs(&many).total().tally);
    }
    // An arch with several thicknesses has one state.
    let vault = |thickness: &str| {
        costs(&format!(
            "[arches]\nhalf_opening = \"pi/2\"\nfriction = \"inf\"\nquantities = \"geometric_safety\"\n\
             thickness = {thickness}\n"
        ))
    };
    assert_eq!(vault("[0.1, 0.2, 0.3]").total().tally, vault("0.2").total().tally);
    let range = vault("0.2").total().tally;
    assert_eq!(range.of(Equation::UpperThrust) + range.of(Equation::ShoulderSliding), 0);
}

#[test]
fn arches_of_one_half_opening_share_its_proofs() {
    warm();
    let of = |frictions: &str, format: &str| {
        let scene = format!(
            "[[arches]]\nhalf_opening = \"80deg\"\nfriction = {frictions}\nformat = \"{format}\"\n"
        );
        // Of several threads that ask for the half opening at a time, one proves it and the others their arches.
        let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        one.install(|| costs(&scene)).total().tally.evaluations()
    };
    let range = |steps: usize| format!("{{ from = 1, to = 2, steps = {steps} }}");
    // Two alone, and the half opening; then any number is free.
    assert_eq!(of(&range(30), "csv"), of(&range(4), "csv"));
    assert!(of(&range(30), "csv") < 5 * of("1", "csv"));
    // For a format that has errors of doubles each is proved.
    assert!(of(&range(30), "toml") > 20 * of("1", "toml"));
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
