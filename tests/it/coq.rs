//! The stored Coq files are those that the program prints.

use crate::house::{certificates, files};
use couplet::arch::SelfWeight;
use couplet::certify::certify_arch;
use couplet::claims::coq::certificate;
use couplet::judge::{PrintedVerdict, audit};
use couplet::problem::{Arch, Mode};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

/// What the program prints of the stored certificates.
fn printed() -> BTreeMap<String, String> {
    let stored = certificates(["constants", "states", "asymmetric", "surveys"]).into_iter();
    let certificates = stored.map(|path| {
        let bytes = fs::read(&path).unwrap();
        certificate(&bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    });
    certificates.collect()
}

#[test]
fn stored_and_printed_files_agree() {
    let printed = printed();
    let read = |path: PathBuf| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (name, fs::read_to_string(path).unwrap())
    };
    let stored = files("proofs/coq/generated", "v").into_iter().map(read);
    let stored: BTreeMap<String, String> = stored.collect();
    assert_eq!(stored.keys().collect::<Vec<_>>(), printed.keys().collect::<Vec<_>>());
    for (name, text) in &printed {
        assert!(stored[name] == *text, "{name}: run `make states`, and look at what changed");
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

/// Every mode has a stored state, for both weights where it knows one, and every kind of asymmetric solution.
#[test]
fn every_mode_has_a_stored_certificate() {
    let is_arch =
        |name: &String| ["State", "Slides", "Asymmetric"].iter().any(|of| name.starts_with(of));
    let names: Vec<String> = printed().into_keys().filter(is_arch).collect();
    let kinds = ["SlidesInside", "OpensAtShoulder", "SlidesAlone"];
    let modes = Mode::ALL.into_iter().filter(|mode| *mode != Mode::Sliding);
    let of_both = modes.map(|mode| format!("State{mode:?}"));
    let of_both = of_both.chain(kinds.map(|kind| format!("Asymmetric{kind}")));
    let of_both =
        of_both.flat_map(|name| SelfWeight::ALL.map(|weight| format!("{name}{weight:?}.v")));
    let mut expected: Vec<String> = of_both.chain(["SlidesMilankovitch.v".to_owned()]).collect();
    expected.sort();
    assert_eq!(names, expected);
}

/// Each decimal that the paper prints of a landmark has a corollary, which says what the audit says of its last digit;
/// what is given there has none.
#[test]
fn every_printed_digit_is_judged() {
    let printed = printed();
    let mut seen = BTreeSet::new();
    for audited in audit().unwrap() {
        let value = audited.printed;
        let file = format!("Landmark{:?}{:?}.v", value.landmark, value.weight);
        let quantity = value.quantity.name();
        let is_new = seen.insert((file.clone(), quantity, value.text));
        if is_new && value.text.contains('.') {
            let is_right = audited.verdict == PrintedVerdict::CorrectlyRounded;
            let verdict = if is_right { "right" } else { "wrong" };
            let place = value.place.to_lowercase().replace(". ", "_").replace([' ', '.'], "_");
            let name = format!("Corollary {place}_{quantity}_{verdict} x : is_landmark this ");
            let (_, after) = printed[&file].split_once(&name).unwrap_or_else(|| panic!("{name}"));
            assert!(after.lines().next().unwrap().contains(&format!(" - {})", value.text)));
        }
    }
    let decimals = seen.iter().filter(|(_, _, text)| text.contains('.')).count();
    let all = printed.values().map(|text| text.matches("Corollary ").count());
    assert_eq!(all.sum::<usize>(), decimals);
}

/// What is given is exact: a fraction, a multiple of pi, the tangent of an angle, no limit.
#[test]
fn other_arches_have_a_theorem_too() {
    for (alpha, mu, thickness, subject) in [
        ("1/3", "1/7", None, "(Fraction 1 3) (Coefficient (Fraction 1 7))"),
        ("80deg", "31deg", None, "(TimesPi 4 9) (Angle (TimesPi 31 180))"),
        ("2.6", "inf", None, "State Overturning (Arch Milankovitch (Fraction 13 5) Unlimited)"),
        ("80deg", "0.5", Some("0.2"), "Stands (Arch Milankovitch"),
        ("80deg", "0.5", Some("0.02"), "TooThin Rotational (Arch Milankovitch"),
        ("2.85", "inf", None, "TooWide (Arch Milankovitch"),
    ] {
        let arch = Arch::parse("milankovitch", alpha, mu).unwrap();
        let thickness = thickness.map(|eta| eta.parse().unwrap());
        let certified = certify_arch(&arch, thickness.as_ref(), 20).unwrap();
        let (_, text) = certificate(&serde_json::to_vec(&certified).unwrap()).unwrap();
        assert!(text.contains(subject), "{alpha} {mu}: {text}");
    }
}

#[test]
fn what_does_not_check_is_refused() {
    let good = fs::read_to_string(&certificates(["states"])[0]).unwrap();
    let wrong = good.replacen("\"value\": \"", "\"value\": \"9", 1);
    assert!(certificate(wrong.as_bytes()).is_err());
}
