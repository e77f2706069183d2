//! `couplet study`.

use super::{printed, stdout};
use crate::program::{Scratch, couplet, text};
use std::path::Path;

#[test]
fn a_study_writes_its_numbers_and_figures() {
    let scratch = Scratch::new();
    let folder = scratch.path("out");
    let output =
        couplet(&["study", "stability", "--quick", "--only", "eta-to-two", "--output", &folder]);
    let table = stdout(&output);
    assert!(table.contains("lost by the problem itself") && table.contains("(15) as printed"));
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}")).unwrap();
    let rows = read("stability.csv");
    assert_eq!(rows.matches(",proved").count(), 5, "{rows}");
    assert!(read("README.md").contains("study stability --quick --only eta-to-two"));
    assert!(read("digits-lost.svg").starts_with("<svg"));
    let pixels = Path::new(&folder).join("digits-lost.png");
    assert_eq!(pixels.exists(), cfg!(feature = "plots"));
    let said = text(&output.stderr);
    assert_eq!(said.is_empty(), cfg!(feature = "plots"), "{said}");
    if !cfg!(feature = "plots") {
        assert!(said.lines().count() == 1 && said.contains("SVG only"), "{said}");
    }
    let table = printed(&["study", "accuracy", "--quick", "--only", "half-opening"]);
    assert!(table.contains("half-opening  certified balls"), "{table}");
    assert!(!table.contains("fail"), "{table}");
}
