//! The stored Coq files are those that the program prints.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

#[test]
fn stored_and_printed_files_agree() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/coq/generated");
    let printed: BTreeMap<String, String> =
        couplet::claims::coq::files().unwrap().into_iter().collect();
    let stored: BTreeMap<String, String> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "v"))
        .map(|path| {
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect();
    assert_eq!(stored.keys().collect::<Vec<_>>(), printed.keys().collect::<Vec<_>>());
    for (name, text) in &printed {
        assert!(
            stored[name] == *text,
            "{name}: run `couplet prove --coq proofs/coq/generated` and look at what changed"
        );
    }
}

#[test]
fn a_printed_file_has_no_holes_and_leaves_nothing_unproved() {
    for (name, text) in couplet::claims::coq::files().unwrap() {
        for word in ["<<", ">>", "Admitted", "Axiom", "admit"] {
            assert!(!text.contains(word), "{name}: {word}");
        }
        assert_eq!(text.matches("Proof.").count(), text.matches("Qed.").count(), "{name}");
    }
}
