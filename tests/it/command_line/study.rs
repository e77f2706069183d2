//! `couplet study`.

use crate::program::{Scratch, ended, printed, tells};
use std::path::Path;

#[test]
fn a_study_writes_its_numbers_and_figures() {
    let scratch = Scratch::new();
    let folder = scratch.path("out");
    let line = format!("study stability --quick --only eta-to-two --output {folder}");
    let (table, said) = ended(0, line, "");
    tells(&table, ["lost by the problem itself", "(15) as printed"]);
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}")).unwrap();
    let rows = read("stability.csv");
    assert_eq!(rows.matches(",proved").count(), 5, "{rows}");
    assert!(read("README.md").contains("study stability --quick --only eta-to-two"));
    assert!(read("digits-left.svg").starts_with("<svg"));
    let pixels = Path::new(&folder).join("digits-left.png");
    assert_eq!(pixels.exists(), cfg!(feature = "plots"));
    assert_eq!(said.is_empty(), cfg!(feature = "plots"), "{said}");
    if !cfg!(feature = "plots") {
        assert!(said.lines().count() == 1 && said.contains("SVG only"), "{said}");
    }
    let table = printed("study accuracy --quick --only half-opening");
    assert!(table.contains("half-opening  one proved root, balls of MPFR"), "{table}");
    assert!(!table.contains("fail"), "{table}");
}

/// The proofs that the product asks first are in the study, and what the command does; what is proved holds the truth.
#[test]
fn states_are_measured_as_the_command_proves_them() {
    let scratch = Scratch::new();
    let folder = scratch.path("acc");
    let table =
        printed(["study", "accuracy", "--quick", "--only", "landmark,state", "-o", &folder]);
    tells(
        &table,
        [
            "one proved root, balls of MPFR",
            "one proved root, astro-float",
            "certified, balls of doubles",
            "certified, balls of double-doubles",
            "certified, balls of MPFR",
            "what couplet state does",
        ],
    );
    let claimed = table.split("A claimed bound was at least the true error in ").nth(1).unwrap();
    let (right, all) = claimed.split_once(" of ").unwrap();
    assert_eq!(Some(right), all.strip_suffix(" rows.\n"), "{table}");
    let svg = scratch.read("acc/error-against-time.svg");
    assert!(svg.contains("what couplet state does") && svg.contains("quartiles"));
}

#[test]
fn a_name_of_a_file_makes_no_folder() {
    let scratch = Scratch::new();
    let file = scratch.path("acc.svg");
    let (output, message) = ended(2, ["study", "stability", "--quick", "-o", &file], "");
    assert_eq!(output, "");
    assert!(message.contains("looks like a file") && message.lines().count() == 1, "{message}");
    assert!(!Path::new(&file).exists());
}
