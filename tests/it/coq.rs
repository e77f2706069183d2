//! The stored Coq files are those that the program prints.

use couplet::arch::SelfWeight;
use couplet::certify::certify_arch;
use couplet::claims::coq::{StateError, files, state};
use couplet::problem::{Arch, Landmark, Mode};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The files of a folder of `proofs` with an extension.
fn stored(folder: &str, extension: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs").join(folder);
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|found| found == extension)).collect()
}

/// What the program prints: the landmarks, and the states of the stored certificates.
fn printed() -> BTreeMap<String, String> {
    let slides_inside = |path: &PathBuf| path.to_string_lossy().contains("inner-sliding");
    let asymmetric = stored("asymmetric", "json").into_iter().filter(slides_inside);
    let states = stored("states", "json").into_iter().chain(asymmetric).map(|path| {
        let certificate = fs::read(&path).unwrap();
        state(&certificate).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    });
    files().unwrap().into_iter().chain(states).collect()
}

#[test]
fn stored_and_printed_files_agree() {
    let printed = printed();
    let stored: BTreeMap<String, String> = stored("coq/generated", "v")
        .into_iter()
        .map(|path| {
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect();
    assert_eq!(stored.keys().collect::<Vec<_>>(), printed.keys().collect::<Vec<_>>());
    for (name, text) in &printed {
        assert!(
            stored[name] == *text,
            "{name}: run `couplet prove --coq proofs/coq/generated`, `make states`, and look at what changed"
        );
    }
}

#[test]
fn a_printed_file_has_no_holes_and_leaves_nothing_unproved() {
    for (name, text) in printed() {
        for word in ["<<", ">>", "Admitted", "Axiom", "admit"] {
            assert!(!text.contains(word), "{name}: {word}");
        }
        assert_eq!(text.matches("Proof.").count(), text.matches("Qed.").count(), "{name}");
    }
}

/// Every mode has a stored state, for both weights where it knows one.
#[test]
fn every_mode_has_a_stored_state() {
    let names: Vec<String> =
        printed().into_keys().filter(|name| name.starts_with("State")).collect();
    let expected = Mode::ALL.into_iter().flat_map(|mode| match mode {
        Mode::Sliding => vec![format!("State{mode:?}.v")],
        _ => SelfWeight::ALL.map(|weight| format!("State{mode:?}{weight:?}.v")).to_vec(),
    });
    let mut expected: Vec<String> = expected.collect();
    expected.sort();
    assert_eq!(names, expected);
}

/// A landmark has the theorem of its state, and where it has a friction, that nothing stands with less.
#[test]
fn every_landmark_is_a_state() {
    let printed = printed();
    for (landmark, weight) in
        Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w)))
    {
        let text = &printed[&format!("{landmark:?}{weight:?}.v")];
        let is_limited = landmark.modes().contains(&Mode::Sliding);
        let [inside, stands, mu] = match is_limited {
            true => ["admissible", "stands_from", " mu"],
            false => ["thrust_inside", "stands_without_limit_from", ""],
        };
        let eta = match landmark {
            Landmark::Border | Landmark::OverturningEnd => "2",
            _ => "eta",
        };
        let delta = weight.flag();
        let claim = format!(
            "  {stands} {delta} alpha{mu} {eta}.\nProof.\n  intros W E. pose proof (signs "
        );
        let (before, _) = text.split_once(&claim).unwrap_or_else(|| panic!("{landmark} {delta}"));
        let (_, theorem) = before.rsplit_once("Theorem state ").unwrap();
        assert!(theorem.contains(&format!("  {inside} {delta} alpha {eta}{mu} ")), "{landmark}");
        assert_eq!(text.contains("Theorem less_friction "), is_limited, "{landmark}");
    }
}

/// A theorem has the digits of the state, however few its certificate has.
#[test]
fn a_certificate_of_two_digits_gives_the_same_theorem() {
    let arch = Arch::parse("heyman", "pi/2", "0.38").unwrap();
    let few = certify_arch(&arch, None, 2).unwrap();
    let (name, text) = state(&serde_json::to_vec(&few).unwrap()).unwrap();
    assert_eq!(text, printed()[&name]);
}

/// What is given is exact: a fraction, a multiple of pi, the tangent of an angle; a small half opening, and one
/// next to the end of rotation.
#[test]
fn other_arches_have_a_theorem_too() {
    for (alpha, mu, given) in [
        ("1/3", "1/7", "alpha : R := 1/3.\nDefinition mu : R := 1/7."),
        ("80deg", "31deg", "alpha : R := 4 * PI / 9.\nDefinition mu : R := tan (31 * PI / 180)."),
        ("2.6", "inf", "alpha : R := 2.6.\n\n"),
        ("1e-4", "1", "alpha : R := 0.0001."),
        ("2.59084318392461", "inf", "alpha : R := 2.59084318392461.\n\n"),
    ] {
        let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
        let certificate = serde_json::to_vec(&certify_arch(&arch, None, 20).unwrap()).unwrap();
        let (_, text) = state(&certificate).unwrap_or_else(|e| panic!("{alpha} {mu}: {e}"));
        assert!(text.contains(given), "{alpha} {mu}: {text}");
    }
}

#[test]
fn what_is_no_state_or_does_not_check_is_refused() {
    let landmark = fs::read(&stored("constants", "json")[0]).unwrap();
    assert_eq!(state(&landmark), Err(StateError::NotState));
    let good = fs::read_to_string(&stored("states", "json")[0]).unwrap();
    let wrong = good.replacen("\"value\": \"", "\"value\": \"9", 1);
    assert!(matches!(state(wrong.as_bytes()), Err(StateError::Refused(_))));
    // Nothing that 30 decimals show.
    let arch = Arch::parse("heyman", "1e-5", "1").unwrap();
    let tiny = serde_json::to_vec(&certify_arch(&arch, None, 10).unwrap()).unwrap();
    assert!(matches!(state(&tiny), Err(StateError::Undecided(_))));
}
